#include "critic.hpp"

#include <algorithm>
#include <cmath>
#include <wend/math.hpp>

namespace lssvm {

constexpr double prior_mass = 0.05;  // of the deviation in a spread, in kernel values

Critic::Critic(const CriticSettings& settings)
    : settings_(settings), kernel_(settings.actions * settings.actions), raw_(3 * settings.actions) {
  for (std::uint32_t a = 0; a < settings.actions; ++a)
    for (std::uint32_t b = 0; b < settings.actions; ++b) {
      const double apart = between(a, b) / settings.sigma;
      kernel_[a * settings.actions + b] = wend::math::exp(-0.5 * apart * apart);
    }
}

double Critic::between(std::uint32_t a, std::uint32_t b) const noexcept {
  if (settings_.ordinal) return settings_.action_distance * (a > b ? a - b : b - a);
  return a == b ? 0 : settings_.action_distance;
}

// (s, a) as one input: an ordinal action is one coordinate more, others are corners of a simplex.
Points Critic::pairs(const Window& window) const {
  const Index more = settings_.ordinal ? 1 : settings_.actions, width = settings_.features + more;
  const double side = settings_.action_distance * std::sqrt(0.5);
  std::vector<double> all(window.size() * width);
  for (Index i = 0; i < window.size(); ++i) {
    double* row = all.data() + i * width;
    std::copy(window.state(i).begin(), window.state(i).end(), row);
    if (settings_.ordinal)
      row[settings_.features] = settings_.action_distance * window.action(i);
    else
      row[settings_.features + window.action(i)] = side;
  }
  return Points(all, width);
}

// q - caution * spread from the expansion's outputs.
void Critic::compare(std::span<const double> raw, std::span<double> out) const {
  const std::uint32_t k = settings_.actions;
  for (std::uint32_t a = 0; a < k; ++a) {
    out[a] = raw[a];
    if (settings_.caution > 0)
      out[a] -= settings_.caution * (raw[k + a] + prior_mass * deviation_) / (raw[2 * k + a] + prior_mass);
  }
}

void Critic::values(std::span<const double> state, std::span<double> q, std::span<double> spread) {
  std::fill(q.begin(), q.end(), 0.0);
  std::fill(spread.begin(), spread.end(), 0.0);
  if (!trained()) return;
  const std::uint32_t k = settings_.actions;
  expansion_.evaluate(state.data(), raw_.data(), 3 * k);
  for (std::uint32_t a = 0; a < k; ++a) {
    q[a] = raw_[a];
    spread[a] = (raw_[k + a] + prior_mass * deviation_) / (raw_[2 * k + a] + prior_mass);
  }
}

void Critic::worth(std::span<const double> state, std::span<double> out) {
  std::fill(out.begin(), out.end(), 0.0);
  if (!trained()) return;
  expansion_.evaluate(state.data(), raw_.data(), settings_.caution > 0 ? 3 * settings_.actions : settings_.actions);
  compare(raw_, out);
}

// targets[i] = r_i + gamma max_a Q(s'_i, a); values: the kernel values of each s'_i with the expansion's points.
void Critic::bootstrap(const Window& window, std::span<const double> values, Index padded,
                       std::vector<double>& targets) const {
  std::vector<double> raw(3 * settings_.actions), own(settings_.actions);
  for (Index i = 0; i < window.size(); ++i) {
    targets[i] = window.reward(i);
    if (window.terminal(i) || !trained()) continue;
    expansion_.weigh(values.data() + i * padded, raw.data(),
                     settings_.caution > 0 ? 3 * settings_.actions : settings_.actions);
    compare(raw, own);
    targets[i] += settings_.discount * *std::max_element(own.begin(), own.end());
  }
}

// The expansion of a solution: Q(s, a) = b + sum_j alpha_j k(a, a_j) k(s, s_j); the error of sample j is alpha_j / C.
void Critic::adopt(const Window& window, const Dual& dual) {
  const std::uint32_t k = settings_.actions;
  for (std::uint32_t a = 0; a < k; ++a) {
    for (Index j = 0; j < window.size(); ++j) {
      const double near = kernel_[a * k + window.action(j)];
      expansion_.set(a, j, near * dual.alpha[j]);
      expansion_.set(k + a, j, near * std::fabs(dual.alpha[j]) / settings_.c);
      expansion_.set(2 * k + a, j, near);
    }
    expansion_.set_bias(a, dual.b);
  }
}

void Critic::train(const Window& window, std::uint32_t sweeps) {
  const Index n = window.size();
  if (n == 0) return;
  Lssvm machine(pairs(window), settings_.sigma, settings_.c);
  std::vector<double> targets(n);
  Buffer values;
  const auto see_next = [&] {
    if (!trained()) return;
    values.resize(n * expansion_.padded());
    for (Index i = 0; i < n; ++i)
      if (!window.terminal(i)) expansion_.kernel(window.next(i).data(), values.data() + i * expansion_.padded());
  };
  see_next();
  bootstrap(window, values, expansion_.padded(), targets);
  Dual dual = machine.fit(targets, 1).front();
  expansion_ = Expansion(Points(window.states(), settings_.features), settings_.sigma, 3 * settings_.actions);
  for (std::uint32_t sweep = 1;; ++sweep) {
    double mean = 0, square = 0;
    for (const double target : targets) mean += target / static_cast<double>(n);
    for (const double target : targets) square += (target - mean) * (target - mean);
    deviation_ = std::sqrt(square / static_cast<double>(n));
    adopt(window, dual);
    if (sweep == sweeps) break;
    if (sweep == 1) see_next();
    bootstrap(window, values, expansion_.padded(), targets);
    dual = machine.fit(targets, 1).front();
  }
  bool finite = std::isfinite(deviation_);
  for (const double weight : dual.alpha) finite = finite && std::isfinite(weight);
  if (!finite)
    throw wend::Error(WEND_E_PARAMETER, {},
                      "training: expected finite values Q, found NaN or infinity; lower gamma, caution or the rewards");
  machine_ = std::move(machine);
  dual_ = std::move(dual);
  targets_ = std::move(targets);
  told_.reset();
}

std::optional<Training> Critic::last_training() {
  if (!machine_) return {};
  if (!told_) {
    double square = 0;
    for (const double weight : dual_.alpha) square += weight * weight;
    told_ = {machine_->residual(dual_, targets_), machine_->condition(),
             std::sqrt(square / static_cast<double>(dual_.alpha.size())) / settings_.c};
  }
  return told_;
}

void Critic::save(wend::Writer& writer) const {
  writer.put(deviation_);
  expansion_.save(writer);
}

void Critic::load(wend::Reader& reader) {
  const auto deviation = reader.get<double>();
  if (!std::isfinite(deviation) || deviation < 0) throw wend::damaged_state("a deviation is not a finite number");
  expansion_ = Expansion::load(reader, settings_.features, settings_.sigma, 3 * settings_.actions);
  deviation_ = deviation;
  machine_.reset();
  told_.reset();
}

}  // namespace lssvm
