#include <wend/abi.h>

#include <algorithm>
#include <core/experiment/robots.hpp>
#include <core/plugin/schema.hpp>
#include <utility>

namespace wend::core {

void Robots::read(Json& file) {
  const auto robots = file.find("robots");
  if (robots == file.end() || !robots->is_object()) return;
  for (auto& [name, definition] : robots->items()) {
    Robot& robot = robots_[name];
    robot.file = &definition;
    if (definition.is_object()) {
      read_sensors(name, robot);
    } else {
      scope_.error("/robots/" + pointer_token(name),
                   "expected the definition of robot " + quote(name) + ", found " + quote(definition.dump()),
                   "an object");
    }
  }
}

void Robots::read_sensors(const std::string& name, Robot& robot) {
  const std::string pointer = "/robots/" + pointer_token(name) + "/sensors";
  Json& sensors = robot.file->emplace("sensors", Json::array()).first.value();
  if (!sensors.is_array())
    return scope_.error(pointer, "expected the sensors of robot " + quote(name) + ", found " + quote(sensors.dump()),
                        "an array of {\"id\": ..., \"type\": ...}");
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const std::string at = element(pointer, i);
    const std::string id = text_in(sensors[i], "id");
    scope_.check("sensor", sensors[i], at, id.empty() ? "a sensor of robot " + quote(name) : "sensor " + quote(id));
    ids.push_back(id);
    if (!sensors[i].is_object()) continue;
    if (member(sensors[i], "id") && sensors[i]["id"].is_string()) scope_.check_id(at + "/id", "sensor", id);
    if (id == "world")
      scope_.error(at + "/id", "sensor id \"world\" cannot be used: columns of the world itself are called so",
                   "choose another");
    Composed sensor = compose_object(scope_, sensors[i], at, WEND_SENSOR, robot.needs);
    robot.sensors.push_back({id, std::move(sensor.spec)});
  }
  scope_.check_unique("sensor", pointer, ids);
}

std::vector<std::string> Robots::names() const {
  std::vector<std::string> all;
  for (const auto& robot : robots_) all.push_back(robot.first);
  return all;
}

bool Robots::check_name(const std::string& name, const std::string& pointer, const std::string& who) const {
  if (has(name)) return true;
  scope_.unknown(pointer, "robot", name, " in " + who, names());
  return false;
}

const RobotSpec& Robots::in_world(const std::string& name, const ComponentEntry& world) {
  Robot& robot = robots_.at(name);
  const auto [entry, fresh] = robot.by_world_type.try_emplace(world.id);
  RobotSpec& spec = entry->second;
  if (!fresh || !robot.file->is_object()) return spec;
  spec.name = name;
  spec.sensors = robot.sensors;
  spec.definition = *robot.file;
  spec.definition.erase("sensors");
  const std::string pointer = "/robots/" + pointer_token(name);
  if (world.robot.is_null()) {
    if (spec.definition.empty()) return spec;
    const std::string key = spec.definition.begin().key();
    scope_.error(pointer + "/" + pointer_token(key),
                 "robot " + quote(name) + " can only have sensors in a world of type " + quote(world.id),
                 "remove " + quote(key) + ", or use another robot there", true);
    return spec;
  }
  scope_.assets.resolve(world.robot, spec.definition, pointer, spec.content);
  scope_.report_assets();
  Diagnostics mistakes;
  const SchemaContext context{"robot " + quote(name) + " in " + title(world),
                              &scope_.document,
                              {"all keys: wend plugins show " + world.id},
                              "key"};
  check_schema(world.robot, spec.definition, pointer, context, mistakes);
  for (const Diagnostic& mistake : mistakes.sorted())
    if (told_.insert(mistake.pointer).second) scope_.diagnostics.add(mistake);
  return spec;
}

void Robots::show_defaults() {
  for (auto& [name, robot] : robots_) {
    if (robot.by_world_type.empty()) continue;
    const Json& definition = robot.by_world_type.begin()->second.definition;
    const bool agreed = std::all_of(robot.by_world_type.begin(), robot.by_world_type.end(),
                                    [&](const auto& entry) { return entry.second.definition == definition; });
    if (!agreed) continue;
    Json sensors = std::move((*robot.file)["sensors"]);
    *robot.file = definition;
    (*robot.file)["sensors"] = std::move(sensors);
  }
}

}  // namespace wend::core
