// Samples as a robot with six sonars collects them while it avoids obstacles: the same from each seed, everywhere.
#pragma once
#include <algorithm>
#include <memory>
#include <wend/random.hpp>

#include "basis.hpp"
#include "solver.hpp"

namespace peer {

inline constexpr double reach = 20;  // m

inline std::vector<lspi::Range> sonars() {
  return std::vector<lspi::Range>(6, {0.0, reach});
}

// From random states, one random action each: 0 brings all readings nearer, 1 and 2 those of one side farther.
inline lspi::Samples avoidance(const lspi::Basis& basis, std::size_t n, std::uint64_t seed) {
  const std::size_t m = basis.size();
  wend::Random random(seed);
  lspi::Samples all;
  all.features = m;
  all.phi.resize(n * m);
  all.next_phi.resize(n * m);
  for (std::size_t i = 0; i < n; ++i) {
    const auto action = static_cast<std::uint32_t>(random.below(3));
    double from[6], to[6], left = reach, right = reach;
    for (std::size_t k = 0; k < 6; ++k) {
      from[k] = random.uniform(0, reach);
      const double drift = action == 0 ? -0.5 : (action == 1) == (k < 3) ? 0.4 : -0.6;
      to[k] = std::clamp(from[k] + drift + random.normal(), 0.0, reach);
      (k < 3 ? left : right) = std::min(k < 3 ? left : right, to[k]);
    }
    const bool crash = std::min(left, right) < 0.2;
    basis.evaluate(from, {all.phi.data() + i * m, m});
    basis.evaluate(to, {all.next_phi.data() + i * m, m});
    all.actions.push_back(action);
    all.rewards.push_back(crash ? -100 : -0.9 * std::max(0.0, 8 - left) - 0.9 * std::max(0.0, 8 - right));
    all.terminal.push_back(crash);
  }
  return all;
}

// `ridge` for SolverOptions that adds lambda to the diagonal, as dlib does.
inline double ridge_of(const lspi::Samples& samples, std::uint32_t actions, double lambda) {
  double squares = 0;
  for (const double phi : samples.phi) squares += phi * phi;
  return lambda * static_cast<double>(actions * samples.features) / squares;
}

}  // namespace peer
