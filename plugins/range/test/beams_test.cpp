// The layout of axes and cones.
#include "../beams.hpp"

#include <gtest/gtest.h>

#include <wend/math.hpp>

TEST(Spread, FullCircleStartsAheadAndTurnsLeft) {
  EXPECT_EQ(range::spread_deg(8, 360), (std::vector<double>{0, 45, 90, 135, -180, -135, -90, -45}));
}

TEST(Spread, PartOfACircleRunsFromLeftToRightWithBothEnds) {
  EXPECT_EQ(range::spread_deg(5, 180), (std::vector<double>{90, 45, 0, -45, -90}));
  EXPECT_EQ(range::spread_deg(1, 90), std::vector<double>{0});
}

TEST(Cone, CoversItsWidthWithBothEdges) {
  EXPECT_EQ(range::cone_deg(30, 7), (std::vector<double>{-15, -10, -5, 0, 5, 10, 15}));
  EXPECT_EQ(range::cone_deg(0, 7), std::vector<double>{0});
  EXPECT_EQ(range::cone_deg(30, 1), std::vector<double>{0});
}

TEST(Beams, BearingsAreWrappedAndEachAxisHasItsCone) {
  const range::Beams beams({0, 180, 270, -75}, 30, 3);
  EXPECT_EQ(beams.axes(), 4u);
  EXPECT_EQ(beams.rays_per_axis(), 3u);
  EXPECT_EQ(beams.bearing(1), -wend::math::pi);
  EXPECT_EQ(beams.bearing(2), -wend::math::half_pi);
  EXPECT_NEAR(beams.rays()[2].bearing, 15 * wend::math::degree, 1e-15);
  EXPECT_NEAR(beams.rays()[5].bearing, -165 * wend::math::degree, 1e-15);
  EXPECT_NEAR(beams.rays()[9].sin, -1, 1e-15);
}

TEST(Beams, FingerprintTellsLayoutsApart) {
  EXPECT_EQ(range::Beams({0, 10}, 0, 1).fingerprint(), range::Beams({0, 10}, 0, 7).fingerprint());
  EXPECT_NE(range::Beams({0, 10}, 0, 1).fingerprint(), range::Beams({10, 0}, 0, 1).fingerprint());
  EXPECT_NE(range::Beams({0, 10}, 20, 7).fingerprint(), range::Beams({0, 10}, 0, 7).fingerprint());
}
