// Clearance and lengths against closed forms and plain sampling.
#include "clearance_grid.hpp"

#include <gtest/gtest.h>

#include <wend/random.hpp>

#include "rooms.hpp"

using ga::Area;
using ga::ClearanceGrid;
using ga::Point;

TEST(ClearanceGrid, CoversItsArea) {
  const ClearanceGrid grid({-1, 2, 2, 3}, 0.3);
  EXPECT_EQ(grid.columns(), 11u);
  EXPECT_EQ(grid.rows(), 5u);
  EXPECT_EQ(grid.lattice_point(0).x, -1);
  EXPECT_EQ(grid.lattice_point(0).y, 2);
  EXPECT_GE(grid.lattice_point(grid.columns() * grid.rows() - 1).x, 2 - 1e-12);
  EXPECT_GE(grid.lattice_point(grid.columns() * grid.rows() - 1).y, 3);
  EXPECT_GT(grid.at(0, 2.5), 1e5) << "nothing is near";
}

TEST(ClearanceGrid, InterpolatesLinesExactly) {
  ClearanceGrid grid({0, 0, 2, 2}, 0.25);
  std::vector<double> values;
  for (std::size_t k = 0; k < grid.columns() * grid.rows(); ++k) {
    const Point p = grid.lattice_point(k);
    values.push_back(3 * p.x - 2 * p.y + 1);
  }
  grid.set(0, values);
  EXPECT_NEAR(grid.at(0.4, 1.3), 3 * 0.4 - 2 * 1.3 + 1, 1e-6);
  EXPECT_NEAR(grid.at(2, 2), 3, 1e-6);
  EXPECT_NEAR(grid.at(7, -3), 7, 1e-6) << "as at the corner (2, 0)";
}

TEST(ClearanceGrid, ADiscIsAddedWhereItIsNearest) {
  ClearanceGrid grid = ga::testing::room(4, {}, 0.02);
  grid.add({1.5, 2, 0.4});
  EXPECT_NEAR(grid.at(1.5, 3), 0.6, 1e-3);
  EXPECT_NEAR(grid.at(2.5, 2.75), std::hypot(1, 0.75) - 0.4, 1e-3);
  EXPECT_NEAR(grid.at(0.1, 0.1), 0.1, 1e-3) << "the wall is nearer";
  EXPECT_NEAR(grid.at(1.7, 2), -0.2, 1e-3);
}

TEST(ClearanceGrid, AWayThroughADiscIsAChordOfTheInflatedOne) {
  ClearanceGrid grid({0, 0, 10, 10}, 0.05);
  grid.add({5, 5, 0.7});
  for (const double needed : {0.0, 0.15, 0.3})
    for (const double off : {0.0, 0.2, 0.5, 0.65, 0.9, 1.2}) {
      const double radius = 0.7 + needed, chord = off < radius ? 2 * std::sqrt(radius * radius - off * off) : 0;
      EXPECT_NEAR(grid.length_within({1, 5 + off}, {9, 5 + off}, needed), chord, 0.03) << needed << " " << off;
      EXPECT_NEAR(grid.length_within({5 - off, 9.5}, {5 - off, 0.3}, needed), chord, 0.03) << needed << " " << off;
    }
  EXPECT_NEAR(grid.length_within({5, 5}, {9, 5}, 0.15), 0.85, 0.01) << "it starts inside";
  EXPECT_NEAR(grid.length_within({5.1, 5}, {5.3, 5.1}, 0.15), std::hypot(0.2, 0.1), 1e-9) << "it stays inside";
  EXPECT_EQ(grid.length_within({5, 5}, {5, 5}, 0.15), 0);
}

TEST(ClearanceGrid, AWallIsAsThickAsItIsInflated) {
  const ClearanceGrid grid = ga::testing::room(10, {{0, 5, 6, 5.3}, {7.2, 5, 10, 5.3}});
  EXPECT_NEAR(grid.length_within({3, 2}, {3, 8}, 0.2), 0.3 + 0.4, 0.01);
  EXPECT_NEAR(grid.length_within({2, 2}, {5, 8}, 0.2), 0.7 * std::sqrt(45.0) / 6, 0.01) << "aslant";
  EXPECT_EQ(grid.length_within({6.6, 2}, {6.6, 8}, 0.2), 0) << "through the door";
  EXPECT_EQ(grid.length_within({6.6, 2}, {6.6, 8}, 0.55), 0);
  EXPECT_NEAR(grid.length_within({6.6, 2}, {6.6, 8}, 0.65), 0.3 + 2 * std::sqrt(0.65 * 0.65 - 0.36), 0.02);
}

TEST(ClearanceGrid, AgreesWithPlainSampling) {
  const std::vector<Area> blocks{
      {1.2, 1.3, 3, 3}, {4.2, 1, 6, 2.7}, {2, 5, 4, 6.5}, {0, 7.5, 5, 7.8}, {6.2, 7.5, 9, 7.8}};
  const ClearanceGrid grid = ga::testing::room(9, blocks);
  wend::Random random(5);
  for (int k = 0; k < 200; ++k) {
    const Point a{random.uniform(0, 9), random.uniform(0, 9)}, b{random.uniform(0, 9), random.uniform(0, 9)};
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const int samples = 20000;
    int within = 0;
    for (int i = 0; i < samples; ++i) {
      const double t = (i + 0.5) / samples;
      within += ga::testing::clearance_in(9, blocks, a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)) < 0.2;
    }
    EXPECT_NEAR(grid.length_within(a, b, 0.2), length * within / samples, 0.06) << k;
  }
}
