// Goal-direct: gets there on an empty plane with every kind of action, and not through an obstacle.
#include <gtest/gtest.h>

#include <cmath>
#include <wend/testing_plane.hpp>

using wend::testing::Bench;
using wend::testing::error_of;
using wend::testing::Plane;

namespace {

struct Policy : Bench {
  wend::Columns eyes;
  explicit Policy(Plane& plane) : Bench(*wend_plugin_1.components[1]) {
    eyes.box("goal.distance", "m").box("goal.bearing", "rad").box("goal.radius", "m");
    observation(eyes).action(plane->actions()).set("goal", "goal").use("world", plane.ref());
  }
};

// Drives until the episode ends; the flags.
std::uint32_t drive(Plane& plane, Policy& policy, double seconds) {
  plane->time_limit = seconds;
  const std::uint32_t copy = 0;
  std::vector<wend_outcome> outcome(1);
  while (outcome[0].flags == 0) {
    const auto& me = plane->motions[0];
    const auto& goal = plane->goals[0];
    const double bearing = wend::math::wrap_angle(wend::math::atan2(goal.y - me.y, goal.x - me.x) - me.heading);
    const auto action = policy.act({1, bearing, 1});
    plane->step(wend::Rows(&copy, 1), wend::Matrix<const double>(action.data(), 1, action.size()), outcome);
  }
  return outcome[0].flags;
}

}  // namespace

TEST(GoalDirect, ReachesAGoalBehindItWithAUnicycle) {
  Plane plane;
  plane->body.turn_rate = 1;
  plane->goals[0] = {-5, 1, 0.2};
  plane->speed_and_turn_rate();
  Policy policy(plane);
  ASSERT_TRUE(policy.create()) << policy.error();
  EXPECT_EQ(drive(plane, policy, 12), WEND_TERMINATED | WEND_ARRIVED);
}

TEST(GoalDirect, ReachesItWithSluggishWheels) {
  Plane plane;
  plane->body.acceleration = 1, plane->body.turn_acceleration = 2, plane->body.turn_rate = 2;
  plane->goals[0] = {-5, 1, 0.2};
  Policy policy(plane);
  ASSERT_TRUE(policy.create());
  EXPECT_EQ(drive(plane, policy, 12), WEND_TERMINATED | WEND_ARRIVED);
}

TEST(GoalDirect, ReachesItWithThreeActionsAndATurnRadiusOfThree) {
  Plane plane;
  plane->dt = 1;
  plane->action_table({{0.5, 0}, {0.25, 1.0 / 12}, {0.25, -1.0 / 12}});
  plane->goals[0] = {-30, 10, 3};
  Policy policy(plane);
  ASSERT_TRUE(policy.create());
  EXPECT_EQ(drive(plane, policy, 200), WEND_TERMINATED | WEND_ARRIVED);
}

TEST(GoalDirect, IsBlindToObstacles) {
  Plane plane;
  plane->obstacles = {{5, 0, 1}};
  Policy policy(plane);
  ASSERT_TRUE(policy.create());
  EXPECT_EQ(drive(plane, policy, 100), WEND_TERMINATED | WEND_COLLIDED);
}

TEST(GoalDirect, KeepsTheSpeedItIsGiven) {
  Plane plane;
  Policy policy(plane);
  ASSERT_TRUE(policy.set("speed", 0.25).create());
  EXPECT_EQ(policy.act({9, 0, 1}), (std::vector<double>{0.25, 0}));
  EXPECT_EQ(policy.act({9, 2, 1})[0], 0) << "turns in place";
}

TEST(GoalDirect, ASpeedWithoutBoundMustBeGiven) {
  Plane plane;
  plane->body.speed_high = std::numeric_limits<double>::infinity();
  plane->speed_and_turn_rate();
  Policy policy(plane);
  EXPECT_FALSE(policy.create());
  EXPECT_EQ(policy.parameter(), "speed");
  EXPECT_EQ(policy.error(), "expected a speed, since neither the body nor the action space bounds it; found none");
  EXPECT_TRUE(policy.set("speed", 2).create());
}

TEST(GoalDirect, RefusesNaNAndAMissingGoal) {
  Plane plane;
  Policy policy(plane);
  ASSERT_TRUE(policy.create());
  EXPECT_EQ(error_of([&] {
              policy.act({1, std::nan(""), 1});
            }),
            "observation \"goal.bearing\": expected a finite number, found NaN");
  EXPECT_FALSE(policy.set("goal", "target").create());
  EXPECT_EQ(policy.error(),
            "no column fits \"target.bearing\"; the columns are goal.distance, goal.bearing, goal.radius");
}
