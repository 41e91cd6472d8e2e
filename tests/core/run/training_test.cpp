#include <core/record/trace.hpp>
#include <core/run/driver.hpp>

#include "fixture.hpp"

namespace wend::core {
namespace {

class TrainingTest : public RunTest {
 protected:
  // Episodes of four steps, of which every other one is a sample.
  static Training usual(const Budget& budget) {
    return training_of(counter({{"ends", {4}}, {"pays", {0.25, 1, 0.5}}}), table({{"use", 2}}), budget);
  }

  const Curve* curve(const TrainingResult& result, const std::string& metric, const std::string& x) {
    for (const Curve& one : result.curves)
      if (one.metric == metric && one.x == x) return &one;
    return nullptr;
  }
};

TEST_F(TrainingTest, SpendsItsBudgetToTheStep) {
  const struct {
    Budget budget;
    std::uint64_t samples, steps, episodes;
  } cases[] = {{{"samples", 5}, 5, 10, 2},  {{"samples", 6}, 6, 12, 3}, {{"samples", 1}, 1, 2, 0},
               {{"steps", 10}, 5, 10, 2},   {{"steps", 8}, 4, 8, 2},    {{"steps", 1}, 0, 1, 0},
               {{"episodes", 3}, 6, 12, 3}, {{"episodes", 0}, 0, 0, 0}};
  for (const auto& one : cases) {
    const TrainingResult result = run(usual(one.budget));
    EXPECT_EQ(result.samples, one.samples) << one.budget.unit << one.budget.amount;
    EXPECT_EQ(result.steps, one.steps) << one.budget.unit << one.budget.amount;
    EXPECT_EQ(result.episodes, one.episodes) << one.budget.unit << one.budget.amount;
    EXPECT_EQ(result.hash.size(), 32u);
    EXPECT_EQ(result.hash, run(usual(one.budget)).hash);
  }
}

TEST_F(TrainingTest, CountsTheDecisionsOfAllRobots) {
  Training training = usual({"steps", 3});
  training.worlds[0].robots = 2;
  EXPECT_EQ(run(training).steps, 4u);  // two at a time
  training.budget = {"episodes", 2};
  const TrainingResult result = run(training);
  EXPECT_EQ(result.steps, 16u);
  EXPECT_EQ(result.samples, 8u);
  ASSERT_NE(curve(result, "return", "train_episodes"), nullptr);
  EXPECT_EQ(curve(result, "return", "train_episodes")->robot, 0u);
}

// A snapshot is what a training with that budget would have ended with, and taking it changes nothing.
TEST_F(TrainingTest, SnapshotsEqualShorterTrainings) {
  for (const char* unit : {"samples", "steps", "episodes"}) {
    Training training = usual({unit, 9});
    training.snapshots = {0, 1, 2, 5, 8, 9};
    const TrainingResult with_snapshots = run(training);
    ASSERT_EQ(with_snapshots.snapshots.size(), 6u);
    for (const auto& [at, name] : with_snapshots.snapshots) {
      const std::string bytes = file(name);
      Training shorter = usual({unit, at});
      shorter.id = std::string(64, 'b');
      EXPECT_EQ(file(run(shorter).final_state), bytes) << unit << " " << at;
    }
    EXPECT_EQ(file(with_snapshots.final_state), file(with_snapshots.snapshots.at(9))) << unit;
    training.snapshots.clear();
    training.id = std::string(64, 'd');
    const TrainingResult without = run(training);
    EXPECT_EQ(file(without.final_state), file(with_snapshots.final_state)) << unit;
    EXPECT_EQ(without.steps, with_snapshots.steps);
  }
}

// After every third episode a greedy one, which the budget and the count of episodes leave out.
TEST_F(TrainingTest, DrivesEveryNthEpisodeGreedily) {
  Training training = usual({"episodes", 7});
  training.greedy_every = 3;
  training.worlds[0].params["log"] = true;
  const TrainingResult result = run(training);
  EXPECT_EQ(result.episodes, 7u);
  EXPECT_EQ(result.steps, 9 * 4u);
  EXPECT_EQ(curve(result, "return", "train_episodes")->points.size(), 7u);
  const Curve* greedy = curve(result, "greedy_episode_steps", "train_episodes");
  ASSERT_NE(greedy, nullptr);
  EXPECT_EQ(greedy->points, (std::vector<std::pair<double, double>>{{3, 4}, {6, 4}}));
  std::vector<std::string> modes;
  for (const std::string& line : told_)
    if (line.find("reset") != std::string::npos) modes.push_back(line.substr(std::string("world: reset 0 #").size()));
  EXPECT_EQ(modes, (std::vector<std::string>{"0 explore", "1 explore", "2 explore", "3 greedy", "4 explore", "5 explore",
                                             "6 explore", "7 greedy", "8 explore"}));
}

TEST_F(TrainingTest, EndsOnceTheLearnerSaysSo) {
  Training training = usual({"episodes", 9});  // every episode brings two samples
  training.until = "samples";
  training.snapshots = {5};
  const TrainingResult result = run(training);
  EXPECT_EQ(result.episodes, 1u);
  EXPECT_EQ(file(result.snapshots.at(5)), file(result.final_state));
  training.until = "learned";
  EXPECT_EQ(failure([&] { run(training); }),
            "training: until: expected the name of a value that the policy tells after an episode, found \"learned\"; it tells "
            "samples, best");
}

TEST_F(TrainingTest, TracesItsFirstEpisodes) {
  Training training = usual({"episodes", 5});
  training.traced_episodes = 2;
  training.worlds[0].variants = 3;
  const TrainingResult result = run(training);
  ASSERT_EQ(result.traces.size(), 2u);
  for (const auto& [episode, name] : result.traces) {
    const Trace trace = read_trace(folder_ + "/" + name);
    EXPECT_EQ(trace.about["training"], true);
    EXPECT_EQ(trace.about["episode"], episode);
    EXPECT_EQ(trace.about["variant"], episode);
    EXPECT_EQ(trace.reward.size(), 4u);
  }
  training.traced_episodes = 0;
  EXPECT_EQ(run(training).hash, result.hash);
}

TEST_F(TrainingTest, VisitsItsWorldsInTurn) {
  Training training = usual({"episodes", 5});
  training.worlds.push_back(counter({{"ends", {7}}}));
  training.streams.push_back(training.streams[0]);
  const TrainingResult result = run(training);
  EXPECT_EQ(result.steps, 3 * 4 + 2 * 7u);
  const Curve* steps = curve(result, "episode_steps", "train_episodes");
  ASSERT_NE(steps, nullptr);
  EXPECT_EQ(steps->points, (std::vector<std::pair<double, double>>{{1, 4}, {2, 7}, {3, 4}, {4, 7}, {5, 4}}));
  training.greedy_every = 1;  // episodes without exploration between do not change the turns
  const TrainingResult shown = run(training);
  EXPECT_EQ(curve(shown, "episode_steps", "train_episodes")->points, steps->points);
  EXPECT_EQ(curve(shown, "greedy_episode_steps", "train_episodes")->points,
            (std::vector<std::pair<double, double>>{{1, 4}, {2, 7}, {3, 4}, {4, 7}}));
  training.worlds[1] = counter({{"actions", 2}});
  EXPECT_EQ(failure([&] { run(training); }),
            "rule: training worlds: expected the same observation and action columns in all of them, found others in "
            "test.counter");
}

TEST_F(TrainingTest, GivesUpABudgetThatIsNeverSpent) {
  const Training training = training_of(counter({{"ends", {1}}}), table({{"use", 0}}), {"samples", 10});
  EXPECT_EQ(
      failure([&] { run(training); }),
      "training: policy (test.table): a budget of 10 samples, but 2000 episodes on end brought none; found 0 so far");
}

TEST_F(TrainingTest, NeedsALearnerAndAWorld) {
  EXPECT_EQ(failure([&] {
              run(training_of(counter(), script(), {"episodes", 1}));
            }),
            "rule: policy (test.script): expected the interface wend.learner/1, found none");
  Training training = usual({"episodes", 1});
  training.worlds.clear();
  EXPECT_EQ(failure([&] { run(training); }), "training: expected at least one training world, found none");
}

// What finish() makes of n samples is plan[n]; only action 2 arrives in the selection world.
TEST_F(TrainingTest, KeepsTheSnapshotThatDoesBest) {
  Training training = training_of(counter(), table({{"plan", {0, 1, 2, 1, 0}}}), {"samples", 4});
  training.snapshots = {1, 2, 3};
  training.keep = "best";
  training.selection_worlds = {counter({{"arrive", 2}})};
  training.selection_worlds[0].variants = 2;
  training.selection_streams = training.streams;
  training.selection_episodes = 3;
  TrainingResult result = run(training);
  EXPECT_EQ(file(result.final_state), file(result.snapshots.at(2)));
  EXPECT_NE(file(result.final_state), file(result.snapshots.at(3)));

  training.selection_worlds[0].params["arrive"] = 0;  // the plan's last: the final state itself
  result = run(training);
  for (const auto& [at, name] : result.snapshots) EXPECT_NE(file(result.final_state), file(name)) << at;

  training.selection_worlds[0].params["arrive"] = -1;  // all arrive: the reward decides
  training.selection_worlds[0].params["pays"] = {0, 0.75, 0.5};
  result = run(training);
  EXPECT_EQ(file(result.final_state), file(result.snapshots.at(1)));  // snapshot 3 is as good and later
}

TEST_F(TrainingTest, GoesOnFromAState) {
  const TrainingResult first = run(usual({"episodes", 3}));
  const std::string bytes = file(first.final_state);
  const TrainingResult none = run_training(usual({"episodes", 0}), bytes, "w.state", options());
  EXPECT_EQ(file(none.final_state), bytes);
  EXPECT_EQ(failure([&] {
              run_training(usual({"episodes", 0}), bytes + "x", "w.state", options());
            }),
            "state: w.state: the state has 1 bytes too many");
}

// The table's mean of each action is what that action pays, so its best action is 1, and a frozen test plays nothing
// else.
TEST_F(TrainingTest, WhatWasLearnedIsTested) {
  const TrainingResult trained = run(usual({"episodes", 50}));
  const Cell cell = cell_of(counter({{"ends", {4}}, {"pays", {0.25, 1, 0.5}}}), table(), 3);
  for (const Episode& episode : run_cell(cell, file(trained.final_state), "w.state", options(2)).episodes)
    EXPECT_EQ(episode.robots[0].reward, 4);
  for (const Episode& episode : run(cell).episodes) EXPECT_EQ(episode.robots[0].reward, 1);
}

TEST_F(TrainingTest, DrawsTheCurvesOfEverybody) {
  Training training = usual({"samples", 4});
  training.snapshots = {2};
  const TrainingResult result = run(training);
  const auto points = [&](const std::string& metric, const std::string& x) {
    const Curve* found = curve(result, metric, x);
    return found ? found->points : std::vector<std::pair<double, double>>();
  };
  using Points = std::vector<std::pair<double, double>>;
  EXPECT_EQ(points("episode_steps", "train_episodes"), (Points{{1, 4}, {2, 4}}));
  EXPECT_EQ(points("train_success", "train_episodes"), (Points{{1, 1}, {2, 1}}));
  EXPECT_EQ(points("samples", "train_episodes"), (Points{{1, 2}, {2, 4}}));
  EXPECT_EQ(points("samples", "samples"), (Points{{2, 2}, {4, 4}}));
  ASSERT_EQ(points("best_action", "rounds").size(), 2u);
  EXPECT_EQ(points("last_x", "train_episodes").size(), 2u);
}

}  // namespace
}  // namespace wend::core
