// Generated scenes: the same from the same key, within their gaps, and with a way for the body.
#include <algorithm>
#include <cmath>
#include <wend/math.hpp>

#include "../scenes/optimal.hpp"
#include "../scenes/placement.hpp"
#include "../scenes/scene_file.hpp"
#include "../scenes/text_file.hpp"
#include "scene_support.hpp"

namespace arena {
namespace {

std::uint64_t key_of(std::uint64_t i) {
  return wend::stream(2024, i);
}
Point start_of(const Scene& scene) {
  return {scene.starts.at(0).x, scene.starts.at(0).y};
}
Point goal_of(const Scene& scene) {
  return {scene.goals.at(0).x, scene.goals.at(0).y};
}

template <class Kind>
void expect_pure(const Kind& kind) {
  EXPECT_EQ(format_scene(generate(kind, 7)), format_scene(generate(kind, 7)));
  EXPECT_NE(format_scene(generate(kind, 7)), format_scene(generate(kind, 8)));
}

TEST(Generate, IsAFunctionOfItsKey) {
  expect_pure(RandomObstacles{});
  expect_pure(UTrap{});
  expect_pure(Rooms{});
  expect_pure(DoorRoom{});
  expect_pure(Cellular{});
}

void expect_gaps(const Scene& scene, const RandomObstacles& p) {
  for (const Disc& a : scene.discs) {
    EXPECT_GE(std::min({a.x, a.y, scene.width - a.x, scene.height - a.y}) - a.radius, p.wall_gap - 1e-9);
    EXPECT_GE(a.radius, p.radius[0]);
    EXPECT_LE(a.radius, p.radius[1]);
    for (const Disc& b : scene.discs)
      EXPECT_TRUE(&a == &b || std::hypot(a.x - b.x, a.y - b.y) - a.radius - b.radius >= p.gap - 1e-9);
  }
}

// Goal-direct driving meets an obstacle on most of these maps.
double share_blocked(const Scene& scene, std::uint64_t key) {
  wend::Random random(key);
  int blocked = 0, n = 0;
  while (n < 50) {
    Point a{}, b{};
    if (!draw_place(scene, random, 0, 0, 100, 100, 6, a) || !draw_place(scene, random, 0, 0, 100, 100, 6, b)) return -1;
    if (std::hypot(a.x - b.x, a.y - b.y) < 50) continue;
    bool hit = false;
    for (int i = 0; i <= 100; ++i)
      hit = hit || clearance(scene, {a.x + (b.x - a.x) * i / 100, a.y + (b.y - a.y) * i / 100}) < 3;
    blocked += hit, ++n;
  }
  return blocked / 50.0;
}

TEST(Generate, RandomObstaclesKeepTheirGapsAndStandInTheWay) {
  RandomObstacles ordinary, dense;
  dense.gap = 10, dense.density = 0.2;
  double blocked = 0, crowd = 0;
  for (std::uint64_t i = 0; i < 10; ++i) {
    const Scene a = generate(ordinary, key_of(i)), b = generate(dense, key_of(i));
    expect_gaps(a, ordinary);
    expect_gaps(b, dense);
    EXPECT_TRUE(a.starts.empty());  // the world draws them
    EXPECT_TRUE(all_joined(a, 3));
    blocked += share_blocked(a, i) / 10, crowd += share_blocked(b, i) / 10;
  }
  EXPECT_GT(blocked, 0.6);
  EXPECT_GT(crowd, 0.85);
}

TEST(Generate, LargeMapInTime) {
  RandomObstacles large;
  large.size = {500, 500}, large.placement = "corners";
  const Scene scene = generate(large, 3);
  expect_gaps(scene, large);
  EXPECT_GT(scene.discs.size(), 200u);
  EXPECT_GT(optimal_length(scene, start_of(scene), goal_of(scene), {1, 3, 0}), 650);
}

TEST(Generate, PlacementWithTheMap) {
  RandomObstacles p;
  p.placement = "random", p.distance = 60;
  for (std::uint64_t i = 0; i < 10; ++i) {
    const Scene scene = generate(p, key_of(i));
    const Point start = start_of(scene), goal = goal_of(scene);
    EXPECT_GE(std::hypot(start.x - goal.x, start.y - goal.y), 60);
    EXPECT_GE(clearance(scene, start), 6);
    EXPECT_GE(clearance(scene, goal), 6);
    EXPECT_GT(optimal_length(scene, start, goal, {1, 3, 0}), 60);
  }
  p.placement = "corners";
  EXPECT_EQ(start_of(generate(p, 1)).x, 6);
  EXPECT_EQ(goal_of(generate(p, 1)).y, 94);
}

// The mirror image of a point in the line from start to goal.
Point mirrored(const Scene& scene, Point p) {
  const Point a = start_of(scene), b = goal_of(scene);
  const double dx = b.x - a.x, dy = b.y - a.y, t = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
  return {2 * (a.x + t * dx) - p.x, 2 * (a.y + t * dy) - p.y};
}

TEST(Generate, UTrapsAreSymmetricOpenToTheStartAndInTheWay) {
  const double sizes[][2] = {{10, 8}, {20, 15}, {40, 30}, {60, 50}};
  for (const auto& size : sizes) {
    UTrap p;
    p.width = size[0], p.depth = size[1];
    for (std::uint64_t i = 0; i < 10; ++i) {
      const Scene scene = generate(p, key_of(i));
      const Point a = start_of(scene), b = goal_of(scene);
      const double straight = std::hypot(a.x - b.x, a.y - b.y);
      const auto on_line = [&](double s) {
        return Point{a.x + (b.x - a.x) * s / straight, a.y + (b.y - a.y) * s / straight};
      };
      EXPECT_GT(clearance(scene, on_line(0.95 * (p.before + p.depth) - 1)), 0);  // one drives into it...
      double least = 1e9;
      for (double s = 0; s <= straight; s += 0.25) least = std::min(least, clearance(scene, on_line(s)));
      EXPECT_LT(least, 0);  // ...and on to its back wall
      wend::Random random(i);
      for (int k = 0; k < 200; ++k) {
        const Point q{random.uniform(10, 90), random.uniform(10, 90)}, m = mirrored(scene, q);
        Scene open = scene;
        open.walled = false;
        EXPECT_NEAR(clearance(open, q), clearance(open, m), 1e-9);
      }
      const double length = optimal_length(scene, a, b, {0.5, 3, 0});
      EXPECT_GT(length, 1.05 * straight) << size[0];
      EXPECT_GE(scene.width, 100);
      EXPECT_GE(std::min(clearance(scene, a), clearance(scene, b)), 9.9);
    }
  }
}

TEST(Generate, RoomsAreJoinedByNarrowDoorsOnly) {
  for (const auto& [columns, rows, count] : {std::array{2u, 1u, 0u}, std::array{3u, 2u, 10u}}) {
    Rooms p;
    p.rooms = {columns, rows}, p.count = count;
    for (std::uint64_t i = 0; i < 10; ++i) {
      const Scene scene = generate(p, key_of(i));
      EXPECT_GE(optimal_length(scene, start_of(scene), goal_of(scene), {0.5, 3, 0}), 0);
      EXPECT_EQ(optimal_length(scene, start_of(scene), goal_of(scene), {0.5, 5.6, 0}), -1);  // wider than any door
    }
  }
}

TEST(Generate, DoorRoomHasItsStreetsItsDoorAndItsPatrols) {
  DoorRoom p;
  p.patrols = 3, p.goals = 3;
  for (std::uint64_t i = 0; i < 10; ++i) {
    const Scene scene = generate(p, key_of(i));
    EXPECT_EQ(scene.polygons.size(), 8u);
    EXPECT_EQ(scene.goals.size(), 3u);
    ASSERT_EQ(scene.movers.size(), 3u);
    for (const Mover& mover : scene.movers) {
      EXPECT_GE(mover.speed, 0.04);
      EXPECT_LE(mover.speed, 0.05);
      for (int k = 0; k <= 20; ++k) {
        const Point &a = mover.waypoints[0], &b = mover.waypoints[1];
        EXPECT_GT(clearance(scene, {a.x + (b.x - a.x) * k / 20, a.y + (b.y - a.y) * k / 20}), mover.radius);
      }
    }
    for (const Goal& goal : scene.goals) {
      EXPECT_GE(optimal_length(scene, {0.6, 0.6}, {goal.x, goal.y}, {0.05, 0.25, 0}), 0);
      EXPECT_GT(goal.y, 8);
    }
    const Point behind{5, 9.2};
    EXPECT_GE(optimal_length(scene, {0.6, 0.6}, behind, {0.05, 0.5, 0}), 0);
    EXPECT_EQ(optimal_length(scene, {0.6, 0.6}, behind, {0.05, 0.62, 0}), -1);  // the door is 1.2 m wide
  }
}

TEST(Generate, DoorRoomMayHaveItsGoalsAboutTheDoor) {
  DoorRoom p;
  p.goals = 3, p.goal_spread = 5;
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Scene scene = generate(p, key_of(i));
    ASSERT_EQ(scene.goals.size(), 3u);
    const double door = scene.polygons[6].points[1].x + p.door / 2, first = std::clamp(door - 2.5, 0.0, 5.0);
    for (std::size_t g = 0; g < 3; ++g) {
      EXPECT_GT(scene.goals[g].x, first + 5.0 / 3 * static_cast<double>(g));
      EXPECT_LT(scene.goals[g].x, first + 5.0 / 3 * static_cast<double>(g + 1));
    }
  }
  p.goal_spread = 3;
  EXPECT_EQ(error_of([&] { generate(p, 1); }),
            "generate/goal_spread: expected room for a robot on each goal, found less: choose a larger one, or 0 for the "
            "whole width");
}

TEST(Generate, DoorRoomMayHaveItsPatrolsOnTheWaysToTheDoor) {
  DoorRoom p;
  p.patrols = 3, p.patrol_beat = 3;
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Scene scene = generate(p, key_of(i));
    ASSERT_EQ(scene.movers.size(), 3u);
    const double door = scene.polygons[6].points[1].x + p.door / 2;
    const auto& before = scene.movers[0].waypoints;
    EXPECT_LE(before[1].x - before[0].x, 3 + 1e-9);
    EXPECT_LE(before[0].x, door);
    EXPECT_GE(before[1].x, door);
    for (const Mover& mover : scene.movers) {
      const Point &a = mover.waypoints[0], &b = mover.waypoints[1];
      for (int k = 0; k <= 20; ++k)
        EXPECT_GT(clearance(scene, {a.x + (b.x - a.x) * k / 20, a.y + (b.y - a.y) * k / 20}), 0.5);
    }
    EXPECT_EQ(scene.movers[1].waypoints[0].x, scene.movers[1].waypoints[1].x) << "up and down";
  }
}

TEST(Generate, DoorRoomKeepsItsDoorBeforeTheGoals) {
  double farthest = 0;
  for (const double offset : {1.0, 1000.0}) {
    DoorRoom p;
    p.door_offset = offset;
    for (std::uint64_t i = 0; i < 30; ++i) {
      const Scene scene = generate(p, key_of(i));
      const double door = scene.polygons[6].points[1].x + p.door / 2;  // beyond the wall's left part
      const double apart = std::fabs(door - scene.goals[0].x);
      EXPECT_LE(apart, offset);
      farthest = std::max(farthest, apart);
    }
  }
  EXPECT_GT(farthest, 4) << "anywhere by default";
}

struct Difficulty {
  double density = 0, length = 0, width = 0;  // share of cells; m; m, radius that still passes
};

Difficulty difficulty_of(const Scene& scene) {
  Difficulty d;
  for (int column = 1; column < 29; ++column)
    for (int row = 34; row < 63; ++row) d.density += scene.grid.at(column, row) / (28.0 * 29.0);
  const Point start{-2.25, 3}, goal{-2.25, 13};
  d.length = optimal_length(scene, start, goal, {0.05, 0.3, 0});
  double high = 1.5;
  for (int i = 0; i < 8; ++i) {
    const double middle = (d.width + high) / 2;
    (optimal_length(scene, start, goal, {0.05, middle, 0}) >= 0 ? d.width : high) = middle;
  }
  return d;
}

template <class Make>
Difficulty mean_difficulty(int n, Make&& make) {
  Difficulty mean;
  for (int i = 0; i < n; ++i) {
    const Difficulty d = difficulty_of(make(i));
    mean.density += d.density / n, mean.length += d.length / n, mean.width += d.width / n;
  }
  return mean;
}

TEST(Generate, CellularLiesAsTheBarnWorldsDo) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Scene scene = generate(Cellular{}, key_of(i));
    EXPECT_FALSE(scene.walled);
    EXPECT_EQ(scene.x, -4.5);
    EXPECT_DOUBLE_EQ(scene.y + scene.height, 14);
    EXPECT_EQ(start_of(scene).x, -2.25);
    EXPECT_EQ(start_of(scene).y, 3);
    EXPECT_EQ(scene.starts[0].heading, wend::math::half_pi);
    EXPECT_EQ(goal_of(scene).y, 13);
    for (std::int64_t row = 0; row < 64; ++row) EXPECT_TRUE(scene.grid.at(0, row) && scene.grid.at(29, row));
    for (std::int64_t row = 1; row < 34; ++row)
      for (std::int64_t column = 1; column < 29; ++column) EXPECT_FALSE(scene.grid.at(column, row));
    EXPECT_GE(difficulty_of(scene).width, 0.35);
    Cellular discs;
    discs.discs = true;
    EXPECT_EQ(generate(discs, key_of(i)).grid.columns, 0u);
  }
}

TEST(Generate, CellularIsAsHardAsTheBarnMapsOrSlightlyHarder) {
  const std::string folder = data_path("barn/maps");
  SKIP_WITHOUT(folder);
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  const MapOptions options{0.15, -4.5, 0, true, false, false};
  const Difficulty real = mean_difficulty(static_cast<int>(files.size()), [&](int i) {
    return parse_movingai_map(files[static_cast<std::size_t>(i)], read_text(files[static_cast<std::size_t>(i)]),
                              options);
  });
  const Difficulty ours =
      mean_difficulty(100, [](int i) { return generate(Cellular{}, key_of(static_cast<std::uint64_t>(i))); });
  EXPECT_NEAR(ours.density, real.density, 0.025);
  EXPECT_GE(ours.length, real.length - 0.02);
  EXPECT_LE(ours.length, real.length + 0.25);
  EXPECT_LE(ours.width, real.width + 0.01);
  EXPECT_GE(ours.width, real.width - 0.12);
}

TEST(Generate, SaysWhyNothingCanBeDrawn) {
  RandomObstacles many;
  many.count = 500;
  EXPECT_EQ(error_of([&] { generate(many, 1); }),
            "generate/count: expected room for 500 discs, found none in 20 tries: choose fewer, smaller ones, or "
            "smaller gaps");
  RandomObstacles dust;
  dust.radius = {0.01, 0.01}, dust.gap = 0;
  EXPECT_EQ(error_of([&] { generate(dust, 1); }),
            "generate/density: expected at most 20000 discs, found more: choose fewer, larger ones, or a smaller size");
  UTrap small;
  small.size = {50, 50};
  EXPECT_EQ(error_of([&] { generate(small, 1); }),
            "generate/size: expected room for the trap, start, goal and a robot beside them, found none in 1000 tries: "
            "choose "
            "a larger size, or 0 for one that fits");
  Rooms narrow;
  narrow.door = {5, 5};
  EXPECT_EQ(error_of([&] { generate(narrow, 1); }),
            "generate/door: expected doors wider than the body's diameter, found narrower ones");
  DoorRoom tiny;
  tiny.size = {5, 5};
  EXPECT_EQ(error_of([&] { generate(tiny, 1); }),
            "generate/size: expected room for blocks between the streets, found none: choose a larger size or narrower "
            "streets");
  Cellular full;
  full.fill = {0.6, 0.6};
  EXPECT_EQ(
      error_of([&] { generate(full, 1); }),
      "generate/fill: expected a way from start to goal, found none in 1000 tries: choose less fill or a smaller body");
}

}  // namespace
}  // namespace arena
