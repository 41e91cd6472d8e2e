// What the learners refuse, and in what words.
#include <gtest/gtest.h>

#include <limits>

#include "rig.hpp"
#include "rule_text.hpp"

using namespace xcs::testing;

namespace {

void expect_refused(Rig& rig, const std::string& parameter, const std::string& message) {
  EXPECT_FALSE(rig.create());
  EXPECT_EQ(rig.parameter(), parameter);
  EXPECT_EQ(rig.error(), message);
}

const std::string head = "wend rules 1\nencoding bit.0/2;bit.1/2;\nactions 2\n";

}  // namespace

TEST(Refusals, APopulationSmallerThanTheActionSet) {
  XcsRig rig(4, 5);
  rig.set("N", 4);
  expect_refused(rig, "N", "expected room for a rule of each of the 5 actions, found a population of 4");
}

TEST(Refusals, APopulationThatIsTooSmallForLongerConditionsOnly) {
  XcsRig rig(4, 5);
  rig.set("by_bits/0/bits", 3).set("by_bits/0/N", 4);
  expect_refused(rig, "by_bits/0/N", "expected room for a rule of each of the 5 actions, found a population of 4");
}

TEST(Refusals, MoreActionsToCoverThanThereAre) {
  XcsRig rig;
  rig.set("theta_mna", 3);
  expect_refused(rig, "theta_mna", "expected at most the 2 actions that there are, found 3; 0 stands for all of them");
}

TEST(Refusals, AnActionSpaceThatIsNotDiscrete) {
  XcsRig rig;
  wend::Columns speed;
  speed.box("speed", "m/s", 0, 1);
  rig.action(speed);
  expect_refused(
      rig, "", "expected one column of discrete actions, found 1 that is not discrete; give the robot an action table");
}

TEST(Refusals, ObservationsThatCannotBeEncoded) {
  XcsRig rig;
  ASSERT_TRUE(rig.create()) << rig.error();
  rig.begin(1, WEND_TRAIN_EXPLORE);
  const std::string before = rig.save();
  EXPECT_EQ(error_of([&] {
              rig.act({0, 0.5, 0, 0});
            }),
            "observation \"bit.1\": expected a whole number 0..1, found 0.5");
  EXPECT_EQ(error_of([&] {
              rig.act({0, 0, std::numeric_limits<double>::quiet_NaN(), 0});
            }),
            "observation \"bit.2\": expected a finite number, found NaN");
  EXPECT_EQ(error_of([&] {
              rig.learn({2, 0, 0, 0}, {0}, {1}, {0, 0, 0, 0}, 0);
            }),
            "observation \"bit.0\": expected a whole number 0..1, found 2");
  EXPECT_EQ(rig.save(), before);
}

TEST(Refusals, ActionsAndRewardsThatAreNone) {
  for (const bool zcs : {false, true}) {
    XcsRig xcs;
    ZcsRig other;
    Rig& rig = zcs ? static_cast<Rig&>(other) : xcs;
    ASSERT_TRUE(rig.create()) << rig.error();
    rig.begin(1, WEND_TRAIN_EXPLORE);
    const auto action = rig.act({0, 0, 0, 0});
    EXPECT_EQ(error_of([&] {
                rig.learn({0, 0, 0, 0}, {2}, {1}, {0, 0, 0, 0}, 0);
              }),
              "an action: expected 0..1, found 2");
    EXPECT_EQ(error_of([&] {
                rig.learn({0, 0, 0, 0}, action, {std::numeric_limits<double>::infinity()}, {0, 0, 0, 0}, 0);
              }),
              "a reward: expected a finite number, found inf");
  }
}

TEST(Refusals, RuleFilesThatDoNotFit) {
  const auto told = [](const std::string& text, double limit = 100) {
    const TemporaryFile file(text);
    XcsRig rig(2);
    rig.set("rules", file.path).set("N", limit);
    EXPECT_FALSE(rig.create());
    EXPECT_EQ(rig.parameter(), "rules");
    return rig.error();
  };
  EXPECT_EQ(told(""), "expected \"wend rules 1\", found the end of the file");
  EXPECT_EQ(told("rules\n"), "line 1: expected \"wend rules 1\", found \"rules\"");
  EXPECT_EQ(told("wend rules 1\nencoding sonar<0.5;\nactions 2\n"),
            "line 2: expected the encoding of this observation, with bit 0 \"bit.0/2\", found \"sonar<0.5\"");
  EXPECT_EQ(told("wend rules 1\nencoding bit.0/2;\nactions 2\n"),
            "line 2: expected the encoding of this observation, with bit 1 \"bit.1/2\", found \"\"");
  EXPECT_EQ(told("wend rules 1\nencoding bit.0/2;bit.1/2;bit.2/2;\nactions 2\n"),
            "line 2: expected the encoding of this observation, of 2 bits, found \"bit.2/2\"");
  EXPECT_EQ(told("wend rules 1\nactions 2\n"),
            "line 2: expected \"encoding\" and the names of its bits, found \"actions 2\"");
  EXPECT_EQ(told("wend rules 1\n"), "expected \"encoding\" and the names of its bits, found the end of the file");
  EXPECT_EQ(told(std::string("\xff\xfe\0w\0e\0", 6)), "line 1: expected \"wend rules 1\", found \"???w?e\"");
  EXPECT_EQ(told(std::string(70, 'x')), "line 1: expected \"wend rules 1\", found \"" + std::string(60, 'x') + "...\"");
  EXPECT_EQ(told("wend rules 1\nencoding bit.0/2;bit.1/2;\nactions 3\n"),
            "line 3: expected \"actions 2\", found \"actions 3\"");
  EXPECT_EQ(told(head + "01# 0 1 0 0.5 1 1 1\n"),
            "line 4: expected a condition of 2 characters 0, 1 or #, found \"01#\"");
  EXPECT_EQ(told(head + "// a remark\n\n0x 0 1 0 0.5 1 1 1\n"),
            "line 6: expected a condition of 2 characters 0, 1 or #, found \"0x\"");
  EXPECT_EQ(told(head + "01 2 1 0 0.5 1 1 1\n"), "line 4: expected an action 0..1, found \"2\"");
  EXPECT_EQ(told(head + "01 0 nan 0 0.5 1 1 1\n"), "line 4: expected prediction: a number, found \"nan\"");
  EXPECT_EQ(told(head + "01 0 1 -1 0.5 1 1 1\n"), "line 4: expected error: a number >= 0, found \"-1\"");
  EXPECT_EQ(told(head + "01 0 1 0 0.5 1 1\n"), "line 4: expected numerosity: a number >= 1, found \"\"");
  EXPECT_EQ(told(head + "01 0 1 0 0.5 1 1 1.5\n"), "line 4: expected numerosity: a whole number, found \"1.5\"");
  EXPECT_EQ(told(head + "01 0 1 0 0.5 1 1 1 9\n"),
            "line 4: expected a rule: condition action prediction error fitness experience set_size numerosity, found "
            "\"01 0 1 0 0.5 1 1 1 9\"");
  EXPECT_EQ(told(head + "01 0 1 0 0.5 1 1 1\n01 0 2 0 0.5 1 1 1\n"),
            "line 5: expected each condition with an action once, found \"01 0 2 0 0.5 1 1 1\"");
  EXPECT_EQ(told(head + "01 0 1 0 0.5 1 1 101\n"),
            "expected at most N = 100 micro-classifiers, found 101: raise N or take fewer rules");

  XcsRig rig(2);
  rig.set("rules", "/nowhere/rules.txt");
  expect_refused(rig, "rules", "expected a file of rules, found none that can be read at /nowhere/rules.txt");
}

TEST(RuleText, ReadsWhatItWrote) {
  wend::Random random(3);
  xcs::Population population(70, 3), read(70, 3);
  for (int r = 0; r < 200; ++r) {
    const std::uint64_t care[2] = {random.word(), random.word() & 63}, value[2] = {random.word(), random.word() & 63};
    population.add(
        care, value, static_cast<std::uint32_t>(random.below(3)),
        {random.normal(), random.uniform(), random.uniform(), 1e-300, 1.0 / 3, 5, double(1 + random.below(9)), 0});
  }
  xcs::read_rules(xcs::format_rules(population, "any code"), "any code", "rules", read);
  ASSERT_EQ(read.size(), 200u);
  for (std::uint32_t r = 0; r < 200; ++r) {
    EXPECT_EQ(read.condition(r), population.condition(r));
    EXPECT_EQ(read.action(r), population.action(r));
    EXPECT_EQ(read.prediction[r], population.prediction[r]);
    EXPECT_EQ(read.error[r], population.error[r]);
    EXPECT_EQ(read.fitness[r], population.fitness[r]);
    EXPECT_EQ(read.experience[r], population.experience[r]);
    EXPECT_EQ(read.set_size[r], population.set_size[r]);
    EXPECT_EQ(read.numerosity(r), population.numerosity(r));
    EXPECT_EQ(read.marks[r], xcs::kSeeded);
  }
  xcs::Population kept(70, 3);
  kept.add(population.care(0), population.value(0), 0, {});
  EXPECT_NE(error_of([&] { xcs::read_rules("wend rules 1\n", "any code", "rules", kept); }), "");
  EXPECT_EQ(kept.size(), 1u);
}
