// The world through its C tables.
#include <gtest/gtest.h>

#include <cmath>
#include <wend/testing.hpp>

#include "dynamics.hpp"

using wend::testing::Bench;

namespace {

struct World : Bench {
  explicit World(std::uint32_t copies = 1) : Bench(*wend_plugin_1.components[0]) {
    set("gravity", 9.8).set("pendulum_mass", 2).set("cart_mass", 8).set("length", 0.5).set("force", 50);
    set("noise", 10).set("period", 0.1).set("substeps", 4).set("start_angle", 0.1).set("start_speed", 0.2);
    set("time_limit", 300).Bench::copies(copies);
  }
  void reset(std::vector<std::uint32_t> copies, std::uint64_t seed) {
    std::vector<wend_episode> episodes;
    for (const std::uint32_t copy : copies)
      episodes.push_back({0, wend::stream(seed, std::uint64_t{copy}), 0, 0, WEND_TEST});
    ASSERT_EQ(table<wend_world>(WEND_WORLD)->reset(ref().self, copies.data(),
                                                   static_cast<std::uint32_t>(copies.size()), episodes.data()),
              WEND_OK);
  }
  std::vector<wend_outcome> step(std::vector<std::uint32_t> copies, std::vector<double> actions) {
    std::vector<wend_outcome> outcomes(copies.size());
    EXPECT_EQ(table<wend_world>(WEND_WORLD)->step(ref().self, copies.data(), static_cast<std::uint32_t>(copies.size()),
                                                  actions.data(), outcomes.data()),
              WEND_OK);
    return outcomes;
  }
};

}  // namespace

TEST(Pendulum, StartsNearTheUprightOnBothSides) {
  World world(200);
  ASSERT_TRUE(world.create()) << world.error();
  world.reset(world.all_rows(), 4);
  const auto seen = world.sense();
  double least[2] = {9, 9}, most[2] = {-9, -9};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    least[i % 2] = std::min(least[i % 2], seen[i]);
    most[i % 2] = std::max(most[i % 2], seen[i]);
  }
  EXPECT_GE(least[0], -0.1);
  EXPECT_LE(most[0], 0.1);
  EXPECT_GE(least[1], -0.2);
  EXPECT_LE(most[1], 0.2);
  EXPECT_LT(least[0], -0.09);
  EXPECT_GT(most[0], 0.09);
  EXPECT_LT(least[1], -0.18);
  EXPECT_GT(most[1], 0.18);
}

TEST(Pendulum, ActionsPushLeftNotAndRight) {
  World world;
  world.set("noise", 0).set("start_angle", 0).set("start_speed", 0);
  ASSERT_TRUE(world.create()) << world.error();
  const pendulum::Dynamics dynamics(pendulum::Constants{});
  for (const int action : {0, 1, 2}) {
    world.reset({0}, 1);
    EXPECT_EQ(world.step({0}, {double(action)})[0].reward, 0);
    const pendulum::State expected = dynamics.advance({}, 50.0 * (action - 1), 0.1, 4);
    EXPECT_EQ(world.sense(), (std::vector<double>{expected.theta, expected.theta_dot}));
  }
  EXPECT_LT(world.sense()[0], 0) << "a cart pushed to the right leaves its pendulum behind";
}

TEST(Pendulum, NoiseIsUniformWithinItsWidth) {
  World world(2000);
  world.set("start_angle", 0).set("start_speed", 0);
  ASSERT_TRUE(world.create()) << world.error();
  world.reset(world.all_rows(), 8);
  world.step(world.all_rows(), std::vector<double>(2000, 1));
  const auto seen = world.sense();
  const double limit = pendulum::Dynamics(pendulum::Constants{}).advance({}, -10, 0.1, 4).theta;
  double mean = 0, square = 0, most = 0;
  for (std::size_t i = 0; i < seen.size(); i += 2) {
    const double share = seen[i] / limit;  // nearly linear in the force
    mean += share / 2000;
    square += share * share / 2000;
    most = std::max(most, std::fabs(share));
  }
  EXPECT_LE(most, 1);
  EXPECT_GT(most, 0.99);
  EXPECT_NEAR(mean, 0, 0.05);
  EXPECT_NEAR(square, 1.0 / 3, 0.03);
}

TEST(Pendulum, FallsAtARightAngleAndIsFinedOnce) {
  World world;
  ASSERT_TRUE(world.create()) << world.error();
  world.reset({0}, 2);
  int steps = 0;
  wend_outcome outcome{};
  while (outcome.flags == 0 && steps < 100) {
    EXPECT_LE(std::fabs(world.sense()[0]), std::acos(0.0));
    outcome = world.step({0}, {2})[0];
    ++steps;
    EXPECT_EQ(outcome.reward, outcome.flags ? -1 : 0);
  }
  EXPECT_EQ(outcome.flags, std::uint32_t{WEND_TERMINATED});
  EXPECT_GT(std::fabs(world.sense()[0]), std::acos(0.0));
  EXPECT_EQ(world.telemetry(WEND_PER_EPISODE), std::vector<double>{steps - 1.0});
}

TEST(Pendulum, BalancingToTheTimeLimitIsASuccess) {
  World world;
  world.set("time_limit", 0.7).set("noise", 0).set("start_angle", 0).set("start_speed", 0);
  ASSERT_TRUE(world.create()) << world.error();
  world.reset({0}, 2);
  for (int i = 0; i < 7; ++i)
    EXPECT_EQ(world.step({0}, {1})[0].flags, i == 6 ? std::uint32_t{WEND_TRUNCATED | WEND_ARRIVED} : 0u) << i;
  EXPECT_EQ(world.telemetry(WEND_PER_EPISODE), std::vector<double>{7});
}

TEST(Pendulum, CopiesDoNotDependOnEachOther) {
  World many(3), one;
  ASSERT_TRUE(many.create() && one.create());
  many.reset({0, 1, 2}, 9);
  const wend_episode episode{0, wend::stream(9, std::uint64_t{2}), 0, 0, WEND_TEST};
  const std::uint32_t first = 0;
  ASSERT_EQ(one.table<wend_world>(WEND_WORLD)->reset(one.ref().self, &first, 1, &episode), WEND_OK);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(many.sense({2}), one.sense());
    if (i % 2) many.step({0, 2}, {1, i % 3 * 1.0});
    else many.step({2}, {i % 3 * 1.0});
    one.step({0}, {i % 3 * 1.0});
  }
}

TEST(Pendulum, ObservesAngleAndRate) {
  World world;
  ASSERT_TRUE(world.create()) << world.error();
  const wend_space* space = world.table<wend_sensor>(WEND_SENSOR)->space(world.ref().self);
  ASSERT_EQ(space->width, 2u);
  EXPECT_STREQ(space->columns[0].name, "theta");
  EXPECT_STREQ(space->columns[0].unit, "rad");
  EXPECT_STREQ(space->columns[1].name, "theta_dot");
  EXPECT_STREQ(space->columns[1].unit, "rad/s");
  EXPECT_EQ(world.table<wend_world>(WEND_WORLD)->period(world.ref().self), 0.1);
}

TEST(Pendulum, RefusesTwoRobots) {
  World world;
  world.robots(2);
  EXPECT_FALSE(world.create());
  EXPECT_EQ(world.error(), "expected one robot with a pendulum, found 2");
}
