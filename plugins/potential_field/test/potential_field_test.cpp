// Both components through their C tables.
#include <gtest/gtest.h>

#include <cmath>
#include <wend/testing_plane.hpp>

using wend::testing::Bench;
using wend::testing::error_of;
using wend::testing::Plane;

namespace {

struct Policy : Bench {
  wend::Columns eyes;
  Policy(Plane& plane, int component) : Bench(*wend_plugin_1.components[component]) {
    eyes.box("goal.distance", "m").box("goal.bearing", "rad");
    for (int i = 0; i < 3; ++i) eyes.box("sonar.range." + std::to_string(i), "m", 0, 20, 0.5 - 0.5 * i);
    observation(eyes)
        .action(plane->actions())
        .set("observe", {"sonar.range.*"})
        .set("goal", "goal")
        .use("world", plane.ref());
    set("k_a", 1).set("d_star", 0).set("eta", 400).set("rho_0", 8);
  }
};

}  // namespace

TEST(PotentialField, SumsTheForcesOfTheBeams) {
  Plane plane;
  Policy policy(plane, 0);
  ASSERT_TRUE(policy.create()) << policy.error();
  policy.begin(1);
  policy.act({10, 0.2, 2, 20, 9});  // the left beam sees something 2 m away; the right one beyond rho_0
  const double push = 400 * (1 / 2.0 - 1 / 8.0) / 4;
  const double x = 10 * std::cos(0.2) - push * std::cos(0.5), y = 10 * std::sin(0.2) - push * std::sin(0.5);
  const auto told = policy.telemetry(WEND_PER_STEP);
  EXPECT_NEAR(told[0], x, 1e-12);
  EXPECT_NEAR(told[1], y, 1e-12);
  EXPECT_NEAR(told[2], std::atan2(y, x), 1e-12);
  EXPECT_NEAR(told[3], 10, 1e-12);
  EXPECT_NEAR(told[4], push, 1e-12);
  EXPECT_EQ(policy.explain(),
            "attraction 10 at +11 deg, repulsion 37.5 at -151 deg (nearest: 2 m at +29 deg); steers to -145 deg");
}

TEST(PotentialField, WithoutObstaclesItSteersToTheGoal) {
  Plane plane;
  Policy policy(plane, 0);
  ASSERT_TRUE(policy.create());
  policy.begin(1);
  EXPECT_EQ(policy.act({10, 0, 20, 20, 20}), (std::vector<double>{1, 0}));
  EXPECT_EQ(policy.explain(), "attraction 10 at +0 deg, nothing within 8 m; steers to +0 deg");
}

TEST(PotentialField, AReadingOfTheReachIsNoObstacle) {
  Plane plane;
  Policy policy(plane, 0);
  ASSERT_TRUE(policy.set("rho_0", 30).create());
  policy.begin(1);
  policy.act({10, 0, 20, 20, 20});
  EXPECT_EQ(policy.telemetry(WEND_PER_STEP)[4], 0);
}

TEST(PotentialField, TurnsAwayWithTheTableOfThree) {
  Plane plane;
  plane->dt = 1;
  plane->action_table({{0.5, 0}, {0.25, 1.0 / 12}, {0.25, -1.0 / 12}});
  Policy policy(plane, 0);
  ASSERT_TRUE(policy.create());
  policy.begin(1);
  EXPECT_EQ(policy.act({100, 0, 20, 20, 20})[0], 0);
  EXPECT_EQ(policy.act({10, 0, 1, 20, 20})[0], 2);
  EXPECT_EQ(policy.act({10, 0, 20, 20, 1})[0], 1);
}

TEST(PotentialField, RefusesNaN) {
  Plane plane;
  Policy policy(plane, 0);
  ASSERT_TRUE(policy.create());
  policy.begin(1);
  EXPECT_EQ(error_of([&] {
              policy.act({10, 0, 1, std::nan(""), 1});
            }),
            "observation \"sonar.range.1\": expected a finite number, found NaN");
  EXPECT_EQ(error_of([&] {
              policy.act({INFINITY, 0, 1, 1, 1});
            }),
            "observation \"goal.distance\": expected a finite number, found infinity");
}

TEST(PotentialFieldTrue, TakesTheNearestPointOfEveryDisc) {
  Plane plane;
  plane->motions[0] = {1, 1, wend::math::half_pi, 0, 0};
  plane->obstacles = {{1, 4, 1}, {50, 50, 1}};  // ahead: 2 m from the centre
  plane->movers = {{5, 1, 1}};                  // to the right: 3 m from the centre
  Policy policy(plane, 1);
  ASSERT_TRUE(policy.create()) << policy.error();
  policy.begin(1);
  policy.act({10, 0, 20, 20, 20});
  const auto push = [](double rho) { return 400 * (1 / rho - 1 / 8.0) / (rho * rho); };
  const auto told = policy.telemetry(WEND_PER_STEP);
  EXPECT_NEAR(told[0], 10 - push(2 - 0.3), 1e-9);
  EXPECT_NEAR(told[1], push(3 - 0.3), 1e-9);
}

TEST(PotentialFieldTrue, OtherRobotsPush) {
  Plane plane(1, 2);
  plane->motions[1] = {3, 0, 0, 0, 0};
  Policy policy(plane, 1);
  ASSERT_TRUE(policy.robots(2).create());
  policy.begin(1);
  policy.act({10, 0, 20, 20, 20, 10, 0, 20, 20, 20});
  const double push = 400 * (1 / 2.4 - 1 / 8.0) / (2.4 * 2.4);
  const auto told = policy.telemetry(WEND_PER_STEP);
  EXPECT_NEAR(told[0], 10 - push, 1e-9);
  EXPECT_NEAR(told[5], 10 + push, 1e-9);
}
