// The component through its C tables: acting, learning, its state and its telemetry.
#include "rig.hpp"

namespace {

// How often each action was taken in 2 x 300 decisions.
std::vector<int> counts(Learner& learner) {
  std::vector<int> taken(3, 0);
  for (int i = 0; i < 300; ++i)
    for (const double action : learner.decide(3, 1)) ++taken.at(static_cast<std::size_t>(action));
  return taken;
}

}  // namespace

TEST(Lspi, ActsAtRandomBeforeItHasLearned) {
  Learner learner;
  ASSERT_TRUE(learner.create()) << learner.error();
  learner.begin(7);
  for (const int n : counts(learner)) EXPECT_NEAR(n, 200, 60);
  learner.finish();
  EXPECT_EQ(learner.values(3, 1), std::vector<double>(3, 0));
}

TEST(Lspi, ItsChanceIsThatOfTheRowAndEpisode) {
  Learner batched, single;
  ASSERT_TRUE(batched.create() && single.create());
  batched.begin(7), single.begin(7);
  for (int i = 0; i < 50; ++i) {
    const std::vector<double> both = batched.decide(3, 1);
    EXPECT_EQ(single.act({1}, {3, 1, 0})[0], both[1]);
  }
  batched.begin(7), single.begin(8);
  int equal = 0;
  for (int i = 0; i < 50; ++i) equal += batched.decide(3, 1) == single.decide(3, 1);
  EXPECT_LT(equal, 25);
}

TEST(Lspi, IsGreedyAfterwardsUnlessItExplores) {
  Learner learner;
  ASSERT_TRUE(learner.create());
  learner.teach(300, 1);
  learner.finish();
  for (const std::uint32_t mode : {WEND_TEST, WEND_TRAIN_GREEDY}) {
    learner.begin(7, mode);
    EXPECT_EQ(learner.decide(3, 1), (std::vector<double>{left, left}));
    EXPECT_EQ(learner.decide(1, 3), (std::vector<double>{right, right}));
  }
  learner.begin(7, WEND_TRAIN_EXPLORE);
  for (const int n : counts(learner)) EXPECT_NEAR(n, 200, 60);
}

TEST(Lspi, ValuesAreThoseOfTheTask) {
  Learner learner;
  ASSERT_TRUE(learner.set("ridge", 0).create());
  learner.teach(300, 1);
  learner.finish();
  const std::vector<double> q = learner.values(3, 0.5);
  EXPECT_NEAR(q[straight], 0, 1e-10);
  EXPECT_NEAR(q[left], 2.5, 1e-10);
  EXPECT_NEAR(q[right], -2.5, 1e-10);
}

TEST(Lspi, TheMirrorTeachesTheOtherSide) {
  Learner plain, mirrored;
  ASSERT_TRUE(plain.create());
  ASSERT_TRUE(mirrored.set("mirror", 1).create()) << mirrored.error();
  plain.teach(300, 1, true), mirrored.teach(300, 1, true);
  plain.finish(), mirrored.finish();
  EXPECT_EQ(plain.values(1, 3)[right], 0);
  EXPECT_NEAR(mirrored.values(1, 3)[right], 2, 0.1);
  EXPECT_NEAR(mirrored.values(1, 3)[right], mirrored.values(3, 1)[left], 1e-12);
}

TEST(Lspi, AHandOverMayEndTheTask) {
  for (const bool terminal : {false, true}) {
    Learner learner;
    ASSERT_TRUE(
        learner.set("ridge", 0).set("degree", 1).set("handed_over", terminal ? "terminal" : "bootstrap").create());
    learner.learn({0, 0, 0}, straight, 1, {4, 0, 0}, WEND_HANDED_OVER);
    learner.learn({4, 0, 0}, straight, 10, {0, 4, 0}, WEND_TERMINATED);
    learner.finish();
    EXPECT_NEAR(learner.values(0, 0)[straight], terminal ? 1 : 1 + 0.9 * 10, 1e-10);
  }
}

TEST(Lspi, ATimeLimitIsNoEnd) {
  Learner learner;
  ASSERT_TRUE(learner.set("ridge", 0).set("degree", 1).set("handed_over", "terminal").create());
  learner.learn({0, 0, 0}, straight, 1, {4, 0, 0}, WEND_TRUNCATED);
  learner.learn({4, 0, 0}, straight, 10, {0, 4, 0}, WEND_TERMINATED | WEND_COLLIDED);
  learner.finish();
  EXPECT_NEAR(learner.values(0, 0)[straight], 10, 1e-10);
}

TEST(Lspi, SavesAndLoads) {
  Learner learner, other;
  ASSERT_TRUE(learner.create() && other.create());
  learner.teach(100, 1);
  learner.finish();
  const std::string bytes = learner.save();
  other.load(bytes);
  EXPECT_EQ(other.save(), bytes);
  learner.begin(7), other.begin(7);
  wend::Random random(3);
  for (int i = 0; i < 100; ++i) {
    const double l = random.uniform(0, 4), r = random.uniform(0, 4);
    EXPECT_EQ(learner.values(l, r), other.values(l, r));
    EXPECT_EQ(learner.decide(l, r), other.decide(l, r));
  }
  learner.teach(100, 2), other.teach(100, 2);  // and goes on as if nothing had happened
  learner.finish(), other.finish();
  EXPECT_EQ(other.save(), learner.save());
}

TEST(Lspi, ADamagedStateChangesNothing) {
  Learner learner;
  ASSERT_TRUE(learner.create());
  learner.teach(100, 1);
  learner.finish();
  const std::string bytes = learner.save();
  for (const std::string& bad : {std::string(), bytes.substr(0, bytes.size() - 1), bytes + "x"}) {
    EXPECT_NE(error_of([&] { learner.load(bad); }), "");
    EXPECT_EQ(learner.status(), WEND_E_STATE);
    EXPECT_EQ(learner.save(), bytes);
  }
  EXPECT_EQ(error_of([&] { learner.load(bytes + "x"); }), "the state has 1 bytes too many");
}

TEST(Lspi, RefusesAStateOfAnotherBasis) {
  Learner learner, other;
  ASSERT_TRUE(learner.create() && other.set("degree", 4).create());
  EXPECT_EQ(error_of([&] { other.load(learner.save()); }),
            "expected a state of wend.lspi 1: powers 2 4, 3 actions, found wend.lspi 1: powers 2 2, 3 actions");
}

TEST(Lspi, RefusesAStateOfOtherRanges) {
  Learner learner, other;
  wend::Columns longer;
  longer.box("sonar.range.0", "m", 0, 5, 0.5).box("sonar.range.1", "m", 0, 5, -0.5);
  ASSERT_TRUE(learner.create() && other.observation(longer).create());
  EXPECT_EQ(error_of([&] { other.load(learner.save()); }),
            "expected a state learned with this observation's ranges and this basis' centres and width, found others");
}

TEST(Lspi, TellsOfItsSolves) {
  Learner learner;
  ASSERT_TRUE(learner.create());
  learner.teach(300, 1);
  std::vector<double> told = learner.telemetry(WEND_PER_UPDATE);
  EXPECT_EQ(told[0], 300);
  for (std::size_t k = 1; k < 6; ++k) EXPECT_TRUE(std::isnan(told[k])) << k;
  learner.finish();
  told = learner.telemetry(WEND_PER_UPDATE);
  EXPECT_EQ(told[0], 300);
  EXPECT_GE(told[1], 1);
  EXPECT_EQ(told[2], 1);
  EXPECT_LT(told[3], 1e-12);
  EXPECT_GT(told[4], 1);
  EXPECT_EQ(told[5], 15);
  EXPECT_TRUE(learner.telemetry(WEND_PER_STEP).empty());
  EXPECT_TRUE(learner.logged.empty());
}

TEST(Lspi, WarnsOfTooFewStates) {
  Learner learner;
  ASSERT_TRUE(learner.set("ridge", 0).create());
  for (int i = 0; i < 10; ++i) learner.learn({1, 2, 0}, straight, 5, {1, 2, 0}, WEND_TERMINATED);
  learner.finish();
  ASSERT_EQ(learner.logged.size(), 1u);
  EXPECT_EQ(learner.logged[0].level, 2u);
  EXPECT_EQ(learner.logged[0].text,
            "the 10 samples determine 1 of 15 weights: collect from more states, or take a smaller basis");
  EXPECT_NEAR(learner.values(1, 2)[straight], 5, 1e-10);
}

TEST(Lspi, WarnsOfAnIllConditionedSystem) {
  Learner learner;
  ASSERT_TRUE(learner.set("ridge", 0).set("degree", 1).create());
  const auto around = [&](std::uint32_t action, double d, int times) {
    for (int i = 0; i < times; ++i)
      for (const double l : {2 - d, 2 + d})
        for (const double r : {2 - d, 2 + d}) learner.learn({l, r, 0}, action, 5, {1, 2, 0}, WEND_TERMINATED);
  };
  around(straight, 2, 50), around(left, 6e-6, 1), around(right, 2, 50);  // squares of 3e-6 beside sums of 200
  learner.finish();
  EXPECT_EQ(learner.telemetry(WEND_PER_UPDATE)[5], 9) << "not for want of rank";
  EXPECT_NEAR(learner.telemetry(WEND_PER_UPDATE)[4], 200 / (4 * 9e-12), 1e10);
  ASSERT_EQ(learner.logged.size(), 1u);
  EXPECT_EQ(learner.logged[0].level, 2u);
  EXPECT_EQ(learner.logged[0].text,
            "the 404 samples make an ill-conditioned system: collect from more states or raise ridge");
}
