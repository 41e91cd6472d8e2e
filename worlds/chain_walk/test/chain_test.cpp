// The exact values against closed forms and value iteration.
#include "chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using chain_walk::Chain;

namespace {

std::vector<double> rewards(std::size_t n, std::initializer_list<std::size_t> states) {
  std::vector<double> all(n);
  for (const std::size_t s : states) all[s - 1] = 1;
  return all;
}

// What value iteration says, to rounding.
std::vector<double> by_value_iteration(const Chain& chain) {
  std::vector<double> v(chain.size()), next(chain.size());
  for (int sweep = 0; sweep < 2000; ++sweep) {
    for (std::size_t s = 0; s < v.size(); ++s) {
      const auto q = chain.action_values(s, v);
      next[s] = std::max(q[0], q[1]);
    }
    v.swap(next);
  }
  return v;
}

// The optimal policy as text: = where both actions are as good.
std::string optimal_policy(const Chain& chain) {
  const auto v = chain.optimal_values();
  std::string policy;
  for (std::size_t s = 0; s < v.size(); ++s) {
    const auto q = chain.action_values(s, v);
    policy += std::fabs(q[0] - q[1]) <= chain_walk::tie ? '=' : q[0] > q[1] ? 'L' : 'R';
  }
  return policy;
}

}  // namespace

TEST(Chain, OptimalPoliciesAreThoseOfThePaper) {
  EXPECT_EQ(optimal_policy(Chain(rewards(4, {2, 3}), 0.9, 0.9)), "RRLL");
  EXPECT_EQ(optimal_policy(Chain(rewards(20, {1, 20}), 0.9, 0.9)), std::string(10, 'L') + std::string(10, 'R'));
  const std::string half = std::string(9, 'R') + std::string(16, 'L');  // 1-9 and 10-25, the rest mirrored
  EXPECT_EQ(optimal_policy(Chain(rewards(50, {10, 41}), 0.9, 0.9)),
            half + std::string(16, 'R') + std::string(9, 'L'));
}

TEST(Chain, EqualActionsAreATie) {
  EXPECT_EQ(optimal_policy(Chain(rewards(3, {1, 3}), 0.9, 0.9)), "L=R");
  EXPECT_EQ(optimal_policy(Chain(rewards(5, {}), 0.9, 0.9)), "=====");
  EXPECT_EQ(optimal_policy(Chain(rewards(5, {2}), 0.5, 0.9)), "=====");
  EXPECT_EQ(optimal_policy(Chain(rewards(4, {1}), 0.1, 0.9)), "RRRR") << "each action does the other's work";
}

TEST(Chain, ValuesOfTwoStatesInClosedForm) {
  // Reward in state 2, always right: from either state p leads to state 2, so v1 = v2 = p / (1 - gamma).
  const Chain chain(rewards(2, {2}), 0.8, 0.9);
  const auto v = chain.optimal_values();
  EXPECT_NEAR(v[0], 0.8 / 0.1, 1e-12);
  EXPECT_NEAR(v[1], 0.8 / 0.1, 1e-12);
}

TEST(Chain, ACertainWalkIsDiscountedByItsLength) {
  // 1 at every arrival in state 5 from state s: gamma^(4 - s) / (1 - gamma), and once less far from state 5 itself.
  const Chain chain(rewards(5, {5}), 1, 0.5);
  const auto v = chain.optimal_values();
  for (int s = 1; s <= 5; ++s) EXPECT_NEAR(v[s - 1], 2 * std::pow(0.5, std::max(4 - s, 0)), 1e-14) << s;
}

TEST(Chain, PolicyIterationAndValueIterationAgree) {
  for (const double success : {0.9, 0.6, 0.3, 1.0})
    for (const std::size_t n : {2u, 4u, 20u, 50u, 77u}) {
      const Chain chain(rewards(n, {1, n / 2, n}), success, 0.95);
      const auto exact = chain.optimal_values(), iterated = by_value_iteration(chain);
      for (std::size_t s = 0; s < n; ++s) EXPECT_NEAR(exact[s], iterated[s], 1e-9) << n << " " << success << " " << s;
    }
}

TEST(Chain, ValuesOfAnyPolicySatisfyBellmansEquation) {
  const Chain chain(rewards(50, {10, 41}), 0.9, 0.9);
  std::vector<std::uint8_t> policy(50);
  for (std::size_t s = 0; s < 50; ++s) policy[s] = (s * 7 + s * s) % 3 == 0;
  std::vector<double> v(50), scratch(50);
  chain.evaluate(policy, v, scratch);
  for (std::size_t s = 0; s < 50; ++s) EXPECT_NEAR(v[s], chain.action_values(s, v)[policy[s]], 1e-12);
}
