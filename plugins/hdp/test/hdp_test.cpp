// wend.hdp through its C tables: presets, trials, states, divergence and refusals.
#include <cmath>
#include <cstring>

#include "harness.hpp"

using namespace hdp_test;

namespace {

const std::vector<double> ahead = sees({10, 10, 10, 10, 10}, {0, 0, 0, 0, 0}, 0.7);

}  // namespace

TEST(Hdp, ActsBySignAndTheSameInATest) {
  Policy policy("paper");
  ASSERT_TRUE(policy.create()) << policy.error();
  policy.begin(1);
  const double left = policy.act(ahead)[0];
  const double right = policy.act(sees({10, 10, 10, 10, 10}, {0, 0, 0, 0, 0}, -0.7))[0];
  EXPECT_EQ(left + right, 2) << "without biases u is odd: one turns left (0), the other right (2)";
  EXPECT_NE(left, right);
  EXPECT_EQ(policy.act(sees({10, 10, 10, 10, 10}, {0, 0, 0, 0, 0}, 0))[0], 1) << "u = 0 goes straight";
  const std::string before = policy.save();
  for (int i = 0; i < 50; ++i) policy.act(ahead);
  EXPECT_EQ(policy.save(), before);
}

TEST(Hdp, FoldedItTurnsTheOtherWayInTheMirror) {
  Policy policy("folded");
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    ASSERT_TRUE(policy.seed(seed).create()) << policy.error();
    policy.begin(1);
    const double a = policy.act(sees({3, 10, 5, 10, 2}, {2, 0, 1, 0, 2}, 0.4))[0];
    const double b = policy.act(sees({3, 5, 10, 2, 10}, {2, 1, 0, 2, 0}, -0.4))[0];
    EXPECT_EQ(a + b, 2) << seed;
  }
}

TEST(Hdp, LearnsInTrainingOnly) {
  Policy policy;
  ASSERT_TRUE(policy.create());
  const std::string before = policy.save();
  for (const std::uint32_t mode : {WEND_TEST, WEND_TRAIN_GREEDY}) {
    policy.begin(1, mode);
    for (int i = 0; i < 20; ++i) policy.decide(ahead, ahead, -1, i == 19 ? crashed : 0u);
    EXPECT_EQ(policy.save(), before);
  }
  policy.begin(1, WEND_TRAIN_EXPLORE);
  policy.decide(ahead, ahead, -1);
  EXPECT_NE(policy.save(), before);
}

TEST(Hdp, CountsTrialsAndStopsAfterSuccesses) {
  Policy policy;
  policy.set("stop_after", 3);
  ASSERT_TRUE(policy.create());
  EXPECT_TRUE(std::isnan(policy.telemetry(WEND_PER_EPISODE)[0]));
  for (const std::uint32_t flags : {crashed, crashed, arrived, crashed, arrived, arrived, arrived}) {
    EXPECT_EQ(policy.told("learned"), 0);
    policy.trial(flags);
  }
  EXPECT_EQ(policy.told("learned"), 1);
  EXPECT_EQ(policy.told("trials"), 7);
  EXPECT_EQ(policy.told("crashes"), 3);
  EXPECT_EQ(policy.telemetry(WEND_PER_EPISODE), (std::vector<double>{3, 7, 2}));
  const double norm = policy.told("critic_norm");
  policy.trial(crashed);
  EXPECT_EQ(policy.told("critic_norm"), norm) << "the policy that passed is kept";
}

TEST(Hdp, RobustDrawsAnewAfterATimeoutAndOnlyThen) {
  Policy policy;
  ASSERT_TRUE(policy.create());
  policy.trial(crashed), policy.trial(arrived);
  EXPECT_EQ(policy.told("redraws"), 0);
  policy.trial(WEND_TRUNCATED);
  EXPECT_EQ(policy.told("redraws"), 1);
  EXPECT_EQ(policy.told("timeouts"), 1);
  Policy paper("paper");
  ASSERT_TRUE(paper.create());
  for (int i = 0; i < 5; ++i) paper.trial(WEND_TRUNCATED);
  EXPECT_EQ(paper.told("redraws"), 0);
}

TEST(Hdp, DrawsAnewAfterTrialsOfTheSameLength) {
  Policy policy("paper");
  policy.set("similar_trials", 3).set("similar_steps", 1);
  ASSERT_TRUE(policy.create());
  policy.trial(crashed, 4), policy.trial(crashed, 6), policy.trial(crashed, 5);
  EXPECT_EQ(policy.told("redraws"), 0);
  policy.trial(crashed, 6);
  EXPECT_EQ(policy.told("redraws"), 1);
}

TEST(Hdp, WeightsStayWithinTheClip) {
  Policy policy;
  policy.set("clip", 0.31).set("l_c", 0.05).set("l_a", 0.05);
  ASSERT_TRUE(policy.create());
  for (int i = 0; i < 20; ++i) policy.trial(crashed);
  EXPECT_LE(policy.told("critic_norm"), 0.31 * std::sqrt(48.0));
  EXPECT_GT(policy.told("critic_norm"), 0.31 * std::sqrt(10.0)) << "it has grown up to the clip";
}

TEST(Hdp, AStateIsTheWholePolicyAndCountsAnewInTheNextTraining) {
  Policy first, second;
  ASSERT_TRUE(first.seed(4).create() && second.seed(5).create());
  for (int i = 0; i < 4; ++i) first.trial(crashed, 9);
  second.load(first.save());
  EXPECT_EQ(second.save(), first.save());
  EXPECT_EQ(second.told("trials"), 4) << "tested as it is, it tells of its training";
  second.begin(1), first.begin(1);
  for (double bearing = -3; bearing < 3; bearing += 0.1) {
    const auto seen = sees({10, 3, 10, 10, 4}, {0, 1, 0, 0, 2}, bearing);
    EXPECT_EQ(second.act(seen), first.act(seen));
  }
  second.trial(arrived);
  EXPECT_EQ(second.told("trials"), 1);
  EXPECT_EQ(second.telemetry(WEND_PER_EPISODE)[0], 1);
}

TEST(Hdp, RefusesAStateOfAnotherShapeAndKeepsItsOwn) {
  Policy wide, own;
  wide.set("hidden", 8);
  ASSERT_TRUE(wide.create() && own.create());
  const std::string before = own.save();
  EXPECT_EQ(wend::testing::error_of([&] { own.load(wide.save()); }),
            "expected a state of wend.hdp 1: 6 inputs, 6 hidden units, found wend.hdp 1: 6 inputs, 8 hidden units");
  std::string damaged = before;
  const double infinite = INFINITY;
  std::memcpy(&damaged[damaged.size() - sizeof infinite * 8], &infinite, sizeof infinite);
  EXPECT_EQ(wend::testing::error_of([&] { own.load(damaged); }),
            "critic: expected finite weights, found another output weight (unit 0)");
  damaged = before;
  std::memcpy(&damaged[damaged.size() - sizeof infinite], &infinite, sizeof infinite);  // lane 7 of 6 units
  EXPECT_EQ(wend::testing::error_of([&] { own.load(damaged); }),
            "critic: expected zeros beyond the hidden units, found others");
  EXPECT_EQ(wend::testing::error_of([&] { own.load(before.substr(0, before.size() - 1)); }),
            "the state ends early: 8 values announced");
  EXPECT_EQ(own.save(), before);
}

TEST(Hdp, DivergenceSaysWhereAndFailsTheTraining) {
  Policy policy;
  policy.set("l_c", 1e200).set("T_c", 0);
  ASSERT_TRUE(policy.create());
  const std::string error = wend::testing::error_of([&] { policy.trial(crashed, 5); });
  EXPECT_EQ(error,
            "trial 1, step 1: the critic's hidden weight (unit 0, input 0) is no longer a finite number; lower l_a and "
            "l_c, or set clip, normalise or on_divergence: redraw");
  EXPECT_EQ(policy.parameter(), "l_c");
}

TEST(Hdp, DivergenceOfThePaperIsAFailedTrialAndARestart) {
  Policy policy("paper");
  policy.set("l_c", 1e200).set("T_c", 0);
  ASSERT_TRUE(policy.create());
  policy.trial(arrived, 5);
  ASSERT_EQ(policy.logged.size(), 1u);
  EXPECT_EQ(policy.logged[0].level, 2u);
  EXPECT_EQ(
      policy.logged[0].text,
      "trial 1, step 1: the critic's hidden weight (unit 0, input 0) is no longer a finite number; the trial counts "
      "as failed and all weights are drawn anew");
  EXPECT_EQ(policy.told("diverged"), 1);
  EXPECT_EQ(policy.told("redraws"), 1);
  EXPECT_EQ(policy.told("learned"), 0);
  EXPECT_TRUE(std::isnan(policy.telemetry(WEND_PER_EPISODE)[0])) << "an arrival after a divergence is no success";
  EXPECT_TRUE(std::isfinite(policy.told("critic_norm")));
}

TEST(Hdp, RefusesWhatItCannotUse) {
  Policy continuous;
  wend::Columns turn;
  turn.box("turn", "rad", -1, 1);
  continuous.action(turn);
  EXPECT_FALSE(continuous.create());
  EXPECT_EQ(continuous.error(), "expected discrete actions (a table in the robot's definition), found continuous ones");
  Policy two;
  wend::Columns push;
  push.discrete("push", 2);
  two.action(push);
  EXPECT_FALSE(two.create());
  EXPECT_EQ(two.parameter(), "actions/2");
  EXPECT_EQ(two.error(), "expected an action 0..1, found 2");
  Policy scales;
  scales.set("observe", {"goal.bearing"}).set("scales", {1, 2});
  EXPECT_FALSE(scales.create());
  EXPECT_EQ(scales.error(), "expected one for each of the 1 observed columns, found 2");
  Policy fold;
  fold.set("fold", 1).set("observe", {"goal.bearing"});
  EXPECT_FALSE(fold.create());
  EXPECT_EQ(fold.error(), "expected the navigation state, found observed columns");
  Policy ignored;
  ignored.set("scales", {1, 2});
  EXPECT_FALSE(ignored.create());
  EXPECT_EQ(ignored.parameter(), "scales");
  EXPECT_EQ(ignored.error(), "expected none beside the navigation state, found 2; they divide the columns of observe");
  Policy hasty;
  hasty.set("criterion", 10);
  EXPECT_FALSE(hasty.create());
  EXPECT_EQ(hasty.parameter(), "stop_after");
  EXPECT_EQ(hasty.error(), "expected at least criterion = 10, or 0 for never, found 5");
  EXPECT_TRUE(hasty.set("stop_after", 0).create());
  Policy quiet;
  quiet.set("noise", 0);
  EXPECT_FALSE(quiet.create());
  EXPECT_EQ(quiet.parameter(), "noise_floor");
  EXPECT_EQ(quiet.error(), "expected at most noise = 0, found 0.02; lower it too, or raise noise");
  EXPECT_TRUE(quiet.set("noise_floor", 0).create());
  Policy blind;
  ASSERT_TRUE(blind.create());
  blind.begin(1);
  std::vector<double> dark = ahead;
  dark[2] = NAN;
  dark[7] = WEND_WALL;
  EXPECT_EQ(wend::testing::error_of([&] { blind.act(dark); }),
            "observation \"sonar.range.2\": expected a finite number, found NaN");
}
