// The arena by its C table: collisions, arrivals, movers, several robots, metrics, and that batching changes nothing.
#include <cmath>

#include "harness.hpp"

namespace arena {
namespace {

constexpr double pi = wend::math::pi;

// 100 x 100 m, a start at (10, 50) heading along x, a goal at (90, 50).
Scene empty_scene() {
  Scene scene;
  scene.name = "test";
  scene.starts = {{10, 50, 0, false}};
  scene.goals = {{90, 50, 2, {}, 0}};
  return scene;
}

TEST(Arena, OffersItsInterfaces) {
  Arena arena(empty_scene(), world_values(), robot_values());
  ASSERT_EQ(arena.status, WEND_OK) << arena.host.failure;
  for (const char* id : {WEND_WORLD, WEND_GEOMETRY2D, WEND_BODY, WEND_SCENE, WEND_TELEMETRY})
    EXPECT_NE(arena.table<void>(id), nullptr) << id;
  EXPECT_EQ(arena.table<void>(WEND_SENSOR), nullptr);
  EXPECT_EQ(arena.world()->period(arena.self()), 1);
}

TEST(Arena, ArrivesWhenItsCentreIsWithinTheGoal) {
  Arena arena(empty_scene(), world_values({{"optimal", 1}}), robot_values());
  ASSERT_EQ(arena.reset(), WEND_OK) << arena.host.failure;
  int steps = 0;
  while (arena.flags() == 0) arena.step({3, 0}), ++steps;
  EXPECT_EQ(arena.flags(), WEND_TERMINATED | WEND_ARRIVED);
  EXPECT_EQ(steps, 26);  // 78 m to the disc
  EXPECT_EQ(arena.outcomes[0].reward, 1);
  EXPECT_EQ(arena.metric("time_s"), 26);
  EXPECT_EQ(arena.metric("path_length_m"), 78);
  EXPECT_EQ(arena.metric("min_clearance_m"), 9);
  EXPECT_NEAR(arena.metric("optimal_length_m"), 80, 0.2);  // on cells of a third of a metre
  EXPECT_EQ(arena.metric("spl"), 1);
  EXPECT_EQ(arena.metric("heading_change_rate"), 0);
  // Parked: nothing happens to it any more.
  const wend_pose before = arena.pose();
  arena.outcomes[0] = {7, 9, 0};
  arena.step({3, 0});
  EXPECT_EQ(arena.pose().x, before.x);
  EXPECT_EQ(arena.outcomes[0].reward, 7);
}

TEST(Arena, CollidesWhenItsClearanceFallsToTheStopDistance) {
  Scene scene = empty_scene();
  scene.discs = {{50, 50, 5}};
  for (const double stop : {0.0, 2.5}) {
    Arena arena(scene, world_values(), robot_values(1, {{"stop_distance", stop}}));
    ASSERT_EQ(arena.reset(), WEND_OK);
    int steps = 0;
    while (arena.flags() == 0) arena.step({0.5, 0}), ++steps;
    EXPECT_EQ(arena.flags(), WEND_TERMINATED | WEND_COLLIDED);
    EXPECT_EQ(steps, (34 - stop) / 0.5);  // 40 - 5 - 1 m of way
    EXPECT_EQ(arena.outcomes[0].reward, -1);
    EXPECT_NEAR(arena.metric("min_clearance_m"), stop, 1e-12);
    EXPECT_TRUE(std::isnan(arena.metric("time_s")));
    EXPECT_TRUE(std::isnan(arena.metric("path_length_m")));
  }
}

TEST(Arena, TruncatesAtTheTimeLimitAndTestsEveryDt) {
  Arena arena(empty_scene(), world_values({{"dt", 0.1}, {"substeps", 5}, {"time_limit", 1.2}}), robot_values());
  ASSERT_EQ(arena.reset(), WEND_OK);
  EXPECT_EQ(arena.world()->period(arena.self()), 0.5);
  arena.step({1, 0});
  arena.step({1, 0});
  EXPECT_EQ(arena.flags(), 0u);
  arena.step({1, 0});
  EXPECT_EQ(arena.flags(), WEND_TRUNCATED);
  EXPECT_NEAR(arena.pose().x, 11.2, 1e-12);  // stopped within the period
}

TEST(Arena, NothingIsTunnelledThrough) {
  Scene wall = empty_scene();
  wall.segments = {{30, 0, 30, 100}};
  Scene disc = empty_scene();
  disc.discs = {{30, 50, 0.05}};
  Scene cells = empty_scene();
  cells.grid = {30, 40, 0.1, 1, 200, std::vector<std::uint8_t>(200, 1)};
  Scene plate = empty_scene();
  plate.polygons = {{{{30, 40}, {30.01, 40}, {30.01, 60}, {30, 60}}}};
  for (const Scene& scene : {wall, disc, cells, plate})
    for (const double radius : {0.0, 0.01, 0.3, 2.0})
      for (const double speed : {7.0, 35.0, 79.0}) {
        Arena arena(scene, world_values(), robot_values(radius));
        ASSERT_EQ(arena.reset(), WEND_OK) << arena.host.failure;
        while (arena.flags() == 0) arena.step({speed, 0});
        EXPECT_EQ(arena.flags(), WEND_TERMINATED | WEND_COLLIDED) << "radius " << radius << " speed " << speed;
        EXPECT_LT(arena.pose().x, 33) << "radius " << radius << " speed " << speed;
      }
  // Through the wall around the arena too; and a mover that crosses the way within a dt.
  Arena out(empty_scene(), world_values({{"goal_radius", 0.5}}), robot_values(0));
  out.reset();
  out.step({95, 0});
  EXPECT_EQ(out.flags(), WEND_TERMINATED | WEND_COLLIDED);
  EXPECT_NEAR(out.pose().x, 100, 1e-9);
  Scene crossing = empty_scene();
  Mover mover;
  mover.radius = 0.2, mover.x = 20, mover.y = 50, mover.vx = -15;
  crossing.movers = {mover};
  Arena head_on(crossing, world_values(), robot_values(0.3));
  head_on.reset();
  head_on.step({5, 0});  // 10 m behind each other after the dt, having met
  EXPECT_EQ(head_on.flags(), WEND_TERMINATED | WEND_COLLIDED);
}

TEST(Arena, WhoDoesNotMoveIsStillTested) {
  Scene scene = empty_scene();
  scene.discs = {{12, 50, 0.5}};
  const double there = scene.starts.at(0).x;
  for (const double gap : {0.25, 0.75}) {  // of the rims, against a stop distance of 0.5 m
    scene.discs[0].x = there + 1 + 0.5 + gap;
    Arena arena(scene, world_values(), robot_values(1, {{"stop_distance", 0.5}}));
    ASSERT_EQ(arena.reset(), WEND_OK) << arena.host.failure;
    for (int k = 0; k < 5; ++k) arena.step({0, 0.7});
    EXPECT_EQ(arena.flags(), gap < 0.5 ? WEND_TERMINATED | WEND_COLLIDED : 0u) << gap;
    EXPECT_NEAR(arena.metric("min_clearance_m"), gap, 1e-9);
  }
}

TEST(Arena, PointRobotsSlideAlongNothing) {
  Scene scene = empty_scene();
  scene.discs = {{50, 50, 5}};
  Arena arena(scene, world_values({{"dt", 0.02}, {"substeps", 25}, {"time_limit", 160}}), robot_values(0));
  arena.reset();
  int steps = 0;
  while (arena.flags() == 0) arena.step({1, 0}), ++steps;
  EXPECT_EQ(arena.flags(), WEND_TERMINATED | WEND_COLLIDED);
  EXPECT_NEAR(arena.pose().x, 45, 1e-9);
  EXPECT_EQ(steps, 70);
}

TEST(Arena, ArrivedRobotsParkAsSurfaces) {
  Scene scene = empty_scene();
  scene.starts = {{10, 50, 0, false}, {5, 50, 0, false}};
  scene.goals = {{20, 50, 1, {}, 0}, {60, 50, 1, {}, 0}};
  Arena arena(scene, world_values(), robot_values(), 1, 2);
  ASSERT_EQ(arena.reset(), WEND_OK);
  for (int k = 0; k < 9; ++k) arena.step({1, 0, 1, 0});
  EXPECT_EQ(arena.flags(0), WEND_TERMINATED | WEND_ARRIVED);
  EXPECT_EQ(arena.flags(1), 0u);
  EXPECT_EQ(arena.pose(0).x, 19);
  const auto [distance, kind] = arena.cast({15, 50, 0}, 20, WEND_WALL | WEND_ROBOT, 1);
  EXPECT_EQ(distance, 3);
  EXPECT_EQ(kind, WEND_ROBOT);
  EXPECT_EQ(arena.cast({17, 50, 0}, 20, WEND_WALL | WEND_ROBOT, 0).second, WEND_NOTHING);  // does not see itself
  for (int k = 0; k < 3; ++k) arena.step({1, 0, 1, 0});
  EXPECT_EQ(arena.flags(1), WEND_TERMINATED | WEND_COLLIDED);
  EXPECT_EQ(arena.flags(0), WEND_TERMINATED | WEND_ARRIVED);
  EXPECT_EQ(arena.metric("min_clearance_m", 1), 0);
}

TEST(Arena, RobotsThatMeetBothCollide) {
  Scene scene = empty_scene();
  scene.starts = {{10, 50, 0, false}, {30, 50, pi, false}};
  scene.goals = {{90, 50, 1, {}, 0}, {1, 1, 0.1, {}, 0}};
  Arena arena(scene, world_values(), robot_values(), 1, 2);
  arena.reset();
  int steps = 0;
  while (arena.flags(0) == 0 && arena.flags(1) == 0) arena.step({7, 0, 7, 0}), ++steps;  // 20 m apart, 14 m a step
  EXPECT_EQ(steps, 2);
  EXPECT_EQ(arena.flags(0), WEND_TERMINATED | WEND_COLLIDED);
  EXPECT_EQ(arena.flags(1), WEND_TERMINATED | WEND_COLLIDED);
}

TEST(Arena, MoversPatrolAndAreSeen) {
  Scene scene = empty_scene();
  Mover mover;
  mover.radius = 1, mover.waypoints = {{50, 20}, {50, 80}}, mover.speed = 2, mover.random_phase = false;
  scene.movers = {mover};
  Arena arena(scene, world_values(), robot_values());
  arena.reset();
  const auto before = arena.shapes();
  for (int k = 0; k < 14; ++k) arena.step({0, 0});
  const auto after = arena.shapes();
  ASSERT_EQ(after.size(), 2u);  // the walls and it
  EXPECT_EQ(after[1].kind, WEND_MOVER);
  EXPECT_EQ(after[1].xy[1], 48);
  EXPECT_EQ(after[1].vy, 2);
  EXPECT_EQ(after[1].xy, before[1].xy);
  EXPECT_EQ(arena.cast({40, 48, 0}, 100, WEND_MOVER), (std::pair<double, int>(9, WEND_MOVER)));
  EXPECT_EQ(arena.clearance(50, 45, WEND_MOVER | WEND_WALL), 2);
  for (int k = 0; k < 20; ++k) arena.step({0, 0});
  EXPECT_EQ(arena.shapes()[1].vy, -2);
  EXPECT_EQ(arena.shapes()[1].xy[1], 72);
}

TEST(Arena, PhasesComeFromTheEpisode) {
  Scene scene = empty_scene();
  Mover mover;
  mover.radius = 1, mover.waypoints = {{50, 20}, {50, 80}}, mover.speed = 2;
  scene.movers = {mover};
  Arena arena(scene, world_values(), robot_values());
  std::vector<double> at;
  for (const std::uint64_t seed : {1, 2, 1}) {
    arena.reset(seed);
    at.push_back(arena.shapes()[1].xy[1]);
  }
  EXPECT_NE(at[0], at[1]);
  EXPECT_EQ(at[0], at[2]);
}

TEST(Arena, GoalsMove) {
  Scene scene = empty_scene();
  scene.goals = {{70, 90, 2, {{70, 90}, {30, 90}}, 0.8}};
  Arena arena(scene, world_values({{"optimal", 1}}), robot_values());
  arena.reset();
  for (int k = 0; k < 5; ++k) arena.step({0, 0});
  EXPECT_NEAR(arena.goal().x, 66, 1e-12);
  EXPECT_EQ(arena.cast({66, 50, pi / 2}, 100, WEND_WALL | WEND_GOAL).second, WEND_GOAL);
  EXPECT_NEAR(arena.cast({66, 50, pi / 2}, 100, WEND_WALL | WEND_GOAL).first, 38, 1e-12);
  EXPECT_TRUE(std::isnan(arena.metric("optimal_length_m")));
}

TEST(Arena, KindsAreToldApart) {
  Scene scene = empty_scene();
  scene.discs = {{30, 50, 4}};
  Arena arena(scene, world_values(), robot_values());
  arena.reset();
  using Hit = std::pair<double, int>;
  EXPECT_EQ(arena.cast({20, 50, 0}, 100, WEND_WALL | WEND_OBSTACLE), Hit(6, WEND_OBSTACLE));
  EXPECT_EQ(arena.cast({20, 50, 0}, 100, WEND_WALL), Hit(80, WEND_WALL));
  EXPECT_EQ(arena.cast({20, 50, 0}, 5, WEND_WALL | WEND_OBSTACLE), Hit(5, WEND_NOTHING));
  EXPECT_EQ(arena.cast({31, 50, 0}, 5, WEND_WALL | WEND_OBSTACLE), Hit(0, WEND_OBSTACLE));
  EXPECT_EQ(arena.cast({101, 50, 0}, 5, WEND_WALL), Hit(0, WEND_WALL));
  EXPECT_EQ(arena.clearance(30, 50, WEND_OBSTACLE), -4);
  EXPECT_EQ(arena.clearance(-1, 50, WEND_WALL), -1);
}

TEST(Arena, ScoresAsBarnDoes) {
  Arena arena(empty_scene(), world_values({{"optimal", 1}, {"optimal_speed", 2}}), robot_values());
  arena.reset();
  while (arena.flags() == 0) arena.step({1, 0});
  EXPECT_NEAR(arena.metric("time_over_optimal"), 78.0 / 40, 0.01);
  EXPECT_NEAR(arena.metric("barn_score"), 0.5, 1e-9);  // 78 s is below twice the optimal time of 40 s
  arena.reset();
  while (arena.flags() == 0) arena.step({1, 1});
  EXPECT_EQ(arena.metric("barn_score"), 0);
  EXPECT_EQ(arena.metric("spl"), 0);
  EXPECT_EQ(arena.metric("heading_change_rate"), 1);
}

TEST(Arena, PredictsItsOwnMotion) {
  Arena arena(empty_scene(), world_values({{"dt", 0.1}, {"substeps", 3}}),
              robot_values(1, {{"kinematics/acceleration", 2}, {"kinematics/turn_acceleration", 3}}));
  arena.reset();
  const wend_motion to = arena.predict({10, 50, 0, 0, 0}, {3, 1}, arena.world()->period(arena.self()));
  arena.step({3, 1});
  EXPECT_NEAR(arena.pose().x, to.x, 1e-12);
  EXPECT_NEAR(arena.pose().y, to.y, 1e-12);
  EXPECT_NEAR(arena.pose().heading, to.heading, 1e-12);
  EXPECT_EQ(arena.limits().acceleration, 2);
  EXPECT_EQ(arena.limits().radius, 1);
}

TEST(Arena, ErrorsSayWhatIsWrong) {
  Values robot = robot_values();
  robot.texts["kinematics/type"] = "hover";
  Arena hover(empty_scene(), world_values(), robot);
  EXPECT_EQ(hover.host.failure, "kinematics/type: expected differential, unicycle or turn_then_advance, found hover");
  Arena arena(empty_scene(), world_values(), robot_values());
  arena.reset();
  EXPECT_EQ(arena.step({std::nan(""), 0}), WEND_E_ARGUMENT);
  EXPECT_EQ(arena.host.failure, "action: expected two finite numbers, found nan, 0.000000");
  Scene full = empty_scene();
  full.starts.clear();
  full.discs = {{50, 50, 80}};
  Arena none(full, world_values(), robot_values());
  EXPECT_EQ(none.reset(), WEND_E_PARAMETER);
  EXPECT_EQ(none.host.failure,
            "draw: no start and goal found for robot 0 in the scene \"test\": expected a free way for a body of radius "
            "1.000000 m with 0.000000 m of clearance, 0.000000 m or more from start to goal; lower draw/clearance or "
            "draw/distance, or give starts and goals");
}

}  // namespace
}  // namespace arena
