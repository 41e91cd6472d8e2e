// The memory against brute force over the surface points that it was told.
#include "../grid_memory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <wend/math.hpp>
#include <wend/random.hpp>

using rolling_window::Beam;
using rolling_window::GridMemory;
using rolling_window::Percept;
using rolling_window::Point;

namespace {

// A robot of radius 0.5 at (x, y) with beams that read these ranges, evenly spread from bearing 0 on.
Percept scan(double x, double y, const std::vector<double>& ranges, double reach = 10) {
  Percept percept;
  percept.motion = {x, y, 0, 0, 0};
  percept.body = 0.5;
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    Beam beam;
    beam.bearing = wend::math::two_pi * static_cast<double>(k) / static_cast<double>(ranges.size());
    beam.range = std::min(ranges[k], reach), beam.hit = ranges[k] < reach;
    beam.cosine = wend::math::cos(beam.bearing), beam.sine = wend::math::sin(beam.bearing);
    percept.window.push_back(beam);
  }
  return percept;
}
GridMemory::Settings settings(double cell = 0.25, double influence = 2) {
  return {cell, influence, 0.02, 1000000};
}

}  // namespace

TEST(GridMemory, ForgetsNothingItSawOnce) {
  GridMemory memory(settings());
  memory.observe(scan(0, 0, {3, 20, 20, 20}));
  EXPECT_NEAR(memory.clearance(3.5, 0), 0, 1e-6);
  EXPECT_NEAR(memory.clearance(2.5, 0), 1, 1e-6);
  EXPECT_NEAR(memory.clearance(3.5, 1.5), 1.5, 1e-6);
  EXPECT_EQ(memory.clearance(-3.5, 0), 2);  // beyond its influence
  memory.observe(scan(20, 5, {20, 20, 20, 20}));
  EXPECT_NEAR(memory.clearance(2.5, 0), 1, 1e-6);
}

TEST(GridMemory, IsFreeAgainWhereBeamsGoThroughOftenEnough) {
  GridMemory memory(settings());
  memory.observe(scan(0, 0, {3, 20, 20, 20}));
  const auto before = memory.version();
  for (int k = 0; k < 2; ++k) memory.observe(scan(0, 0, {20, 20, 20, 20}));
  EXPECT_NEAR(memory.clearance(3.5, 0), 0, 1e-6);
  EXPECT_EQ(memory.version(), before);
  memory.observe(scan(0, 0, {20, 20, 20, 20}));
  EXPECT_EQ(memory.clearance(3.5, 0), 2);
  EXPECT_GT(memory.version(), before);
}

TEST(GridMemory, ClearancesAreThoseOfBruteForce) {
  wend::Random random(3);
  GridMemory memory(settings());
  std::vector<Point> points;
  for (int k = 0; k < 10; ++k) {  // robots far apart, so that no beam goes through another's surface
    const double x = 30.0 * k, y = 7.0 * k;
    std::vector<double> ranges;
    for (int b = 0; b < 8; ++b) ranges.push_back(random.uniform(0.3, 4));
    const Percept percept = scan(x, y, ranges);
    memory.observe(percept);
    for (const Beam& beam : percept.window)
      points.push_back({x + (0.5 + beam.range) * beam.cosine, y + (0.5 + beam.range) * beam.sine});
  }
  int compared = 0;
  for (int k = 0; k < 5000; ++k) {
    const Point& around = points[random.below(points.size())];
    const double x = around.x + random.uniform(-2, 2), y = around.y + random.uniform(-2, 2);
    double least = 2;
    for (const Point& p : points) least = std::min(least, wend::math::hypot(p.x - x, p.y - y));
    // The nearest point of a cell's centre may be another than that of the place: at most a cell's diagonal worse.
    EXPECT_GE(memory.clearance(x, y), least - 1e-5);
    EXPECT_LE(memory.clearance(x, y), std::min(2.0, least + 0.25 * 1.42));
    compared += memory.clearance(x, y) < least + 1e-5;
  }
  EXPECT_GT(compared, 4500);
}

TEST(GridMemory, RemovalLeavesWhatANewMemoryWouldHold) {
  wend::Random random(5);
  std::vector<double> walls(36, 3.0), open(36, 20.0);
  for (int k = 10; k < 20; ++k) open[static_cast<std::size_t>(k)] = 3;  // this part stays
  GridMemory memory(settings()), fresh(settings());
  memory.observe(scan(0, 0, walls));
  for (int k = 0; k < 6; ++k) memory.observe(scan(0, 0, open));
  for (int k = 0; k < 7; ++k) fresh.observe(scan(0, 0, open));
  for (int k = 0; k < 2000; ++k) {
    const double x = random.uniform(-5, 5), y = random.uniform(-5, 5);
    EXPECT_NEAR(memory.clearance(x, y), fresh.clearance(x, y), 0.1) << x << ' ' << y;
  }
}

TEST(GridMemory, GrowingAndRollingKeepWhatIsInside) {
  GridMemory memory(settings(1, 2));
  memory.observe(scan(0, 0, {3, 20, 20, 20}));
  memory.cover(-200, -100, 150, 100);
  EXPECT_NEAR(memory.clearance(2.5, 0), 1, 1e-6);
  EXPECT_TRUE(memory.contains(-200, -100));
  auto few = settings(1, 2);
  few.most_cells = 1600;
  GridMemory rolling(few);
  rolling.observe(scan(0, 0, {3, 20, 20, 20}));
  for (int x = 0; x <= 100; x += 5) {
    rolling.observe(scan(x, 0, {20, 20, 20, 20}));
    EXPECT_LE(rolling.size(), 1600u);
    EXPECT_TRUE(rolling.contains(x, 0));
  }
  EXPECT_FALSE(rolling.contains(3.5, 0));
  EXPECT_EQ(rolling.clearance(3.5, 0), 2);
}

TEST(GridMemory, ClearIsAFreshStart) {
  GridMemory memory(settings());
  memory.observe(scan(0, 0, {3, 20, 20, 20}));
  memory.clear();
  EXPECT_EQ(memory.size(), 0u);
  EXPECT_EQ(memory.clearance(3.5, 0), 2);
  memory.observe(scan(0, 0, {20, 20, 20, 20}));
  EXPECT_EQ(memory.clearance(3.5, 0), 2);
}
