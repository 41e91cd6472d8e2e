// Nearest points of every form of obstacle.
#include "../nearest.hpp"

#include <gtest/gtest.h>

using potential_field::Near;
using potential_field::Obstacles;

namespace {

std::vector<Near> around(double x, double y, double reach, const std::vector<wend_shape>& shapes) {
  Obstacles obstacles;
  const auto all = obstacles.around(x, y, reach, shapes);
  return {all.begin(), all.end()};
}
void expect_near(const Near& near, double dx, double dy, double distance) {
  EXPECT_NEAR(near.dx, dx, 1e-12);
  EXPECT_NEAR(near.dy, dy, 1e-12);
  EXPECT_NEAR(near.distance, distance, 1e-12);
}

}  // namespace

TEST(Nearest, Disc) {
  const double at[] = {3, 4};
  const wend_shape disc{WEND_SHAPE_DISC, WEND_OBSTACLE, 1, at, nullptr, 2, 0, 0};
  const auto near = around(0, 0, 10, {disc});
  ASSERT_EQ(near.size(), 1u);
  expect_near(near[0], 1.8, 2.4, 3);
  EXPECT_TRUE(around(0, 0, 3, {disc}).empty()) << "out of reach";
  EXPECT_EQ(around(3, 5, 3, {disc})[0].distance, 0) << "inside";
}

TEST(Nearest, EverySegmentOfItsOwn) {
  const double points[] = {-5, 2, 5, 2, 4, -1, 4, -9};
  const auto near = around(1, 0, 10, {{WEND_SHAPE_SEGMENTS, WEND_WALL, 4, points, nullptr, 0, 0, 0}});
  ASSERT_EQ(near.size(), 2u);
  expect_near(near[0], 0, 2, 2);
  expect_near(near[1], 3, -1, 3.1622776601683795);
}

TEST(Nearest, PolygonFromOutsideAndInside) {
  const double square[] = {1, -1, 3, -1, 3, 1, 1, 1};
  const wend_shape polygon{WEND_SHAPE_POLYGON, WEND_OBSTACLE, 4, square, nullptr, 0, 0, 0};
  expect_near(around(0, 0.5, 10, {polygon})[0], 1, 0, 1);
  expect_near(around(0, 2, 10, {polygon})[0], 1, -1, 1.4142135623730951);
  EXPECT_EQ(around(2, 0, 10, {polygon})[0].distance, 0);
}

TEST(Nearest, ConnectedCellsOfAGridAreOneObstacle) {
  // 5 columns, 3 rows of 1 m from (10, 20); cells that touch at a corner belong together.
  const double corner[] = {10, 20, 1};
  const std::uint8_t cells[] = {1, 0, 0, 0, 1,  //
                                0, 1, 0, 0, 1,  //
                                0, 0, 0, 0, 0};
  const wend_shape grid{WEND_SHAPE_GRID, WEND_OBSTACLE, 5ull << 32 | 3, corner, cells, 0, 0, 0};
  const auto near = around(12.5, 21.5, 20, {grid});
  ASSERT_EQ(near.size(), 2u);
  expect_near(near[0], -0.5, 0, 0.5);
  expect_near(near[1], 1.5, 0, 1.5);
  EXPECT_EQ(around(12.5, 21.5, 1, {grid}).size(), 1u);
  EXPECT_TRUE(around(-100, 0, 5, {grid}).empty()) << "beyond the grid";
  EXPECT_TRUE(around(12.5, 100, 5, {grid}).empty());
}

TEST(Nearest, GoalsAndRobotsAreNoObstacles) {
  const double at[] = {3, 4};
  EXPECT_TRUE(around(0, 0, 10,
                     {{WEND_SHAPE_DISC, WEND_GOAL, 1, at, nullptr, 2, 0, 0},
                      {WEND_SHAPE_DISC, WEND_ROBOT, 1, at, nullptr, 2, 0, 0}})
                  .empty());
}
