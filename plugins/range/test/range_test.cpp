// The sensor through its C table, in a plane of discs whose distances follow from a pencil sketch.
#include <gtest/gtest.h>

#include <cmath>
#include <wend/math.hpp>
#include <wend/testing_plane.hpp>

using wend::testing::Bench;
using wend::testing::error_of;
using wend::testing::Plane;

namespace {

constexpr double pi = wend::math::pi;

// The parameters as the host would fill them in.
struct Sonar : Bench {
  explicit Sonar(const Plane& plane, std::uint32_t copies = 1, std::uint32_t robots = 1)
      : Bench(*wend_plugin_1.components[0]) {
    set("field_deg", 360).set("cone_deg", 0).set("rays_per_cone", 7).set("reach", 20).set("from", "rim");
    set("noise", 0).set("noise_m", 0).set("sees", {"walls", "obstacles", "movers", "robots"}).set("kinds", 0);
    use("world", plane.ref()).Bench::copies(copies).Bench::robots(robots);
  }
};

}  // namespace

TEST(Range, MeasuresFromTheRimAlongEachAxis) {
  Plane plane;
  plane->motions[0] = {1, 2, pi / 2, 0, 0};
  plane->obstacles = {{1, 7, 1}, {-9, 2, 2}};  // 5 m ahead, 10 m to the left
  Sonar sonar(plane);
  ASSERT_TRUE(sonar.set("beams", 4).create()) << sonar.error();
  const auto seen = sonar.sense();
  EXPECT_NEAR(seen[0], 5 - 1 - 0.3, 1e-12);
  EXPECT_NEAR(seen[1], 10 - 2 - 0.3, 1e-12);
  EXPECT_EQ(seen[2], 20);
  EXPECT_EQ(seen[3], 20);
}

TEST(Range, MeasuresFromTheCentre) {
  Plane plane;
  plane->obstacles = {{5, 0, 1}};
  Sonar sonar(plane);
  ASSERT_TRUE(sonar.set("axes_deg", {0.0}).set("from", "centre").create());
  EXPECT_NEAR(sonar.sense()[0], 4, 1e-12);
}

TEST(Range, ColumnsCarryNameUnitBoundsAndBearing) {
  Plane plane;
  Sonar sonar(plane);
  ASSERT_TRUE(sonar.set("axes_deg", {75.0, -75.0}).set("reach", 5).set("kinds", 1).create());
  const wend_space* space = sonar.table<wend_sensor>(WEND_SENSOR)->space(sonar.ref().self);
  ASSERT_EQ(space->width, 4u);
  EXPECT_STREQ(space->columns[1].name, "range.1");
  EXPECT_STREQ(space->columns[1].unit, "m");
  EXPECT_EQ(space->columns[1].low, 0);
  EXPECT_EQ(space->columns[1].high, 5);
  EXPECT_NEAR(space->columns[1].at, -75 * wend::math::degree, 1e-15);
  EXPECT_STREQ(space->columns[2].name, "kind.0");
  EXPECT_NEAR(space->columns[2].at, 75 * wend::math::degree, 1e-15);
}

TEST(Range, AConeReadsTheLeastOfItsRays) {
  Plane plane;
  plane->obstacles = {{6 * std::cos(0.26), 6 * std::sin(0.26), 0.3}};  // at 14.9 degrees: within the cone, off the axis
  Sonar sonar(plane);
  ASSERT_TRUE(sonar.set("axes_deg", {0.0}).create());
  EXPECT_EQ(sonar.sense()[0], 20);
  ASSERT_TRUE(sonar.set("cone_deg", 30).create());
  EXPECT_NEAR(sonar.sense()[0], 6 - 0.3 - 0.3, 2e-3);
}

TEST(Range, ARayThatStartsInsideAnObstacleReadsZero) {
  Plane plane;
  plane->obstacles = {{0.5, 0, 0.4}};  // reaches to 0.1 m from the centre; the rim is at 0.3 m
  Sonar sonar(plane);
  ASSERT_TRUE(sonar.set("beams", 2).set("noise_m", 0).create());
  EXPECT_EQ(sonar.sense()[0], 0);
}

TEST(Range, SeesOtherRobotsButNotItself) {
  Plane plane(1, 2);
  plane->motions[1] = {4, 0, 0, 0, 0};
  Sonar sonar(plane, 1, 2);
  ASSERT_TRUE(sonar.set("beams", 2).set("kinds", 1).create());
  const auto seen = sonar.sense();  // rows of range.0, range.1, kind.0, kind.1
  EXPECT_NEAR(seen[0], 4 - 0.6, 1e-12);
  EXPECT_EQ(seen[1], 20);
  EXPECT_EQ(seen[2], WEND_ROBOT);
  EXPECT_EQ(seen[3], WEND_NOTHING);
  EXPECT_EQ(seen[4], 20);
  EXPECT_NEAR(seen[5], 4 - 0.6, 1e-12);
}

TEST(Range, SeesTheKindsItIsAskedToSee) {
  Plane plane;
  plane->movers = {{5, 0, 1}};
  plane->goals[0] = {3, 0, 1};
  Sonar sonar(plane);
  sonar.set("axes_deg", {0.0}).set("kinds", 1);
  ASSERT_TRUE(sonar.create());
  EXPECT_NEAR(sonar.sense()[0], 3.7, 1e-12);
  EXPECT_EQ(sonar.sense()[1], WEND_MOVER);
  ASSERT_TRUE(sonar.set("sees", {"walls", "goal", "movers", "robots"}).create());
  EXPECT_NEAR(sonar.sense()[0], 1.7, 1e-12);
  EXPECT_EQ(sonar.sense()[1], WEND_GOAL);
}

TEST(Range, NoiseHasTheStatedSpreadAndStaysWithinBounds) {
  Plane plane;
  plane->obstacles = {{11.3, 0, 1}};  // 10 m from the rim
  Sonar sonar(plane);
  ASSERT_TRUE(sonar.set("axes_deg", {0.0, 90.0}).set("noise", 0.02).set("noise_m", 0.1).create());
  sonar.begin(3);
  double sum = 0, squares = 0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const auto seen = sonar.sense();
    sum += seen[0] - 10, squares += (seen[0] - 10) * (seen[0] - 10);
    ASSERT_EQ(seen[1], 20) << "no echo, no error";
  }
  EXPECT_NEAR(sum / n, 0, 4 * std::sqrt(0.05 / n));
  EXPECT_NEAR(squares / n, 0.2 * 0.2 + 0.1 * 0.1, 0.002);

  ASSERT_TRUE(sonar.set("noise", 3).create());
  sonar.begin(3);
  bool at_zero = false, at_reach = false;
  for (int i = 0; i < 100; ++i) {
    const double seen = sonar.sense()[0];
    ASSERT_TRUE(seen >= 0 && seen <= 20);
    at_zero |= seen == 0, at_reach |= seen == 20;
  }
  EXPECT_TRUE(at_zero && at_reach);
}

TEST(Range, NoiseDoesNotDependOnTheBatch) {
  Plane plane(3, 1);
  plane->obstacles = {{11.3, 0, 1}};
  Sonar together(plane, 3), apart(plane, 3);
  ASSERT_TRUE(together.set("beams", 5).set("noise", 0.1).create());
  ASSERT_TRUE(apart.set("beams", 5).set("noise", 0.1).create());
  together.begin(8), apart.begin(8);
  std::vector<double> first, second;
  for (int step = 0; step < 3; ++step)
    for (const double value : together.sense()) first.push_back(value);
  std::vector<std::vector<double>> steps(3);
  for (const std::uint32_t row : {2u, 0u, 1u})
    for (int step = 0; step < 3; ++step) {
      const auto seen = apart.sense({row});
      steps[step].resize(15);
      std::copy(seen.begin(), seen.end(), steps[step].begin() + 5 * row);
    }
  for (const auto& step : steps) second.insert(second.end(), step.begin(), step.end());
  EXPECT_EQ(first, second);
  EXPECT_NE(first[0], first[5]) << "rows err independently";
  EXPECT_NE(first[0], first[15]) << "steps err independently";
  together.begin(8);
  const auto again = together.sense();
  EXPECT_TRUE(std::equal(again.begin(), again.end(), first.begin())) << "an episode can be replayed";
}

TEST(Range, RefusesAxesAndBeamsTogether) {
  Plane plane;
  Sonar sonar(plane);
  EXPECT_FALSE(sonar.set("axes_deg", {0.0}).set("beams", 3).create());
  EXPECT_EQ(sonar.parameter(), "beams");
  EXPECT_EQ(sonar.error(), "expected either axes_deg or beams, found both");
}

TEST(Range, RefusesAWorldThatGivesNaN) {
  struct Broken : wend::testing::PlaneWorld {
    using PlaneWorld::PlaneWorld;
    void cast(wend::Rows, std::span<const wend_pose> rays, double, std::uint32_t, double* distance,
              std::uint8_t* kind) {
      for (std::size_t i = 0; i < rays.size(); ++i) distance[i] = i == 1 ? std::nan("") : 1, kind[i] = WEND_WALL;
    }
  };
  Bench world(wend::component<Broken>("test.broken"));
  ASSERT_TRUE(world.create());
  Bench bench(*wend_plugin_1.components[0]);
  bench.set("axes_deg", {0}).set("cone_deg", 30).set("rays_per_cone", 3).set("reach", 20).set("from", "rim");
  bench.set("noise", 0).set("noise_m", 0).set("sees", {"walls"}).set("kinds", 0).use("world", world.ref());
  ASSERT_TRUE(bench.create()) << bench.error();
  EXPECT_EQ(error_of([&] { bench.sense(); }),
            "cast of row 0: expected a distance of 0 m or more from the world, found NaN");
}
