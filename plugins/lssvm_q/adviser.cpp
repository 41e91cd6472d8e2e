#include "adviser.hpp"

#include <algorithm>

namespace lssvm {

std::uint32_t Adviser::advise(std::span<const double> state) {
  expansion_.evaluate(state.data(), scores_.data(), actions_);
  return static_cast<std::uint32_t>(std::max_element(scores_.begin(), scores_.end()) - scores_.begin());
}

void Adviser::train(const Window& window) {
  const Index n = window.size();
  if (n == 0) return;
  const Points states(window.states(), features_);
  std::vector<double> targets(n * actions_);
  for (std::uint32_t a = 0; a < actions_; ++a)
    for (Index i = 0; i < n; ++i) targets[a * n + i] = window.action(i) == a ? 1 : -1;
  const std::vector<Dual> duals = Lssvm(states, sigma_, c_).fit(targets, actions_);
  expansion_ = Expansion(states, sigma_, actions_);
  for (std::uint32_t a = 0; a < actions_; ++a) {
    for (Index i = 0; i < n; ++i) expansion_.set(a, i, duals[a].alpha[i]);
    expansion_.set_bias(a, duals[a].b);
  }
}

}  // namespace lssvm
