// What an episode brings depends on its seeds and actions alone: not on how many copies there are, which are stepped
// together, or what was asked in between.  Streams, drawn places, noise, and no allocation in a step.
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

#include "harness.hpp"

namespace {
std::atomic<long> allocations{0};
}  // namespace

[[gnu::noinline]] void* operator new(std::size_t n) {
  ++allocations;
  if (void* p = std::malloc(n ? n : 1)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept {
  std::free(p);
}
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}

namespace arena {
namespace {

// Discs, cells, a polygon and two movers; starts and goals are drawn.
Scene busy_scene() {
  Scene scene;
  scene.name = "busy";
  scene.width = scene.height = 40;
  wend::Random random(5);
  for (int k = 0; k < 12; ++k)
    scene.discs.push_back({random.uniform(2, 38), random.uniform(2, 38), random.uniform(0.3, 1.5)});
  scene.segments = {{5, 5, 12, 7}, {30, 30, 33, 22}};
  scene.polygons = {{{{20, 20}, {23, 20}, {23, 24}, {20, 24}}}};
  scene.grid = {10, 28, 0.5, 8, 8, {}};
  for (int k = 0; k < 64; ++k) scene.grid.occupied.push_back(random.chance(0.3));
  Mover patrol, ball;
  patrol.radius = 0.5, patrol.waypoints = {{2, 15}, {38, 15}, {38, 26}}, patrol.speed = 0.7;
  ball.radius = 0.4, ball.x = 3, ball.y = 30, ball.vx = 1.3, ball.vy = -0.9;
  scene.movers = {patrol, ball};
  return scene;
}

constexpr std::uint32_t robots = 3;
Values noisy_robot() {
  return robot_values(0.3, {{"noise/speed", 0.05}, {"noise/turn_rate", 0.1}, {"kinematics/acceleration", 1.5}});
}
Values busy_world() {
  return world_values({{"dt", 0.2}, {"substeps", 2}, {"time_limit", 30}, {"optimal", 1}, {"draw/distance", 10}});
}

wend_episode episode(std::uint64_t k) {
  return {k, wend::stream(99, k), 4, 0, WEND_TEST};
}

// All that is to be seen of an episode, with actions that depend on what is seen.
struct Course {
  std::vector<double> seen;
  int steps = 0;
  void look(const Arena& arena, std::uint32_t copy, std::vector<double>& actions) {
    for (std::uint32_t r = 0; r < robots; ++r) {
      const std::uint32_t row = copy * robots + r;
      const wend_pose at = arena.pose(row);
      const wend_outcome& outcome = arena.outcomes[row];
      const auto left = arena.cast({at.x, at.y, at.heading + 0.5}, 6, 15, row),
                 right = arena.cast({at.x, at.y, at.heading - 0.5}, 6, 31, row);
      for (const double value : {at.x, at.y, at.heading, left.first, right.first, outcome.reward, 1.0 * outcome.flags,
                                 1.0 * left.second, arena.goal(row).x, arena.clearance(at.x, at.y, 15, row)})
        seen.push_back(value);
      actions[2 * r] = 1, actions[2 * r + 1] = left.first > right.first ? 0.6 : -0.4;
    }
  }
  void finish(const Arena& arena, std::uint32_t copy) {
    for (std::uint32_t r = 0; r < robots; ++r)
      for (const char* name :
           {"time_s", "path_length_m", "min_clearance_m", "optimal_length_m", "spl", "heading_change_rate"}) {
        const double value = arena.metric(name, copy * robots + r);
        seen.push_back(std::isnan(value) ? -1e9 : value);
      }
  }
};

bool over(const Arena& arena, std::uint32_t copy) {
  for (std::uint32_t r = 0; r < robots; ++r)
    if (arena.flags(copy * robots + r) == 0) return false;
  return true;
}

Course alone(Arena& arena, std::uint32_t copy, std::uint64_t k) {
  Course course;
  EXPECT_EQ(arena.reset_one(copy, episode(k)), WEND_OK) << arena.host.failure;
  for (std::uint32_t r = 0; r < robots; ++r) arena.outcomes[copy * robots + r] = {};
  std::vector<double> actions(2 * robots);
  course.look(arena, copy, actions);
  while (!over(arena, copy)) {
    arena.step_one(copy, actions);
    course.look(arena, copy, actions);
    ++course.steps;
  }
  course.finish(arena, copy);
  return course;
}

TEST(Batching, OneCopyOrEightBringTheSameBits) {
  Arena one(busy_scene(), busy_world(), noisy_robot(), 1, robots);
  Arena eight(busy_scene(), busy_world(), noisy_robot(), 8, robots);
  ASSERT_EQ(eight.status, WEND_OK) << eight.host.failure;
  std::vector<Course> courses(8);
  std::vector<std::vector<double>> actions(8, std::vector<double>(2 * robots));
  for (std::uint32_t c = 0; c < 8; ++c) ASSERT_EQ(eight.reset_one(c, episode(c)), WEND_OK) << eight.host.failure;
  for (std::uint32_t c = 0; c < 8; ++c) courses[c].look(eight, c, actions[c]);
  bool left = true;
  while (left) {
    std::vector<double> all;
    for (const auto& row : actions) all.insert(all.end(), row.begin(), row.end());
    std::vector<bool> was_over;
    for (std::uint32_t c = 0; c < 8; ++c) was_over.push_back(over(eight, c));
    eight.step(all);
    left = false;
    for (std::uint32_t c = 0; c < 8; ++c) {
      if (was_over[c]) continue;
      courses[c].look(eight, c, actions[c]);
      left = left || !over(eight, c);
    }
  }
  std::size_t longest = 0;
  for (std::uint32_t c = 0; c < 8; ++c) {
    courses[c].finish(eight, c);
    const Course single = alone(one, 0, c);
    ASSERT_EQ(courses[c].seen, single.seen) << "episode " << c;
    longest = std::max(longest, single.seen.size());
  }
  EXPECT_GT(longest, 1000u);
  EXPECT_NE(courses[0].seen, courses[1].seen);
  // In another order, in other copies, after other episodes.
  EXPECT_EQ(alone(eight, 5, 2).seen, courses[2].seen);
  EXPECT_EQ(alone(eight, 0, 7).seen, courses[7].seen);
}

TEST(Batching, DrawnPlacesKeepTheirDistances) {
  Arena arena(busy_scene(), world_values({{"optimal", 1}, {"draw/distance", 15}, {"draw/clearance", 0.4}}),
              robot_values(0.5), 16, robots);
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    ASSERT_EQ(arena.reset(seed), WEND_OK) << arena.host.failure;
    for (std::uint32_t row = 0; row < 16 * robots; ++row) {
      const wend_pose at = arena.pose(row);
      const wend_disc goal = arena.goal(row);
      EXPECT_GE(std::hypot(at.x - goal.x, at.y - goal.y), 15);
      EXPECT_GT(arena.clearance(at.x, at.y, WEND_WALL | WEND_OBSTACLE | WEND_MOVER, row), 0.9);
      EXPECT_GT(arena.clearance(at.x, at.y, WEND_ROBOT, row), 0.9);
      EXPECT_GT(arena.clearance(goal.x, goal.y, WEND_WALL | WEND_OBSTACLE, row), 0.9);
      EXPECT_GE(arena.metric("optimal_length_m", row), 14.9);
      EXPECT_GE(arena.metric("min_clearance_m", row), 0.4);
    }
  }
}

TEST(Batching, RobotsHaveNoiseOfTheirOwn) {
  Scene scene;
  scene.starts = {{20, 20, 0, false}, {20, 60, 0, false}};
  scene.goals = {{90, 20, 1, {}, 0}, {90, 60, 1, {}, 0}};
  Arena arena(scene, world_values(), robot_values(1, {{"noise/speed", 0.2}}), 2, 2);
  arena.reset(3);
  std::vector<double> moved;
  for (int k = 0; k < 3; ++k) {
    std::vector<double> before;
    for (std::uint32_t row = 0; row < 4; ++row) before.push_back(arena.pose(row).x);
    arena.step({1, 0, 1, 0, 1, 0, 1, 0});
    for (std::uint32_t row = 0; row < 4; ++row) moved.push_back(arena.pose(row).x - before[row]);
  }
  std::sort(moved.begin(), moved.end());
  for (std::size_t i = 1; i < moved.size(); ++i) EXPECT_NE(moved[i - 1], moved[i]);
  EXPECT_GT(moved.back() - moved.front(), 0.05);
}

TEST(Batching, StepsAndSensesAllocateNothing) {
  Arena arena(busy_scene(), busy_world(), noisy_robot(), 4, robots);
  arena.reset(1);
  std::vector<std::uint32_t> copies{0, 1, 2, 3}, rows;
  std::vector<wend_pose> rays;
  for (std::uint32_t row = 0; row < 4 * robots; ++row) rows.push_back(row), rays.push_back({20, 10, 0.3 * row});
  std::vector<double> actions(8 * robots, 0.5), distance(rows.size());
  std::vector<std::uint8_t> kind(rows.size());
  const auto* geometry = arena.table<wend_geometry2d>(WEND_GEOMETRY2D);
  const long before = allocations;
  for (int k = 0; k < 40; ++k) {
    arena.world()->step(arena.self(), copies.data(), 4, actions.data(), arena.outcomes.data());
    geometry->cast(arena.self(), rows.data(), rays.data(), static_cast<std::uint32_t>(rows.size()), 10, 31,
                   distance.data(), kind.data());
  }
  EXPECT_EQ(allocations - before, 0);
}

TEST(Scenes, AreWrittenSoThatTheyAreReadAgain) {
  Arena arena(busy_scene(), busy_world(), noisy_robot(), 1, 1);
  arena.reset(4);
  std::string text;
  const wend_sink sink{sizeof(wend_sink), &text, [](void* to, const void* bytes, std::uint64_t n) -> wend_status {
                         static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), n);
                         return WEND_OK;
                       }};
  ASSERT_EQ(arena.table<wend_scene>(WEND_SCENE)->write(arena.self(), 0, &sink), WEND_OK);
  const Scene scene = parse_scene("written", text);
  EXPECT_EQ(scene.discs.size(), 12u);
  EXPECT_EQ(scene.starts.at(0).x, arena.pose().x);
  EXPECT_EQ(scene.goals.at(0).y, arena.goal().y);
}

}  // namespace
}  // namespace arena
