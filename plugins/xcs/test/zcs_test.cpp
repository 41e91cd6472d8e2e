// ZCS: its payments by hand, its roulettes, and a bit that it learns.
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "rig.hpp"

using namespace xcs::testing;

namespace {

// Strength of the one rule with this condition and action.
double strength(Rig& rig, const std::string& rule) {
  for (const std::string& line : rig.rules())
    if (line.rfind(rule + " ", 0) == 0) return std::atof(line.c_str() + rule.size() + 1);
  ADD_FAILURE() << "no rule " << rule << " in\n" << rig.explain();
  return 0;
}

const std::string two_states =
    "wend rules 1\nencoding bit.0/2;\nactions 2\n0 0 10 0 0 0 1 1\n0 1 30 0 0 0 1 1\n1 0 50 0 0 0 1 1\n1 1 70 0 0 0 1 "
    "1\n";

}  // namespace

TEST(Zcs, ABucketGoesBackTheRewardComesInAndOthersAreTaxed) {
  const TemporaryFile file(two_states);
  ZcsRig rig(1);
  rig.set("rules", file.path).set("phi", 0.1);
  ASSERT_TRUE(rig.create()) << rig.error();
  rig.begin(5, WEND_TRAIN_EXPLORE);
  double s[2][2] = {{10, 30}, {50, 70}};
  const int first = static_cast<int>(rig.act({0})[0]);
  s[0][first] *= 0.8;
  s[0][1 - first] *= 0.9;
  rig.learn({0}, {double(first)}, {5}, {1}, 0);
  s[0][first] += 0.2 * 5;
  const int second = static_cast<int>(rig.act({1})[0]);
  s[0][first] += 0.71 * 0.2 * s[1][second];
  s[1][second] *= 0.8;
  s[1][1 - second] *= 0.9;
  rig.learn({1}, {double(second)}, {1000}, {1}, WEND_TERMINATED);
  s[1][second] += 0.2 * 1000;
  for (int state = 0; state < 2; ++state)
    for (int action = 0; action < 2; ++action)
      EXPECT_NEAR(strength(rig, std::to_string(state) + " " + std::to_string(action)), s[state][action], 1e-12);

  rig.begin(6, WEND_TRAIN_EXPLORE);  // what the last episode ended with is paid nothing more
  const double before = strength(rig, "1 " + std::to_string(second));
  const int third = static_cast<int>(rig.act({0})[0]);
  EXPECT_EQ(strength(rig, "1 " + std::to_string(second)), before);
  EXPECT_NEAR(strength(rig, "0 " + std::to_string(third)), 0.8 * s[0][third], 1e-12);
}

TEST(Zcs, ActionsAreDrawnByStrength) {
  const TemporaryFile file(two_states);
  for (const char* tests : {"roulette", "greedy"}) {
    ZcsRig rig(1);
    rig.set("rules", file.path).set("test_selection", tests);
    ASSERT_TRUE(rig.create()) << rig.error();
    const std::string saved = rig.save();
    int ones = 0;
    for (int k = 0; k < 4000; ++k) {
      rig.begin(static_cast<std::uint64_t>(k));
      ones += rig.act({0})[0] == 1;
    }
    if (tests == std::string("greedy"))
      EXPECT_EQ(ones, 4000);
    else
      EXPECT_NEAR(ones, 3000, 120);
    EXPECT_EQ(rig.save(), saved) << "a test teaches nothing";
  }
}

TEST(Zcs, LearnsOneBitWithinItsPopulation) {
  ZcsRig rig;
  rig.set("rho", 0.25).set("mu", 0.002).set("chi", 0.5).set("N", 200);
  ASSERT_TRUE(rig.create()) << rig.error();
  wend::Random random(4);
  for (int t = 0; t < 6000; ++t) {
    rig.begin(static_cast<std::uint64_t>(t), WEND_TRAIN_EXPLORE);
    std::vector<double> state;
    for (int j = 0; j < 4; ++j) state.push_back(static_cast<double>(random.below(2)));
    const auto action = rig.act(state);
    rig.learn(state, action, {action[0] == state[0] ? 1000.0 : 0}, state, WEND_TERMINATED);
    ASSERT_LE(rig.telemetry(WEND_PER_UPDATE)[1], 200);
  }
  rig.begin(1);
  int right = 0;
  for (int s = 0; s < 16; ++s)
    right += rig.act({double(s & 1), double(s >> 1 & 1), double(s >> 2 & 1), double(s >> 3 & 1)})[0] == (s & 1);
  EXPECT_GE(right, 14);
}

TEST(Zcs, ItsStateIsItsOwn) {
  ZcsRig zcs;
  XcsRig xcs;
  ASSERT_TRUE(zcs.create() && xcs.create()) << zcs.error() << xcs.error();
  zcs.begin(1, WEND_TRAIN_EXPLORE);
  zcs.act({0, 1, 0, 1});
  const std::string saved = zcs.save();
  ZcsRig other;
  ASSERT_TRUE(other.create());
  other.load(saved);
  EXPECT_EQ(other.save(), saved);
  EXPECT_EQ(error_of([&] { xcs.load(saved); }),
            "expected a state of wend.xcs 1: 2 actions, bit.0/2;bit.1/2;bit.2/2;bit.3/2;, found wend.zcs 1: 2 actions, "
            "bit.0/2;bit.1/2;bit.2/2;bit.3/2;");
}
