// The chain as a Markov decision process whose values are known exactly.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace chain_walk {

enum Action : std::uint32_t { left = 0, right = 1 };

// States are 0..n-1 here.
class Chain {
 public:
  Chain(std::vector<double> rewards, double success, double discount);

  std::size_t size() const noexcept { return rewards_.size(); }
  double reward(std::size_t arrived_in) const noexcept { return rewards_[arrived_in]; }
  double success() const noexcept { return success_; }

  // Where a step in direction `towards` leads; the ends are walls.
  std::size_t neighbour(std::size_t state, Action towards) const noexcept {
    if (towards == left) return state == 0 ? 0 : state - 1;
    return state + 1 == size() ? state : state + 1;
  }

  // The values of a policy, exactly but for rounding: v (I - gamma P) = P r is tridiagonal and diagonally dominant.
  // `v` and `scratch` have size() elements.
  void evaluate(std::span<const std::uint8_t> policy, std::span<double> v, std::span<double> scratch) const noexcept;

  // Of both actions in `state`, where v is worth the states.
  std::array<double, 2> action_values(std::size_t state, std::span<const double> v) const noexcept;

  // The optimal values, by policy iteration (Howard 1960).
  std::vector<double> optimal_values() const;

 private:
  std::vector<double> rewards_;
  double success_, discount_;
};

// Actions whose values differ by less are equally good: far above rounding, far below any difference that matters.
inline constexpr double tie = 1e-10;

}  // namespace chain_walk
