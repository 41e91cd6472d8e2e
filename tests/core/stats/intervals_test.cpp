#include <gtest/gtest.h>

#include <core/stats/intervals.hpp>

namespace wend::core {
namespace {

// scipy 1.10.1: ci = scipy.stats.binomtest(k, n).proportion_ci(method="wilson")
TEST(Wilson, IsThatOfScipy) {
  const struct {
    std::uint64_t k, n;
    double low, high;
  } cases[] = {{0, 10, 0.0, 0.27753279986288926},
               {1, 10, 0.017876213095072896, 0.4041500267952385},
               {7, 10, 0.39677814746114526, 0.892208732593699},
               {99, 100, 0.9455138038212946, 0.9982325679358593},
               {995, 1000, 0.9883490446266248, 0.9978624644726755},
               {1000, 1000, 0.9961732415144449, 1.0},
               {0, 1, 0.0, 0.7934506856227626}};
  for (const auto& c : cases) {
    EXPECT_NEAR(wilson(c.k, c.n).low, c.low, 1e-14) << c.k << "/" << c.n;
    EXPECT_NEAR(wilson(c.k, c.n).high, c.high, 1e-14) << c.k << "/" << c.n;
  }
}

TEST(Wilson, EndsAreExact) {
  for (std::uint64_t n = 1; n < 2000; ++n) {
    EXPECT_EQ(wilson(0, n).low, 0);
    EXPECT_EQ(wilson(n, n).high, 1);
    EXPECT_GT(wilson(0, n).high, 0);
    EXPECT_LT(wilson(n, n).low, 1);
  }
}

TEST(Wilson, NoEpisodesSayNothing) {
  EXPECT_EQ(wilson(0, 0).low, 0);
  EXPECT_EQ(wilson(0, 0).high, 1);
}

}  // namespace
}  // namespace wend::core
