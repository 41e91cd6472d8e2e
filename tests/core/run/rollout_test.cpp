#include <core/run/rollout.hpp>

#include "fixture.hpp"

namespace wend::core {
namespace {

class RolloutTest : public RunTest {
 protected:
  Cell logged(const Json& world, std::uint32_t robots, std::uint32_t episodes) {
    Cell cell = cell_of(counter(with({{"log", true}}, world), robots), script({{"log", true}}), episodes);
    cell.driver.robot.sensors = {{"eye", eye({{"log", true}})}};
    cell.driver.reward = pay({{"log", true}});
    return cell;
  }
};

using Lines = std::vector<std::string>;

// Robot 0 ends after one step and is not named again; the world is still told of its copy.
TEST_F(RolloutTest, CallsInTheOrderOfTheHeader) {
  run(logged({{"ends", {1, 2}}}, 2, 1));
  EXPECT_EQ(told_, (Lines{"world: reset 0 #0 test", "sensor/eye: begin 0 1", "reward: begin 0 1", "policy: begin 0 1",
                          "sensor/eye: sense 0 1", "world: sense 0 1", "policy: act 0 1", "world: step 0",
                          "sensor/eye: sense 0 1", "world: sense 0 1", "reward: score 0 1", "policy: act 1",
                          "world: step 0", "sensor/eye: sense 1", "world: sense 1", "reward: score 1"}));
}

// Episodes of 1, 2 and 1 steps on two copies: the third begins on copy 0 while the second goes on.
TEST_F(RolloutTest, IdleCopiesTakeTheNextEpisode) {
  run(logged({{"ends", {1, 2}}}, 1, 3), 2);
  EXPECT_EQ(told_, (Lines{"world: reset 0 1 #0 test #1 test",
                          "sensor/eye: begin 0 1",
                          "reward: begin 0 1",
                          "policy: begin 0 1",
                          "sensor/eye: sense 0 1",
                          "world: sense 0 1",
                          "policy: act 0 1",
                          "world: step 0 1",
                          "sensor/eye: sense 0 1",
                          "world: sense 0 1",
                          "reward: score 0 1",
                          "world: reset 0 #2 test",
                          "sensor/eye: begin 0",
                          "reward: begin 0",
                          "policy: begin 0",
                          "sensor/eye: sense 0",
                          "world: sense 0",
                          "policy: act 0 1",
                          "world: step 0 1",
                          "sensor/eye: sense 0 1",
                          "world: sense 0 1",
                          "reward: score 0 1"}));
}

TEST_F(RolloutTest, LearnsAfterScoringAndBeforeTheNextAction) {
  Training training = training_of(counter({{"ends", {2, 1}}, {"log", true}}), table({{"log", true}}), {"steps", 3});
  training.driver.reward = pay({{"log", true}});
  training.greedy_every = 1;
  run(training);
  EXPECT_EQ(told_, (Lines{"world: reset 0 #0 explore",
                          "reward: begin 0",
                          "policy: begin 0",
                          "world: sense 0",
                          "policy: act 0",
                          "world: step 0",
                          "world: sense 0",
                          "reward: score 0",
                          "policy: learn 0",
                          "policy: act 0",
                          "world: step 0",
                          "world: sense 0",
                          "reward: score 0",
                          "policy: learn 0",
                          "world: reset 0 #1 greedy",
                          "reward: begin 0",
                          "policy: begin 0",
                          "world: sense 0",
                          "policy: act 0",
                          "world: step 0",
                          "world: sense 0",
                          "reward: score 0",
                          "policy: learn 0",
                          "policy: finish"}));
}

TEST_F(RolloutTest, ARewardEndsEpisodesInTrainingOnlyAndAddsNoFacts) {
  Training training = training_of(counter({{"ends", {5}}}), table(), {"episodes", 3});
  training.driver.reward = pay({{"end", 2}, {"reward", 0.5}});
  const TrainingResult trained = run(training);
  EXPECT_EQ(trained.steps, 6u);
  Cell cell = cell_of(counter({{"ends", {5}}}), script());
  cell.driver.reward = training.driver.reward;
  const RobotEpisode tested = run(cell).episodes.at(0).robots.at(0);
  EXPECT_EQ(tested.steps, 5u);
  EXPECT_EQ(tested.reward, 2.5);
  EXPECT_EQ(tested.flags, std::uint32_t{WEND_TERMINATED | WEND_ARRIVED});
}

}  // namespace
}  // namespace wend::core
