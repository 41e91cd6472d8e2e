// The chain walk of Koller & Parr (2000): actions left and right succeed with probability 0.9 and else go the other
// way.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>
#include <wend/random.hpp>

#include "basis.hpp"
#include "solver.hpp"

struct ChainWalk {
  std::vector<double> reward;  // of being in a state
  double discount = 0.9;

  int states() const { return static_cast<int>(reward.size()); }
  int after(int state, int direction) const { return std::clamp(state + direction, 0, states() - 1); }

  double value_of(const std::vector<double>& value, int state, int action) const {
    const int intended = action == 0 ? -1 : 1;
    const auto worth = [&](int next) { return reward[next] + discount * value[next]; };
    return 0.9 * worth(after(state, intended)) + 0.1 * worth(after(state, -intended));
  }
  // By value iteration, exact to 1e-40.
  std::vector<int> best_actions() const {
    std::vector<double> value(states(), 0);
    for (int sweep = 0; sweep < 1000; ++sweep) {
      std::vector<double> next(states());
      for (int s = 0; s < states(); ++s) next[s] = std::max(value_of(value, s, 0), value_of(value, s, 1));
      value = next;
    }
    std::vector<int> best(states());
    for (int s = 0; s < states(); ++s) best[s] = value_of(value, s, 1) > value_of(value, s, 0);
    return best;
  }

  // A walk of random actions from a random state.
  lspi::Samples walk(const lspi::Basis& basis, std::size_t n, std::uint64_t seed) const {
    wend::Random random(seed);
    lspi::Samples all;
    all.features = basis.size();
    all.phi.resize(n * basis.size());
    all.next_phi.resize(n * basis.size());
    int s = static_cast<int>(random.below(states()));
    for (std::size_t i = 0; i < n; ++i) {
      const auto action = static_cast<std::uint32_t>(random.below(2));
      const int intended = action == 0 ? -1 : 1;
      const int next = after(s, random.chance(0.9) ? intended : -intended);
      const double from = s, to = next;
      basis.evaluate({&from, 1}, {all.phi.data() + i * basis.size(), basis.size()});
      basis.evaluate({&to, 1}, {all.next_phi.data() + i * basis.size(), basis.size()});
      all.actions.push_back(action);
      all.rewards.push_back(reward[next]);
      all.terminal.push_back(0);
      s = next;
    }
    return all;
  }

  std::vector<int> greedy_actions(const lspi::Basis& basis, const std::vector<double>& weights) const {
    std::vector<int> all;
    std::vector<double> features(basis.size());
    for (int s = 0; s < states(); ++s) {
      const double state = s;
      basis.evaluate({&state, 1}, features);
      all.push_back(static_cast<int>(lspi::greedy(features, weights, 2)));
    }
    return all;
  }
  // In how many of `runs` random walks of n steps LSPI finds an optimal policy.
  int optimal_runs(std::size_t degree, std::size_t n, int runs) const {
    const auto basis = lspi::powers({{0.0, states() - 1.0}}, degree);
    int optimal = 0;
    for (int run = 0; run < runs; ++run) {
      const auto found = lspi::solve(walk(*basis, n, wend::stream(2003, std::uint64_t(run))), {2, discount, 0, 20});
      optimal += greedy_actions(*basis, found.weights) == best_actions();
    }
    return optimal;
  }
};
