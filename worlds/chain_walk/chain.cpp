#include "chain.hpp"

#include <utility>

namespace chain_walk {

Chain::Chain(std::vector<double> rewards, double success, double discount)
    : rewards_(std::move(rewards)), success_(success), discount_(discount) {}

// Row s: v[s] - gamma (p v[s - 1] + q v[s + 1]) = p r[s - 1] + q r[s + 1], where the policy goes left with p and right
// with q = 1 - p, and a wall's share falls on s itself.  Thomas' elimination; `above` is what is left of the upper
// diagonal.
void Chain::evaluate(std::span<const std::uint8_t> policy, std::span<double> v,
                     std::span<double> above) const noexcept {
  const std::size_t n = size();
  for (std::size_t s = 0; s < n; ++s) {
    const double q = policy[s] == right ? success_ : 1 - success_, p = 1 - q;
    const double stays = (s == 0 ? p : 0) + (s + 1 == n ? q : 0);
    const double lower = s == 0 ? 0 : -discount_ * p, upper = s + 1 == n ? 0 : -discount_ * q;
    const double constant = p * reward(neighbour(s, left)) + q * reward(neighbour(s, right));
    const double pivot = 1 - discount_ * stays - (s == 0 ? 0 : lower * above[s - 1]);
    above[s] = upper / pivot;
    v[s] = (constant - (s == 0 ? 0 : lower * v[s - 1])) / pivot;
  }
  for (std::size_t s = n - 1; s-- > 0;) v[s] -= above[s] * v[s + 1];
}

std::array<double, 2> Chain::action_values(std::size_t state, std::span<const double> v) const noexcept {
  const std::size_t l = neighbour(state, left), r = neighbour(state, right);
  const double to_left = reward(l) + discount_ * v[l], to_right = reward(r) + discount_ * v[r];
  return {success_ * to_left + (1 - success_) * to_right, success_ * to_right + (1 - success_) * to_left};
}

std::vector<double> Chain::optimal_values() const {
  std::vector<double> v(size()), scratch(size());
  std::vector<std::uint8_t> policy(size(), left);
  bool changed = true;
  while (changed) {  // each change raises a value by more than `tie`, so it ends
    evaluate(policy, v, scratch);
    changed = false;
    for (std::size_t s = 0; s < size(); ++s) {
      const auto q = action_values(s, v);
      if (q[1 - policy[s]] <= q[policy[s]] + tie) continue;
      policy[s] = static_cast<std::uint8_t>(1 - policy[s]);
      changed = true;
    }
  }
  return v;
}

}  // namespace chain_walk
