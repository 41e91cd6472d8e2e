// A catalog of made-up components and a folder to load experiment files from.
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <core/base/diagnostics.hpp>
#include <core/experiment/experiment.hpp>
#include <core/plugin/catalog.hpp>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace wend::core {

inline Catalog fake_catalog() {
  const std::string text = R"({"wend": 1, "name": "fake", "version": "1", "license": "none", "components": [
    {"id": "test.field", "summary": "A plane.", "interfaces": ["wend.world/1", "wend.geometry2d/1"],
     "parameters": {"type": "object", "properties": {
       "size": {"type": "number", "exclusiveMinimum": 0, "default": 10}, "map": {"type": "array",
         "items": {"type": "string", "format": "files"}}}},
     "robot": {"type": "object", "required": ["radius"], "properties": {
       "radius": {"type": "number", "minimum": 0}, "stop_distance": {"type": "number", "minimum": 0, "default": 0}}}},
    {"id": "test.chain", "summary": "States in a row.", "interfaces": ["wend.world/1", "wend.sensor/1"],
     "parameters": {"type": "object", "properties": {"states": {"type": "integer", "minimum": 2, "default": 4}}}},
    {"id": "test.range", "summary": "Distances.", "interfaces": ["wend.sensor/1"],
      "uses": {"world": {"interfaces": ["wend.geometry2d/1"]}},
     "parameters": {"type": "object", "properties": {"reach": {"type": "number", "exclusiveMinimum": 0,
       "default": 5}, "noise": {"type": "number", "minimum": 0, "default": 0}}}},
    {"id": "test.goal", "summary": "Where to.", "interfaces": ["wend.sensor/1"]},
    {"id": "test.direct", "summary": "Straight on.", "interfaces": ["wend.policy/1"],
     "parameters": {"type": "object", "properties": {"table": {"type": "string", "format": "file"}}}},
    {"id": "test.oracle", "summary": "Reads the map.", "interfaces": ["wend.policy/1"],
      "uses": {"world": {"interfaces": ["wend.geometry2d/1"]}}},
    {"id": "test.window", "summary": "Hands over.", "interfaces": ["wend.policy/1"], "forwards": "avoid",
     "slots": {"avoid": {"interface": "wend.policy/1"}},
     "parameters": {"type": "object", "properties": {"memory": {"enum": ["none", "grid"], "default": "none"}}}},
    {"id": "test.learner", "summary": "Learns.", "interfaces": ["wend.policy/1", "wend.learner/1",
      "wend.state/1", "wend.values/1"],
     "parameters": {"type": "object", "properties": {"gamma": {"type": "number", "minimum": 0,
       "exclusiveMaximum": 1, "default": 0.9}, "mirror": {"type": "boolean"}}}},
    {"id": "test.pupil", "summary": "Is taught.", "interfaces": ["wend.policy/1", "wend.learner/1", "wend.state/1"],
     "slots": {"teacher": {"interface": "wend.values/1", "required": true}}},
    {"id": "test.cost", "summary": "Punishes.", "interfaces": ["wend.reward/1"]}]})";
  return Catalog::of({parse_manifest("fake.so", text)});
}

class ExperimentFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::path(::testing::TempDir()) /
        ("wend_" + std::to_string(::getpid()) + "_" + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = folder_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
    return path.string();
  }

  // Loads `text` as a file of the folder.  What is wrong is kept in `complaints_`, with the folder's name as DIR.
  std::optional<Experiment> load(const std::string& text, const Options& options = {}) {
    Diagnostics diagnostics;
    auto experiment = load_experiment(write("e.json", text), catalog_, options, diagnostics);
    complaints_ = diagnostics.text();
    for (std::size_t at; (at = complaints_.find(folder_.string())) != std::string::npos;)
      complaints_.replace(at, folder_.string().size(), "DIR");
    EXPECT_EQ(experiment.has_value(), !diagnostics.any());
    return experiment;
  }
  std::optional<Experiment> load(const Json& json, const Options& options = {}) { return load(json.dump(2), options); }

  std::filesystem::path folder_;
  Catalog catalog_ = fake_catalog();
  std::string complaints_;
};

// Two worlds, a plain arm and one that learns.
inline Json small_experiment() {
  return Json::parse(R"({"name": "small", "seed": 7,
    "worlds": [{"id": "open", "type": "test.field", "params": {"size": 20}, "variants": 2}, {"id": "tight",
      "type": "test.field"}],
    "robots": {"disc": {"radius": 0.5, "sensors": [{"id": "sonar", "type": "test.range"}, {"id": "goal",
      "type": "test.goal"}]}},
    "arms": [{"id": "plain", "robot": "disc", "policy": "test.direct"},
             {"id": "learns", "robot": "disc", "reward": "test.cost",
              "policy": {"type": "test.window", "slots": {"avoid": {"type": "test.learner",
                "params": {"mirror": true}}}},
              "train": {"samples": 1000, "evaluate": {"at": [0, 500], "episodes": 3}}}],
    "test": {"episodes": 5}, "seeds": 3})");
}

}  // namespace wend::core
