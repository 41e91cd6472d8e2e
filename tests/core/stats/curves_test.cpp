#include <gtest/gtest.h>

#include <cmath>
#include <core/stats/curves.hpp>
#include <limits>

namespace wend::core {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Aggregate, MeansOfEqualX) {
  const Json found = aggregate({{{1, 0.5}, {2, 1}}, {{1, 0.25}, {2, 2}}, {{1, 0}, {2, 3}}});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0][0], 1);
  EXPECT_EQ(found[0][1], 0.25);
  EXPECT_EQ(found[0][2], 0);  // three seeds all alike are drawn in 1 of 27 repetitions: the range is the interval
  EXPECT_EQ(found[0][3], 0.5);
  EXPECT_EQ(found[1][1], 2);
}

TEST(Aggregate, DifferentXAreUnitedAndTheLastValueIsCarried) {
  const Json found = aggregate({{{1, 10}, {4, 40}}, {{2, 20}, {3, 30}}});
  const double expected[][2] = {{1, 10}, {2, 15}, {3, 20}, {4, 35}};
  ASSERT_EQ(found.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(found[i][0], expected[i][0]);
    EXPECT_EQ(found[i][1], expected[i][1]);
  }
}

TEST(Aggregate, TheLastOfEqualXCountsAndOrderDoesNotMatter) {
  EXPECT_EQ(aggregate({{{3, 7}, {1, 5}, {3, 8}}}), aggregate({{{1, 5}, {3, 8}}}));
  EXPECT_EQ(aggregate({{{1, 5}, {3, 8}}}), Json::parse("[[1.0,5.0,5.0,5.0],[3.0,8.0,8.0,8.0]]"));
}

TEST(Aggregate, NothingThatIsNotFiniteComesOut) {
  EXPECT_EQ(aggregate({{{1, nan}, {nan, 2}, {infinity, 3}, {2, infinity}}, {}}), Json::array());
  EXPECT_EQ(aggregate({{{1, nan}, {2, 0.5}}, {{1, 1.5}}}), Json::parse("[[1.0,1.5,1.5,1.5],[2.0,1.0,0.5,1.5]]"));
  EXPECT_EQ(aggregate({{{1, 1e308}}, {{1, 1.7e308}}}), Json::array());  // a mean beyond double
}

TEST(Aggregate, AShareHasWilsonsBand) {
  std::vector<Points> seeds;
  for (int i = 0; i < 10; ++i) seeds.push_back({{0, 0}, {1, i < 7 ? 1 : 0}});
  const Json found = aggregate(seeds);
  EXPECT_EQ(found[0][3], wilson(0, 10).high);
  EXPECT_EQ(found[1][1], 0.7);
  EXPECT_EQ(found[1][2], wilson(7, 10).low);
  EXPECT_EQ(found[1][3], wilson(7, 10).high);
}

TEST(Aggregate, ALongUnionIsThinnedAndKeepsItsEnds) {
  Points points;
  for (int i = 0; i < 12345; ++i) points.emplace_back(i, i % 2 + 0.5);
  const Json found = aggregate({points});
  EXPECT_EQ(found.size(), most_curve_points);
  EXPECT_EQ(found[0][0], 0);
  EXPECT_EQ(found[most_curve_points - 1][0], 12344);
}

TEST(Aggregate, TheBandIsTheBootstrapOverSeeds) {
  std::vector<Points> seeds;
  std::vector<Measurement> values;
  for (std::uint32_t i = 0; i < 10; ++i) {
    const double y = i * i % 7 / 3.0;
    seeds.push_back({{5, y}});
    values.push_back({y, i});
  }
  const Json found = aggregate(seeds, {20'000, 0});
  const Interval expected = bootstrap({10}, {values}, Centre::mean, {20'000, 0})[0].value();
  EXPECT_NEAR(found[0][2].get<double>(), expected.low, 1e-12);
  EXPECT_NEAR(found[0][3].get<double>(), expected.high, 1e-12);
}

}  // namespace
}  // namespace wend::core
