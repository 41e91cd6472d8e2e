// Equation (11) and table 1, one case a condition.
#include <gtest/gtest.h>

#include <cmath>
#include <wend/testing.hpp>

using wend::testing::Bench;
using wend::testing::error_of;

namespace {

struct Reward : Bench {
  wend::Columns sonars, action;
  explicit Reward(std::initializer_list<double> bearings = {1.3, 0.8, 0.3, -0.3, -0.8, -1.3})
      : Bench(*wend_plugin_1.components[0]) {
    sonars.box("goal.distance", "m");
    int i = 0;
    for (const double bearing : bearings) sonars.box("sonar.range." + std::to_string(i++), "m", 0, 20, bearing);
    action.discrete("action", 3);
    observation(sonars).Bench::action(action).set("observe", {"sonar.range.*"});
    set("D", 8).set("D_us", 0.2).set("k", 0.9).set("penalty", 1000).set("terminate", 1);
  }
  wend_outcome of(std::vector<double> next, std::uint32_t flags = 0) {
    next.insert(next.begin(), 55);
    return score(std::vector<double>(next.size(), 1), {0}, next, {{0.5, flags, 0}})[0];
  }
};

}  // namespace

TEST(Clearance, FollowsTheResolvedTable) {
  Reward reward;
  ASSERT_TRUE(reward.create()) << reward.error();
  reward.begin(1);
  EXPECT_EQ(reward.of({20, 20, 0.2, 20, 20, 20}).reward, -1000);
  EXPECT_DOUBLE_EQ(reward.of({7, 5, 9, 20, 6, 8}).reward, -0.9 * 3 - 0.9 * 2);
  EXPECT_DOUBLE_EQ(reward.of({7, 5, 9, 20, 9, 8.5}).reward, -0.9 * 3);
  EXPECT_DOUBLE_EQ(reward.of({9, 10, 9, 20, 6, 8}).reward, -0.9 * 2);
  EXPECT_EQ(reward.of({9, 10, 9, 20, 9, 8.5}).reward, 0);
  EXPECT_EQ(reward.of({8, 10, 9, 20, 9, 8}).reward, 0) << "D itself lacks nothing";
}

TEST(Clearance, ACollisionIsACrashWhateverTheSonarsRead) {
  Reward reward;
  ASSERT_TRUE(reward.create());
  reward.begin(1);
  EXPECT_EQ(reward.of({20, 20, 20, 20, 20, 20}, WEND_COLLIDED | WEND_TERMINATED).reward, -1000);
}

TEST(Clearance, EndsTheTaskInTrainingOnly) {
  Reward reward;
  ASSERT_TRUE(reward.create());
  reward.begin(1, WEND_TRAIN_EXPLORE);
  EXPECT_EQ(reward.of({20, 20, 0.1, 20, 20, 20}).flags, WEND_TERMINATED);
  EXPECT_EQ(reward.of({20, 20, 0.3, 20, 20, 20}).flags, 0u);
  reward.begin(1, WEND_TEST);
  EXPECT_EQ(reward.of({20, 20, 0.1, 20, 20, 20}).flags, 0u);
  ASSERT_TRUE(reward.set("terminate", 0).create());
  reward.begin(1, WEND_TRAIN_GREEDY);
  EXPECT_EQ(reward.of({20, 20, 0.1, 20, 20, 20}).flags, 0u);
}

TEST(Clearance, ABeamStraightAheadCountsForBothSides) {
  Reward reward({1, 0, -1});
  ASSERT_TRUE(reward.create());
  reward.begin(1);
  EXPECT_DOUBLE_EQ(reward.of({20, 6, 20}).reward, -0.9 * 2 - 0.9 * 2);
}

TEST(Clearance, RefusesColumnsOfOneSide) {
  Reward reward({1, 0.5});
  EXPECT_FALSE(reward.create());
  EXPECT_EQ(reward.parameter(), "observe");
  EXPECT_EQ(reward.error(), "expected distances to the left and to the right, found none to the right");
}

TEST(Clearance, RefusesAThresholdAboveD) {
  Reward reward;
  EXPECT_FALSE(reward.set("D_us", 9).create());
  EXPECT_EQ(reward.error(), "expected at most D = 8.000000, found 9.000000");
}

TEST(Clearance, RefusesNaN) {
  Reward reward;
  ASSERT_TRUE(reward.create());
  reward.begin(1);
  EXPECT_EQ(error_of([&] {
              reward.of({20, 20, 20, std::nan(""), 20, 20});
            }),
            "observation \"sonar.range.3\": expected a finite number, found NaN");
}

TEST(Clearance, TakesTheCostOfAnAction) {
  Reward reward;
  ASSERT_TRUE(reward.set("action_costs", {2.0, 0.5, 0.5}).create()) << reward.error();
  reward.begin(1);
  EXPECT_EQ(reward.of({9, 10, 9, 20, 9, 8.5}).reward, -2);
  EXPECT_EQ(reward.of({20, 20, 0.2, 20, 20, 20}).reward, -1000) << "a crash costs the penalty alone";
}

TEST(Clearance, RefusesCostsOfAnotherTable) {
  Reward reward;
  EXPECT_FALSE(reward.set("action_costs", {2.0, 0.5}).create());
  EXPECT_EQ(reward.parameter(), "action_costs");
  EXPECT_EQ(reward.error(), "expected one cost for each discrete action, 3, found 2");
}
