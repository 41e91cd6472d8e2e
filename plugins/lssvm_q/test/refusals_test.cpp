// What the component refuses, with the whole text.
#include "rig.hpp"

namespace {

// "parameter: message" of a refused creation, "" if there was none.
std::string refused(Bench& bench) {
  return bench.create() ? "" : bench.parameter() + ": " + bench.error();
}

const double not_a_number = std::nan(""), infinite = std::numeric_limits<double>::infinity();

}  // namespace

TEST(LssvmQ, RefusesReadingsThatAreNotFinite) {
  Learner learner;
  ASSERT_TRUE(learner.create());
  learner.begin(7, WEND_TRAIN_EXPLORE);
  EXPECT_EQ(error_of([&] { learner.act({0}, Learner::see(not_a_number, 2)); }),
            "observation \"sonar.range.0\": expected a finite number, found NaN");
  EXPECT_EQ(error_of([&] { learner.act({0}, Learner::see(1, 2, infinite)); }),
            "observation \"goal.bearing\": expected a finite number, found infinity");
  EXPECT_EQ(error_of([&] { learner.learn(Learner::see(1, 2), 0, 1, Learner::see(1, not_a_number)); }),
            "observation \"goal.distance\": expected a finite number, found NaN");
  EXPECT_EQ(error_of([&] { learner.learn(Learner::see(1, 2), 0, not_a_number, Learner::see(2, 2)); }),
            "a reward: expected a finite number, found NaN or infinity");
  EXPECT_EQ(error_of([&] { learner.learn(Learner::see(1, 2), 2, 0, Learner::see(2, 2)); }),
            "an action: expected 0..1, found 2.000000");
  EXPECT_EQ(error_of([&] { learner.values(not_a_number, 2); }),
            "observation \"sonar.range.0\": expected a finite number, found NaN");
  EXPECT_EQ(learner.told(samples), 0);
}

TEST(LssvmQ, RefusesActionsThatAreNotATable) {
  wend::Columns wheels, pair, one;
  wheels.box("speed", "m/s", 0, 1);
  pair.discrete("left", 3).discrete("right", 3);
  one.discrete("action", 1);
  Learner learner;
  EXPECT_EQ(refused(learner.action(wheels)),
            ": expected discrete actions, found the continuous column \"speed\"; give the robot an action table");
  EXPECT_EQ(refused(learner.action(pair)),
            ": expected one column of discrete actions, found 2 columns; give the robot an action table");
  EXPECT_EQ(refused(learner.action(one)), ": expected 2..256 actions to choose from, found 1");
}

TEST(LssvmQ, RefusesColumnsThatItCannotScaleOrFind) {
  Learner learner;
  EXPECT_EQ(refused(learner.set("observe", {"goal.distance"})),
            "observe: column \"goal.distance\": expected a finite range to scale to [0, 1], found none; take another "
            "column");
  EXPECT_EQ(refused(learner.set("observe", {"lidar.*"})),
            "observe/0: no column fits \"lidar.*\"; the columns are sonar.range.0, goal.distance, goal.bearing, "
            "goal.radius");
  learner.set("observe", {"sonar.range.*"});
  EXPECT_EQ(refused(learner.set("goal", "target")),
            "goal/0: no column fits \"target.distance\"; the columns are sonar.range.0, goal.distance, goal.bearing, "
            "goal.radius");
}

TEST(LssvmQ, RefusesParametersThatContradictEachOther) {
  Learner learner;
  EXPECT_EQ(refused(learner.set("temperature", {9.0, 1.5})),
            "temperature: expected the lowest first, found 9 before 1.5");
  learner.set("temperature", {1.0, 9.0});
  EXPECT_EQ(refused(learner.set("retrain_every", 201)),
            "retrain_every: expected at most window = 200, or samples are forgotten before they are learned from, "
            "found 201");
  learner.set("retrain_every", 20);
  EXPECT_EQ(refused(learner.set("goal", "")),
            "goal: expected a goal's sensor, for condition (9) of the advice needs its distance; found none: name "
            "one, or set switch to after_episodes with 0 episodes");
  EXPECT_EQ(refused(learner.set("switch/episodes", 0)), "");
}

TEST(LssvmQ, RefusesAStateOfAnotherShape) {
  Learner learner, other;
  ASSERT_TRUE(learner.create());
  learner.teach(30, 1);
  const std::string bytes = learner.save();
  ASSERT_TRUE(other.set("goal", "").set("switch/episodes", 0).create());
  EXPECT_EQ(error_of([&] { other.load(bytes); }),
            "expected a state of wend.lssvm_q 1: 1 features, 2 actions, found wend.lssvm_q 1: 4 features, 2 actions");
  ASSERT_TRUE(other.set("goal", "goal").set("sigma", 0.4).create());
  EXPECT_EQ(error_of([&] { other.load(bytes); }),
            "expected a state learned with this observation's ranges and these weights of features, sigma, C and "
            "action_distance, found others");
  ASSERT_TRUE(other.set("sigma", 0.3).set("window", 20).create());
  EXPECT_EQ(error_of([&] { other.load(bytes); }), "expected at most the window's 20 samples, found 30");
}
