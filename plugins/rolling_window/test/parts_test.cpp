// Subgoals, the switch, pursuit and the safety filter, each from numbers that a pencil sketch gives.
#include <gtest/gtest.h>

#include <cmath>
#include <wend/math.hpp>

#include "../pursuit.hpp"
#include "../safety_filter.hpp"
#include "../subgoal.hpp"
#include "../switching.hpp"

using namespace rolling_window;

namespace {

constexpr double degree = wend::math::degree, infinity = wend::math::detail::infinity;

Percept at(double x, double y, double heading, Point goal, double goal_radius = 1) {
  Percept percept;
  percept.motion = {x, y, heading, 0, 0};
  percept.body = 1;
  percept.goal = goal;
  percept.goal_distance = wend::math::hypot(goal.x - x, goal.y - y);
  percept.goal_bearing = wend::math::wrap_angle(wend::math::atan2(goal.y - y, goal.x - x) - heading);
  percept.goal_radius = goal_radius;
  return percept;
}
// A sonar reading, and its surface point.
void see(Percept& percept, double bearing, double range) {
  const double angle = percept.motion.heading + bearing;
  percept.sonar.push_back({bearing, range, wend::math::cos(angle), wend::math::sin(angle), true});
  percept.surface.push_back({percept.motion.x + (percept.body + range) * wend::math::cos(angle),
                             percept.motion.y + (percept.body + range) * wend::math::sin(angle)});
}
Subgoal choose(const SubgoalChooser& chooser, const Percept& percept) {
  return chooser.choose(
      percept,
      [&](double ux, double uy, double most) {
        return free_length(percept.surface, percept.at(), ux, uy, percept.body, most);
      },
      [&](Point p) { return wend::math::hypot(p.x - percept.goal.x, p.y - percept.goal.y); });
}
wend_limits unicycle(double acceleration = infinity) {
  return {1, 0, 0, 2, wend::math::pi, acceleration, infinity, 0};
}

}  // namespace

TEST(Subgoal, IsTheGoalInsideTheWindow) {
  const SubgoalChooser chooser(8, 72);
  const Subgoal subgoal = choose(chooser, at(1, 2, 0, {6, 2}));
  EXPECT_TRUE(subgoal.is_goal);
  EXPECT_EQ(subgoal.at.x, 6);
  EXPECT_EQ(subgoal.f, 5);
}

TEST(Subgoal, IsTheRimPointTowardsAFarGoal) {
  const SubgoalChooser chooser(8, 72);
  const Subgoal subgoal = choose(chooser, at(0, 0, 2, {30, 40}));
  EXPECT_FALSE(subgoal.is_goal);
  EXPECT_TRUE(subgoal.free);
  EXPECT_NEAR(subgoal.at.x, 8 * 0.6, 1e-12);
  EXPECT_NEAR(subgoal.at.y, 8 * 0.8, 1e-12);
  EXPECT_NEAR(subgoal.f, 50, 1e-9);  // g + h = 8 + 42
}

TEST(Subgoal, GoesRoundWhatBlocksTheRobotsWidth) {
  const SubgoalChooser chooser(8, 72);
  Percept percept = at(0, 0, 0, {50, 0});
  percept.surface = {{4, 0}, {4, -1}, {4, -2}};  // more to the right than to the left
  const Subgoal subgoal = choose(chooser, percept);
  EXPECT_TRUE(subgoal.free);
  EXPECT_GT(subgoal.at.y, 0);
  // The least bearing that passes (4, 0) at 1 m: asin(1 / 4) = 14.5 degrees, so the candidate of 15.
  EXPECT_NEAR(wend::math::atan2(subgoal.at.y, subgoal.at.x), 15 * degree, 1e-9);
}

TEST(Subgoal, WithoutAFreePointIsTheFarthestFreeWay) {
  const SubgoalChooser chooser(8, 72);
  Percept percept = at(0, 0, 0, {50, 0});
  for (int k = 0; k < 360; k += 5) {
    const double r = k == 180 ? 7 : 5;
    percept.surface.push_back({r * wend::math::cos(k * degree), r * wend::math::sin(k * degree)});
  }
  const Subgoal subgoal = choose(chooser, percept);
  EXPECT_FALSE(subgoal.free);
  EXPECT_LT(subgoal.at.x, 0);
  EXPECT_NEAR(subgoal.at.y, 0, 1e-9);
}

TEST(FreeLength, IsWhereADiscTouches) {
  const std::vector<Point> surface{{5, 0.6}};
  EXPECT_NEAR(free_length(surface, {0, 0}, 1, 0, 1, 20), 5 - 0.8, 1e-12);
  EXPECT_EQ(free_length(surface, {0, 0}, 1, 0, 0.6, 20), 20);  // it only grazes
  EXPECT_EQ(free_length(surface, {0, 0}, -1, 0, 1, 20), 20);   // behind
}

TEST(Switching, AIsAnySonarWithinD) {
  Switching rule{Switch::a, 8};
  Percept percept = at(0, 0, 0, {50, 0});
  see(percept, 75 * degree, 8.01);
  EXPECT_FALSE(rule.avoids(percept, {8, 0}));
  see(percept, -75 * degree, 8);
  EXPECT_TRUE(rule.avoids(percept, {8, 0}));
}

TEST(Switching, BIsTheCorridorToTheSubgoal) {
  Switching rule{Switch::b, 8};
  Percept percept = at(0, 0, 0, {50, 0});
  see(percept, 75 * degree, 3);  // beside the corridor along the heading
  EXPECT_FALSE(rule.avoids(percept, {8, 0}));
  EXPECT_TRUE(rule.avoids(percept, {8 * wend::math::cos(75 * degree), 8 * wend::math::sin(75 * degree)}));
  percept.surface.clear(), percept.sonar.clear();
  see(percept, 0, 8.5);  // in the corridor, but farther than D
  EXPECT_FALSE(rule.avoids(percept, {12, 0}));
}

TEST(Switching, BIsAConeThatReadsHalfOfD) {
  Switching rule{Switch::b, 8};
  Percept percept = at(0, 0, 0, {0, 50});
  see(percept, 15 * degree, 4.01);
  EXPECT_FALSE(rule.avoids(percept, {0, 8}));
  see(percept, -15 * degree, 4);
  EXPECT_TRUE(rule.avoids(percept, {0, 8}));
  rule.rule = Switch::never;
  EXPECT_FALSE(rule.avoids(percept, {0, 8}));
}

TEST(Pursuit, DrivesTheArcThroughItsTarget) {
  const Pursuit pursuit{5, wend::math::pi};
  const Percept percept = at(1, 1, 0, {50, 0});
  const Drive drive = pursuit.towards(percept, {4, 2}, unicycle(), 1, 0.1);
  const double radius =
      drive.speed / drive.turn_rate;  // centre (1, 1 + radius): as far from the target as from the robot
  EXPECT_NEAR(9 + (1 - radius) * (1 - radius), radius * radius, 1e-9);
  EXPECT_EQ(drive.speed, 1);
}

TEST(Pursuit, TurnsInPlaceToWhatIsBehind) {
  const Pursuit pursuit{0.8};
  const Drive drive = pursuit.towards(at(0, 0, 0, {9, 9}), {-1, -0.1}, unicycle(), 1, 0.1);
  EXPECT_EQ(drive.speed, 0);
  EXPECT_NEAR(drive.turn_rate, -wend::math::pi, 1e-12);
}

TEST(SafetyFilter, LeavesAFreeWayAlone) {
  const SafetyFilter filter(unicycle(2), 0.1, 2);
  const Drive drive = filter.nearest_safe(at(0, 0, 0, {50, 0}), nullptr, 0.1, {1.5, 0.3});
  EXPECT_EQ(drive.speed, 1.5);
  EXPECT_EQ(drive.turn_rate, 0.3);
}

TEST(SafetyFilter, CanAlwaysStopBeforeAWall) {
  const double period = 0.1;
  const SafetyFilter filter(unicycle(2), period, 2);
  Percept percept = at(0, 0, 0, {50, 0});
  for (double y = -20; y <= 20; y += 0.1) percept.surface.push_back({6, y});
  for (int k = 0; k < 200; ++k) {
    const Drive drive = filter.reachable(percept.motion, filter.nearest_safe(percept, nullptr, 0.1, {2, 0}));
    const double half = 0.5 * drive.turn_rate * period;
    percept.motion.x += drive.speed * period * wend::math::cos(percept.motion.heading + half);
    percept.motion.y += drive.speed * period * wend::math::sin(percept.motion.heading + half);
    percept.motion.heading += 2 * half;
    percept.motion.speed = drive.speed, percept.motion.turn_rate = drive.turn_rate;
    ASSERT_LE(percept.motion.x, 5 - 0.03) << k;
  }
  EXPECT_GT(percept.motion.x, 4);  // it came near
}

TEST(SafetyFilter, PassesAPostOnTheFreeSide) {
  const SafetyFilter filter(unicycle(), 1, 2);
  Percept percept = at(0, 0, 0, {50, 0});
  percept.surface = {{2.2, -0.5}};
  const Drive drive = filter.nearest_safe(percept, nullptr, 0, {2, 0});
  EXPECT_GT(drive.speed, 0);
  EXPECT_TRUE(drive.speed < 2 || drive.turn_rate > 0);
}

TEST(SafetyFilter, WhoIsTooNearMayOnlyLeave) {
  const SafetyFilter filter(unicycle(), 0.1, 2);
  Percept percept = at(0, 0, 0, {50, 0});
  percept.surface = {{1.02, 0}};  // nearer than the margin asks
  EXPECT_EQ(filter.nearest_safe(percept, nullptr, 0.1, {1, 0}).speed, 0);
  percept.surface = {{-1.02, 0}};
  EXPECT_EQ(filter.nearest_safe(percept, nullptr, 0.1, {1, 0}).speed, 1);
}
