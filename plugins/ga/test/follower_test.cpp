// Following paths with tables of actions.
#include "follower.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <wend/testing_plane.hpp>

#include "rooms.hpp"

using ga::ClearanceGrid;
using ga::Follower;
using ga::Point;
using ga::Track;
using wend::testing::Plane;

namespace {

constexpr double radius = 0.15;

struct Drive {
  double farthest_off = 0, least_clearance = 1e9;  // m
  std::size_t steps = 0;
  bool arrived = false;
};

// In a room of 10 m, until the goal at the end of the path, or 200 steps.
Drive drive(Plane& plane, std::size_t actions, std::vector<Point> path, double heading, const ClearanceGrid& grid) {
  Follower follower{wend::BodyRef(plane.ref()), actions, plane->dt, 3};
  const wend_disc goal{path.back().x, path.back().y, 0.3};
  wend_motion now{path[0].x, path[0].y, heading, 0, 0};
  const Track track(std::move(path));
  double way = 0;
  Drive drive;
  while (drive.steps < 200 && !drive.arrived) {
    now = follower.choose(0, now, track, way, goal, grid, radius).next;
    ++drive.steps;
    drive.farthest_off = std::max(drive.farthest_off, track.foot({now.x, now.y}, 0, track.length()).distance);
    drive.least_clearance = std::min(drive.least_clearance, grid.at(now.x, now.y));
    drive.arrived = std::hypot(now.x - goal.x, now.y - goal.y) <= goal.radius;
  }
  return drive;
}

// 0.15 m in a period, turning by up to 45 degrees.
void steps_and_turns(Plane& plane) {
  plane->body = {radius, 0, 0, 1, 16, wend::math::detail::infinity, wend::math::detail::infinity, 0};
  plane->dt = 0.15;
  const double turn = 22.5 * wend::math::degree / plane->dt;
  plane->action_table({{1, -2 * turn}, {1, -turn}, {1, 0}, {1, turn}, {1, 2 * turn}});
}

const ClearanceGrid empty = ga::testing::room(10, {});

}  // namespace

TEST(Follower, KeepsToAStraightPath) {
  Plane plane;
  steps_and_turns(plane);
  const Drive straight = drive(plane, 5, {{1, 5}, {9, 5}}, 0, empty);
  EXPECT_TRUE(straight.arrived);
  EXPECT_EQ(straight.steps, 52u) << "7.7 m";
  EXPECT_NEAR(straight.farthest_off, 0, 1e-12);
}

TEST(Follower, ComesBackToThePathFromAnyHeading) {
  Plane plane;
  steps_and_turns(plane);
  for (double heading = -3; heading < 3.2; heading += 0.5) {
    const Drive turned = drive(plane, 5, {{2, 5}, {9, 5}}, heading, empty);
    EXPECT_TRUE(turned.arrived) << heading;
    EXPECT_LT(turned.farthest_off, 0.5) << heading;
    EXPECT_LT(turned.steps, 55u) << heading;
  }
}

TEST(Follower, RoundsCorners) {
  Plane plane;
  steps_and_turns(plane);
  const Drive corners = drive(plane, 5, {{1, 1}, {5, 1}, {5, 5}, {1, 5}, {1, 9}}, 0, empty);
  EXPECT_TRUE(corners.arrived);
  EXPECT_LT(corners.farthest_off, 0.2);
  EXPECT_NEAR(static_cast<double>(corners.steps), 16 / 0.15, 8);
}

TEST(Follower, DoesNotTouchWhatThePlanKnew) {
  Plane plane;
  steps_and_turns(plane);
  const ClearanceGrid walled = ga::testing::room(10, {{0, 5, 10, 5.3}});
  const Drive blocked = drive(plane, 5, {{5, 2}, {5, 9}}, wend::math::half_pi, walled);
  EXPECT_FALSE(blocked.arrived);
  EXPECT_EQ(blocked.steps, 200u);
  EXPECT_GT(blocked.least_clearance, radius);
  const ClearanceGrid corner = ga::testing::room(10, {{0, 0, 1.6, 10}});
  for (double heading = 2.4; heading < 3.9; heading += 0.1) {  // 0.2 m from the rim to the wall it looks at
    const Drive turned = drive(plane, 5, {{1.95, 5}, {9, 5}}, heading, corner);
    EXPECT_TRUE(turned.arrived) << heading;
    EXPECT_GT(turned.least_clearance, radius) << heading;
  }
}

TEST(Follower, TurnsOnTheSpotWhereThatIsAllABodyCan) {
  Plane plane;
  plane->body = {radius, 0, 0, 1, 16, wend::math::detail::infinity, wend::math::detail::infinity, 0};
  plane->action_table({{1, 0}, {0, 2}, {0, -2}});  // 0.1 m, or 11 degrees
  plane->dt = 0.1;
  const Drive round = drive(plane, 3, {{2, 2}, {5, 2}, {5, 6}}, 3, empty);
  EXPECT_TRUE(round.arrived);
  EXPECT_LT(round.farthest_off, 0.15);
  EXPECT_LT(round.steps, 110u) << "67 steps ahead, 15 turns at the start and 8 at the corner";
}

TEST(Follower, LooksAheadAsFarAsSequencesAreFew) {
  Plane plane;
  steps_and_turns(plane);
  const wend::BodyRef body(plane.ref());
  EXPECT_EQ((Follower{body, 5, 0.15, 3}.depth()), 3u);
  EXPECT_EQ((Follower{body, 5, 0.15, 10}.depth()), 4u) << "625 sequences";
  EXPECT_EQ((Follower{body, 5, 0.15, 1}.depth()), 1u);
  EXPECT_NEAR((Follower{body, 5, 0.15, 3}.advance()), 0.15, 1e-12);
}
