// The goal sensor through its C table.
#include <gtest/gtest.h>

#include <wend/math.hpp>
#include <wend/testing_plane.hpp>

using wend::testing::Bench;
using wend::testing::Plane;

namespace {

constexpr double pi = wend::math::pi;

std::vector<double> seen(const wend_motion& from, const wend_disc& goal) {
  Plane plane;
  plane->motions[0] = from;
  plane->goals[0] = goal;
  Bench sensor(*wend_plugin_1.components[0]);
  EXPECT_TRUE(sensor.use("world", plane.ref()).create()) << sensor.error();
  sensor.begin(1);
  return sensor.sense();
}

}  // namespace

TEST(Goal, DistanceAndBearingRelativeToTheHeading) {
  const auto ahead = seen({1, 1, pi / 2, 0, 0}, {1, 5, 0.7});
  EXPECT_EQ(ahead[0], 4);
  EXPECT_NEAR(ahead[1], 0, 1e-15);
  EXPECT_EQ(ahead[2], 0.7);
  const auto left = seen({0, 0, 0.2, 0, 0}, {-3, 4, 1});
  EXPECT_EQ(left[0], 5);
  EXPECT_NEAR(left[1], 2.214297435588181 - 0.2, 1e-15);
}

TEST(Goal, BearingStaysBelowPi) {
  EXPECT_EQ(seen({0, 0, 0, 0, 0}, {-2, 0, 1})[1], -pi);
  // atan2(0.1, -1) = 3.0419, less -3 is 6.0419, less a turn is -0.2413
  EXPECT_NEAR(seen({0, 0, -3, 0, 0}, {-1, 0.1, 1})[1], -0.2412613060809, 1e-12);
}

TEST(Goal, BearingIsZeroOnTheGoal) {
  EXPECT_EQ(seen({3, 4, 1, 0, 0}, {3, 4, 1}), (std::vector<double>{0, 0, 1}));
}

TEST(Goal, FollowsAGoalThatMoves) {
  Plane plane;
  Bench sensor(*wend_plugin_1.components[0]);
  ASSERT_TRUE(sensor.use("world", plane.ref()).create());
  sensor.begin(1);
  EXPECT_EQ(sensor.sense()[0], 10);
  plane->goals[0].x = 7;
  EXPECT_EQ(sensor.sense()[0], 7);
}

TEST(Goal, WithDriftItIsSeenFromTheBelievedPose) {
  Plane plane;
  Bench exact(*wend_plugin_1.components[0]), drifting(*wend_plugin_1.components[0]);
  ASSERT_TRUE(exact.use("world", plane.ref()).create());
  ASSERT_TRUE(drifting.use("world", plane.ref()).set("drift/scale", 0.1).create());
  exact.begin(4), drifting.begin(4);
  EXPECT_EQ(exact.sense(), drifting.sense()) << "the start is known";
  plane->motions[0].x = 2;
  const double scale =
      1 + 0.1 * wend::Random(wend::stream(wend::stream(4, std::uint64_t{0}), "wend.odometry")).normal();
  EXPECT_EQ(exact.sense()[0], 8);
  EXPECT_NEAR(drifting.sense()[0], 10 - 2 * scale, 1e-12);
}
