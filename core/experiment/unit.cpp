// Units and results as JSON.  Each structure is described once, and the description serves writing, reading and
// identifying.
#include <concepts>
#include <core/base/sha256.hpp>
#include <core/experiment/codec.hpp>
#include <core/experiment/unit.hpp>
#include <type_traits>
#include <utility>

namespace wend::core {

template <class T, class U>
concept Is = std::same_as<std::remove_const_t<T>, U>;

template <class Archive, Is<ComponentSpec> T>
void fields(Archive& archive, T& spec) {
  archive("type", spec.type);
  archive.with_files("params", spec.params, spec.content);
  archive("slots", spec.slots);
}

template <class Archive, Is<SensorSpec> T>
void fields(Archive& archive, T& spec) {
  archive("id", spec.id);
  archive("component", spec.component);
}

template <class Archive, Is<RobotSpec> T>
void fields(Archive& archive, T& spec) {
  archive("name", spec.name);
  archive.with_files("definition", spec.definition, spec.content);
  archive("sensors", spec.sensors);
}

template <class Archive, Is<WorldSpec> T>
void fields(Archive& archive, T& spec) {
  archive("id", spec.id);
  archive("type", spec.type);
  archive.with_files("params", spec.params, spec.content);
  archive("robots", spec.robots);
  archive("variants", spec.variants);
  archive("files", spec.files);
  archive("one_scene", spec.one_scene);
}

template <class Archive, Is<StreamSpec> T>
void fields(Archive& archive, T& spec) {
  archive("root", spec.root);
  archive("seed", spec.seed);
  archive("train", spec.train);
}

template <class Archive, Is<DriverSpec> T>
void fields(Archive& archive, T& spec) {
  archive("arm", spec.arm);
  archive("robot", spec.robot);
  archive("policy", spec.policy);
  archive("reward", spec.reward);
}

template <class Archive, Is<Budget> T>
void fields(Archive& archive, T& spec) {
  archive("unit", spec.unit);
  archive("amount", spec.amount);
}

// What a unit is besides its id, driver and worlds.
template <class Archive, Is<Training> T>
void rest_of(Archive& archive, T& unit) {
  archive("point", unit.point);
  archive("streams", unit.streams);
  archive("budget", unit.budget);
  archive("greedy_every", unit.greedy_every);
  archive("snapshots", unit.snapshots);
  archive("until", unit.until);
  archive("keep", unit.keep);
  archive("selection_episodes", unit.selection_episodes);
  archive("selection_streams", unit.selection_streams);
  archive("initial_state", unit.initial_state);
  archive("initial_training", unit.initial_training);
  archive("traced_episodes", unit.traced_episodes);
}

template <class Archive, Is<Cell> T>
void rest_of(Archive& archive, T& unit) {
  archive("point", unit.point);
  archive("stream", unit.stream);
  archive("variant", unit.variant);
  archive("episodes", unit.episodes);
  archive("training", unit.training);
  archive("at", unit.at);
  archive("state", unit.state);
  archive("traced_episodes", unit.traced_episodes);
  archive("privileged", unit.privileged);
}

template <class Archive, Is<Training> T>
void fields(Archive& archive, T& unit) {
  archive("id", unit.id);
  archive("driver", unit.driver);
  archive("worlds", unit.worlds);
  archive("selection_worlds", unit.selection_worlds);
  rest_of(archive, unit);
}

template <class Archive, Is<Cell> T>
void fields(Archive& archive, T& unit) {
  archive("id", unit.id);
  archive("driver", unit.driver);
  archive("world", unit.world);
  rest_of(archive, unit);
}

template <class Archive, Is<RobotEpisode> T>
void fields(Archive& archive, T& result) {
  archive("robot", result.robot);
  archive("flags", result.flags);
  archive("steps", result.steps);
  archive("reward", result.reward);
  archive("metrics", result.metrics);
}

template <class Archive, Is<Episode> T>
void fields(Archive& archive, T& result) {
  archive("index", result.index);
  archive("hash", result.hash);
  archive("robots", result.robots);
}

template <class Archive, Is<Curve> T>
void fields(Archive& archive, T& result) {
  archive("metric", result.metric);
  archive("x", result.x);
  archive("robot", result.robot);
  archive("points", result.points);
}

template <class Archive, Is<CellResult> T>
void fields(Archive& archive, T& result) {
  archive("metrics", result.metrics);
  archive("episodes", result.episodes);
  archive("traces", result.traces);
  archive("curves", result.curves);
  archive("decision_us", result.decision_us);
}

template <class Archive, Is<TrainingResult> T>
void fields(Archive& archive, T& result) {
  archive("hash", result.hash);
  archive("snapshots", result.snapshots);
  archive("final_state", result.final_state);
  archive("traces", result.traces);
  archive("samples", result.samples);
  archive("steps", result.steps);
  archive("episodes", result.episodes);
  archive("curves", result.curves);
  archive("train_s", result.train_s);
}

namespace {

template <class T>
Json write(const T& value, bool canonical) {
  UnitWriter writer(canonical);
  fields(writer, value);
  return std::move(writer.json);
}

template <class T>
void read(const Json& json, T& value) {
  T result;  // `value` stays as it was if the JSON is wrong
  UnitReader reader(json, "");
  fields(reader, result);
  value = std::move(result);
}

Json digests_of(const std::vector<WorldSpec>& worlds) {
  Json result = Json::array();
  for (const WorldSpec& world : worlds) result.push_back(digest(world));
  return result;
}

template <class T>
std::string identified(const T& unit, const Json& digests) {
  UnitWriter writer(true);
  rest_of(writer, unit);
  writer.json.update(digests);
  return sha256(writer.json.dump());
}

}  // namespace

void to_json(Json& json, const ComponentSpec& spec) {
  json = write(spec, false);
}
void from_json(const Json& json, ComponentSpec& spec) {
  read(json, spec);
}
void to_json(Json& json, const Training& unit) {
  json = write(unit, false);
}
void from_json(const Json& json, Training& unit) {
  read(json, unit);
}
void to_json(Json& json, const Cell& unit) {
  json = write(unit, false);
}
void from_json(const Json& json, Cell& unit) {
  read(json, unit);
}
void to_json(Json& json, const CellResult& result) {
  json = write(result, false);
}
void from_json(const Json& json, CellResult& result) {
  read(json, result);
}
void to_json(Json& json, const TrainingResult& result) {
  json = write(result, false);
}
void from_json(const Json& json, TrainingResult& result) {
  read(json, result);
}

std::string digest(const DriverSpec& driver) {
  return sha256(write(driver, true).dump());
}
std::string digest(const WorldSpec& world) {
  return sha256(write(world, true).dump());
}

Json digests(const Training& unit) {
  return {{"unit", "training"},
          {"driver", digest(unit.driver)},
          {"worlds", digests_of(unit.worlds)},
          {"selection_worlds", digests_of(unit.selection_worlds)}};
}
Json digests(const Cell& unit) {
  return {{"unit", "cell"}, {"driver", digest(unit.driver)}, {"world", digest(unit.world)}};
}

std::string identify(const Training& unit, const Json& digests) {
  return identified(unit, digests);
}
std::string identify(const Cell& unit, const Json& digests) {
  return identified(unit, digests);
}
std::string identify(const Training& unit) {
  return identified(unit, digests(unit));
}
std::string identify(const Cell& unit) {
  return identified(unit, digests(unit));
}

}  // namespace wend::core
