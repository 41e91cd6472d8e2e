#include "update.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <wend/math.hpp>

namespace xcs {
namespace {

// ratio^nu: by multiplication for small whole nu, as in the literature's 5.
double power(double ratio, double nu) {
  if (nu == std::floor(nu) && nu >= 0 && nu <= 16) {
    double result = 1;
    for (int k = static_cast<int>(nu); k > 0; --k) result *= ratio;
    return result;
  }
  return wend::math::pow(ratio, nu);
}

}  // namespace

void predict(const Population& population, const RuleSet& match, Predictions& out) {
  out.weighted.assign(population.actions(), 0);
  out.fitness.assign(population.actions(), 0);
  out.array.assign(population.actions(), std::numeric_limits<double>::quiet_NaN());
  for (const std::uint32_t rule : match) {
    const std::uint32_t a = population.action(rule);
    out.weighted[a] += population.fitness[rule] * population.prediction[rule];
    out.fitness[a] += population.fitness[rule];
    out.array[a] = population.prediction[rule];
  }
  for (std::uint32_t a = 0; a < population.actions(); ++a)
    if (out.fitness[a] > 0) out.array[a] = out.weighted[a] / out.fitness[a];
}

std::uint32_t best_action(const std::vector<double>& array) {
  auto best = static_cast<std::uint32_t>(array.size());
  for (std::uint32_t a = 0; a < array.size(); ++a)
    if (!std::isnan(array[a]) && (best == array.size() || array[a] > array[best])) best = a;
  return best;
}

double accuracy(double error, const Parameters& parameters) {
  return error < parameters.epsilon_0 ? 1 : parameters.alpha * power(parameters.epsilon_0 / error, parameters.nu);
}

void update(Population& population, const RuleSet& acted, double target, const Parameters& parameters) {
  double micro = 0, fitness = 0;
  for (const std::uint32_t rule : acted) {
    micro += population.numerosity(rule);
    fitness += population.fitness[rule];
  }
  double accurate = 0;
  for (const std::uint32_t rule : acted) {
    const double rate =
        std::max(parameters.beta, 1 / ++population.experience[rule]);  // the mean, until it is as slow as beta
    const double step = target - population.prediction[rule];
    population.error[rule] += rate * (std::fabs(step) - population.error[rule]);
    const double share = parameters.gradient && fitness > 0 ? population.fitness[rule] / fitness : 1;
    population.prediction[rule] += rate * share * step;
    population.set_size[rule] += rate * (micro - population.set_size[rule]);
    accurate += accuracy(population.error[rule], parameters) * population.numerosity(rule);
  }
  for (const std::uint32_t rule : acted) {
    const double own = accuracy(population.error[rule], parameters) * population.numerosity(rule);
    population.fitness[rule] += parameters.beta * (own / accurate - population.fitness[rule]);
  }
}

}  // namespace xcs
