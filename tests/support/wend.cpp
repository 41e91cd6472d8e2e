#include "wend.hpp"

#include <core/base/error.hpp>
#include <core/record/store.hpp>
#include <filesystem>
#include <tuple>

namespace wend::test {

std::vector<std::string> wend_command(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), WEND_BINARY_DIR "/bin/wend");
  return arguments;
}

Outcome run_wend(std::vector<std::string> arguments, const Setting& setting) {
  return run(wend_command(std::move(arguments)), setting);
}

std::vector<std::string> run_command(const std::string& file, const std::string& directory,
                                     const std::vector<std::string>& more) {
  std::vector<std::string> all = {"run", file, "--out", directory, "--no-pictures"};
  all.insert(all.end(), more.begin(), more.end());
  return wend_command(all);
}

Json small_experiment(int variants) {
  Json experiment = Json::parse(R"({"name": "small", "seed": 7,
    "worlds": [{"id": "ordinary", "type": "wend.arena", "params": {"generate": {"kind": "random_obstacles"}, "time_limit": 400}}],
    "robots": {"simrobot": {"body": {"radius": 3}, "kinematics": {"type": "differential", "wheel_radius": 1, "half_track": 3},
      "actions": [[0.5, 0.5], [0, 0.5], [0.5, 0]],
      "sensors": [{"id": "sonar", "type": "wend.range", "params": {"axes_deg": [75, 45, 15, -15, -45, -75], "cone_deg": 30, "reach": 20, "noise": 0.02}},
                  {"id": "goal", "type": "wend.goal"}, {"id": "pose", "type": "wend.pose"}]}},
    "arms": [{"id": "field", "robot": "simrobot", "policy": "wend.potential_field"},
             {"id": "random", "robot": "simrobot", "policy": "wend.random"},
             {"id": "lspi", "robot": "simrobot", "reward": "wend.clearance",
              "policy": {"type": "wend.rolling_window", "params": {"window": ["sonar.range.*"]}, "slots": {"avoid": "wend.lspi"}},
              "train": {"samples": 300, "evaluate": {"at": [0, 150], "episodes": 1}}}],
    "test": {"episodes": 3}, "seeds": 2, "record": {"episodes": 0, "seeds": 0}})");
  experiment["worlds"][0]["variants"] = variants;
  return experiment;
}

Json long_way(const std::string& scene_file, const Json& policy) {
  return {{"name", "long way"},
          {"seed", 3},
          {"worlds",
           {{{"id", "room"},
             {"type", "wend.arena"},
             {"params", {{"scene", {scene_file}}, {"dt", 0.1}, {"time_limit", 100}}}}}},
          {"robots",
           {{"slow",
             {{"body", {{"radius", 0.3}}},
              {"kinematics", {{"type", "unicycle"}, {"speed", {0, 1}}, {"turn_rate", 2}}},
              {"sensors", {{{"id", "goal"}, {"type", "wend.goal"}}}}}}}},
          {"arms", {{{"id", "driver"}, {"robot", "slow"}, {"policy", policy}}}},
          {"test", {{"episodes", 1}}}};
}

std::string empty_room() {
  return R"({"wend_scene": 1, "name": "empty room", "bounds": {"width": 80, "height": 20},
 "starts": [{"x": 5, "y": 5, "heading_deg": 30}], "goals": [{"x": 74, "y": 13, "radius": 0.5}]})";
}

Json read_json(const std::string& path) {
  return Json::parse(read_text(path));
}

std::string fingerprint(const std::string& directory) {
  return read_json(directory + "/summary.json").at("fingerprint").get<std::string>();
}

std::map<std::string, std::vector<std::string>> episode_hashes(const std::string& directory) {
  const core::Store store(directory, true);
  std::map<std::tuple<std::string, std::string, std::uint64_t, std::uint64_t>, std::vector<std::string>> cells;
  for (const auto& [id, done] : store.done(core::UnitKind::cell)) {
    const Json cell = store.description(id).value();
    auto& hashes = cells[{cell.at("driver").at("arm"), cell.at("world").at("id"),
                          cell.value("variant", std::uint64_t{0}), cell.at("stream").value("seed", std::uint64_t{0})}];
    const core::CellResult result = store.cell(id).value();
    for (const core::Episode& episode : result.episodes) hashes.push_back(episode.hash);
  }
  std::map<std::string, std::vector<std::string>> by_arm;
  for (const auto& [key, hashes] : cells)
    by_arm[std::get<0>(key)].insert(by_arm[std::get<0>(key)].end(), hashes.begin(), hashes.end());
  return by_arm;
}

std::set<std::string> cell_ids(const std::string& directory) {
  std::set<std::string> ids;
  for (const auto& [id, done] : core::Store(directory, true).done(core::UnitKind::cell)) ids.insert(id);
  return ids;
}

std::size_t committed_cells(const std::string& directory) {
  if (!std::filesystem::exists(directory + "/results.sqlite")) return 0;
  try {
    return core::Store(directory, true).done(core::UnitKind::cell).size();
  } catch (const core::Error&) {
    return 0;  // it is being made
  }
}

std::string plugin_path(const std::string& name) {
  return WEND_BINARY_DIR "/lib/wend/plugins/" + name + ".so";
}
std::string test_plugins() {
  return WEND_BINARY_DIR "/tests/system/plugins";
}

}  // namespace wend::test
