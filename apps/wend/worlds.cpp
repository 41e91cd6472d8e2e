// wend worlds list|show|import: which worlds there are, what a scene looks like, other people's maps.
#include "command.hpp"

#include <core/base/files.hpp>
#include <core/plugin/schema.hpp>

#include <filesystem>
#include <iostream>

namespace wend::app {
namespace {

int list(const core::Catalog& catalog, bool json) {
  Json all = Json::array();
  for (const std::string& id : catalog.ids("wend.world/1")) {
    const core::ComponentEntry& entry = *catalog.find(id);
    all.push_back({{"id", id}, {"summary", entry.summary}, {"file", catalog.file_of(id)}});
    if (!json) std::cout << id << std::string(id.size() < 24 ? 24 - id.size() : 1, ' ') << entry.summary << "\n";
  }
  if (json) std::cout << all.dump(2) << "\n";
  else if (all.empty()) std::cout << "no worlds found; WEND_PLUGIN_PATH or --plugin-path says where to look\n";
  return 0;
}

// The world component of --world, or the only one that can write its scenes.
const core::ComponentEntry& world_of(const core::Catalog& catalog, const po::variables_map& values) {
  std::vector<std::string> able;
  for (const std::string& id : catalog.ids("wend.world/1"))
    if (catalog.find(id)->answers("wend.scene/1")) able.push_back(id);
  if (values.count("world")) {
    const std::string id = values["world"].as<std::string>();
    const core::ComponentEntry* entry = catalog.find(id);
    if (entry && entry->answers("wend.world/1")) return *entry;
    const std::string near = core::did_you_mean(id, catalog.ids("wend.world/1"));
    throw core::Error(Exit::plugin, "no plugin has a world \"" + id + "\"" + (near.empty() ? "" : ": did you mean \"" + near + "\"?"));
  }
  if (able.size() == 1) return *catalog.find(able.front());
  throw Usage("expected --world ID: " + std::to_string(able.size()) + " of the worlds found can write their scenes");
}

// The scene of a world with these parameters, in the world's own format, made in a worker.
std::string scene_of(const core::Catalog& catalog, const core::ComponentEntry& entry, Json params, std::uint64_t seed, std::uint32_t variant) {
  core::Diagnostics diagnostics;
  core::SchemaContext context;
  context.subject = core::title(entry);
  context.notes = {"all parameters: wend plugins show " + entry.id};
  core::check_schema(entry.parameters, params, "", context, diagnostics);
  Json robot = Json::object();
  if (!entry.robot.is_null()) {
    robot = {{"body", {{"radius", 0.0}}}, {"kinematics", {{"type", "unicycle"}, {"speed", {0.0, 1.0}}, {"turn_rate", 1.0}}}};
    core::SchemaContext robot_context;
    robot_context.subject = "robot of " + core::title(entry);
    core::check_schema(entry.robot, robot, "", robot_context, diagnostics);
  }
  if (diagnostics.any()) {
    std::cerr << diagnostics.text();
    throw Stopped{Exit::configuration};
  }
  core::Request request;
  request.kind = core::Request::Kind::scene;
  request.unit = {{"type", entry.id}, {"params", params}, {"robot", robot}, {"key", seed}, {"variant", variant}};
  request.plugins = {{entry.id, catalog.file_of(entry.id)}};
  return ask_worker(std::move(request)).at("scene").get<std::string>();
}

int show(const core::Catalog& catalog, const po::variables_map& values, const std::string& id) {
  const core::ComponentEntry* entry = catalog.find(id);
  if (entry == nullptr || !entry->answers("wend.world/1")) {
    const std::string near = core::did_you_mean(id, catalog.ids("wend.world/1"));
    throw core::Error(Exit::plugin, "no plugin has a world \"" + id + "\"" + (near.empty() ? "" : ": did you mean \"" + near + "\"?"));
  }
  Json params = Json::object();
  if (values.count("params")) {
    params = Json::parse(values["params"].as<std::string>(), nullptr, false);
    if (!params.is_object()) throw Usage("--params: expected a JSON object, found " + values["params"].as<std::string>());
  }
  std::cout << scene_of(catalog, *entry, params, values["seed"].as<std::uint64_t>(), values["variant"].as<std::uint32_t>());
  return 0;
}

int import(const core::Catalog& catalog, const po::variables_map& values, const std::string& file) {
  Json params = Json::object();
  if (values.count("params")) {
    params = Json::parse(values["params"].as<std::string>(), nullptr, false);
    if (!params.is_object()) throw Usage("--params: expected a JSON object, found " + values["params"].as<std::string>());
  }
  params["map"] = {std::filesystem::absolute(file).lexically_normal().string()};
  const std::string scene = scene_of(catalog, world_of(catalog, values), params, 0, 0);
  if (!values.count("out")) {
    std::cout << scene;
    return 0;
  }
  const std::string out = values["out"].as<std::string>();
  core::write_file(out, scene);
  if (values.count("json")) std::cout << Json{{"written", out}, {"bytes", scene.size()}}.dump() << "\n";
  else std::cout << "written: " << out << "\n";
  return 0;
}

}  // namespace

int worlds(const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()("world", po::value<std::string>()->value_name("ID"), "import: the world that reads the map")(
      "params", po::value<std::string>()->value_name("JSON"), "parameters of the world, such as '{\"cell\": 0.15}'")(
      "seed", po::value<std::uint64_t>()->default_value(0)->value_name("N"), "show: draws the scene")(
      "variant", po::value<std::uint32_t>()->default_value(0)->value_name("N"), "show: which of several files")("out", po::value<std::string>()->value_name("FILE"), "import: the scene file to write (default: stdout)");
  add_common(options);
  const auto values = parse(arguments, "worlds list | worlds show ID | worlds import MAP [--out SCENE]", "Lists worlds, prints a scene that one draws, or turns somebody else's map into a scene file.", options, {"what"});
  const auto what = values.count("what") ? values["what"].as<std::vector<std::string>>() : std::vector<std::string>{"list"};
  if (what.size() == 1 && what[0] == "list") return list(catalog_of(values), values.count("json") > 0);
  if (what.size() == 2 && what[0] == "show") return show(catalog_of(values), values, what[1]);
  if (what.size() == 2 && what[0] == "import") return import(catalog_of(values), values, what[1]);
  throw Usage("expected list, show ID or import MAP\nusage: wend worlds list | worlds show ID | worlds import MAP [--out SCENE]");
}

}  // namespace wend::app
