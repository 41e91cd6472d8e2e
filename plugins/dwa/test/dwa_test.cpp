// The policy through its C table, alone and driving in a plane of discs.
#include <gtest/gtest.h>

#include <cmath>
#include <wend/testing_plane.hpp>

using wend::testing::Bench;
using wend::testing::error_of;
using wend::testing::Plane;

namespace {

constexpr int beams = 36;
constexpr double reach = 5;

struct Policy : Bench {
  wend::Columns eyes;
  explicit Policy(Plane& plane, std::uint32_t copies = 1) : Bench(*wend_plugin_1.components[0]) {
    eyes.box("goal.distance", "m").box("goal.bearing", "rad").box("pose.speed", "m/s").box("pose.turn_rate", "rad/s");
    for (int i = 0; i < beams; ++i)
      eyes.box("sonar.range." + std::to_string(i), "m", 0, reach, wend::math::wrap_angle(i * 10 * wend::math::degree));
    observation(eyes).action(plane->actions()).use("world", plane.ref()).Bench::copies(copies);
    set("observe", {"sonar.range.*"}).set("from", "rim").set("goal", "goal").set("pose", "pose").set("margin", 0.05);
    set("look_ahead", 2).set("alpha", 0.8).set("beta", 0.8).set("gamma", 0.2).set("v_samples", 11).set("w_samples", 21);
    set("recover_distance", 0);
  }
};

std::vector<double> observe(Plane& plane, std::uint32_t row) {
  const wend_motion me = plane->motions[row];
  const wend_disc goal = plane->goals[row];
  std::vector<double> all{std::hypot(goal.x - me.x, goal.y - me.y),
                          wend::math::wrap_angle(wend::math::atan2(goal.y - me.y, goal.x - me.x) - me.heading),
                          me.speed, me.turn_rate};
  for (int i = 0; i < beams; ++i) {
    const double angle = wend::math::wrap_angle(me.heading + i * 10 * wend::math::degree), r = plane->body.radius;
    const wend_pose ray{me.x + r * std::cos(angle), me.y + r * std::sin(angle), angle};
    double distance;
    std::uint8_t kind;
    plane->cast(wend::Rows(&row, 1), std::span(&ray, 1), reach, WEND_OBSTACLE | WEND_MOVER, &distance, &kind);
    all.push_back(distance);
  }
  return all;
}

std::uint32_t drive(Plane& plane, Policy& policy, double seconds) {
  plane->time_limit = seconds;
  plane->steps = 0;
  policy.begin(1);
  const std::uint32_t copy = 0;
  std::vector<wend_outcome> outcome(1);
  while (outcome[0].flags == 0) {
    const auto action = policy.act(observe(plane, 0));
    plane->step(wend::Rows(&copy, 1), wend::Matrix<const double>(action.data(), 1, action.size()), outcome);
  }
  return outcome[0].flags;
}

// A wall of posts across the way with a gap.
void wall_with_gap(Plane& plane, double low, double high) {
  for (double y = -3; y <= 3; y += 0.15)
    if (y < low || y > high) plane->obstacles.push_back({4, y, 0.075});
}

}  // namespace

TEST(Dwa, DrivesStraightToAFreeGoal) {
  Plane plane;
  plane->body.speed_high = 2;
  plane->speed_and_turn_rate();
  Policy policy(plane);
  ASSERT_TRUE(policy.create()) << policy.error();
  EXPECT_EQ(drive(plane, policy, 9.0 / 2 + 0.2), WEND_TERMINATED | WEND_ARRIVED);
}

TEST(Dwa, GoesAroundAnObstacleAndThroughAGap) {
  for (const double acceleration : {2.0, wend::math::detail::infinity}) {
    Plane plane;
    plane->body.speed_high = 2, plane->body.acceleration = acceleration,
    plane->body.turn_acceleration = 3 * acceleration;
    plane->speed_and_turn_rate();
    plane->obstacles = {{2, 0, 0.3}};
    wall_with_gap(plane, 0.4, 2);
    Policy policy(plane);
    ASSERT_TRUE(policy.create()) << policy.error();
    EXPECT_EQ(drive(plane, policy, 30), WEND_TERMINATED | WEND_ARRIVED) << acceleration;
  }
}

TEST(Dwa, KeepsToTheSpeedItIsGiven) {
  Plane plane;
  Policy policy(plane);
  ASSERT_TRUE(policy.set("max_speed", 0.5).create());
  policy.begin(1);
  const auto action = policy.act(observe(plane, 0));
  EXPECT_EQ(action[0], 0.5);
  EXPECT_EQ(action[1], 0);
}

TEST(Dwa, NeverDrivesIntoAWallThatFillsItsView) {
  Plane plane;
  plane->body.acceleration = 2, plane->body.speed_high = 2;
  plane->speed_and_turn_rate();
  wall_with_gap(plane, 99, 99);
  Policy policy(plane);
  ASSERT_TRUE(policy.create());
  EXPECT_EQ(drive(plane, policy, 20) & WEND_COLLIDED, 0u);
}

TEST(Dwa, TurnsOnTheSpotWhereNoArcIsAdmissible) {
  Plane plane;
  Policy policy(plane);
  ASSERT_TRUE(policy.create());
  policy.begin(1);
  auto seen = observe(plane, 0);
  for (int i = -10; i <= 10; ++i) seen[4 + (i + beams) % beams] = 0.01;
  seen[4 + 9] = 3;  // some room to the left
  const auto action = policy.act(seen);
  EXPECT_EQ(action[0], 0);
  EXPECT_GT(action[1], 0);
  EXPECT_EQ(policy.telemetry(WEND_PER_STEP)[3], 1);
  EXPECT_EQ(policy.explain().substr(0, 9), "recovery:");
}

TEST(Dwa, WorksWithATableOfActions) {
  Plane plane;
  plane->dt = 1;
  plane->body.radius = 0.25;
  plane->action_table({{0.1, 0}, {0, 10 * wend::math::degree}, {0, -10 * wend::math::degree}});
  plane->obstacles = {{2, 0, 0.3}};
  plane->goals[0] = {4, 0, 0.3};
  Policy policy(plane);
  ASSERT_TRUE(policy.create()) << policy.error();
  EXPECT_EQ(drive(plane, policy, 300), WEND_TERMINATED | WEND_ARRIVED);
}

TEST(Dwa, DoesNotDependOnTheBatch) {
  Plane plane(2);
  plane->obstacles = {{1.5, 0.2, 0.3}};
  plane->motions[1] = {0, 0.4, 0.3, 0.5, 0.2};
  Policy together(plane, 2), apart(plane, 2);
  ASSERT_TRUE(together.create() && apart.create());
  together.begin(1), apart.begin(1);
  auto both = observe(plane, 0);
  const auto second = observe(plane, 1), first = both;
  both.insert(both.end(), second.begin(), second.end());
  const auto actions = together.act(both);
  const auto b = apart.act({1}, second), a = apart.act({0}, first);
  EXPECT_EQ(actions, (std::vector<double>{a[0], a[1], b[0], b[1]}));
}

TEST(Dwa, RefusesNaN) {
  Plane plane;
  Policy policy(plane);
  ASSERT_TRUE(policy.create());
  policy.begin(1);
  auto seen = observe(plane, 0);
  seen[4 + 7] = std::nan("");
  EXPECT_EQ(error_of([&] { policy.act(seen); }), "observation \"sonar.range.7\": expected a finite number, found NaN");
}

TEST(Dwa, NeedsTheSpeedWhereAccelerationIsLimited) {
  Plane plane;
  Policy policy(plane);
  policy.set("pose", "odometry");
  EXPECT_TRUE(policy.create()) << "no limit, no need";
  plane->body.acceleration = 1;
  EXPECT_FALSE(policy.create());
  EXPECT_EQ(policy.parameter(), "pose/0");
  EXPECT_EQ(policy.error().rfind("no column fits \"odometry.speed\"; the columns are goal.distance, ", 0), 0u)
      << policy.error();
}

TEST(Dwa, NeedsALimitOfTheTurnRate) {
  Plane plane;
  plane->body.turn_rate = INFINITY;
  Policy policy(plane);
  EXPECT_FALSE(policy.create());
  EXPECT_EQ(policy.parameter(), "max_turn_rate");
  EXPECT_EQ(policy.error(), "expected a limit, since neither the body nor the action space has one; found none");
  EXPECT_TRUE(policy.set("max_turn_rate", 2).create());
}
