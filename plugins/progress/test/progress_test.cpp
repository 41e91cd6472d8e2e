// Each part of the reward by itself, then together.
#include <gtest/gtest.h>

#include <cmath>
#include <wend/testing.hpp>

using wend::testing::Bench;
using wend::testing::error_of;

namespace {

struct Reward : Bench {
  wend::Columns columns, table;
  Reward() : Bench(*wend_plugin_1.components[0]) {
    columns.box("sonar.range.0", "m", 0, 2, 1).box("sonar.range.1", "m", 0, 2, -1).box("goal.distance", "m", 0);
    table.discrete("action", 3);
    observation(columns).action(table).set("observe", {"sonar.range.*"}).set("goal", "goal");
    set("goal_reward", 300).set("collision", 280).set("near", 40).set("safe_distance", 0.2);
    set("progress", 20).set("step", 1);
  }
  // From (2, 2) and 5 m from the goal.
  double of(double left, double right, double distance, std::uint32_t flags = 0, double action = 0) {
    begin(1);
    return score({2, 2, 5}, {action}, {left, right, distance}, {{0.5, flags, 0}})[0].reward;
  }
};

}  // namespace

TEST(Progress, PaysForTheWayCoveredAndTakesAStepsCost) {
  Reward reward;
  ASSERT_TRUE(reward.create()) << reward.error();
  EXPECT_DOUBLE_EQ(reward.of(2, 2, 4.75), 20 * 0.25 - 1);
  EXPECT_DOUBLE_EQ(reward.of(2, 2, 5.25), -20 * 0.25 - 1);
}

TEST(Progress, GradesWhatComesNear) {
  Reward reward;
  ASSERT_TRUE(reward.create());
  EXPECT_DOUBLE_EQ(reward.of(0.2, 2, 5), -1) << "the safe distance itself lacks nothing";
  EXPECT_DOUBLE_EQ(reward.of(2, 0.15, 5), -1 - 40 * 0.25);
  EXPECT_DOUBLE_EQ(reward.of(0.15, 0.05, 5), -1 - 40 * 0.75) << "the least reading counts";
  EXPECT_DOUBLE_EQ(reward.of(0, 2, 5), -1 - 40.0);
}

TEST(Progress, PaysForTheGoalAndPunishesACollision) {
  Reward reward;
  ASSERT_TRUE(reward.create());
  EXPECT_DOUBLE_EQ(reward.of(2, 2, 5, WEND_ARRIVED | WEND_TERMINATED), 300 - 1);
  EXPECT_DOUBLE_EQ(reward.of(0.01, 2, 5, WEND_COLLIDED | WEND_TERMINATED), -280 - 1)
      << "a collision costs its penalty alone, however near the sonars read";
  EXPECT_DOUBLE_EQ(reward.of(0.1, 2, 5, WEND_ARRIVED | WEND_TERMINATED), 300 - 1 - 20.0) << "arrived, but near a wall";
}

TEST(Progress, TakesTheCostOfAnAction) {
  Reward reward;
  ASSERT_TRUE(reward.set("action_costs", {0.0, 2.0, 3.0}).create()) << reward.error();
  EXPECT_DOUBLE_EQ(reward.of(2, 2, 5, 0, 2), -4);
  EXPECT_FALSE(reward.set("action_costs", {0.0, 2.0}).create());
  EXPECT_EQ(reward.parameter(), "action_costs");
  EXPECT_EQ(reward.error(), "expected one cost for each discrete action, 3, found 2");
}

TEST(Progress, RefusesCostsOfActionsThatAreNotCounted) {
  Reward reward;
  wend::Columns wheels;
  wheels.box("speed", "m/s", 0, 1).box("turn_rate", "rad/s", -1, 1);
  EXPECT_FALSE(reward.action(wheels).set("action_costs", {0.0, 2.0}).create());
  EXPECT_EQ(reward.parameter(), "action_costs");
  EXPECT_EQ(reward.error(), "expected none for continuous actions, found 2");
}

TEST(Progress, LeavesTheWorldsFlagsAlone) {
  Reward reward;
  ASSERT_TRUE(reward.create());
  reward.begin(1, WEND_TRAIN_EXPLORE);
  EXPECT_EQ(reward.score({2, 2, 5}, {0}, {0, 0, 5}, {{0, 0, 0}})[0].flags, 0u);
}

TEST(Progress, RefusesAPenaltyOfNearnessAboveThatOfACollision) {
  Reward reward;
  EXPECT_FALSE(reward.set("near", 300).create());
  EXPECT_EQ(reward.parameter(), "near");
  EXPECT_EQ(reward.error(),
            "expected at most collision = 280, so that a collision is never the lesser evil, found 300");
}

TEST(Progress, RefusesARobotWithoutAGoalSensor) {
  Reward reward;
  EXPECT_FALSE(reward.set("goal", "target").create());
  EXPECT_EQ(reward.parameter(), "goal/0");
  EXPECT_EQ(reward.error(),
            "no column fits \"target.distance\"; the columns are sonar.range.0, sonar.range.1, goal.distance");
}

TEST(Progress, RefusesNaN) {
  Reward reward;
  ASSERT_TRUE(reward.create());
  EXPECT_EQ(error_of([&] { reward.of(2, std::nan(""), 5); }),
            "observation \"sonar.range.1\": expected a finite number, found NaN");
}
