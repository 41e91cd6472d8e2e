// LSPI against dlib's, which somebody else wrote.
#include <gtest/gtest.h>

#include "avoidance.hpp"
#include "solver.hpp"
#ifdef WEND_HAVE_DLIB
#include "dlib_lspi.hpp"
#endif

TEST(Dlib, FindsTheSameWeights) {
#ifdef WEND_HAVE_DLIB
  const auto basis = lspi::powers(peer::sonars(), 4);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const lspi::Samples samples = peer::avoidance(*basis, 3000, seed);
    const lspi::SolverOptions options{3, 0.9, peer::ridge_of(samples, 3, 10), 100};
    const lspi::Solution found = lspi::solve(samples, options);
    ASSERT_TRUE(found.converged);
    ASSERT_GT(found.iterations, 2u);
    ASSERT_LT(found.condition, 1e5);
    const std::vector<double> expected = peer::dlib_lspi(samples, 3, 0.9, 10, 1e-9, 100);
    ASSERT_EQ(found.weights.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(found.weights[k], expected[k], 1e-10) << seed;
  }
#else
  GTEST_SKIP() << "dlib was not found (Debian: libdlib-dev)";
#endif
}
