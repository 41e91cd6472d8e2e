// Whole experiments of the counting plugin: the same results however they are run, and nothing done twice.
#include <core/base/diagnostics.hpp>
#include <core/record/store.hpp>
#include <core/run/runner.hpp>

#include "fixture.hpp"

namespace wend::core {
namespace {

class RunnerTest : public RunTest {
 protected:
  RunnerTest() : catalog_(Catalog::search({WEND_TEST_PLUGINS})) {}

  Json usual() const {
    return Json::parse(R"({"name": "counting", "seed": 3, "seeds": 2, "test": {"episodes": 4},
      "worlds": [{"id": "short", "type": "test.counter", "params": {"ends": [3, 5]}, "variants": 2}, {"id": "long", "type": "test.counter", "params": {"ends": [8]}, "robots": 2}],
      "arms": [{"id": "random", "policy": {"type": "test.script", "params": {"random": true}}},
               {"id": "table", "policy": "test.table", "train": {"worlds": ["short:train"], "samples": 30, "evaluate": {"at": [0, 10], "episodes": 2}}}]})");
  }
  Experiment load(const Json& json) {
    write_file(folder_ + "/experiment.json", json.dump());
    Diagnostics diagnostics;
    auto experiment = load_experiment(folder_ + "/experiment.json", catalog_, {}, diagnostics);
    EXPECT_TRUE(experiment.has_value()) << diagnostics.text();
    return std::move(experiment.value());
  }
  RunOptions options(const std::string& name, std::uint32_t jobs = 2) const {
    RunOptions options;
    options.directory = folder_ + "/" + name;
    options.worker = WEND_TEST_WORKER;
    options.jobs = jobs;
    return options;
  }
  RunReport run_it(const Experiment& experiment, const RunOptions& options, const RunListener& listener = {}) {
    return run_experiment(experiment, catalog_, options, listener);
  }
  // Everything that was found out, without times.
  Json results(const Experiment& experiment, const RunOptions& options) const {
    const Store store(options.directory, true);
    Json all = Json::object();
    for (const Cell& cell : experiment.cells()) {
      const auto result = store.cell(cell.id);
      all[cell.id] = result ? Json(*result) : Json();
      if (result) all[cell.id].erase("decision_us");
    }
    for (const Training& training : experiment.trainings()) {
      const auto result = store.training(training.id);
      all[training.id] = result ? Json(*result) : Json();
      if (result) all[training.id].erase("train_s");
    }
    return all;
  }

  Catalog catalog_;
};

TEST_F(RunnerTest, TheSameHoweverItIsRun) {
  const Experiment experiment = load(usual());
  const std::uint64_t cells = experiment.cells().size(), trainings = experiment.trainings().size();
  EXPECT_EQ(trainings, 2u);  // one a seed
  RunOptions one = options("one", 1), two = options("two", 2), here = options("here", 1);
  two.batch = 64;
  here.isolated = false;
  here.batch = 1;
  const RunReport report = run_it(experiment, one);
  EXPECT_EQ(report.progress.done, cells);
  EXPECT_EQ(report.progress.failed, 0u);
  EXPECT_EQ(report.progress.trainings_done, trainings);
  EXPECT_TRUE(report.failures.empty());
  run_it(experiment, two);
  run_it(experiment, here);
  const Json all = results(experiment, one);
  EXPECT_EQ(all.size(), cells + trainings);
  for (const auto& [id, result] : all.items()) EXPECT_FALSE(result.is_null()) << id;
  EXPECT_EQ(all, results(experiment, two));
  EXPECT_EQ(all, results(experiment, here));
  const Store store(one.directory, true);
  for (const Training& training : experiment.trainings()) {
    const TrainingResult result = store.training(training.id).value();
    EXPECT_EQ(result.snapshots.size(), 2u);
    for (const auto& [at, file] : result.snapshots)
      EXPECT_EQ(read_file(one.directory + "/states/" + file), read_file(two.directory + "/states/" + file)) << at;
  }
  EXPECT_FALSE(std::filesystem::exists(one.directory + "/scratch"));
}

TEST_F(RunnerTest, GoesOnWhereItWasStopped) {
  const Experiment experiment = load(usual());
  const std::uint64_t cells = experiment.cells().size();
  RunListener impatient;
  std::uint64_t asked = 0;
  impatient.stopping = [&] { return ++asked > 6; };
  const RunReport stopped = run_it(experiment, options("parts"), impatient);
  EXPECT_TRUE(stopped.stopped);
  EXPECT_GT(stopped.progress.done, 0u);
  EXPECT_LT(stopped.progress.done, cells);
  const RunReport rest = run_it(experiment, options("parts"));
  EXPECT_EQ(rest.progress.resumed, stopped.progress.done);
  EXPECT_EQ(rest.progress.done, cells);
  const RunReport nothing = run_it(experiment, options("parts"));
  EXPECT_EQ(nothing.progress.resumed, cells);
  EXPECT_EQ(nothing.progress.steps, 0u);
  run_it(experiment, options("whole"));
  EXPECT_EQ(results(experiment, options("parts")), results(experiment, options("whole")));
}

TEST_F(RunnerTest, TrainsAgainWhereAStateIsGone) {
  const Experiment experiment = load(usual());
  run_it(experiment, options("run"));
  std::filesystem::remove_all(folder_ + "/run/states");
  EXPECT_EQ(run_it(experiment, options("run")).progress.steps, 0u);  // nothing is left to test
  Json more = usual();
  more["arms"][1]["train"]["evaluate"]["episodes"] = 3;
  const Experiment other = load(more);
  const RunReport report = run_it(other, options("run"));
  EXPECT_EQ(report.progress.failed, 0u);
  EXPECT_EQ(report.progress.done, other.cells().size());
}

// An arm that goes on from another arm's training starts with its state, seed by seed, and waits for it.
TEST_F(RunnerTest, ATrainingGoesOnFromAnother) {
  Json json = usual();
  json["arms"].push_back(Json::parse(R"({"id": "more", "policy": "test.table", "train": {"worlds": ["short:train"], "samples": 20, "state": {"arm": "table"}}})"));
  json["arms"].push_back(Json::parse(R"({"id": "as_it_is", "policy": "test.table", "train": {"state": {"arm": "table"}}})"));
  const Experiment experiment = load(json);
  const RunReport report = run_it(experiment, options("run"));
  EXPECT_EQ(report.progress.failed, 0u);
  const auto rewards = [&](const std::string& arm) {
    const Store store(folder_ + "/run", true);
    std::vector<double> all;
    for (const Cell& cell : experiment.cells())
      if (cell.driver.arm == arm && !cell.at) {
        const CellResult result = store.cell(cell.id).value();
        for (const Episode& episode : result.episodes) all.push_back(episode.robots[0].reward);
      }
    return all;
  };
  EXPECT_EQ(rewards("as_it_is"), rewards("table"));
  {
    const Store store(folder_ + "/run", true);
    std::map<std::string, std::string> states;  // of the arm "table", by training
    for (const Training& training : experiment.trainings()) {
      const TrainingResult result = store.training(training.id).value();
      if (training.driver.arm == "table") states[training.id] = result.final_state;
      if (training.driver.arm != "more") continue;
      ASSERT_TRUE(states.count(training.initial_training));
      Training alone = training;
      alone.id = std::string(64, 'e');
      const std::string initial = read_file(folder_ + "/run/states/" + states[training.initial_training]);
      EXPECT_EQ(run_training(alone, initial, "", RunTest::options()).hash, result.hash);
    }
  }
  std::filesystem::remove_all(folder_ + "/run/states");  // both are needed again for a cell that is new
  json["arms"][2]["worlds"] = {"short"};
  json["test"]["episodes"] = 5;
  const Experiment other = load(json);
  const RunReport again = run_it(other, options("run"));
  EXPECT_EQ(again.progress.failed, 0u);
  EXPECT_EQ(again.progress.done, other.cells().size());
}

TEST_F(RunnerTest, ATrainingFailsWithTheOneItStartsFrom) {
  Json json = usual();
  json["arms"][1]["policy"] = {{"type", "test.table"}, {"params", {{"use", 0}}}};
  json["arms"].push_back(Json::parse(R"({"id": "more", "policy": "test.table", "worlds": ["short"], "train": {"worlds": ["short:train"], "samples": 20, "state": {"arm": "table"}}})"));
  json["arms"].push_back(json["arms"].back());
  json["arms"].back()["id"] = "still_more";
  json["arms"].back()["train"]["state"]["arm"] = "more";
  const Experiment experiment = load(json);
  run_it(experiment, options("run"));
  const Store store(folder_ + "/run", true);
  const std::string why = "training: policy (test.table): a budget of 30 samples, but 2000 episodes on end brought none; found 0 so far";
  std::size_t followers = 0;
  const auto failed = store.failed(UnitKind::training);
  for (const Training& training : experiment.trainings()) {
    if (!training.driver.arm.ends_with("more")) continue;
    ++followers;
    EXPECT_EQ(failed.at(training.id).failure.message, "the training it starts from failed: " + why);
  }
  EXPECT_EQ(followers, 4u);
}

TEST_F(RunnerTest, AFailureIsOfItsCellAlone) {
  Json json = usual();
  json["arms"].push_back(Json::parse(
      R"({"id": "crash", "policy": {"type": "bad.policy", "params": {"deed": "segv"}}, "worlds": ["short"]})"));
  const Experiment experiment = load(json);
  const RunReport report = run_it(experiment, options("run"));
  EXPECT_EQ(report.progress.failed, 4u);  // two variants, two seeds
  EXPECT_EQ(report.progress.done, experiment.cells().size() - 4);
  ASSERT_EQ(report.failures.size(), 4u);
  for (const RunFailure& failure : report.failures) {
    EXPECT_EQ(failure.unit, "cell");
    EXPECT_EQ(failure.what.find("crash @ short, seed "), 0u);
    EXPECT_EQ(failure.failure.cause, "crash");
  }
  EXPECT_EQ(run_it(experiment, options("run")).progress.steps, 0u);  // not tried again
  RunOptions again = options("run");
  again.retry_failed = true;
  EXPECT_EQ(run_it(experiment, again).progress.failed, 4u);
  const Store store(folder_ + "/run", true);
  for (const auto& [id, failed] : store.failed(UnitKind::cell)) EXPECT_EQ(failed.attempts, 2u);
}

TEST_F(RunnerTest, ATrainingThatFailsTakesItsCellsAlong) {
  Json json = usual();
  json["arms"][1]["policy"] = {{"type", "test.table"}, {"params", {{"use", 0}}}};
  const Experiment experiment = load(json);
  const RunReport report = run_it(experiment, options("run"));
  std::uint64_t waiting = 0;
  for (const Cell& cell : experiment.cells()) waiting += cell.training.empty() ? 0 : 1;
  EXPECT_EQ(report.progress.failed, waiting);
  EXPECT_EQ(report.failures.size(), 2u);
  const Store store(folder_ + "/run", true);
  const std::string why =
      "policy (test.table): a budget of 30 samples, but 2000 episodes on end brought none; found 0 so far";
  for (const auto& [id, failed] : store.failed(UnitKind::training)) EXPECT_EQ(failed.failure.message, why);
  const auto cells = store.failed(UnitKind::cell);
  EXPECT_EQ(cells.size(), waiting);
  for (const auto& [id, failed] : cells) EXPECT_EQ(failed.failure.message, "its training failed: training: " + why);
}

TEST_F(RunnerTest, ACellWhoseFilesAreTakenAwayFails) {
  Json json = usual();
  json["arms"] = Json::array({json["arms"][0]});
  json["arms"].push_back(
      {{"id", "thief"},
       {"worlds", {"short"}},
       {"policy",
        {{"type", "bad.policy"},
         {"params", {{"deed", "unlink"}, {"when", "destroy"}, {"scratch", folder_ + "/run/scratch"}}}}}});
  json["seeds"] = 1;
  const Experiment experiment = load(json);
  const RunReport report = run_it(experiment, options("run", 1));
  EXPECT_EQ(report.progress.failed, 2u);
  EXPECT_EQ(report.progress.done, experiment.cells().size() - 2);
  for (const RunFailure& failure : report.failures) {
    EXPECT_EQ(failure.failure.cause, "files");
    EXPECT_EQ(failure.failure.message.find("expected the file scratch/"), 0u);
  }
}

TEST_F(RunnerTest, FailFastStopsAtTheFirst) {
  Json json = usual();
  json["arms"] = Json::parse(R"([{"id": "crash", "policy": {"type": "bad.policy", "params": {"deed": "_exit"}}}])");
  json["seeds"] = 20;
  RunOptions fast = options("run", 1);
  fast.fail_fast = true;
  const RunReport report = run_it(load(json), fast);
  EXPECT_TRUE(report.stopped);
  EXPECT_GE(report.progress.failed, 1u);
  EXPECT_LE(report.progress.failed, 3u);
}

}  // namespace
}  // namespace wend::core
