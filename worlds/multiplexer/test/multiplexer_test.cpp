// The world through its C tables.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <wend/testing.hpp>

using wend::testing::Bench;

namespace {

struct World : Bench {
  explicit World(std::uint32_t copies = 1) : Bench(*wend_plugin_1.components[0]) {
    set("address_bits", 2).set("payoff", 1000).set("reward_noise", 0).set("test", "random");
    Bench::copies(copies);
  }
  // Copy c gets the episode of that index and the stream `index` below `seed`.
  void reset(std::vector<std::uint32_t> copies, std::uint64_t seed, std::uint32_t mode, std::uint64_t index = 0) {
    std::vector<wend_episode> episodes;
    for (const std::uint32_t copy : copies) {
      const std::uint64_t number = index + copy;
      episodes.push_back({number, wend::stream(seed, number), 0, 0, mode});
    }
    ASSERT_EQ(table<wend_world>(WEND_WORLD)
                  ->reset(ref().self, copies.data(), static_cast<std::uint32_t>(copies.size()), episodes.data()),
              WEND_OK);
  }
  std::vector<wend_outcome> step(std::vector<std::uint32_t> copies, std::vector<double> actions) {
    std::vector<wend_outcome> outcomes(copies.size());
    EXPECT_EQ(table<wend_world>(WEND_WORLD)
                  ->step(ref().self, copies.data(), static_cast<std::uint32_t>(copies.size()), actions.data(),
                         outcomes.data()),
              WEND_OK);
    return outcomes;
  }
};

// The answer to the columns of the 6-multiplexer.
double answer_to(const std::vector<double>& x) {
  return x[static_cast<std::size_t>(2 + 2 * x[0] + x[1])];
}

constexpr std::uint32_t right = WEND_TERMINATED | WEND_ARRIVED, wrong = WEND_TERMINATED;

}  // namespace

TEST(Multiplexer, ShowsItsBitsAndAsksForOne) {
  for (const auto& [k, n] : {std::pair{2, 6u}, {3, 11u}, {4, 20u}, {5, 37u}}) {
    World world;
    world.set("address_bits", k);
    ASSERT_TRUE(world.create()) << world.error();
    const wend_space* space = world.table<wend_sensor>(WEND_SENSOR)->space(world.ref().self);
    ASSERT_EQ(space->width, n);
    EXPECT_STREQ(space->columns[0].name, "bit.0");
    EXPECT_EQ(space->columns[n - 1].name, "bit." + std::to_string(n - 1));
    EXPECT_EQ(space->columns[0].count, 2u);
    EXPECT_STREQ(space->columns[0].unit, "1");
    const wend_space* action = world.table<wend_world>(WEND_WORLD)->action(world.ref().self, 0);
    ASSERT_EQ(action->width, 1u);
    EXPECT_EQ(action->columns[0].count, 2u);
  }
}

TEST(Multiplexer, PaysTheRightAnswerAndEnds) {
  World world(400);
  ASSERT_TRUE(world.create()) << world.error();
  const auto all = world.all_rows();
  world.reset(all, 3, WEND_TRAIN_GREEDY);
  std::vector<double> answers;
  for (const std::uint32_t row : all) answers.push_back((row % 2 == 0) == (answer_to(world.sense({row})) == 1));
  const auto outcomes = world.step(all, answers);
  const auto accuracy = world.telemetry(WEND_PER_EPISODE);
  for (const std::uint32_t row : all) {  // every other row answered rightly
    EXPECT_EQ(outcomes[row].reward, row % 2 == 0 ? 1000 : 0) << row;
    EXPECT_EQ(outcomes[row].flags, row % 2 == 0 ? right : wrong) << row;
    EXPECT_EQ(accuracy[row], row % 2 == 0 ? 1 : 0) << row;
  }
}

TEST(Multiplexer, AccuracyIsToldOfTrialsWithoutExploration) {
  World world;
  ASSERT_TRUE(world.create()) << world.error();
  for (const std::uint32_t mode : {WEND_TEST, WEND_TRAIN_GREEDY, WEND_TRAIN_EXPLORE}) {
    world.reset({0}, 8, mode);
    EXPECT_TRUE(std::isnan(world.telemetry(WEND_PER_EPISODE)[0])) << "before the answer";
    world.step({0}, {answer_to(world.sense())});
    const double accuracy = world.telemetry(WEND_PER_EPISODE)[0];
    if (mode == WEND_TRAIN_EXPLORE)
      EXPECT_TRUE(std::isnan(accuracy));
    else
      EXPECT_EQ(accuracy, 1);
  }
}

TEST(Multiplexer, InputsAreUniform) {
  World world(6400);
  ASSERT_TRUE(world.create()) << world.error();
  world.reset(world.all_rows(), 11, WEND_TRAIN_EXPLORE);
  std::vector<int> count(64);
  for (const std::uint32_t row : world.all_rows()) {
    std::size_t number = 0;
    for (const double bit : world.sense({row})) number = 2 * number + static_cast<std::size_t>(bit);
    ++count[number];
  }
  double chi_square = 0;
  for (const int n : count) chi_square += (n - 100.0) * (n - 100.0) / 100;
  EXPECT_LT(chi_square, 103.4) << "0.1 % point of 63 degrees of freedom";
}

TEST(Multiplexer, TestsCanAskForAllInputs) {
  World world;
  world.set("test", "enumerate");
  ASSERT_TRUE(world.create()) << world.error();
  std::set<std::vector<double>> seen;
  for (std::uint64_t index = 0; index < 64; ++index) {
    world.reset({0}, 5, WEND_TEST, index);
    seen.insert(world.sense());
  }
  EXPECT_EQ(seen.size(), 64u);
  world.reset({0}, 5, WEND_TEST, 64 + 35);
  EXPECT_EQ(world.sense(), (std::vector<double>{1, 0, 0, 0, 1, 1})) << "35 again";
  seen.clear();
  for (std::uint64_t index = 0; index < 64; ++index) {
    world.reset({0}, 5, WEND_TRAIN_EXPLORE, index);
    seen.insert(world.sense());
  }
  EXPECT_LT(seen.size(), 60u) << "training draws";
}

TEST(Multiplexer, RewardsMayBeNoisy) {
  World world(10000);
  world.set("reward_noise", 100);
  ASSERT_TRUE(world.create()) << world.error();
  const auto all = world.all_rows();
  world.reset(all, 2, WEND_TRAIN_EXPLORE);
  const auto outcomes = world.step(all, std::vector<double>(all.size(), 1));
  double sum = 0, squares = 0;
  for (const wend_outcome& outcome : outcomes) {
    const double noise = outcome.reward - (outcome.flags & WEND_ARRIVED ? 1000 : 0);
    sum += noise, squares += noise * noise;
  }
  EXPECT_NEAR(sum / 1e4, 0, 4.0);
  EXPECT_NEAR(std::sqrt(squares / 1e4), 100, 4.0 / std::sqrt(2.0));
}

TEST(Multiplexer, CopiesDoNotDependOnEachOther) {
  World many(5), one;
  for (World* world : {&many, &one}) world->set("address_bits", 4).set("reward_noise", 10);
  ASSERT_TRUE(many.create() && one.create());
  many.reset({0, 1, 2, 3, 4}, 9, WEND_TRAIN_EXPLORE);
  one.reset({0}, 9, WEND_TRAIN_EXPLORE, 3);
  EXPECT_EQ(many.sense({3}), one.sense());
  const auto several = many.step({1, 3}, {0, 1}), alone = one.step({0}, {1});
  EXPECT_EQ(several[1].reward, alone[0].reward);
  EXPECT_EQ(several[1].flags, alone[0].flags);
}

TEST(Multiplexer, RefusesTwoRobots) {
  World world;
  world.robots(2);
  EXPECT_FALSE(world.create());
  EXPECT_EQ(world.error(), "expected one robot at a multiplexer, found 2");
}
