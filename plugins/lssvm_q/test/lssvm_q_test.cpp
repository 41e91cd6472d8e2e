// The component through its C tables: acting, learning, conditions (8) and (9), annealing (11), state, telemetry.
#include "rig.hpp"

namespace {

// How often the first robot goes left in n decisions.
int lefts(Learner& learner, double range, int n = 400) {
  int count = 0;
  for (int i = 0; i < n; ++i) count += learner.act({0}, Learner::see(range, 2))[0] == left;
  return count;
}

}  // namespace

TEST(LssvmQ, ActsAtRandomBeforeItHasLearned) {
  for (const std::uint32_t mode : {WEND_TEST, WEND_TRAIN_EXPLORE}) {
    Learner learner;
    ASSERT_TRUE(learner.create()) << learner.error();
    learner.begin(7, mode);
    EXPECT_NEAR(lefts(learner, 3), 200, 50);
    learner.finish();
    EXPECT_EQ(learner.values(3, 2), std::vector<double>(4, 0));
  }
}

TEST(LssvmQ, IsGreedyWhenItDoesNotExplore) {
  Learner learner;
  ASSERT_TRUE(learner.create());
  learner.teach(200, 1);
  learner.finish();
  const std::vector<double> near = learner.values(1, 2), far = learner.values(3, 2);
  EXPECT_NEAR(near[left], 1, 0.1);
  EXPECT_NEAR(far[left], 3, 0.1);
  EXPECT_NEAR(far[right], 2, 0.1);
  EXPECT_GT(near[actions + left], 0);
  for (const std::uint32_t mode : {WEND_TEST, WEND_TRAIN_GREEDY}) {
    learner.begin(7, mode);
    EXPECT_EQ(lefts(learner, 3), 400);
    EXPECT_EQ(lefts(learner, 1), 0);
  }
}

TEST(LssvmQ, ExploresByBoltzmann) {  // (10)
  Learner learner;
  ASSERT_TRUE(learner.set("switch/episodes", 0).set("temperature", {2.0, 2.0}).create());
  learner.teach(200, 1);
  learner.finish();
  const std::vector<double> q = learner.values(3, 2);
  learner.begin(7, WEND_TRAIN_EXPLORE);
  EXPECT_NEAR(lefts(learner, 3, 4000) / 4000.0, 1 / (1 + std::exp((q[right] - q[left]) / 2)), 0.03);
}

TEST(LssvmQ, AnnealsOnceForEveryExploringEpisode) {  // (11)
  Learner learner;
  ASSERT_TRUE(learner.create());
  for (const double expected : {9.0, 5.0, 3.0, 2.0}) {
    learner.begin(7, WEND_TRAIN_EXPLORE);  // both robots: one episode
    EXPECT_EQ(learner.told(temperature), expected);
    learner.begin(8, WEND_TRAIN_GREEDY);
    learner.begin(9, WEND_TEST);
    EXPECT_EQ(learner.told(temperature), expected);
  }
}

TEST(LssvmQ, ConditionsDecideWhatIsASample) {
  Learner learner;
  ASSERT_TRUE(learner.create());
  learner.begin(7, WEND_TRAIN_EXPLORE);
  const auto counts = [&] { return std::pair(learner.told(samples), learner.told(advice_samples)); };
  const auto from = Learner::see(2, 5);
  EXPECT_EQ(learner.learn(from, left, 1, Learner::see(2.02, 5)), 0u);  // (8): 0.005 <= theta; (9): no nearer
  EXPECT_EQ(counts(), std::pair(0.0, 0.0));
  EXPECT_EQ(learner.learn(from, left, 1, Learner::see(2.2, 5)), 1u);  // (8)
  EXPECT_EQ(counts(), std::pair(1.0, 0.0));
  EXPECT_EQ(learner.learn(from, left, 1, Learner::see(2.2, 4.9)), 1u);  // both
  EXPECT_EQ(counts(), std::pair(2.0, 1.0));
  EXPECT_EQ(learner.learn(from, left, 1, Learner::see(2, 4.95)), 0u);  // (9) alone
  EXPECT_EQ(counts(), std::pair(2.0, 2.0));
  EXPECT_EQ(learner.learn(from, left, -9, Learner::see(0, 4.9), WEND_TERMINATED | WEND_COLLIDED), 1u);
  EXPECT_EQ(counts(), std::pair(3.0, 2.0));  // a collision is no advice
  EXPECT_EQ(learner.learn(from, left, 9, Learner::see(2, 5), WEND_TERMINATED | WEND_ARRIVED), 1u);
  EXPECT_EQ(counts(), std::pair(4.0, 2.0));  // an end is worth knowing however small the step
}

TEST(LssvmQ, CollisionsMayBeRejected) {
  Learner learner;
  ASSERT_TRUE(learner.set("collisions", "reject").create());
  learner.begin(7, WEND_TRAIN_EXPLORE);
  EXPECT_EQ(learner.learn(Learner::see(2, 5), left, -9, Learner::see(0, 4.9), WEND_TERMINATED | WEND_COLLIDED), 0u);
  EXPECT_EQ(learner.told(samples), 0);
}

TEST(LssvmQ, LearnsOnlyWhereItExplores) {
  Learner learner;
  ASSERT_TRUE(learner.create());
  for (const std::uint32_t mode : {WEND_TEST, WEND_TRAIN_GREEDY}) {
    learner.begin(7, mode);
    EXPECT_EQ(learner.learn(Learner::see(2, 5), left, 1, Learner::see(1, 4)), 0u);
  }
  EXPECT_EQ(learner.told(samples), 0);
}

TEST(LssvmQ, ATimeLimitIsNoEnd) {
  Learner learner;
  ASSERT_TRUE(learner.set("retrain_every", 2).set("forget", "oldest").set("C", 1e6).create());
  learner.begin(7, WEND_TRAIN_EXPLORE);
  learner.learn(Learner::see(1, 5), left, 1, Learner::see(3, 5), WEND_TRUNCATED);
  learner.learn(Learner::see(3, 5), left, 10, Learner::see(4, 5), WEND_TERMINATED | WEND_COLLIDED);
  learner.finish();
  EXPECT_NEAR(learner.values(1, 5)[left], 1 + 0.9 * 10, 0.01);
}

TEST(LssvmQ, FollowsTheAdviceUntilTheDeepPhase) {
  Learner learner;
  ASSERT_TRUE(learner.create());
  learner.begin(1, WEND_TRAIN_EXPLORE);
  for (int i = 0; i < 40; ++i)  // right always brings it nearer, left is worth more
    learner.learn(Learner::see(0.1 * i, 2), i % 2, i % 2 ? 0 : 50, Learner::see(0.1 * i + 0.5, i % 2 ? 1.5 : 2.5));
  EXPECT_EQ(learner.told(trainings), 2);
  EXPECT_EQ(lefts(learner, 2), 0);
  EXPECT_LT(learner.told(agreement), 0.5);
  EXPECT_EQ(learner.told(deep), 0);
  EXPECT_TRUE(std::isnan(learner.told(switch_episode)));
  for (int episode = 0; episode < 3; ++episode) learner.begin(2, WEND_TRAIN_EXPLORE);
  EXPECT_EQ(learner.told(deep), 1);
  EXPECT_EQ(learner.told(switch_episode), 3);
  EXPECT_EQ(learner.told(switch_step), 400);
  EXPECT_GT(lefts(learner, 2), 300);
}

TEST(LssvmQ, TellsOfItsTrainings) {
  Learner learner;
  ASSERT_TRUE(learner.create());
  EXPECT_TRUE(std::isnan(learner.told(residual)));
  learner.teach(100, 1);
  EXPECT_EQ(learner.told(trainings), 5);
  EXPECT_LT(learner.told(residual), 1e-9);
  EXPECT_GT(learner.told(condition), 1);
  EXPECT_GT(learner.told(bellman_error), 0);
  EXPECT_LT(learner.told(bellman_error), 1);
  EXPECT_TRUE(learner.telemetry(WEND_PER_STEP).empty());
}

TEST(LssvmQ, SavesAndLoadsAndGoesOn) {
  for (const char* kind : {"after_episodes", "window", "per_state"}) {
    Learner learner, other;
    for (Learner* each : {&learner, &other})
      ASSERT_TRUE(each->set("switch/kind", kind).set("switch/threshold", 0.9).set("switch/n", 1000).create());
    learner.teach(110, 1);
    lefts(learner, 2);
    const std::string bytes = learner.save();
    other.load(bytes);
    EXPECT_EQ(other.save(), bytes);
    EXPECT_EQ(other.values(2.7, 1.3), learner.values(2.7, 1.3));
    learner.teach(300, 2), other.teach(300, 2);
    EXPECT_EQ(lefts(other, 2.1), lefts(learner, 2.1));
    learner.finish(), other.finish();
    EXPECT_EQ(other.save(), learner.save());
  }
}

TEST(LssvmQ, ADamagedStateChangesNothing) {
  Learner learner;
  ASSERT_TRUE(learner.create());
  learner.teach(30, 1);
  const std::string bytes = learner.save();
  for (std::size_t n = 0; n < bytes.size(); n += 97) {
    EXPECT_NE(error_of([&] { learner.load(bytes.substr(0, n)); }), "");
    EXPECT_EQ(learner.status(), WEND_E_STATE);
  }
  EXPECT_EQ(error_of([&] { learner.load(bytes + "x"); }), "the state has 1 bytes too many");
  EXPECT_EQ(learner.save(), bytes);
}

TEST(LssvmQ, RobotsAndOrderOfRowsShareOneLearner) {
  Learner two, one(1);  // the same transitions of one robot, or by turns of two
  ASSERT_TRUE(two.create() && one.create());
  two.begin(7, WEND_TRAIN_EXPLORE), one.begin(7, WEND_TRAIN_EXPLORE);
  wend::Random random(5);
  for (int i = 0; i < 60; ++i) {
    const auto a = Learner::see(random.uniform(0, 4), 2), b = Learner::see(random.uniform(0, 4), 2);
    std::vector<double> both = a, next = b;
    both.insert(both.end(), b.begin(), b.end()), next.insert(next.end(), a.begin(), a.end());
    const std::uint32_t rows[] = {0, 1};
    const double taken[] = {0, 1};
    const wend_outcome outcomes[] = {{1, 0, 0}, {2, WEND_TERMINATED, 0}};
    EXPECT_EQ(two.learn({sizeof(wend_batch), 2, rows, both.data(), taken, next.data(), outcomes}), 2u);
    one.learn(a, 0, 1, b), one.learn(b, 1, 2, a, WEND_TERMINATED);
  }
  EXPECT_EQ(two.values(2.7, 2), one.values(2.7, 2));
  EXPECT_EQ(two.told(samples), 120);
}

TEST(LssvmQ, ItsChanceIsThatOfTheRowAndEpisode) {
  Learner batched, single;
  ASSERT_TRUE(batched.create() && single.create());
  batched.begin(7, WEND_TRAIN_EXPLORE), single.begin(7, WEND_TRAIN_EXPLORE);
  std::vector<double> both = Learner::see(1, 2);
  both.insert(both.end(), both.begin(), both.begin() + 4);
  int equal = 0;
  for (int i = 0; i < 60; ++i) {
    const std::vector<double> taken = batched.act(both);
    EXPECT_EQ(single.act({1}, Learner::see(1, 2))[0], taken[1]);
    equal += taken[0] == taken[1];
  }
  EXPECT_NEAR(equal, 30, 20);
}
