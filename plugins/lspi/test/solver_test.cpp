// LSPI against the same thing written naively: full vectors phi(s, a), one dense system, no blocks.
#include "solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <wend/random.hpp>

#include "chain_walk.hpp"

namespace {

lspi::Samples random_samples(std::size_t n, std::size_t features, std::uint32_t actions, std::uint64_t seed) {
  wend::Random random(seed);
  lspi::Samples all;
  all.features = features;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < features; ++k) {
      all.phi.push_back(k == 0 ? 1 : random.uniform(-1, 1));
      all.next_phi.push_back(k == 0 ? 1 : random.uniform(-1, 1));
    }
    all.actions.push_back(static_cast<std::uint32_t>(random.below(actions)));
    all.rewards.push_back(random.normal());
    all.terminal.push_back(random.chance(0.1));
  }
  return all;
}

// phi(s, a), K m values.
Eigen::VectorXd whole(const double* phi, std::size_t m, std::uint32_t action, std::uint32_t actions) {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(static_cast<long>(m * actions));
  for (std::size_t k = 0; k < m; ++k) all[static_cast<long>(action * m + k)] = phi[k];
  return all;
}

struct Naive {
  Eigen::VectorXd w;
  std::uint32_t iterations = 0;
  std::vector<Eigen::VectorXd> trail;  // w of every iteration
  std::vector<std::size_t> changes;    // in how many samples its improvement changed the policy
};

Naive naive_lspi(const lspi::Samples& samples, const lspi::SolverOptions& options) {
  const std::size_t m = samples.features;
  const auto size = static_cast<long>(m * options.actions);
  Naive found{Eigen::VectorXd::Zero(size), 0, {}, {}};
  const auto best = [&](std::size_t i) {
    std::uint32_t action = 0;
    for (std::uint32_t a = 1; a < options.actions; ++a)
      if (whole(&samples.next_phi[i * m], m, a, options.actions).dot(found.w) >
          whole(&samples.next_phi[i * m], m, action, options.actions).dot(found.w))
        action = a;
    return action;
  };
  std::vector<std::uint32_t> policy(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) policy[i] = best(i);
  while (found.iterations++ < options.iterations) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(size);
    double square = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto phi = whole(&samples.phi[i * m], m, samples.actions[i], options.actions);
      Eigen::VectorXd next = whole(&samples.next_phi[i * m], m, policy[i], options.actions);
      if (samples.terminal[i]) next.setZero();
      a += phi * (phi - options.discount * next).transpose();
      b += phi * samples.rewards[i];
      square += phi.squaredNorm();
    }
    a.diagonal().array() += options.ridge * square / static_cast<double>(size);
    found.w = a.fullPivLu().solve(b);
    const auto before = policy;
    found.trail.push_back(found.w);
    found.changes.push_back(0);
    for (std::size_t i = 0; i < samples.size(); ++i) found.changes.back() += (policy[i] = best(i)) != before[i];
    if (policy == before) break;
  }
  return found;
}

}  // namespace

TEST(Solver, AgreesWithTheNaiveOne) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const auto actions = static_cast<std::uint32_t>(2 + seed % 3);
    const lspi::Samples samples = random_samples(700, 6, actions, seed);
    const lspi::SolverOptions options{actions, 0.9, seed % 2 ? 1e-3 : 0, 20};
    const lspi::Solution found = lspi::solve(samples, options);
    const Naive expected = naive_lspi(samples, options);
    EXPECT_EQ(found.iterations, expected.iterations);
    EXPECT_GT(found.iterations, 2u) << "no policy was improved";
    EXPECT_TRUE(found.converged);
    EXPECT_EQ(found.rank, 6 * actions);
    EXPECT_LT(found.residual, 1e-12);
    ASSERT_EQ(found.weights.size(), 6 * actions);
    for (std::size_t k = 0; k < found.weights.size(); ++k)
      EXPECT_NEAR(found.weights[k], expected.w[static_cast<long>(k)], 1e-10) << seed << " " << k;
  }
}

TEST(Solver, ConditionIsThatOfTheMatrix) {  // diag(1, 1e-4) in the end: both samples are terminal
  lspi::Samples samples{2, {1, 0, 0, 1e-2}, {0, 0, 0, 0}, {0, 0}, {3, 5}, {1, 1}};
  const lspi::Solution found = lspi::solve(samples, {1, 0.9, 0, 20});
  EXPECT_NEAR(found.condition, 1e4, 1e-6);
  EXPECT_NEAR(found.weights[0], 3, 1e-12);
  EXPECT_NEAR(found.weights[1], 500, 1e-9);
}

TEST(Solver, StopsAtTheCap) {
  const lspi::Solution found = lspi::solve(random_samples(700, 6, 3, 1), {3, 0.9, 0, 1});
  EXPECT_EQ(found.iterations, 1u);
  EXPECT_FALSE(found.converged);
}

// Q(s', 0) = 1.  The policy that takes action 1 in s' = 4 s makes w_1 = 1 / (1 - 0.5 * 4) = -1, worse than action 0;
// the one that takes action 0 makes it 1 + 0.5 * 4 * 1 = 3, better: each is the other's improvement, for ever.
TEST(Solver, KeepsTheSteadiestPolicyOfACycle) {
  lspi::Samples samples{1, {1, 1}, {0, 4}, {0, 1}, {1, 1}, {1, 0}};
  for (const std::uint32_t cap : {3u, 10u, 20u, 21u}) {
    const lspi::Solution found = lspi::solve(samples, {2, 0.5, 0, cap});
    EXPECT_FALSE(found.converged);
    EXPECT_EQ(found.iterations, cap);
    EXPECT_EQ(found.weights, (std::vector<double>{1, 3})) << "the third iteration's, as both change one sample";
  }
}

TEST(Solver, KeepsThePolicyThatItsImprovementChangesLeast) {
  int cycles = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const lspi::Samples samples = random_samples(30, 3, 3, seed);
    const lspi::SolverOptions options{3, 0.99, 0, 20};
    const Naive naive = naive_lspi(samples, options);
    if (naive.changes.back() == 0) continue;
    const auto best = std::min_element(naive.changes.begin() + 2, naive.changes.end());
    cycles += *best < naive.changes.back();
    const lspi::Solution found = lspi::solve(samples, options);
    EXPECT_FALSE(found.converged);
    for (std::size_t k = 0; k < found.weights.size(); ++k)
      EXPECT_NEAR(found.weights[k], naive.trail[best - naive.changes.begin()][static_cast<long>(k)], 1e-8)
          << seed << " " << k;
  }
  EXPECT_GE(cycles, 10) << "too few of them end on a policy that changes more";
}

TEST(Solver, StartsFromTheGivenWeights) {
  const lspi::Samples samples = random_samples(700, 6, 3, 1);
  const lspi::SolverOptions options{3, 0.9, 0, 20};
  const lspi::Solution first = lspi::solve(samples, options);
  const lspi::Solution again = lspi::solve(samples, options, first.weights);
  EXPECT_EQ(again.iterations, 1u);
  for (std::size_t k = 0; k < first.weights.size(); ++k) EXPECT_NEAR(again.weights[k], first.weights[k], 1e-11);
}

TEST(Solver, GivesTheSameBitsTwice) {
  const lspi::Samples samples = random_samples(3000, 11, 3, 5);
  const lspi::Samples elsewhere = samples;
  const lspi::SolverOptions options{3, 0.9, 1e-3, 20};
  EXPECT_EQ(lspi::solve(samples, options).weights, lspi::solve(elsewhere, options).weights);
}

TEST(Solver, TooFewSamplesStayFinite) {
  lspi::Samples samples = random_samples(8, 6, 3, 3);  // 8 samples for 18 weights
  samples.terminal.assign(8, 1);
  const lspi::Solution found = lspi::solve(samples, {3, 0.9, 0, 20});
  EXPECT_EQ(found.rank, 8u);
  EXPECT_GT(found.condition, 1e12);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_NEAR(lspi::value({samples.phi.data() + 6 * i, 6}, found.weights, samples.actions[i]), samples.rewards[i],
                1e-8);
}

TEST(Solver, AnActionThatWasNeverTriedIsWorthNothing) {
  lspi::Samples samples = random_samples(300, 4, 2, 3);
  const lspi::Solution found = lspi::solve(samples, {3, 0.9, 0, 20});
  EXPECT_EQ(found.rank, 8u);
  for (std::size_t k = 0; k < 8; ++k) EXPECT_TRUE(std::isfinite(found.weights[k]));
  for (std::size_t k = 8; k < 12; ++k) EXPECT_NEAR(found.weights[k], 0, 1e-12);
}

TEST(Solver, ARidgeMakesAnySamplesSolvable) {
  const lspi::Solution found = lspi::solve(random_samples(5, 6, 3, 3), {3, 0.9, 1e-3, 20});
  EXPECT_LT(found.condition, 1e6);
  EXPECT_LT(found.rank, 18u);
  EXPECT_LT(found.residual, 1e-12);
}

TEST(Greedy, IsTheFirstOfEquals) {
  const std::vector<double> phi{1, 2}, equal{1, 1, 3, 0, 1, 1}, third{0, 0, 1, 0, 0, 1};
  EXPECT_EQ(lspi::greedy(phi, equal, 3), 0u);
  EXPECT_EQ(lspi::greedy(phi, third, 3), 2u);
}

// Lagoudakis & Parr (2003), section 9.1.
TEST(ChainWalk, OfFourStatesIsSolvedByEveryRun) {
  const ChainWalk chain{{0, 1, 1, 0}};
  ASSERT_EQ(chain.best_actions(), (std::vector<int>{1, 1, 0, 0}));
  EXPECT_EQ(chain.optimal_runs(2, 1000, 20), 20);
}

TEST(ChainWalk, OfTwentyStatesIsSolvedByNearlyEveryRun) {
  ChainWalk chain{std::vector<double>(20, 0)};
  chain.reward.front() = chain.reward.back() = 1;
  EXPECT_GE(chain.optimal_runs(4, 5000, 20), 19);
}
