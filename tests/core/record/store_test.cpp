#include <gtest/gtest.h>
#include <wend/abi.h>

#include <chrono>
#include <cmath>
#include <core/base/error.hpp>
#include <core/base/files.hpp>
#include <core/record/sqlite.hpp>
#include <core/record/store.hpp>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <thread>

namespace wend::core {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class StoreTest : public testing::Test {
 protected:
  StoreTest() {
    char name[] = "/tmp/wend-store-XXXXXX";
    folder_ = mkdtemp(name);
  }
  ~StoreTest() override { std::filesystem::remove_all(folder_); }

  std::string error_of_opening(bool read_only = false) {
    try {
      Store store(folder_, read_only);
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::data);
      return error.what();
    }
    return "";
  }

  std::string folder_;
  std::string file() const { return folder_ + "/results.sqlite"; }
};

CellResult cell_result() {
  CellResult result;
  result.metrics = {"path_length_m", "é"};
  result.decision_us = 1.25;
  result.traces = {{0, "traces/a.npz"}};
  result.curves = {{"best_fitness", "generation", {}, {{0, 12}, {1, 9.5}}}};
  for (std::uint64_t i = 0; i < 3; ++i)
    result.episodes.push_back({i + 5,
                               "hash" + std::to_string(i),
                               {{0, WEND_TERMINATED | WEND_ARRIVED, 100 + i, -0.5, {12.5, nan}},
                                {1, WEND_TRUNCATED, 200, 1e300, {nan, static_cast<double>(i)}}}});
  return result;
}

TrainingResult training_result() {
  TrainingResult result;
  result.hash = "chain";
  result.snapshots = {{500, "states/a"}, {2300, "states/b"}};
  result.final_state = "states/c";
  result.traces = {{0, "traces/t0"}, {7, "traces/t7"}};
  result.samples = 10000;
  result.steps = 12345;
  result.episodes = 67;
  result.train_s = 0.75;
  result.curves = {{"accuracy", "train_episodes", {}, {{1, 0.5}, {2, nan}, {3, 1}}}, {"J", "updates", 2u, {{0, -1}}}};
  return result;
}

void expect_equal(const CellResult& a, const CellResult& b) {
  EXPECT_EQ(a.metrics, b.metrics);
  EXPECT_EQ(a.traces, b.traces);
  EXPECT_EQ(a.decision_us, b.decision_us);
  ASSERT_EQ(a.curves.size(), b.curves.size());
  for (std::size_t i = 0; i < a.curves.size(); ++i) {
    EXPECT_EQ(a.curves[i].metric, b.curves[i].metric);
    EXPECT_EQ(a.curves[i].points, b.curves[i].points);
  }
  ASSERT_EQ(a.episodes.size(), b.episodes.size());
  for (std::size_t i = 0; i < a.episodes.size(); ++i) {
    EXPECT_EQ(a.episodes[i].index, b.episodes[i].index);
    EXPECT_EQ(a.episodes[i].hash, b.episodes[i].hash);
    ASSERT_EQ(a.episodes[i].robots.size(), b.episodes[i].robots.size());
    for (std::size_t r = 0; r < a.episodes[i].robots.size(); ++r) {
      const RobotEpisode &x = a.episodes[i].robots[r], &y = b.episodes[i].robots[r];
      EXPECT_EQ(x.robot, y.robot);
      EXPECT_EQ(x.flags, y.flags);
      EXPECT_EQ(x.steps, y.steps);
      EXPECT_EQ(x.reward, y.reward);
      ASSERT_EQ(x.metrics.size(), y.metrics.size());
      for (std::size_t m = 0; m < x.metrics.size(); ++m)
        EXPECT_TRUE(x.metrics[m] == y.metrics[m] || (std::isnan(x.metrics[m]) && std::isnan(y.metrics[m])));
    }
  }
}

TEST_F(StoreTest, GivesBackWhatWasRecorded) {
  const Json description = {{"driver", {{"arm", "lspi"}}}, {"world", {{"id", "dense"}}}, {"variant", 3},
                            {"stream", {{"seed", 7}}},     {"point", {{"/a", 1}}},       {"at", nullptr}};
  std::string build;
  {
    Store store(folder_);
    build = store.begin_session({{"version", "0.1.0"}}, {{"command", {"run"}}});
    EXPECT_EQ(store.record_cell("c1", description, "ok", nullptr, cell_result()), 1u);
    EXPECT_EQ(store.record_training("t1", {}, "ok", nullptr, training_result()), 1u);
    EXPECT_EQ(store.done(UnitKind::cell).size(), 1u);  // the writer sees what is not committed yet
    EXPECT_EQ(store.committed(), 0u);
    EXPECT_EQ(store.pending(), 2u);
  }
  const Store store(folder_, true);
  expect_equal(store.cell("c1").value(), cell_result());
  const TrainingResult training = store.training("t1").value(), expected = training_result();
  EXPECT_EQ(training.hash, expected.hash);
  EXPECT_EQ(training.snapshots, expected.snapshots);
  EXPECT_EQ(training.final_state, expected.final_state);
  EXPECT_EQ(training.traces, expected.traces);
  EXPECT_EQ(training.samples, expected.samples);
  EXPECT_EQ(training.steps, expected.steps);
  EXPECT_EQ(training.episodes, expected.episodes);
  EXPECT_EQ(training.train_s, expected.train_s);
  ASSERT_EQ(training.curves.size(), 2u);
  EXPECT_EQ(training.curves[0].metric, "accuracy");
  EXPECT_EQ(training.curves[0].x, "train_episodes");
  EXPECT_FALSE(training.curves[0].robot);
  ASSERT_EQ(training.curves[0].points.size(), 3u);
  EXPECT_TRUE(std::isnan(training.curves[0].points[1].second));
  EXPECT_EQ(training.curves[1].robot, 2u);
  EXPECT_EQ(store.description("c1"), description);
  EXPECT_EQ(store.build(), (Json{{"version", "0.1.0"}}));
  EXPECT_EQ(store.done(UnitKind::cell).at("c1").build, build);
  EXPECT_FALSE(store.cell("t1"));
  EXPECT_FALSE(store.training("c1"));

  Database db(file(), Database::Access::read);
  EXPECT_EQ(db.value("SELECT arm || world || variant || seed || point FROM cells WHERE at IS NULL"),
            "lspidense37{\"/a\":1}");
  EXPECT_EQ(db.value("SELECT count(*) FROM metrics"), "6");  // NaN has no row
}

TEST_F(StoreTest, AttemptsAreAppendedAndTheLastGoodOneCounts) {
  Store store(folder_);
  const std::string first = store.begin_session({{"version", "1"}}, {});
  EXPECT_EQ(store.record_failure(UnitKind::cell, "c", {}, {"crash", "signal 11"}), 1u);
  EXPECT_EQ(store.record_failure(UnitKind::cell, "c", {}, {"timeout", "60 s"}), 2u);
  EXPECT_EQ(store.failed(UnitKind::cell).at("c").failure.cause, "timeout");
  EXPECT_EQ(store.failed(UnitKind::cell).at("c").failure.message, "60 s");
  EXPECT_EQ(store.failed(UnitKind::cell).at("c").attempts, 2u);
  EXPECT_TRUE(store.done(UnitKind::cell).empty());
  EXPECT_FALSE(store.cell("c"));
  CellResult result = cell_result();
  EXPECT_EQ(store.record_cell("c", {}, "ok", {}, result), 3u);
  const std::string second = store.begin_session({{"version", "2"}}, {});
  EXPECT_NE(first, second);
  result.decision_us = 9;
  EXPECT_EQ(store.record_cell("c", {}, "ok", {}, result), 4u);
  EXPECT_EQ(store.record_failure(UnitKind::cell, "c", {}, {"crash", "signal 6"}), 5u);
  EXPECT_TRUE(store.failed(UnitKind::cell).empty());
  EXPECT_EQ(store.done(UnitKind::cell).at("c").build, second);
  EXPECT_EQ(store.done(UnitKind::cell).at("c").attempt, 4u);
  EXPECT_EQ(store.cell("c")->decision_us, 9);
  EXPECT_EQ(store.record_failure(UnitKind::training, "c", {}, {"memory", "2 GB"}), 1u);  // another table
  EXPECT_EQ(store.failed(UnitKind::training).size(), 1u);
}

TEST_F(StoreTest, CommitsAfter32RecordsOrASecond) {
  Store store(folder_);
  store.begin_session({}, {});
  for (int i = 0; i < 31; ++i) store.record_cell(std::to_string(i), {}, "ok", {}, {});
  EXPECT_EQ(store.committed(), 0u);
  EXPECT_TRUE(Store(folder_, true).done(UnitKind::cell).empty());  // a reader beside the writer
  store.record_cell("31", {}, "ok", {}, {});
  EXPECT_EQ(store.committed(), 32u);
  EXPECT_EQ(Store(folder_, true).done(UnitKind::cell).size(), 32u);
  store.record_cell("32", {}, "ok", {}, {});
  store.tick();
  EXPECT_EQ(store.committed(), 32u);
  std::this_thread::sleep_for(std::chrono::milliseconds(1010));
  store.tick();
  EXPECT_EQ(store.committed(), 33u);
}

TEST_F(StoreTest, ARecordThatCannotBeIsLeftOutWholeAndTheGroupStands) {
  Store store(folder_);
  store.begin_session({}, {});
  store.record_cell("good", {}, "ok", {}, cell_result());
  CellResult twice = cell_result();
  twice.metrics[1] = twice.metrics[0];
  for (Episode& episode : twice.episodes) episode.robots[0].metrics[1] = 1;
  EXPECT_THROW(store.record_cell("twice", {}, "ok", {}, twice), Error);
  CellResult short_of_one = cell_result();
  short_of_one.episodes[1].robots[0].metrics.pop_back();
  EXPECT_THROW(store.record_cell("short", {}, "ok", {}, short_of_one), std::invalid_argument);
  EXPECT_THROW(store.record_cell("status", {}, "done", {}, {}), std::invalid_argument);
  store.record_cell("after", {}, "ok", {}, cell_result());
  store.flush();
  EXPECT_EQ(store.committed(), 2u);
  EXPECT_EQ(store.done(UnitKind::cell).size(), 2u);
  expect_equal(store.cell("after").value(), cell_result());
  Database db(file(), Database::Access::read);
  EXPECT_EQ(db.value("SELECT count(*) FROM episodes"), "12");
}

TEST_F(StoreTest, NamesAndMessagesThatAreNoUtf8AreMended) {
  Store store(folder_);
  store.begin_session({}, {});
  CellResult result = cell_result();
  result.metrics[0] = "a\xff";
  store.record_cell("c", {}, "ok", {}, result);
  EXPECT_EQ(store.cell("c")->metrics[0], "a\ufffd");
  EXPECT_EQ(store.cell("c")->episodes[0].robots[0].metrics[0], 12.5);
  TrainingResult training;
  training.curves = {{"\xc3", "x\x80", {}, {{1, 2}}}};
  store.record_training("t", {}, "ok", {}, training);
  EXPECT_EQ(store.training("t")->curves[0].metric, "\ufffd");
  EXPECT_EQ(store.training("t")->curves[0].x, "x\ufffd");
  store.record_failure(UnitKind::cell, "f", {}, {"plugin", "\xfe said no"});
  EXPECT_EQ(store.failed(UnitKind::cell).at("f").failure.message, "\ufffd said no");
}

TEST_F(StoreTest, ASessionComesFirst) {
  Store store(folder_);
  EXPECT_THROW(store.record_cell("c", {}, "ok", {}, {}), std::logic_error);
}

TEST_F(StoreTest, ForeignAndDamagedFilesAreRefusedWithTheirName) {
  EXPECT_EQ(error_of_opening(true), "no results in " + folder_ + ": " + file() + " is missing");
  write_file(file(), "");
  EXPECT_EQ(error_of_opening(true), "no results in " + folder_ + ": " + file() + " is empty");
  write_file(file(), std::string(5000, 'x'));
  EXPECT_EQ(error_of_opening(), "cannot use " + file() + ": file is not a database; restore it from a copy, or give another directory");
  EXPECT_EQ(error_of_opening(true), "cannot use " + file() + ": file is not a database; restore it from a copy, or give another directory");
  std::filesystem::remove(file());
  Database(file(), Database::Access::write).run("CREATE TABLE t(a)");
  EXPECT_EQ(error_of_opening(), file() +
                                    " is a database, but not a record of wend's: expected application id "
                                    "2003136100, found 0; give another directory");
  std::filesystem::remove(file());
  { Store store(folder_); }
  Database(file(), Database::Access::write).run("PRAGMA user_version = 3");
  EXPECT_EQ(error_of_opening(),
            file() + " has format 3, expected 2: use the wend that wrote it, or give another directory");
}

TEST_F(StoreTest, ATruncatedOrOverwrittenFileIsRefused) {
  {
    Store store(folder_);
    store.begin_session({}, {});
    for (int i = 0; i < 100; ++i) store.record_cell(std::to_string(i), {}, "ok", {}, cell_result());
  }
  const std::string good = read_file(file());
  write_file(file(), good.substr(0, good.size() / 2 / 4096 * 4096));
  EXPECT_EQ(error_of_opening(true).find("cannot use " + file() + ": database disk image is malformed"), 0u)
      << error_of_opening(true);
  std::string torn = good;
  for (std::size_t i = 8192; i < 8192 + 4096; ++i) torn[i] = static_cast<char>(i * 7);
  write_file(file(), torn);
  EXPECT_NE(error_of_opening(), "");
  write_file(file(), good);
  EXPECT_EQ(error_of_opening(), "");
}

TEST_F(StoreTest, OneWriterWhoIsNamed) {
  Store store(folder_);
  const std::string error = error_of_opening();
  EXPECT_EQ(error.find(folder_ + " is in use by process " + std::to_string(::getpid()) + " on "), 0u) << error;
  EXPECT_NE(error.find(" UTC; wait for it, stop it, or give another directory"), std::string::npos) << error;
  EXPECT_EQ(error_of_opening(true), "");
}

// The bar: 500 trivial cells a second, durable.
TEST_F(StoreTest, Records500CellsASecondDurably) {
  CellResult trivial;
  trivial.metrics = {"path_length_m", "spl"};
  trivial.episodes = {{0, std::string(64, 'a'), {{0, WEND_TERMINATED | WEND_ARRIVED, 10, 1, {1, 1}}}}};
  Store store(folder_);
  store.begin_session({}, {});
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 1000; ++i) store.record_cell("cell " + std::to_string(i), {{"point", {}}}, "ok", {}, trivial);
  store.flush();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  RecordProperty("cells_per_s", std::to_string(1000 / seconds));
  EXPECT_EQ(store.committed(), 1000u);
  EXPECT_LT(seconds, 2.0);
}

}  // namespace
}  // namespace wend::core
