// The XCS learner through its C tables: decisions, learning, states, rule files, several robots.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <sstream>

#include "rig.hpp"

using namespace xcs::testing;

namespace {

const std::vector<double> zeros(4, 0), ones(4, 1);

// Action 0 is right where bit 0 is 1, else action 1.
void teach(XcsRig& rig, int trials) {
  wend::Random random(99);
  for (int t = 0; t < trials; ++t) {
    rig.begin(static_cast<std::uint64_t>(t), WEND_TRAIN_EXPLORE);
    std::vector<double> state, rewards, actions;
    for (std::uint32_t k = 0; k < 4 * rig.rows(); ++k) state.push_back(static_cast<double>(random.below(2)));
    actions = rig.act(state);
    for (std::uint32_t r = 0; r < rig.rows(); ++r)
      rewards.push_back((state[4 * r] == 1) == (actions[r] == 0) ? 1000 : 0);
    EXPECT_EQ(rig.learn(state, actions, rewards, state, WEND_TERMINATED), rig.rows());
  }
}

}  // namespace

TEST(XcsLearner, LearnsARuleOfOneBitAndGeneralisesOverTheOthers) {
  XcsRig rig;
  ASSERT_TRUE(rig.create()) << rig.error();
  teach(rig, 2000);
  rig.begin(1);
  for (int s = 0; s < 16; ++s) {
    const std::vector<double> state{double(s & 1), double(s >> 1 & 1), double(s >> 2 & 1), double(s >> 3 & 1)};
    EXPECT_EQ(rig.act(state)[0], s & 1 ? 0 : 1) << s;
  }
  const std::vector<std::string> rules = rig.rules();
  for (const char* best : {"0### 0 0 ", "0### 1 1000 ", "1### 0 1000 ", "1### 1 0 "}) {
    bool found = false;
    for (const std::string& rule : rules) found |= rule.rfind(best, 0) == 0;
    EXPECT_TRUE(found) << best << " in\n" << rig.explain();
  }
}

TEST(XcsLearner, TestsAndGreedyTrialsWithoutUpdatesChangeNothing) {
  XcsRig rig;
  rig.set("greedy_updates", 0);
  ASSERT_TRUE(rig.create()) << rig.error();
  teach(rig, 50);
  const std::string before = rig.save();
  for (const std::uint32_t mode : {WEND_TEST, WEND_TRAIN_GREEDY}) {
    rig.begin(3, mode);
    for (int k = 0; k < 30; ++k) rig.act({double(k & 1), double(k >> 1 & 1), double(k >> 2 & 1), double(k >> 3 & 1)});
    EXPECT_EQ(rig.learn(zeros, {0}, {1000}, ones, WEND_TERMINATED), 0u);
  }
  EXPECT_EQ(rig.save(), before);
}

TEST(XcsLearner, AGreedyTrialThatUpdatesBreedsNothing) {
  XcsRig rig;
  rig.set("theta_GA", 0).set("exploration", 1);
  ASSERT_TRUE(rig.create()) << rig.error();
  rig.begin(1, WEND_TRAIN_GREEDY);
  for (int k = 0; k < 20; ++k) {
    const auto action = rig.act(zeros);
    EXPECT_EQ(rig.learn(zeros, action, {1000}, zeros, WEND_TERMINATED), 1u);
  }
  EXPECT_EQ(rig.telemetry(WEND_PER_UPDATE)[1], 2) << "a covering rule for each action";
  EXPECT_EQ(rig.telemetry(WEND_PER_STEP)[1], 2);
}

// A chain of two states: what the second is worth comes back to the first, discounted.
TEST(XcsLearner, PredictsDiscountedRewardsOverSteps) {
  XcsRig rig(1);
  rig.set("P_hash", 0).set("mu", 0).set("gamma", 0.5);
  ASSERT_TRUE(rig.create()) << rig.error();
  for (int t = 0; t < 300; ++t) {
    rig.begin(static_cast<std::uint64_t>(t), WEND_TRAIN_EXPLORE);
    rig.learn({0}, rig.act({0}), {100}, {1}, 0);
    rig.learn({1}, rig.act({1}), {1000}, {1}, WEND_TERMINATED);
  }
  rig.begin(1);
  rig.act({1});
  EXPECT_NEAR(rig.telemetry(WEND_PER_STEP)[0], 1000, 1e-9);
  rig.act({0});
  EXPECT_NEAR(rig.telemetry(WEND_PER_STEP)[0], 600, 1e-6);
}

TEST(XcsLearner, ATimeLimitIsNoEnd) {
  XcsRig rig(1);
  rig.set("P_hash", 0).set("mu", 0).set("gamma", 0.5);
  ASSERT_TRUE(rig.create()) << rig.error();
  for (int t = 0; t < 300; ++t) {
    rig.begin(static_cast<std::uint64_t>(t), WEND_TRAIN_EXPLORE);
    rig.learn({0}, rig.act({0}), {100}, {0}, WEND_TRUNCATED);
  }
  rig.begin(1);
  rig.act({0});
  EXPECT_NEAR(rig.telemetry(WEND_PER_STEP)[0], 200, 1e-3);
}

TEST(XcsLearner, LearnsFromWhatAnotherDecided) {
  XcsRig rig(1, 3);
  rig.set("gamma", 0);
  ASSERT_TRUE(rig.create()) << rig.error();
  rig.begin(1, WEND_TRAIN_EXPLORE);
  for (int t = 0; t < 50; ++t)
    for (const double action : {0, 1, 2}) EXPECT_EQ(rig.learn({1}, {action}, {100 * action}, {0}, 0), 1u);
  rig.begin(1);
  EXPECT_EQ(rig.act({1})[0], 2);
}

TEST(XcsLearner, AStateGoesOnExactlyWhereItWasSaved) {
  XcsRig rig, other;
  ASSERT_TRUE(rig.create() && other.seed(77).create());
  teach(rig, 300);
  const std::string saved = rig.save();
  teach(other, 20);
  other.load(saved);
  EXPECT_EQ(other.save(), saved);
  teach(rig, 200);
  teach(other, 200);
  EXPECT_EQ(other.save(), rig.save());
}

TEST(XcsLearner, ABrokenStateIsRefusedAndNothingIsLost) {
  XcsRig rig;
  ASSERT_TRUE(rig.create()) << rig.error();
  teach(rig, 100);
  const std::string saved = rig.save();
  for (std::size_t cut = 0; cut < saved.size(); cut += 7) {
    EXPECT_NE(error_of([&] { rig.load(saved.substr(0, cut)); }), "") << cut;
    ASSERT_EQ(rig.status(), WEND_E_STATE) << cut;
  }
  EXPECT_EQ(error_of([&] { rig.load(saved + "x"); }), "the state has 1 bytes too many");
  std::string broken = saved;
  const double time = 100, never = NAN;  // a hundred explored steps
  const std::size_t at = broken.rfind(std::string(reinterpret_cast<const char*>(&time), sizeof time));
  ASSERT_NE(at, std::string::npos);
  std::memcpy(&broken[at], &never, sizeof never);
  EXPECT_EQ(error_of([&] { rig.load(broken); }), "expected a finite time and number of generations, found others");
  EXPECT_EQ(rig.save(), saved);

  XcsRig wider(5), more(4, 3), small;
  ASSERT_TRUE(wider.create() && more.create() && small.set("N", 20).create());
  EXPECT_EQ(error_of([&] { wider.load(saved); }),
            "expected a state of wend.xcs 1: 2 actions, bit.0/2;bit.1/2;bit.2/2;bit.3/2;bit.4/2;, found wend.xcs 1: 2 "
            "actions, "
            "bit.0/2;bit.1/2;bit.2/2;bit.3/2;");
  EXPECT_EQ(error_of([&] { more.load(saved); }),
            "expected a state of wend.xcs 1: 3 actions, bit.0/2;bit.1/2;bit.2/2;bit.3/2;, found wend.xcs 1: 2 actions, "
            "bit.0/2;bit.1/2;bit.2/2;bit.3/2;");
  EXPECT_EQ(error_of([&] { small.load(saved); }), "expected at most N = 20 micro-classifiers, found 29: raise N");
}

TEST(XcsLearner, IndependentRobotsHaveTheirOwnRulesAndSharedOnesOneBase) {
  for (const char* base : {"shared", "independent"}) {
    XcsRig rig;
    rig.robots(2).set("rule_base", base).set("gamma", 0);
    ASSERT_TRUE(rig.create()) << rig.error();
    for (int t = 0; t < 300; ++t) {  // the second robot is paid for the other action
      rig.begin(static_cast<std::uint64_t>(t), WEND_TRAIN_EXPLORE);
      const std::vector<double> state(8, 0), actions = rig.act(state);
      rig.learn(state, actions, {actions[0] == 0 ? 100.0 : 0, actions[1] == 1 ? 100.0 : 0}, state, WEND_TERMINATED);
    }
    rig.begin(1);
    const auto actions = rig.act(std::vector<double>(8, 0));
    if (base == std::string("shared")) {
      EXPECT_EQ(actions[0], actions[1]);
      EXPECT_EQ(rig.rules(0), rig.rules(1));
    } else {
      EXPECT_EQ(actions, (std::vector<double>{0, 1}));
      EXPECT_NE(rig.rules(0), rig.rules(1));
    }
  }
}

TEST(XcsLearner, OneRuleBaseMayBeHandedToSeveralRobotsButNotTheOtherWay) {
  XcsRig one, three, two;
  ASSERT_TRUE(one.create() && three.robots(3).set("rule_base", "independent").create() &&
              two.robots(2).set("rule_base", "independent").create());
  teach(one, 100);
  three.load(one.save());
  for (std::uint32_t row = 0; row < 3; ++row) EXPECT_EQ(three.rules(row), one.rules());
  EXPECT_EQ(error_of([&] { two.load(three.save()); }), "expected 2 rule bases, found 3");
}

TEST(XcsLearner, ExplainsADecisionAndItsTextSeedsAnother) {
  XcsRig rig;
  ASSERT_TRUE(rig.create()) << rig.error();
  teach(rig, 2000);
  rig.begin(1);
  const double action = rig.act({1, 0, 1, 0})[0];
  const std::string text = rig.explain();
  EXPECT_NE(text.find("// state 1010: action " + std::to_string(static_cast<int>(action)) + ", predicted "),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("\n//   1### -> 0  p 1000 error "), std::string::npos) << text;

  const TemporaryFile file(text);
  XcsRig seeded;
  seeded.set("rules", file.path);
  ASSERT_TRUE(seeded.create()) << seeded.error();
  EXPECT_EQ(seeded.rules(), rig.rules());
  seeded.begin(1);
  EXPECT_EQ(seeded.act({1, 0, 1, 0})[0], action);
  seeded.destroy();
  seeded.set("explain", "json");
  ASSERT_TRUE(seeded.create()) << seeded.error();
  const std::string json = seeded.explain();
  EXPECT_EQ(json.rfind("{\"format\": \"wend rules 1\", \"encoding\": \"bit.0/2;bit.1/2;bit.2/2;bit.3/2;\", "
                       "\"actions\": 2, \"rules\": [\n",
                       0),
            0u)
      << json;
  EXPECT_NE(json.find("{\"condition\": \"1###\", \"action\": 0, \"prediction\": 1000, \"error\": "), std::string::npos);
}

TEST(XcsLearner, CompactsWhatItHandsOverOnlyWhereItIsToldTo) {
  XcsRig rig;
  rig.set("compact", 1).set("mu", 0.3);
  ASSERT_TRUE(rig.create()) << rig.error();
  teach(rig, 400);
  const std::size_t before = rig.rules().size();
  rig.finish();
  EXPECT_LT(rig.rules().size(), before);
  EXPECT_EQ(rig.telemetry(WEND_PER_UPDATE)[1], 100);
  XcsRig plain;
  ASSERT_TRUE(plain.create()) << plain.error();
  teach(plain, 100);
  const std::string saved = plain.save();
  plain.finish();
  EXPECT_EQ(plain.save(), saved);
}

TEST(XcsLearner, TellsFitnessAgainstGeneration) {
  XcsRig rig;
  rig.set("series_every", 10);
  ASSERT_TRUE(rig.create()) << rig.error();
  teach(rig, 300);
  ASSERT_GE(rig.series.size(), 3u);
  EXPECT_EQ(rig.series[0].first, "generation/fitness");
  EXPECT_EQ(rig.series[0].second.first, 10);
  EXPECT_EQ(rig.series[1].second.first, 20);
}

TEST(XcsLearner, ParametersOfLongerConditionsReplaceTheOthers) {
  XcsRig rig;
  rig.set("N", 1).set("by_bits/0/bits", 4).set("by_bits/0/N", 30).set("by_bits/1/bits", 5).set("by_bits/1/N", 40);
  rig.set("by_bits/2/bits", 3).set("by_bits/2/N", 10);
  ASSERT_TRUE(rig.create()) << rig.error();
  teach(rig, 500);
  EXPECT_EQ(rig.telemetry(WEND_PER_UPDATE)[1], 30);
}
