// What the component refuses, with the whole text.
#include "rig.hpp"

namespace {

// "parameter: message" of a refused creation, "" if there was none.
std::string refused(Bench& bench) {
  return bench.create() ? "" : bench.parameter() + ": " + bench.error();
}

}  // namespace

TEST(Lspi, RefusesNaN) {
  Learner learner;
  ASSERT_TRUE(learner.create());
  learner.begin(7);
  const std::string text = "observation \"sonar.range.1\": expected a finite number, found NaN";
  EXPECT_EQ(error_of([&] { learner.decide(1, std::nan("")); }), text);
  EXPECT_EQ(error_of([&] { learner.learn({1, std::nan(""), 0}, 0, 0, {1, 1, 0}, 0); }), text);
  EXPECT_EQ(error_of([&] { learner.learn({1, 1, 0}, 0, 0, {1, std::nan(""), 0}, 0); }), text);
  EXPECT_EQ(error_of([&] {
              learner.learn({1, 1, 0}, 0, std::nan(""), {1, 1, 0}, 0);
            }),
            "a reward: expected a finite number, found NaN or infinity");
  EXPECT_EQ(learner.telemetry(WEND_PER_UPDATE)[0], 0);
}

TEST(Lspi, RefusesAnActionThatThereIsNot) {
  Learner learner;
  ASSERT_TRUE(learner.create());
  EXPECT_EQ(error_of([&] {
              learner.learn({1, 1, 0}, 3, 0, {1, 1, 0}, 0);
            }),
            "an action: expected 0..2, found 3.000000");
}

TEST(Lspi, RefusesMoreSamplesThanItMayKeep) {
  Learner learner;
  ASSERT_TRUE(learner.set("most_samples", 2).create());
  learner.teach(2, 1);
  EXPECT_EQ(error_of([&] { learner.teach(1, 2); }),
            "expected at most 2 samples, found 3; raise most_samples or train for less");
  EXPECT_EQ(learner.parameter(), "most_samples");
}

TEST(Lspi, RefusesActionsThatAreNotDiscrete) {
  wend::Columns wheel, wheels;
  wheel.box("turn_rate", "rad/s", -1, 1);
  wheels.box("left", "rad/s", -1, 1).box("right", "rad/s", -1, 1);
  Learner learner;
  EXPECT_EQ(refused(learner.action(wheel)),
            ": expected discrete actions, found the continuous column \"turn_rate\"; give the robot an action table");
  EXPECT_EQ(learner.status(), WEND_E_UNSUPPORTED);
  EXPECT_EQ(refused(learner.action(wheels)),
            ": expected one column of discrete actions, found 2 columns; give the robot an action table");
}

TEST(Lspi, RefusesToMirrorWhatHasNoMirrorImage) {
  Learner learner;
  wend::Columns lopsided;
  lopsided.box("sonar.range.0", "m", 0, 4, 0.5).box("sonar.range.1", "m", 0, 4, -0.4);
  EXPECT_EQ(refused(learner.observation(lopsided).set("mirror", 1)),
            "mirror: column \"sonar.range.0\" has no mirror image: expected a distance and one column at the opposite "
            "bearing, found m and 0; set mirror to false or change observe");
  wend::Columns twice;
  twice.box("x", "m", 0, 4).box("y", "m", 0, 4);
  EXPECT_EQ(
      refused(learner.observation(twice).set("observe", {"*"})),
      "mirror: column \"x\" has no mirror image: expected a distance and one column at the opposite bearing, found "
      "m and 2; set mirror to false or change observe");
  wend::Columns angle;
  angle.box("goal.bearing", "rad", -3, 3);
  EXPECT_EQ(refused(learner.observation(angle)),
            "mirror: column \"goal.bearing\" has no mirror image: expected a distance and one column at the opposite "
            "bearing, found rad and 1; set mirror to false or change observe");
}

TEST(Lspi, RefusesMirrorActionsThatAreNoMirror) {
  Learner learner;
  learner.set("mirror", 1);
  const std::string expected =
      "mirror_actions: expected for each of the 3 actions the one it becomes in the mirror, and back; found ";
  EXPECT_EQ(refused(learner.set("mirror_actions", {1, 2, 0})), expected + "1 2 0");
  EXPECT_EQ(refused(learner.set("mirror_actions", {0, 2})), expected + "0 2");
  EXPECT_EQ(refused(learner.set("mirror_actions", {0, 2, 3})), expected + "0 2 3");
  EXPECT_EQ(refused(learner.unset("mirror_actions")), expected + "none");
}

TEST(Lspi, RefusesToScaleWhatHasNoRange) {
  const std::string expected =
      "observe: column \"goal.bearing\": expected a finite range to scale to [-1, 1], found none; take another column "
      "or "
      "basis rbf";
  Learner learner;
  EXPECT_EQ(refused(learner.set("observe", {"goal.bearing"})), expected);
  EXPECT_EQ(refused(learner.set("basis", "quartic")), expected);
  EXPECT_EQ(refused(learner.set("basis", "rbf").set("centres/0", {-1, 0, 1})), "");
}

TEST(Lspi, RefusesRbfWithoutCentres) {
  Learner learner;
  EXPECT_EQ(refused(learner.set("basis", "rbf")),
            "centres: expected one list of centres for each of the 2 columns of the state, found 0");
  EXPECT_EQ(refused(learner.set("centres/0", {1, 2})),
            "centres: expected one list of centres for each of the 2 columns of the state, found 1");
}

TEST(Lspi, RefusesABasisThatWouldNotFitIntoMemory) {
  Learner learner;
  wend::Columns window;
  for (int i = 0; i < 36; ++i) window.box("window.range." + std::to_string(i), "m", 0, 8);
  EXPECT_EQ(refused(learner.observation(window).set("observe", {"window.*"}).set("basis", "quartic").set("degree", 4)),
            "degree: expected at most 4096 weights, found 91390 features for each of 3 actions; take fewer columns, a "
            "lower degree or fewer centres");
}
