// Least-squares policy iteration over a fixed set of samples (Lagoudakis & Parr 2003, figures 5 and 8).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace lspi {

struct Samples {
  std::size_t features = 0;            // m
  std::vector<double> phi, next_phi;   // L x m, row-major: phi(s), phi(s')
  std::vector<std::uint32_t> actions;  // L
  std::vector<double> rewards;         // L
  std::vector<std::uint8_t> terminal;  // L: 1 where nothing follows s'
  std::size_t size() const noexcept { return actions.size(); }
};

struct SolverOptions {
  std::uint32_t actions = 0;      // number of actions K
  double discount = 0.9;          // gamma
  double ridge = 1e-3;            // added to A's diagonal, as a share of the mean diagonal of Phi^T Phi
  std::uint32_t iterations = 20;  // at most
};

struct Solution {
  std::vector<double> weights;  // K x m, row-major: Q(s, a) = phi(s) . weights[a]
  std::uint32_t iterations = 0;
  bool converged = false;  // the greedy actions in all s' stopped changing: the weights are those of their own policy;
                           // if not, they are those of the iteration after which the fewest of these actions changed
  double residual = 0;     // |A w - b| / |b| of the system that gave the weights
  double condition = 0;    // estimate of A's condition number (1-norm)
  std::uint32_t rank = 0;  // of Phi: how many of the K m weights the samples determine without a ridge
};

// Q(s, action).
inline double value(std::span<const double> features, std::span<const double> weights, std::uint32_t action) noexcept {
  double q = 0;
  for (std::size_t i = 0; i < features.size(); ++i) q += features[i] * weights[action * features.size() + i];
  return q;
}

// The action of the largest Q value, the first of equals.
std::uint32_t greedy(std::span<const double> features, std::span<const double> weights, std::uint32_t actions) noexcept;

// Starts from `weights` (zero: the greedy action is the first one everywhere).
Solution solve(const Samples& samples, const SolverOptions& options, std::vector<double> weights = {});

}  // namespace lspi
