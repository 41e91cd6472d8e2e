// The planners over a memory: distances against Dijkstra, paths and plans against the clearance that they promise.
#include <gtest/gtest.h>

#include <map>
#include <queue>
#include <set>

#include "../goal_distance.hpp"
#include "../switching.hpp"
#include "../turn_radius_planner.hpp"
#include "rig.hpp"

using rolling_window::Beam;
using rolling_window::GoalDistance;
using rolling_window::GridMemory;
using rolling_window::Motions;
using rolling_window::Passage;
using rolling_window::Percept;
using rolling_window::PlannedStep;
using rolling_window::Point;
using rolling_window::TurnRadiusPlanner;

namespace {

// A memory that holds single points.
GridMemory memory_of(const std::vector<Point>& points, double cell, double influence) {
  GridMemory memory({cell, influence, 0, 1000000});
  memory.cover(-5, -5, 25, 25);
  for (const Point& p : points) {
    Percept percept;
    percept.motion = {p.x - 1e-3, p.y, 0, 0, 0};
    percept.window.push_back({0, 1e-3, 1, 0, true});
    memory.observe(percept);
  }
  return memory;
}
std::vector<Point> scattered(std::uint64_t seed, int n) {
  wend::Random random(seed);
  std::vector<Point> points;
  for (int k = 0; k < n; ++k) points.push_back({random.uniform(0, 20), random.uniform(0, 20)});
  return points;
}

// Dijkstra from the goal's cell over all cells: the same costs, the plain way.
std::vector<double> dijkstra(const GridMemory& memory, const Passage& passage, Point goal) {
  const auto w = static_cast<int>(memory.columns()), h = static_cast<int>(memory.rows());
  std::vector<double> factor(memory.size()), best(memory.size(), 1e300);
  for (std::size_t i = 0; i < memory.size(); ++i)
    factor[i] = passage.factor(memory.clearance(i), memory.centre(i).x, memory.centre(i).y);
  std::set<std::pair<double, int>> open;
  const auto from = static_cast<int>(memory.cell_at(goal.x, goal.y));
  const Point c = memory.centre(static_cast<std::size_t>(from));
  best[static_cast<std::size_t>(from)] = 0.1 * wend::math::hypot(c.x - goal.x, c.y - goal.y);
  open.insert({best[static_cast<std::size_t>(from)], from});
  while (!open.empty()) {
    const auto [g, k] = *open.begin();
    open.erase(open.begin());
    const int x = k % w, y = k / w;
    const auto free = [&](int a, int b) {
      return a >= 0 && b >= 0 && a < w && b < h && factor[static_cast<std::size_t>(b * w + a)] < 1e300;
    };
    for (int n = 0; n < 9; ++n) {
      const int a = x + n % 3 - 1, b = y + n / 3 - 1;
      if (n == 4 || !free(a, b)) continue;
      if (n % 2 == 0 && (!free(a, y) || !free(x, b))) continue;
      const auto to = static_cast<std::size_t>(b * w + a);
      const double cost = g + memory.cell() * (n % 2 == 0 ? std::sqrt(2.0) : 1) * 0.5 *
                                  (factor[static_cast<std::size_t>(k)] + factor[to]);
      if (cost < best[to]) {
        open.erase({best[to], static_cast<int>(to)});
        open.insert({best[to] = cost, static_cast<int>(to)});
      }
    }
  }
  return best;
}

}  // namespace

TEST(GoalDistance, IsThatOfDijkstra) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const GridMemory memory = memory_of(scattered(seed, 25), 0.5, 3);
    const Passage passage{1.0, 1.0, 3, 0.2, {}};
    const Point goal{19.25, 19.25};
    GoalDistance distance;
    distance.begin(memory, passage, goal, 0, {1, 1}, 0);
    const std::vector<double> truth = dijkstra(memory, passage, goal);
    const bool goal_free = memory.clearance(memory.cell_at(19.25, 19.25)) >= 1.0;
    for (std::size_t i = 0; i < memory.size(); i += 7) {
      const double d = distance.cost(i);
      if (!goal_free || truth[i] >= 1e300) {
        EXPECT_GE(d, Passage::infinite);
      } else {
        EXPECT_NEAR(d, truth[i], 1e-3 * truth[i] + 1e-3);
      }
    }
  }
}

TEST(GoalDistance, ExpandsLittleForANearRobotAndGoesOnWhenAsked) {
  const GridMemory memory = memory_of({}, 0.5, 3);
  const Passage passage{1, 1, 3, 0, {}};
  GoalDistance distance;
  distance.begin(memory, passage, {10, 10}, 0, {12, 10}, 0);
  EXPECT_NEAR(distance.cost(12.2, 10.2), 2.0, 0.2);
  EXPECT_LT(distance.expanded(), 30u);
  EXPECT_NEAR(distance.cost(0.2, 10.2), 10.0, 0.5);
}

TEST(GoalDistance, PathKeepsItsClearanceAndCutsNoCorner) {
  std::vector<Point> wall;
  for (double y = 0; y <= 15; y += 0.25) wall.push_back({10, y});
  const GridMemory memory = memory_of(wall, 0.25, 3);
  const Passage passage{1, 1, 3, 0, {}};
  GoalDistance distance;
  distance.begin(memory, passage, {15, 5}, 0.5, {5, 5}, 0);
  std::vector<Point> path;
  ASSERT_TRUE(distance.path({5, 5}, path));
  EXPECT_LT(wend::math::hypot(path.front().x - 5, path.front().y - 5), 0.25);
  EXPECT_LE(wend::math::hypot(path.back().x - 15, path.back().y - 5), 0.5);
  for (std::size_t k = 0; k < path.size(); ++k) {
    EXPECT_GE(memory.clearance(path[k].x, path[k].y), 1.0);
    if (k > 0) {
      EXPECT_LE(wend::math::hypot(path[k].x - path[k - 1].x, path[k].y - path[k - 1].y), 0.25 * 1.4143);
    }
  }
}

TEST(GoalDistance, NoWayIsSaid) {
  std::vector<Point> ring;
  for (int k = 0; k < 100; ++k) ring.push_back({10 + 3 * std::cos(k * 0.0628318), 10 + 3 * std::sin(k * 0.0628318)});
  const GridMemory memory = memory_of(ring, 0.25, 3);
  GoalDistance distance;
  distance.begin(memory, {1, 1, 3, 0, {}}, {10, 10}, 0.5, {20, 20}, 0);
  std::vector<Point> path;
  EXPECT_FALSE(distance.path({20, 20}, path));
  EXPECT_EQ(distance.cost(20, 20), Passage::infinite);
}

TEST(TurnRadiusPlanner, MotionsAreThoseOfTheBody) {
  rig::Rig rig(rig::simrobot());
  const wend::BodyRef body(rig.plane().ref());
  const Motions motions(wend::Steer(wend::Space(rig.plane()->actions().table()), body, 1), body, 1, 24, 1);
  ASSERT_EQ(motions.all.size(), 3u);
  EXPECT_EQ(motions.top_speed, 0.5);
  EXPECT_EQ(motions.all[0].states.size(), 3u);             // 1.5 m: more than a cell's diagonal
  EXPECT_EQ(motions.all[1].states.size(), 3u);             // 14.3 degrees: about one of 24 headings
  const wend_motion& left = motions.all[1].states.back();  // on a circle of radius 3 about (0, 3)
  EXPECT_NEAR(left.heading, 0.25, 1e-12);
  EXPECT_NEAR(left.x, 3 * std::sin(0.25), 1e-9);
  EXPECT_NEAR(left.y, 3 - 3 * std::cos(0.25), 1e-9);
}

TEST(TurnRadiusPlanner, PlansAreDrivableAndClear) {
  rig::Rig rig(rig::simrobot());
  const wend::BodyRef body(rig.plane().ref());
  TurnRadiusPlanner planner(Motions(wend::Steer(wend::Space(rig.plane()->actions().table()), body, 1), body, 1, 24, 1),
                            {24, 60000, 1000});
  std::vector<Point> wall;
  for (double y = -30; y <= 30; y += 1) wall.push_back({20, y});
  GridMemory memory = memory_of(wall, 1, 7);
  memory.cover(-20, -60, 60, 60);
  const Passage passage{3.3, 3, 3, 0, {}};
  const wend_motion start{0, 0, wend::math::pi / 2, 0, 0};
  const Point goal{40, 0};
  GoalDistance distance;
  distance.begin(memory, passage, goal, 2, {0, 0}, 0.5);
  std::vector<PlannedStep> steps;
  ASSERT_EQ(planner.plan(memory, passage, distance, start, goal, 2, steps), TurnRadiusPlanner::Result::reached);
  wend_motion at = start;
  for (const PlannedStep& step : steps) {
    const double action = static_cast<double>(step.motion);
    wend_motion next{};
    body.predict(0, std::span(&at, 1), &action, 1, std::span(&next, 1));
    at = next;
    EXPECT_NEAR(at.x, step.pose.x, 1e-6);
    EXPECT_NEAR(at.y, step.pose.y, 1e-6);
    EXPECT_GE(memory.clearance(at.x, at.y), 3.3);
  }
  EXPECT_LE(wend::math::hypot(at.x - 40, at.y), 2);
}

TEST(TurnRadiusPlanner, SaysThatItIsTrapped) {
  rig::Rig rig(rig::simrobot());
  const wend::BodyRef body(rig.plane().ref());
  TurnRadiusPlanner planner(Motions(wend::Steer(wend::Space(rig.plane()->actions().table()), body, 1), body, 1, 24, 1),
                            {24, 3000, 1000});
  std::vector<Point> box;  // 9 m wide: a body of radius 3 with turn radius 3 cannot turn round in it
  for (double s = -4.5; s <= 4.5; s += 0.5)
    box.push_back({s, 4.5}), box.push_back({s, -4.5}), box.push_back({4.5, s}), box.push_back({-4.5, s});
  const GridMemory memory = memory_of(box, 1, 7);
  const Passage passage{3, 3, 3, 0, {}};
  GoalDistance distance;
  distance.begin(memory, passage, {0.5, 0.5}, 1, {0, 0}, 0.5);
  std::vector<PlannedStep> steps;
  EXPECT_EQ(planner.plan(memory, passage, distance, {0, 0, 0, 0, 0}, {20, 0}, 1, steps),
            TurnRadiusPlanner::Result::trapped);
  EXPECT_GT(steps.size(), 0u);  // as long as it lasts
}

// A circle of radius 3 about (0, 3) leads to a subgoal at the left: the body passes (5.5, 3) at 2.5 m.
TEST(Switching, BLooksAlongWhatSeekingDrives) {
  rig::Rig rig(rig::simrobot());
  const wend::Steer steer(wend::Space(rig.plane()->actions().table()), wend::BodyRef(rig.plane().ref()), 1);
  rolling_window::Percept percept;
  percept.body = 3;
  percept.surface = {{5.5, 3}};
  using rolling_window::Switch, rolling_window::Switching, rolling_window::Percept;
  const Switching rule{Switch::b, 8};
  EXPECT_FALSE(rule.avoids(percept, {0, 8}));
  EXPECT_TRUE(rule.avoids(percept, {0, 8}, &steer));
  percept.surface = {{6.5, 3}};
  EXPECT_FALSE(rule.avoids(percept, {0, 8}, &steer));
  Switching roomy = rule;
  roomy.margin = 1;
  EXPECT_TRUE(roomy.avoids(percept, {0, 8}, &steer));
  percept.surface = {{-2.5, 0}};  // nearer than the margin, but left behind
  EXPECT_FALSE(roomy.avoids(percept, {0, 8}, &steer));
}
