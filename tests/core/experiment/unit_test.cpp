#include <gtest/gtest.h>

#include <cmath>
#include <core/base/error.hpp>
#include <core/experiment/unit.hpp>
#include <limits>

namespace wend::core {
namespace {

ComponentSpec learner() {
  return {"test.learner", {{"gamma", 0.9}}, {}, Json::object()};
}

DriverSpec driver() {
  DriverSpec spec;
  spec.arm = "a";
  spec.robot = {
      "disc", {{"radius", 0.5}}, Json::object(), {{"sonar", {"test.range", {{"reach", 5.0}}, {}, Json::object()}}}};
  spec.policy = {
      "test.window", {{"map", "/one/a.map"}}, {{"avoid", learner()}}, {{"/one/a.map", std::string(64, 'a')}}};
  spec.reward = ComponentSpec{"test.cost", Json::object(), {}, Json::object()};
  return spec;
}

WorldSpec world() {
  return {"w", "test.field", {{"size", 10.0}}, 3, 4, 2, true, Json::object()};
}

Training training() {
  Training unit;
  unit.point = {{"/seed", 1}};
  unit.driver = driver();
  unit.worlds = {world()};
  unit.streams = {{7, 2, true}};
  unit.budget = {"samples", 1000};
  unit.greedy_every = 5;
  unit.snapshots = {0, 500};
  unit.keep = "best";
  unit.selection_episodes = 9;
  unit.selection_worlds = {world()};
  unit.selection_streams = {{7, 2, true}};
  unit.initial_state = std::string(64, 'b');
  unit.id = identify(unit);
  return unit;
}

Cell cell() {
  Cell unit;
  unit.point = {{"/seed", 1}};
  unit.driver = driver();
  unit.world = world();
  unit.stream = {std::numeric_limits<std::uint64_t>::max(), 2, false};
  unit.variant = 3;
  unit.episodes = 11;
  unit.training = std::string(64, 'c');
  unit.at = Budget{"steps", 400};
  unit.state = std::string(64, 'd');
  unit.traced_episodes = 2;
  unit.privileged = true;
  unit.id = identify(unit);
  return unit;
}

// Through text, as between processes.
template <class T>
T through_text(const T& value) {
  return Json::parse(Json(value).dump()).get<T>();
}

TEST(Unit, TrainingSurvivesTheJourneyToAWorker) {
  const Training back = through_text(training());
  EXPECT_EQ(Json(back), Json(training()));
  EXPECT_EQ(identify(back), training().id);
  EXPECT_EQ(back.selection_worlds.at(0).variants, 4u);
  EXPECT_EQ(back.driver.policy.slots.at("avoid").params["gamma"], 0.9);
}

TEST(Unit, CellSurvivesTheJourneyToAWorker) {
  const Cell back = through_text(cell());
  EXPECT_EQ(Json(back), Json(cell()));
  EXPECT_EQ(identify(back), cell().id);
  EXPECT_EQ(back.stream.root, std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(back.at->amount, 400u);
  EXPECT_TRUE(back.privileged);
}

TEST(Unit, ResultsSurviveTheJourneyBackWithNumbersThatJsonDoesNotHave) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CellResult result;
  result.metrics = {"path_length_m", "spl"};
  result.episodes = {{4, "hash", {{1, 9, 500, -2.5, {std::nan(""), 0.1}}, {2, 2, 7, infinity, {-infinity, -0.0}}}}};
  result.traces = {{0, "0.npz"}, {12, "12.npz"}};
  result.decision_us = 1.0 / 3;
  const CellResult back = through_text(result);
  EXPECT_EQ(Json(back), Json(result));
  EXPECT_TRUE(std::isnan(back.episodes[0].robots[0].metrics[0]));
  EXPECT_EQ(back.episodes[0].robots[1].metrics[0], -infinity);
  EXPECT_TRUE(std::signbit(back.episodes[0].robots[1].metrics[1]));
  EXPECT_EQ(back.decision_us, 1.0 / 3);
  EXPECT_EQ(back.traces.at(12), "12.npz");

  TrainingResult trained;
  trained.hash = "h";
  trained.snapshots = {{500, "500.state"}};
  trained.final_state = "final.state";
  trained.samples = 1000;
  trained.curves = {{"accuracy", "train_episodes", std::nullopt, {{0, 0.5}, {1000, std::nan("")}}},
                    {"fitness", "updates", 2u, {}}};
  const TrainingResult trained_back = through_text(trained);
  EXPECT_EQ(Json(trained_back), Json(trained));
  EXPECT_EQ(trained_back.curves[1].robot, 2u);
  EXPECT_TRUE(std::isnan(trained_back.curves[0].points[1].second));
}

std::string complaint_about(const Json& json) {
  Cell unit;
  unit.id = "kept";
  try {
    json.get_to(unit);
  } catch (const Error& error) {
    EXPECT_EQ(unit.id, "kept");
    return error.what();
  }
  return "none";
}

TEST(Unit, DamagedJsonIsRefusedWhereItIsDamaged) {
  Json json = cell();
  json["variant"] = -1;
  EXPECT_EQ(complaint_about(json), "unit /variant: expected a whole number from 0 to 4294967295, found -1");
  json["variant"] = 4294967296;
  EXPECT_EQ(complaint_about(json), "unit /variant: expected a whole number from 0 to 4294967295, found 4294967296");
  json["variant"] = 1.5;
  EXPECT_EQ(complaint_about(json), "unit /variant: expected a whole number from 0 to 4294967295, found 1.5");
  json = cell();
  json["driver"]["robot"]["sensors"][0]["component"]["type"] = true;
  EXPECT_EQ(complaint_about(json), "unit /driver/robot/sensors/0/component/type: expected text, found true");
  json = cell();
  json["world"].erase("files");
  EXPECT_EQ(complaint_about(json), "unit /world/files: missing");
  EXPECT_EQ(complaint_about(5), "unit /: expected an object, found 5");
}

TEST(Unit, IdsAreWhatTheyWere) {  // a change here orphans every run directory
  EXPECT_EQ(training().id, "9a1d423a28403a871be36b4c66bf596d6913c3e7e91f69a6475e682bc9f7dc5f");
  EXPECT_EQ(cell().id, "696fa831fa557226c45b9765714f1751489a60771bf5f233bbdace07f1c05a93");
}

TEST(Unit, EveryPartOfACellIsInItsId) {
  const std::string id = cell().id;
  const Json whole = cell();
  std::size_t leaves = 0;
  const Json flat = whole.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    if (pointer == "/id" || pointer.find("/content") != std::string::npos || value.is_null() || value.empty()) continue;
    if (value.is_structured()) continue;
    Json changed = whole;
    Json& leaf = changed[Json::json_pointer(pointer)];
    if (leaf.is_string())
      leaf = leaf.get<std::string>() + "x";
    else if (leaf.is_boolean())
      leaf = !leaf.get<bool>();
    else if (leaf.is_number_float())
      leaf = leaf.get<double>() + 1;
    else
      leaf = leaf.get<std::uint64_t>() == 0 ? 1 : leaf.get<std::uint64_t>() - 1;
    EXPECT_NE(identify(changed.get<Cell>()), id) << pointer;
    ++leaves;
  }
  EXPECT_GE(leaves, 25u);
}

TEST(Unit, AFileCountsByItsContentAndNotByItsPlace) {
  Cell moved = cell();
  moved.driver.policy.params["map"] = "/elsewhere/b.map";
  moved.driver.policy.content = {{"/elsewhere/b.map", std::string(64, 'a')}};
  EXPECT_EQ(identify(moved), cell().id);
  moved.driver.policy.content = {{"/elsewhere/b.map", std::string(64, 'e')}};
  EXPECT_NE(identify(moved), cell().id);
  Cell unit = cell();
  unit.id = "anything";
  EXPECT_EQ(identify(unit), cell().id);
  EXPECT_EQ(identify(unit, digests(unit)), cell().id);
}

}  // namespace
}  // namespace wend::core
