// Networks with one hidden layer of tanh(g a) and one output, no biases: the actor's ends in tanh(g a), the critic's is
// linear.  Hidden units lie in lanes, padded with zeros that stay zero, so that the inner loops run over whole vectors.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>
#include <wend/math.hpp>
#include <wend/random.hpp>

namespace hdp {

inline constexpr std::size_t block = 8;  // lanes of a vector
inline constexpr std::size_t most_hidden = 32;

struct Network {
  std::size_t inputs = 0, hidden = 0, lanes = 0;
  std::vector<double> first;   // inputs x lanes: weight of input j to unit i at j * lanes + i
  std::vector<double> second;  // lanes

  Network() = default;
  Network(std::size_t in, std::size_t units)
      : inputs(in), hidden(units), lanes((units + block - 1) / block * block), first(in * lanes), second(lanes) {}

  // Weights uniform in [-bound, bound]: the hidden units' in order, each with its inputs, then the output's.
  void draw(wend::Random& random, double bound) {
    std::fill(first.begin(), first.end(), 0.0), std::fill(second.begin(), second.end(), 0.0);
    for (std::size_t i = 0; i < hidden; ++i)
      for (std::size_t j = 0; j < inputs; ++j) first[j * lanes + i] = random.uniform(-bound, bound);
    for (std::size_t i = 0; i < hidden; ++i) second[i] = random.uniform(-bound, bound);
  }

  // a = W1 x, of `lanes` elements.
  void weigh(std::span<const double> x, double* a) const noexcept {
    for (std::size_t i = 0; i < lanes; ++i) a[i] = 0;
    for (std::size_t j = 0; j < x.size(); ++j)
      for (std::size_t i = 0; i < lanes; ++i) a[i] += x[j] * first[j * lanes + i];
  }

  // The sum that reaches the output unit.
  double sum(std::span<const double> x, double gain) const noexcept {
    double a[most_hidden], total = 0;
    weigh(x, a);
    for (std::size_t i = 0; i < hidden; ++i) total += second[i] * wend::math::tanh(gain * a[i]);
    return total;
  }

  // W1 += s x^T.
  void add(std::span<const double> x, const double* s) noexcept {
    for (std::size_t j = 0; j < x.size(); ++j)
      for (std::size_t i = 0; i < lanes; ++i) first[j * lanes + i] += x[j] * s[i];
  }

  double norm() const noexcept {
    double total = 0;
    for (const double w : first) total += w * w;
    for (const double w : second) total += w * w;
    return wend::math::sqrt(total);
  }

  bool finite() const noexcept {
    double total = 0;
    for (const double w : first) total += w * 0;
    for (const double w : second) total += w * 0;
    return total == 0;
  }

  // The lanes beyond the hidden units hold nothing.
  bool padded_with_zeros() const noexcept {
    for (std::size_t j = 0; j <= inputs; ++j)
      for (std::size_t i = hidden; i < lanes; ++i)
        if ((j < inputs ? first[j * lanes + i] : second[i]) != 0) return false;
    return true;
  }

  // "hidden weight (unit 2, input 3)" of the first weight that is not finite.
  std::string where_not_finite() const {
    for (std::size_t i = 0; i < hidden; ++i)
      for (std::size_t j = 0; j < inputs; ++j)
        if (!std::isfinite(first[j * lanes + i]))
          return "hidden weight (unit " + std::to_string(i) + ", input " + std::to_string(j) + ")";
    for (std::size_t i = 0; i < hidden; ++i)
      if (!std::isfinite(second[i])) return "output weight (unit " + std::to_string(i) + ")";
    return "no weight";
  }
};

// u of the actor, in [-1, 1].
inline double actor_output(const Network& actor, std::span<const double> x, double gain) noexcept {
  return wend::math::tanh(gain * actor.sum(x, gain));
}

// (18): the discrete action of u among those for u > 0, u = 0 and u < 0.
inline double action_of(double u, const double (&actions)[3]) noexcept {
  return actions[u > 0 ? 0 : u < 0 ? 2 : 1];
}

}  // namespace hdp
