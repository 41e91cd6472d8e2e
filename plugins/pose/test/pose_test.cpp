// The pose sensor through its C table: exact on arcs, and odometry whose errors have the stated spread.
#include <gtest/gtest.h>

#include <cmath>
#include <wend/testing_plane.hpp>

using wend::testing::Bench;
using wend::testing::Plane;

namespace {

struct Sensor : Bench {
  explicit Sensor(const Plane& plane, std::uint32_t copies = 1) : Bench(*wend_plugin_1.components[0]) {
    use("world", plane.ref()).Bench::copies(copies);
  }
};

// Drives every row with the same speed and turn rate.
void drive(Plane& plane, std::uint32_t copies, double speed, double turn) {
  std::vector<std::uint32_t> all(copies);
  std::vector<double> actions;
  for (std::uint32_t copy = 0; copy < copies; ++copy) all[copy] = copy, actions.insert(actions.end(), {speed, turn});
  std::vector<wend_outcome> outcomes(copies);
  plane->step(all, wend::Matrix<const double>(actions.data(), copies, 2), outcomes);
}

}  // namespace

TEST(Pose, IsExactAndSpeedAndTurnRateComeFromDifferences) {
  Plane plane;
  plane->goals[0] = {1e6, 0, 1};
  plane->body.speed_low = -1;
  plane->motions[0] = {1, 2, 3, 0, 0};
  Sensor sensor(plane);
  ASSERT_TRUE(sensor.create()) << sensor.error();
  sensor.begin(1);
  EXPECT_EQ(sensor.sense(), (std::vector<double>{1, 2, 3, 0, 0}));
  drive(plane, 1, 0.5, 2.5);  // across +-pi
  const auto& now = plane->motions[0];
  auto seen = sensor.sense();
  EXPECT_EQ(seen[0], now.x);
  EXPECT_EQ(seen[1], now.y);
  EXPECT_EQ(seen[2], now.heading);
  EXPECT_LT(seen[2], 0);
  EXPECT_NEAR(seen[3], 0.5, 1e-12);
  EXPECT_NEAR(seen[4], 2.5, 1e-12);
  drive(plane, 1, -0.25, 0);
  seen = sensor.sense();
  EXPECT_NEAR(seen[3], -0.25, 1e-12);
  EXPECT_NEAR(seen[4], 0, 1e-12);
  sensor.begin(2);
  EXPECT_EQ(sensor.sense()[3], 0) << "a new episode knows nothing of the last";
}

TEST(Pose, OdometryDriftsWithTheStatedSpread) {
  const std::uint32_t n = 2000;
  Plane plane(n);
  for (auto& goal : plane->goals) goal = {1e6, 0, 1};
  Sensor sensor(plane, n);
  sensor.set("drift/distance", 0.05).set("drift/heading", 0.02).set("drift/scale", 0.03).set("drift/bend", 0.01);
  ASSERT_TRUE(sensor.create());
  sensor.begin(5);
  sensor.sense();
  const double metres = 4;
  for (int step = 0; step < 40; ++step) {
    drive(plane, n, 1, 0);
    sensor.sense();
  }
  drive(plane, n, 0, 0);
  const auto seen = sensor.sense();
  double along = 0, heading = 0;
  for (std::uint32_t row = 0; row < n; ++row) {
    along += std::pow(seen[5 * row] - metres, 2) / n;
    heading += std::pow(seen[5 * row + 2], 2) / n;
  }
  // Variances of sums of independent errors; 4 standard errors of a variance of n normals are 4 sqrt(2 / n) = 13 %.
  const double expected_along = 0.05 * 0.05 * metres + std::pow(0.03 * metres, 2);
  const double expected_heading = 0.02 * 0.02 * metres + std::pow(0.01 * metres, 2);
  EXPECT_NEAR(along / expected_along, 1, 0.14);
  EXPECT_NEAR(heading / expected_heading, 1, 0.13);
}

TEST(Pose, OdometryOfATurnInPlaceErrsInHeadingOnly) {
  const std::uint32_t n = 2000;
  Plane plane(n);
  for (auto& goal : plane->goals) goal = {1e6, 0, 1};
  Sensor sensor(plane, n);
  ASSERT_TRUE(sensor.set("drift/turn", 0.1).create());
  sensor.begin(6);
  sensor.sense();
  for (int step = 0; step < 10; ++step) drive(plane, n, 0, 1), sensor.sense();
  drive(plane, n, 0, 0);
  const auto seen = sensor.sense();
  double spread = 0;
  for (std::uint32_t row = 0; row < n; ++row) {
    ASSERT_EQ(seen[5 * row], 0);
    spread += std::pow(seen[5 * row + 2] - 1, 2) / n;
  }
  EXPECT_NEAR(spread / 0.01, 1, 0.13);
}

TEST(Pose, OdometryDoesNotDependOnTheBatch) {
  Plane plane(2);
  for (auto& goal : plane->goals) goal = {1e6, 0, 1};
  Sensor together(plane, 2), apart(plane, 2);
  ASSERT_TRUE(together.set("drift/heading", 0.1).create() && apart.set("drift/heading", 0.1).create());
  together.begin(9);
  apart.begin_rows({1}, 9), apart.begin_rows({0}, 9);
  for (int step = 0; step < 3; ++step) {
    const auto both = together.sense(), second = apart.sense({1}), first = apart.sense({0});
    EXPECT_TRUE(std::equal(first.begin(), first.end(), both.begin()));
    EXPECT_TRUE(std::equal(second.begin(), second.end(), both.begin() + 5));
    drive(plane, 2, 1, 0.3);
  }
}
