#include <gtest/gtest.h>
#include <wend/abi.h>

#include <algorithm>
#include <core/base/sha256.hpp>
#include <core/stats/bootstrap.hpp>
#include <core/stats/intervals.hpp>
#include <core/stats/summary.hpp>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>

namespace wend::core {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint32_t arrived = WEND_TERMINATED | WEND_ARRIVED, collided = WEND_TERMINATED | WEND_COLLIDED,
                        truncated = WEND_TRUNCATED;

class SummaryTest : public testing::Test {
 protected:
  SummaryTest() {
    char name[] = "/tmp/wend-summary-XXXXXX";
    folder_ = mkdtemp(name);
    store_.emplace(folder_);
    store_->begin_session({{"version", "0.1.0"}}, {});
  }
  ~SummaryTest() override {
    store_.reset();
    std::filesystem::remove_all(folder_);
  }

  // Plans a cell; ids are numbered.
  Cell& plan(const std::string& arm, const std::string& world, std::uint64_t seed, std::uint32_t variant = 0) {
    Cell cell;
    cell.id = "cell " + std::to_string(cells_.size());
    cell.driver.arm = arm;
    cell.world.id = world;
    cell.stream.seed = seed;
    cell.variant = variant;
    return cells_.emplace_back(cell);
  }

  Training& plan_training(const std::string& arm, const std::string& world, std::uint64_t seed) {
    Training training;
    training.id = "training " + std::to_string(trainings_.size());
    training.driver.arm = arm;
    training.worlds.emplace_back().id = world;
    training.streams.emplace_back().seed = seed;
    return trainings_.emplace_back(training);
  }

  void record(const CellResult& result) { store_->record_cell(cells_.back().id, {}, "ok", {}, result); }

  Json summary() { return summarize("test", trainings_, cells_, *store_); }

  std::string folder_;
  std::optional<Store> store_;
  std::vector<Training> trainings_;
  std::vector<Cell> cells_;
};

// One robot; an episode for each flag, in as many steps as given.
CellResult episodes(const std::vector<std::uint32_t>& flags, std::uint64_t steps = 10) {
  CellResult result;
  result.metrics = {"path_length_m"};
  result.decision_us = 2;
  for (const std::uint32_t f : flags)
    result.episodes.push_back(
        {result.episodes.size(), "h", {{0, f, steps, 0, {f & WEND_ARRIVED ? static_cast<double>(steps) / 2 : nan}}}});
  return result;
}

TEST_F(SummaryTest, RowsInPlanOrderWithRatesAndMetricsOfSuccesses) {
  plan("b", "w", 0).privileged = true;
  record(episodes({arrived, arrived, collided, truncated}, 10));
  plan("a", "w", 0);
  record(episodes({arrived}, 7));
  plan("b", "w", 1, 3);
  record(episodes({arrived, arrived, arrived, arrived, WEND_TERMINATED | WEND_TRUNCATED | WEND_COLLIDED}, 20));
  const Json found = summary();
  ASSERT_EQ(found["results"].size(), 2u);
  const Json& b = found["results"][0];
  EXPECT_EQ(b["arm"], "b");
  EXPECT_EQ(b["world"], "w");
  EXPECT_EQ(b["point"], Json::object());
  EXPECT_EQ(b["at"], Json::object());
  EXPECT_EQ(b["privileged"], true);
  EXPECT_EQ(b["seeds"], 2);
  EXPECT_EQ(b["episodes"], 9);
  EXPECT_EQ(b["success"], (Json{{"rate", 6.0 / 9}, {"low", wilson(6, 9).low}, {"high", wilson(6, 9).high}, {"n", 9}}));
  EXPECT_EQ(b["collision"]["rate"], 2.0 / 9);  // a collision is no timeout
  EXPECT_EQ(b["timeout"]["rate"], 1.0 / 9);
  EXPECT_EQ(b["worst_seed_success"], 0.5);
  EXPECT_EQ(b["metrics"]["steps"]["n"], 6);
  EXPECT_DOUBLE_EQ(b["metrics"]["steps"]["mean"], (2 * 10 + 4 * 20) / 6.0);
  EXPECT_DOUBLE_EQ(b["metrics"]["steps"]["iqm"], (10 + 3 * 20) / 4.0);
  EXPECT_DOUBLE_EQ(b["metrics"]["path_length_m"]["mean"], (2 * 5 + 4 * 10) / 6.0);
  EXPECT_EQ(b["metrics"]["decision_us"], (Json{{"mean", 2.0}, {"iqm", 2.0}, {"low", 2.0}, {"high", 2.0}, {"n", 2}}));
  EXPECT_FALSE(b["metrics"].contains("train_s"));
  EXPECT_FALSE(b.contains("failed"));
  EXPECT_EQ(found["results"][1]["arm"], "a");
  EXPECT_EQ(found["wend"], "0.1.0");
  EXPECT_EQ(found["experiment"], "test");
  EXPECT_EQ(found["cells"], (Json{{"planned", 3}, {"done", 3}, {"failed", 0}}));
  EXPECT_EQ(found.dump().find("null"), std::string::npos);
}

TEST_F(SummaryTest, FailedAndMissingCells) {
  plan("a", "w", 0);
  record(episodes({arrived}));
  plan("a", "w", 1);
  store_->record_failure(UnitKind::cell, cells_.back().id, {}, {"crash", "signal 11"});
  plan("b", "w", 0);  // never ran
  const Json found = summary();
  EXPECT_EQ(found["cells"], (Json{{"planned", 3}, {"done", 1}, {"failed", 1}}));
  EXPECT_EQ(found["results"][0]["failed"], 1);
  EXPECT_EQ(found["results"][0]["seeds"], 1);
  EXPECT_EQ(found["results"][1]["episodes"], 0);
  EXPECT_FALSE(found["results"][1].contains("success"));
}

TEST_F(SummaryTest, NoRatesInAWorldWithoutArrivalsAndCollisions) {
  plan("a", "balance", 0);
  record(episodes({truncated, truncated}, 30));
  plan("a", "maze", 0);
  record(episodes({truncated}));
  plan("b", "maze", 0);
  record(episodes({arrived}));
  const Json rows = summary()["results"];
  for (const char* key : {"success", "collision", "timeout", "worst_seed_success"}) {
    EXPECT_FALSE(rows[0].contains(key)) << key;
    EXPECT_TRUE(rows[1].contains(key)) << key;  // another arm arrives there
  }
  EXPECT_EQ(rows[0]["metrics"]["steps"]["mean"], 30);  // without success, of all episodes
  EXPECT_FALSE(rows[1]["metrics"].contains("steps"));
}

TEST_F(SummaryTest, WhereTheSeedTrainsTheIntervalIsTheWiderOne) {
  const std::vector<std::uint64_t> successes = {10, 10, 9, 10, 3, 10, 8, 10, 10, 10};
  std::vector<SeedCounts> seeds;
  for (const bool trains : {true, false}) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      plan(trains ? "learner" : "fixed", "w", seed).training = trains ? "some" : "";
      std::vector<std::uint32_t> flags(10, truncated);
      std::fill_n(flags.begin(), successes[seed], arrived);
      record(episodes(flags));
      if (trains) seeds.push_back({10, {successes[seed]}});
    }
  }
  const Json rows = summary()["results"];
  EXPECT_EQ(rows[1]["success"]["low"], wilson(90, 100).low);
  EXPECT_NEAR(rows[0]["success"]["low"].get<double>(), 0.75, 0.011);  // numpy: 0.75, 1 (bootstrap_test.cpp)
  EXPECT_EQ(rows[0]["success"]["high"], 1.0);
  EXPECT_EQ(rows[0]["collision"]["high"], wilson(0, 100).high);  // the bootstrap has no width there
  EXPECT_EQ(rows[0]["worst_seed_success"], 0.3);
}

TEST_F(SummaryTest, SeveralRobots) {
  plan("a", "multi", 0);
  CellResult result;
  result.metrics = {"path_length_m"};
  const auto episode = [&](std::uint32_t first, std::uint32_t second) {
    result.episodes.push_back({result.episodes.size(), "h", {{0, first, 10, 0, {4}}, {1, second, 30, 0, {nan}}}});
  };
  episode(arrived, arrived);
  episode(arrived, collided);
  episode(truncated, collided);
  episode(arrived, truncated);
  record(result);
  const Json row = summary()["results"][0];
  EXPECT_EQ(row["episodes"], 4);
  EXPECT_EQ(row["success"]["rate"], 0.25);
  EXPECT_EQ(row["collision"]["rate"], 0.5);
  EXPECT_EQ(row["timeout"]["rate"], 0.25);
  EXPECT_EQ(row["metrics"]["steps"]["mean"], 30);  // until the last one arrived
  EXPECT_EQ(row["metrics"]["success_robot_0"],
            (Json{{"mean", 0.75}, {"low", wilson(3, 4).low}, {"high", wilson(3, 4).high}, {"n", 4}}));
  EXPECT_EQ(row["metrics"]["success_robot_1"]["mean"], 0.25);
  EXPECT_EQ(row["metrics"]["collision_robot_1"]["mean"], 0.5);
  EXPECT_EQ(row["metrics"]["timeout_robot_0"]["mean"], 0.25);
  EXPECT_EQ(row["metrics"]["path_length_m_robot_0"]["n"], 4);
  EXPECT_FALSE(row["metrics"].contains("path_length_m_robot_1"));
}

TEST_F(SummaryTest, SnapshotsAreRowsAndCurves) {
  for (const std::uint64_t amount : {2300, 0}) {
    plan("lspi", "w", 0).at = Budget{"samples", amount};
    CellResult result = episodes(amount > 0 ? std::vector{arrived, arrived} : std::vector{collided, arrived});
    result.metrics = {"spl"};
    for (Episode& episode : result.episodes) episode.robots[0].metrics = {amount > 0 ? 0.5 : 0.25};
    record(result);
  }
  plan("lspi", "w", 0);
  record(episodes({arrived}));
  const Json found = summary();
  ASSERT_EQ(found["results"].size(), 3u);
  EXPECT_EQ(found["results"][0]["at"], (Json{{"samples", 2300}}));
  ASSERT_EQ(found["curves"].size(), 3u);
  const Json expected = {
      {"arm", "lspi"},
      {"world", "w"},
      {"point", Json::object()},
      {"robot", nullptr},
      {"metric", "success"},
      {"x", "samples"},
      {"points", {{0, 0.5, wilson(1, 2).low, wilson(1, 2).high}, {2300, 1.0, wilson(2, 2).low, 1.0}}}};
  EXPECT_EQ(found["curves"][0], expected);
  EXPECT_EQ(found["curves"][1]["metric"], "collision");
  EXPECT_EQ(found["curves"][2]["points"], Json::parse("[[0,0.25,0.25,0.25],[2300,0.5,0.5,0.5]]"));
}

// What plugins tell in the tests of the final state, which may be that of the last snapshot.
TEST_F(SummaryTest, SeriesAreThoseOfTheLastState) {
  const auto plan_series = [&](const std::string& arm, std::uint64_t seed, std::optional<Budget> at, double y) {
    plan(arm, "w", seed).at = at;
    CellResult result = episodes({arrived});
    result.curves = {{"best_fitness", "generation", {}, {{0, y}}}};
    record(result);
  };
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    plan_series("snapshots", seed, Budget{"samples", 300}, 1);
    plan_series("snapshots", seed, Budget{"samples", 100}, 2);
    plan_series("both", seed, Budget{"samples", 300}, 3);
    plan_series("both", seed, std::nullopt, 4);
  }
  std::map<std::string, Json> series;
  const Json found = summary();
  for (const Json& curve : found["curves"])
    if (curve["metric"] == "best_fitness") series[curve["arm"]] = curve["points"];
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series["snapshots"][0][1], 1.0);
  EXPECT_EQ(series["both"][0][1], 4.0);
}

TEST_F(SummaryTest, CurvesOfTrainingsOverSeedsAndTheirTime) {
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    const std::string id = plan_training("xcs", "mux11:train", seed).id;
    TrainingResult result;
    result.train_s = 1.0 + static_cast<double>(seed);
    result.curves = {{"accuracy", "train_episodes", {}, {{1000, 0.5 + 0.25 * static_cast<double>(seed)}, {2000, nan}}},
                     {"J", "updates", 1u, {{1, 3}}}};
    store_->record_training(id, {}, "ok", {}, result);
    for (const char* world : {"mux11", "mux11_new"}) {
      plan("xcs", world, seed).training = id;
      record(episodes({truncated}));
      cells_.back().variant = 0;
    }
  }
  const std::string alone = plan_training("xcs", "elsewhere", 0).id;
  TrainingResult result;
  result.curves = {{"accuracy", "train_episodes", {}, {{1, 1}}}};
  store_->record_training(alone, {}, "ok", {}, result);
  const Json found = summary();
  ASSERT_EQ(found["curves"].size(), 5u);
  EXPECT_EQ(found["curves"][0], (Json{{"arm", "xcs"},
                                      {"world", "mux11"},
                                      {"point", Json::object()},
                                      {"robot", nullptr},
                                      {"metric", "accuracy"},
                                      {"x", "train_episodes"},
                                      {"points", {{1000.0, 0.625, 0.5, 0.75}}}}));
  EXPECT_EQ(found["curves"][1]["robot"], 1);
  EXPECT_EQ(found["curves"][2]["world"], "mux11_new");
  EXPECT_EQ(found["curves"][4]["world"], "elsewhere");
  EXPECT_EQ(found["results"][0]["metrics"]["train_s"]["mean"], 1.5);
  EXPECT_EQ(found["results"][0]["metrics"]["train_s"]["n"], 2);
}

TEST_F(SummaryTest, TheFingerprintChainsHashesAndNothingElse) {
  plan_training("a", "w", 0);
  TrainingResult training;
  training.hash = "T";
  training.train_s = 1;
  store_->record_training("training 0", {}, "ok", {}, training);
  plan("a", "w", 0);
  record(episodes({arrived, collided}));
  plan("a", "w", 1);
  record(episodes({arrived}));
  const std::string first = summary()["fingerprint"];
  EXPECT_EQ(first, sha256("cell cell 0 0:h 1:h\ncell cell 1 0:h\ntraining training 0 T\n"));
  std::reverse(cells_.begin(), cells_.end());
  EXPECT_EQ(summary()["fingerprint"], first);
  CellResult slower = episodes({arrived});
  slower.decision_us = 99;
  training.train_s = 99;
  store_->record_training("training 0", {}, "ok", {}, training);
  store_->record_cell("cell 1", {}, "ok", {}, slower);
  EXPECT_EQ(summary()["fingerprint"], first);
  slower.episodes[0].hash = "H";
  store_->record_cell("cell 1", {}, "ok", {}, slower);
  EXPECT_NE(summary()["fingerprint"], first);
}

// A summary of 100 rows of 1,000 episodes with five metrics; the bar is 3 s on the machine of the figures.
TEST_F(SummaryTest, IsQuick) {
  for (int arm = 0; arm < 100; ++arm) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      plan("arm " + std::to_string(arm), "w", seed).training = arm % 2 ? "some" : "";
      CellResult result;
      result.metrics = {"path_length_m", "spl", "min_clearance_m", "avoid_share"};
      for (std::uint64_t e = 0; e < 100; ++e) {
        const double x = static_cast<double>((e * 37 + seed * 11 + static_cast<std::uint64_t>(arm)) % 101);
        const std::uint32_t flags = x > 5 ? arrived : collided;
        result.episodes.push_back({e, std::string(64, 'a'), {{0, flags, 100 + e, 0, {x, x / 101, -x, x * x}}}});
      }
      record(result);
    }
  }
  const std::clock_t start = std::clock();  // CPU time: tests share their cores
  const Json found = summary();
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  RecordProperty("seconds", std::to_string(seconds));
  EXPECT_EQ(found["results"].size(), 100u);
  EXPECT_EQ(found["results"][0]["episodes"], 1000);
  EXPECT_LT(seconds, 6.0);  // twice the bar
}

}  // namespace
}  // namespace wend::core
