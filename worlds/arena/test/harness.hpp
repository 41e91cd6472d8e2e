// An arena as the host sees it: created by its C table from hand-made parameters, with a scene of the test's own.
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <map>
#include <string>
#include <vector>
#include <wend/plugin.hpp>

#include "../scenes/scene_file.hpp"

namespace arena {

inline wend_status keep_failure(const wend_host* host, wend_status code, const char* param, const char* message);

// A host that remembers what went wrong last.
struct TestHost {
  wend_host table{};  // first: keep_failure() finds the rest behind it
  std::string failure;

  TestHost() {
    table.size = sizeof table;
    table.fail = &keep_failure;
    table.log = [](const wend_host*, std::uint32_t, const char*) {};
    table.series = [](const wend_host*, const char*, double, const char*, double) {};
    table.extension = [](const wend_host*, const char*) -> const void* { return nullptr; };
  }
};

inline wend_status keep_failure(const wend_host* host, wend_status code, const char* param, const char* message) {
  auto* self = reinterpret_cast<TestHost*>(const_cast<wend_host*>(host));
  self->failure = (param ? std::string(param) + ": " : std::string()) + message;
  return code;
}

// Parameters by path; texts and numbers.
struct Values {
  std::map<std::string, double> numbers;
  std::map<std::string, std::string> texts;

  std::vector<wend_value> table() const {
    std::map<std::string, wend_value> all;
    for (const auto& [path, number] : numbers) all[path] = {path.c_str(), nullptr, number};
    for (const auto& [path, text] : texts) all[path] = {path.c_str(), text.c_str(), 0};
    std::vector<wend_value> values;
    for (auto& [path, value] : all) values.push_back(value);
    return values;
  }
};

// The file of a scene, gone with the object.
class SceneFile {
 public:
  explicit SceneFile(const Scene& scene) {
    static int count = 0;
    path_ = testing::TempDir() + "arena_" + std::to_string(::getpid()) + "_" + std::to_string(count++) + ".json";
    std::ofstream(path_) << format_scene(scene);
  }
  SceneFile(const SceneFile&) = delete;
  ~SceneFile() { ::unlink(path_.c_str()); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

// What most tests want: dt 1 s, a unicycle of radius 1 m, no limits of acceleration.
inline Values world_values(std::map<std::string, double> more = {}) {
  Values values{{{"dt", 1}, {"substeps", 1}, {"time_limit", 100}, {"cell", 1}, {"walled", 1}, {"optimal", 0}}, {}};
  for (const auto& [path, number] : more) values.numbers[path] = number;
  return values;
}
inline Values robot_values(double radius = 1, std::map<std::string, double> more = {}) {
  Values values{{{"body/radius", radius},
                 {"kinematics/speed/0", -100},
                 {"kinematics/speed/1", 100},
                 {"kinematics/turn_rate", 100}},
                {{"kinematics/type", "unicycle"}}};
  for (const auto& [path, number] : more) values.numbers[path] = number;
  return values;
}

class Arena {
 public:
  Arena(Values world, Values robot, std::uint32_t copies = 1, std::uint32_t robots = 1)
      : copies_(copies), robots_(robots) {
    const auto values = world.table(), robot_table = robot.table();
    wend_config config{};
    config.size = sizeof config;
    config.copies = copies, config.robots = robots;
    config.values = values.data(), config.value_count = static_cast<std::uint32_t>(values.size());
    config.robot_values = robot_table.data(), config.robot_value_count = static_cast<std::uint32_t>(robot_table.size());
    config.params = config.robot = "{}";
    type_ = wend_plugin_1.components[0];
    status = type_->create(&host.table, &config, &self_);
    if (status != WEND_OK) return;
    world_ = table<wend_world>(WEND_WORLD);
    geometry_ = table<wend_geometry2d>(WEND_GEOMETRY2D);
    body_ = table<wend_body>(WEND_BODY);
    telemetry_ = table<wend_telemetry>(WEND_TELEMETRY);
    width_ = world_->action(self_, 0)->width;
  }
  Arena(const Scene& scene, Values world, Values robot, std::uint32_t copies = 1, std::uint32_t robots = 1)
      : Arena(with_file(std::move(world), SceneFile(scene)), std::move(robot), copies, robots) {}
  Arena(const Arena&) = delete;
  ~Arena() {
    if (self_) type_->destroy(self_);
  }

  wend_status reset(std::uint64_t seed = 1, std::uint64_t scene = 7) {
    std::vector<std::uint32_t> all;
    std::vector<wend_episode> episodes;
    for (std::uint32_t c = 0; c < copies_; ++c) {
      all.push_back(c);
      episodes.push_back({c, wend::stream(seed, c), scene, 0, WEND_TEST});
    }
    outcomes.assign(copies_ * robots_, {});
    return world_->reset(self_, all.data(), copies_, episodes.data());
  }
  wend_status reset_one(std::uint32_t copy, const wend_episode& episode) {
    outcomes.resize(copies_ * robots_);
    return world_->reset(self_, &copy, 1, &episode);
  }
  // One period of all copies, or of some, with an action row for each of their rows.
  wend_status step(const std::vector<double>& actions) {
    std::vector<std::uint32_t> all;
    for (std::uint32_t c = 0; c < copies_; ++c) all.push_back(c);
    return world_->step(self_, all.data(), copies_, actions.data(), outcomes.data());
  }
  wend_status step_one(std::uint32_t copy, const std::vector<double>& actions) {
    return world_->step(self_, &copy, 1, actions.data(), &outcomes[copy * robots_]);
  }
  std::uint32_t flags(std::uint32_t row = 0) const { return outcomes[row].flags; }
  wend_pose pose(std::uint32_t row = 0) const {
    wend_pose out;
    geometry_->poses(self_, &row, 1, &out);
    return out;
  }
  wend_disc goal(std::uint32_t row = 0) const {
    wend_disc body, out;
    geometry_->bodies(self_, &row, 1, &body, &out);
    return out;
  }
  std::pair<double, int> cast(wend_pose ray, double reach, std::uint32_t kinds, std::uint32_t row = 0) const {
    double distance;
    std::uint8_t kind;
    geometry_->cast(self_, &row, &ray, 1, reach, kinds, &distance, &kind);
    return {distance, kind};
  }
  double clearance(double x, double y, std::uint32_t kinds, std::uint32_t row = 0) const {
    const double xy[2] = {x, y};
    double out;
    geometry_->clearance(self_, &row, xy, 1, kinds, &out);
    return out;
  }
  std::vector<wend_shape> shapes(std::uint32_t copy = 0) const {
    const wend_shape* first;
    std::uint32_t n;
    geometry_->shapes(self_, copy, &first, &n);
    return {first, first + n};
  }
  double metric(const std::string& name, std::uint32_t row = 0) const {
    const wend_space* space = telemetry_->space(self_, WEND_PER_EPISODE);
    std::vector<double> values(space->width);
    telemetry_->read(self_, WEND_PER_EPISODE, &row, 1, values.data());
    for (std::uint32_t i = 0; i < space->width; ++i)
      if (name == space->columns[i].name) return values[i];
    ADD_FAILURE() << "no metric " << name;
    return 0;
  }
  wend_limits limits() const {
    wend_limits out;
    body_->limits(self_, 0, &out);
    return out;
  }
  wend_motion predict(wend_motion from, const std::vector<double>& action, double seconds) const {
    wend_motion to;
    body_->predict(self_, 0, &from, action.data(), 1, seconds, &to);
    return to;
  }
  template <class Table>
  const Table* table(const char* id) const {
    return static_cast<const Table*>(type_->query(self_, id));
  }
  wend_object* self() const { return self_; }
  const wend_world* world() const { return world_; }

  TestHost host;
  wend_status status = WEND_OK;
  std::vector<wend_outcome> outcomes;

 private:
  static Values with_file(Values values, const SceneFile& file) {
    values.texts["scene/0"] = file.path();
    return values;
  }

  const wend_component* type_ = nullptr;
  wend_object* self_ = nullptr;
  const wend_world* world_ = nullptr;
  const wend_geometry2d* geometry_ = nullptr;
  const wend_body* body_ = nullptr;
  const wend_telemetry* telemetry_ = nullptr;
  std::uint32_t copies_, robots_, width_ = 0;
};

}  // namespace arena
