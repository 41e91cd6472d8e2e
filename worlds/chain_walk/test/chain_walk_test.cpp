// The world through its C tables.
#include <gtest/gtest.h>

#include <cmath>
#include <wend/testing.hpp>

using wend::testing::Bench;

namespace {

struct World : Bench {
  explicit World(std::uint32_t copies = 1) : Bench(*wend_plugin_1.components[0]) {
    set("states", 4).set("reward_states", {2, 3}).set("success", 0.9).set("gamma", 0.9);
    set("test", "survey").set("time_limit", 50).Bench::copies(copies);
  }
  void reset(std::vector<std::uint32_t> copies, std::uint64_t seed, std::uint32_t mode) {
    std::vector<wend_episode> episodes;
    for (const std::uint32_t copy : copies)
      episodes.push_back({0, wend::stream(seed, std::uint64_t{copy}), 0, 0, mode});
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
  // Flags at the end of a survey of 4 states.
  std::uint32_t survey(const std::vector<double>& answers) {
    reset({0}, 5, WEND_TEST);
    std::uint32_t flags = 0;
    for (std::size_t s = 0; s < answers.size(); ++s) {
      EXPECT_EQ(flags, 0u);
      EXPECT_EQ(sense()[0], static_cast<double>(s + 1));
      flags = step({0}, {answers[s]})[0].flags;
    }
    return flags;
  }
};

}  // namespace

TEST(ChainWalk, ObservesItsStateInAFiniteRange) {
  World world;
  ASSERT_TRUE(world.create()) << world.error();
  const wend_space* space = world.table<wend_sensor>(WEND_SENSOR)->space(world.ref().self);
  ASSERT_EQ(space->width, 1u);
  EXPECT_STREQ(space->columns[0].name, "state");
  EXPECT_EQ(space->columns[0].low, 1);
  EXPECT_EQ(space->columns[0].high, 4);
  EXPECT_EQ(world.table<wend_world>(WEND_WORLD)->action(world.ref().self, 0)->columns[0].count, 2u);
}

TEST(ChainWalk, ASurveyTellsAnOptimalPolicyFromOthers) {
  World world;
  ASSERT_TRUE(world.create()) << world.error();
  EXPECT_EQ(world.survey({1, 1, 0, 0}), std::uint32_t{WEND_TERMINATED | WEND_ARRIVED});
  EXPECT_EQ(world.telemetry(WEND_PER_EPISODE), (std::vector<double>{1, 1, 0}));

  EXPECT_EQ(world.survey({1, 1, 1, 1}), std::uint32_t{WEND_TERMINATED});
  const auto told = world.telemetry(WEND_PER_EPISODE);
  EXPECT_EQ(told[0], 0.5);
  EXPECT_EQ(told[1], 0);
  // RRLL earns 0.9 a step from any state: V* = 9.  RRRR by elimination with fractions; state 4 is worst.
  EXPECT_NEAR(told[2], 33844.0 / 38439, 1e-12);
}

TEST(ChainWalk, AWalkGoesTheOtherWayOneTimeInTen) {
  World world;
  world.set("states", 1000).set("reward_states", {2}).set("time_limit", 1e9);
  ASSERT_TRUE(world.create()) << world.error();
  world.reset({0}, 3, WEND_TRAIN_EXPLORE);
  int intended = 0;
  double state = world.sense()[0];
  const int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double action = state < 500 ? 1 : 0;  // never at a wall
    world.step({0}, {action});
    const double next = world.sense()[0];
    ASSERT_EQ(std::fabs(next - state), 1);
    intended += (next > state) == (action == 1);
    state = next;
  }
  EXPECT_NEAR(intended / double(steps), 0.9, 4 * std::sqrt(0.9 * 0.1 / steps));
}

TEST(ChainWalk, WallsHoldAndArrivalsPay) {
  World world;
  world.set("success", 1.0);
  ASSERT_TRUE(world.create()) << world.error();
  world.reset({0}, 1, WEND_TRAIN_EXPLORE);
  for (int i = 0; i < 4; ++i) world.step({0}, {0});
  EXPECT_EQ(world.sense()[0], 1);
  EXPECT_EQ(world.step({0}, {0})[0].reward, 0) << "stayed in state 1";
  EXPECT_EQ(world.step({0}, {1})[0].reward, 1);
  EXPECT_EQ(world.step({0}, {1})[0].reward, 1);
  EXPECT_EQ(world.step({0}, {1})[0].reward, 0);
  EXPECT_EQ(world.step({0}, {1})[0].reward, 0);
  EXPECT_EQ(world.sense()[0], 4);
}

TEST(ChainWalk, AWalkIsTruncatedAndCountsWhatAgreed) {
  World world;
  world.set("test", "walk").set("time_limit", 3).set("success", 1.0);
  ASSERT_TRUE(world.create()) << world.error();
  world.reset({0}, 1, WEND_TEST);
  for (int i = 0; i < 3; ++i) {
    const double better = world.sense()[0] <= 2 ? 1 : 0;
    EXPECT_EQ(world.step({0}, {i == 1 ? 1 - better : better})[0].flags, i == 2 ? std::uint32_t{WEND_TRUNCATED} : 0u);
  }
  const auto told = world.telemetry(WEND_PER_EPISODE);
  EXPECT_EQ(told[0], 2.0 / 3);
  EXPECT_TRUE(std::isnan(told[1]));
  EXPECT_TRUE(std::isnan(told[2]));
}

TEST(ChainWalk, StartsAreDrawnFromAllStates) {
  World world(400);
  ASSERT_TRUE(world.create()) << world.error();
  world.reset(world.all_rows(), 11, WEND_TRAIN_EXPLORE);
  std::vector<int> count(5);
  for (const double state : world.sense()) ++count[static_cast<std::size_t>(state)];
  for (int s = 1; s <= 4; ++s) EXPECT_NEAR(count[s], 100, 40) << s;
}

TEST(ChainWalk, CopiesDoNotDependOnEachOther) {
  World many(3), one;
  for (World* world : {&many, &one}) world->set("states", 50).set("reward_states", {10, 41});
  ASSERT_TRUE(many.create() && one.create());
  many.reset({0, 1, 2}, 9, WEND_TRAIN_EXPLORE);
  wend_episode episode{0, wend::stream(9, std::uint64_t{2}), 0, 0, WEND_TRAIN_EXPLORE};
  const std::uint32_t first = 0;
  ASSERT_EQ(one.table<wend_world>(WEND_WORLD)->reset(one.ref().self, &first, 1, &episode), WEND_OK);
  for (int i = 0; i < 40; ++i) {
    const double action = i / 3 % 2;
    EXPECT_EQ(many.sense({2}), one.sense());
    if (i % 2) many.step({0, 2}, {1 - action, action});
    else many.step({2}, {action});
    one.step({0}, {action});
  }
}

TEST(ChainWalk, RefusesARewardOutsideTheChain) {
  World world;
  world.set("reward_states", {2, 9});
  EXPECT_FALSE(world.create());
  EXPECT_EQ(world.parameter(), "reward_states/1");
  EXPECT_EQ(world.error(), "expected a state 1..4, found 9");
}

TEST(ChainWalk, RefusesTwoRobots) {
  World world;
  world.robots(2);
  EXPECT_FALSE(world.create());
  EXPECT_EQ(world.error(), "expected one robot in a chain, found 2");
}
