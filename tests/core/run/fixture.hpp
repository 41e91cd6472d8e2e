// What the tests of this folder share: units made of tests/core/run/plugins/counting.cpp, and a place to run them in.
#pragma once
#include <gtest/gtest.h>

#include <core/base/files.hpp>
#include <core/run/cell.hpp>
#include <core/run/failure.hpp>
#include <core/run/training.hpp>
#include <core/run/work.hpp>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace wend::core {

inline std::map<std::string, std::string> test_plugins() {
  const std::string counting = WEND_TEST_PLUGINS "/wend-test-counting.so";
  return {{"test.counter", counting}, {"test.eye", counting},
          {"test.pay", counting},     {"test.script", counting},
          {"test.table", counting},   {"bad.policy", WEND_TEST_PLUGINS "/wend-test-misbehave.so"}};
}

inline Json with(Json defaults, const Json& changes) {
  defaults.update(changes);
  return defaults;
}

inline WorldSpec counter(const Json& changes = Json::object(), std::uint32_t robots = 1) {
  WorldSpec world;
  world.id = "counter";
  world.type = "test.counter";
  world.params =
      with({{"ends", {3}}, {"actions", 3}, {"pays", Json::array()}, {"arrive", -1}, {"break", "none"}, {"log", false}},
           changes);
  world.robots = robots;
  return world;
}
inline ComponentSpec eye(const Json& changes = Json::object()) {
  return {"test.eye", with({{"noise", 0}, {"log", false}}, changes), {}};
}
inline ComponentSpec pay(const Json& changes = Json::object()) {
  return {"test.pay", with({{"reward", 1}, {"end", -1}, {"nan", false}, {"log", false}}, changes), {}};
}
inline ComponentSpec script(const Json& changes = Json::object()) {
  return {"test.script",
          with({{"script", {1}},
                {"random", false},
                {"nan_at", -1},
                {"forget_at", -1},
                {"flip_at", -1},
                {"fail_at", -1},
                {"message", ""},
                {"log", false}},
               changes),
          {}};
}
inline ComponentSpec table(const Json& changes = Json::object()) {
  return {"test.table", with({{"use", 1}, {"plan", Json::array()}, {"log", false}}, changes), {}};
}
inline ComponentSpec bad(const std::string& deed, const std::string& when = "act", const std::string& scratch = "") {
  return {"bad.policy", {{"deed", deed}, {"when", when}, {"at", 2}, {"scratch", scratch}}, {}};
}

inline Cell cell_of(WorldSpec world, ComponentSpec policy, std::uint32_t episodes = 1) {
  Cell cell;
  cell.id = std::string(64, 'c');
  cell.driver.arm = "arm";
  cell.driver.policy = std::move(policy);
  cell.world = std::move(world);
  cell.stream.root = 7;
  cell.episodes = episodes;
  return cell;
}

inline Training training_of(WorldSpec world, ComponentSpec policy, Budget budget) {
  Training training;
  training.id = std::string(64, 'a');
  training.driver.arm = "arm";
  training.driver.policy = std::move(policy);
  training.worlds = {std::move(world)};
  training.streams.resize(1);
  training.streams[0].root = 7;
  training.streams[0].train = true;
  training.budget = std::move(budget);
  return training;
}

// A folder of its own and the plugins, loaded into this process.
class RunTest : public ::testing::Test {
 protected:
  RunTest() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = (std::filesystem::temp_directory_path() /
               ("wend-" + std::string(info->test_suite_name()) + "-" + info->name() + "-" + std::to_string(::getpid())))
                  .string();
    std::filesystem::create_directories(folder_);
    libraries_.know(test_plugins());
    listener_.log = [this](std::uint32_t level, const std::string& message) {
      if (level == 0) told_.push_back(message);
    };
  }
  ~RunTest() override { std::filesystem::remove_all(folder_); }

  WorkOptions options(std::uint32_t batch = 1) { return {&libraries_, &listener_, batch, folder_}; }
  CellResult run(const Cell& cell, std::uint32_t batch = 1) { return run_cell(cell, "", "", options(batch)); }
  TrainingResult run(const Training& training) { return run_training(training, "", "", options()); }
  std::string file(const std::string& name) const { return read_file(folder_ + "/" + name); }

  // "cause: message" of what it throws, or "nothing".
  template <class Body>
  static std::string failure(Body&& body) {
    try {
      body();
    } catch (const UnitFailed& failed) {
      return failed.cause() + ": " + failed.what();
    }
    return "nothing";
  }

  std::string folder_;
  Libraries libraries_;
  Listener listener_;
  std::vector<std::string> told_;
};

}  // namespace wend::core
