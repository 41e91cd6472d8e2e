// Shortest lengths against hand-made sums, against the benchmark's own oracle, and against a plain Dijkstra.
#include "../scenes/optimal.hpp"

#include <cmath>
#include <cstdio>
#include <limits>
#include <wend/random.hpp>

#include "../scenes/text_file.hpp"
#include "scene_support.hpp"

namespace arena {
namespace {

const double root2 = std::sqrt(2.0);

Scene map_of(const std::string& rows, std::uint32_t width, std::uint32_t height) {
  std::string text =
      "type octile\nheight " + std::to_string(height) + "\nwidth " + std::to_string(width) + "\nmap\n" + rows;
  return parse_movingai_map("map", text, {});
}

double between(const Scene& scene, std::uint32_t height, std::array<std::uint32_t, 2> from,
               std::array<std::uint32_t, 2> to) {
  return optimal_length(scene, cell_centre({}, height, from[0], from[1]), cell_centre({}, height, to[0], to[1]),
                        {1, 0, 0});
}

TEST(Optimal, TinyMapsByHand) {
  const Scene open = map_of("....\n....\n....\n", 4, 3);
  EXPECT_DOUBLE_EQ(between(open, 3, {0, 0}, {3, 2}), 1 + 2 * root2);
  EXPECT_EQ(between(open, 3, {1, 1}, {1, 1}), 0);

  const Scene corner = map_of(".@\n..\n", 2, 2);  // a diagonal may not cut the corner
  EXPECT_DOUBLE_EQ(between(corner, 2, {0, 0}, {1, 1}), 2);

  const Scene crossed = map_of(".@\n@.\n", 2, 2);
  EXPECT_EQ(between(crossed, 2, {0, 0}, {1, 1}), -1);

  // out of the pocket, round the hook and on to its back: 2 + 1 + 4 + 1 straight, none aslant past a corner
  const Scene hook = map_of("......\n.@@@@.\n....@.\n.@@@@.\n......\n", 6, 5);
  EXPECT_DOUBLE_EQ(between(hook, 5, {3, 2}, {5, 2}), 3 + 2 + 5 + 2);
}

TEST(Optimal, LengthsAreMetric) {
  MapOptions options;
  options.cell = 0.5, options.x = 10;
  const Scene scene = parse_movingai_map("map", "height 1\nwidth 4\nmap\n....\n", options);
  EXPECT_DOUBLE_EQ(optimal_length(scene, {10.25, 0.25}, {11.75, 0.25}, {0.5, 0, 0}), 1.5);
  // a point between centres is joined by straight legs, not rounded
  EXPECT_DOUBLE_EQ(optimal_length(scene, {10.1, 0.25}, {11.9, 0.25}, {0.5, 0, 0}), 1.8);
  EXPECT_NEAR(optimal_length(scene, {10.1, 0.25}, {10.3, 0.25}, {0.5, 0, 0}), 0.2, 1e-12);
}

TEST(Optimal, EndsAtTheRimOfTheGoal) {
  Scene scene;
  scene.width = scene.height = 20;
  EXPECT_DOUBLE_EQ(optimal_length(scene, {2.25, 10.25}, {17.25, 10.25}, {0.5, 0, 0}), 15);
  EXPECT_DOUBLE_EQ(optimal_length(scene, {2.25, 10.25}, {17.25, 10.25}, {0.5, 0, 3}), 12);
  EXPECT_NEAR(optimal_length(scene, {2, 10}, {17, 10}, {0.5, 0, 0}), 15, 0.15);  // two ends on corners of cells
  EXPECT_EQ(optimal_length(scene, {15, 10}, {17, 10}, {0.5, 0, 3}), 0);
}

TEST(Optimal, BodyNeedsItsWidth) {
  Scene scene;
  scene.width = scene.height = 20;
  scene.polygons = {{{{9, 0}, {11, 0}, {11, 9}, {9, 9}}}, {{{9, 11}, {11, 11}, {11, 20}, {9, 20}}}};  // a gap of 2 m
  EXPECT_NEAR(optimal_length(scene, {3, 10}, {17, 10}, {0.1, 0.9, 0}), 14, 0.1);
  EXPECT_EQ(optimal_length(scene, {3, 10}, {17, 10}, {0.1, 1.1, 0}), -1);
  scene.polygons.clear();
  scene.segments = {{10, 0, 10, 15}};  // as thin as it is, nothing passes through it
  const double around = optimal_length(scene, {9, 2}, {11, 2}, {0.25, 0, 0});
  EXPECT_GT(around, 26);
  EXPECT_LT(around, 27.5);
  scene.segments = {{3, 0, 20, 17.1}};  // nor aslant
  EXPECT_EQ(optimal_length(scene, {3, 17}, {17, 3}, {0.25, 0, 0}), -1);
}

TEST(Optimal, OpenBoundsLetTheWayLeadAroundThem) {
  Scene scene;
  scene.width = scene.height = 10;
  scene.polygons = {{{{4, 0}, {5, 0}, {5, 10}, {4, 10}}}};
  EXPECT_EQ(optimal_length(scene, {2, 5}, {8, 5}, {0.25, 0.5, 0}), -1);
  scene.walled = false;
  EXPECT_GT(optimal_length(scene, {2, 5}, {8, 5}, {0.25, 0.5, 0}), 11);
  EXPECT_GT(optimal_length(scene, {2, 5}, {8, 30}, {0.25, 0.5, 0}), 25);  // the goal is outside
}

// Relaxes every edge until nothing changes.
std::vector<double> bellman_ford(const std::vector<std::uint8_t>& free, std::size_t width, std::size_t goal) {
  std::vector<double> steps(free.size(), std::numeric_limits<double>::infinity());
  steps[goal] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = width + 1; i + width + 1 < free.size(); ++i) {
      if (!free[i]) continue;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const auto at = [&](int x, int y) {
            return static_cast<std::size_t>(static_cast<long>(i) + x + y * static_cast<long>(width));
          };
          if (!free[at(dx, dy)] || !free[at(dx, 0)] || !free[at(0, dy)]) continue;
          const double via = steps[at(dx, dy)] + std::sqrt(static_cast<double>(dx * dx + dy * dy));
          if (via + 1e-12 < steps[i]) steps[i] = via, changed = true;
        }
      }
    }
  }
  return steps;
}

TEST(Optimal, FieldEqualsPlainRelaxationOnRandomGrids) {
  for (std::uint64_t key = 0; key < 10; ++key) {
    wend::Random random(key);
    Scene scene;
    scene.width = 24, scene.height = 17;
    scene.grid.columns = 24, scene.grid.rows = 17;
    std::vector<std::uint8_t> free(26 * 19, 0);
    for (std::size_t i = 0; i < 24 * 17; ++i) {
      scene.grid.occupied.push_back(i != 200 && random.chance(0.3) ? 1 : 0);
      free[(i / 24 + 1) * 26 + i % 24 + 1] = scene.grid.occupied[i] == 0;
    }
    const auto space = std::make_shared<const FreeSpace>(scene, 1.0, 0.0);
    const DistanceField field(space, {200 % 24 + 0.5, 200 / 24 + 0.5});
    const std::vector<double> plain = bellman_ford(free, 26, (200 / 24 + 1) * 26 + 200 % 24 + 1);
    for (std::size_t i = 0; i < 24 * 17; ++i) {
      const double expected = plain[(i / 24 + 1) * 26 + i % 24 + 1];
      const double length = field.length({static_cast<double>(i % 24) + 0.5, static_cast<double>(i / 24) + 0.5});
      if (std::isinf(expected))
        EXPECT_EQ(length, -1) << key << " " << i;
      else
        EXPECT_NEAR(length, expected, 1e-9) << key << " " << i;
    }
  }
}

TEST(Optimal, RefusesAGridThatIsTooFine) {
  Scene scene;
  EXPECT_EQ(error_of([&] {
              optimal_length(scene, {1, 1}, {2, 2}, {0.01, 0, 0});
            }),
            "an arena of 100.000000 m x 100.000000 m in cells of 0.010000 m: expected at most 16 million cells; choose "
            "larger "
            "cells");
}

// The file gives six significant digits; ours, rounded to as many, are the same.
TEST(Optimal, AgreesWithEveryRecordOfTheBenchmark) {
  const std::string map = data_path("movingai/arena.map"), scenario = data_path("movingai/arena.map.scen");
  SKIP_WITHOUT(map);
  const SceneSource source = source_of({{"map", {map}}, {"scenario", scenario}});
  ASSERT_EQ(source.size(), 160u);
  for (std::uint32_t k = 0; k < source.size(); ++k) {
    const ScenePtr scene = make_scene(source, 0, k);
    const Start& start = scene->starts[0];
    const Goal& goal = scene->goals[0];
    const double length = optimal_length(*scene, {start.x, start.y}, {goal.x, goal.y}, {1, 0, 0});
    EXPECT_NEAR(length, scene->optimal_length, 1e-5 * std::max(1.0, length)) << "record " << k;
    char ours[32], theirs[32];
    std::snprintf(ours, sizeof ours, "%.6g", length);
    std::snprintf(theirs, sizeof theirs, "%.6g", scene->optimal_length);
    EXPECT_STREQ(ours, theirs) << "record " << k;
  }
}

// The published path is a bound, no oracle.  For a body of 0.30 m it is legal, so the shortest is no longer.  At the
// clearance that it keeps itself (0.375 m) it cuts four corners, which ours may not, so there ours is longer.  The two
// expected lengths are those of a separate Dijkstra in Python.
TEST(Optimal, PublishedPathOfBarn264IsABound) {
  const std::string map = data_path("barn/maps/barn_264.map"), path = data_path("barn/raw/path_264.npy");
  SKIP_WITHOUT(map);
  SKIP_WITHOUT(path);
  const std::string bytes = read_text(path);
  const std::size_t begin = 10 + static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
  std::vector<std::int64_t> numbers((bytes.size() - begin) / 8);
  std::copy_n(bytes.data() + begin, numbers.size() * 8, reinterpret_cast<char*>(numbers.data()));
  const std::size_t last = numbers.size() - 2;
  double published = 0;
  for (std::size_t i = 2; i < numbers.size(); i += 2)
    published +=
        0.15 * std::sqrt(static_cast<double>((numbers[i] - numbers[i - 2]) * (numbers[i] - numbers[i - 2]) +
                                             (numbers[i + 1] - numbers[i - 1]) * (numbers[i + 1] - numbers[i - 1])));
  EXPECT_NEAR(published, 6.0577, 1e-4);
  const MapOptions options{0.15, -4.5, 0, true, false, false};
  const Scene scene = parse_movingai_map(map, read_text(map), options);
  const auto at = [&](std::size_t i) {  // its columns count from the field's first, the map's 34
    return cell_centre(options, 30, static_cast<std::uint32_t>(numbers[i + 1] + 34),
                       static_cast<std::uint32_t>(numbers[i]));
  };
  const double ours = optimal_length(scene, at(0), at(last), {0.15, 0.3, 0});
  EXPECT_NEAR(ours, 5.969848480983498, 1e-9);
  EXPECT_LE(ours, published);
  const double wide = optimal_length(scene, at(0), at(last), {0.15, 0.35, 0});
  EXPECT_NEAR(wide, 6.14558441227157, 1e-9);
  EXPECT_GT(wide, published);
  // the protocol's own pair of points
  EXPECT_NEAR(optimal_length(scene, {-2.25, 3}, {-2.25, 13}, {0.05, 0.3, 0}), 11.0, 0.1);
}

}  // namespace
}  // namespace arena
