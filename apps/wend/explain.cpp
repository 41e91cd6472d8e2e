// wend explain DIR: what a policy of a run has to say of itself, such as its rules, or why it decided as it did.
#include "command.hpp"

#include <core/record/store.hpp>
#include <core/run/explain.hpp>
#include <core/run/runner.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>

namespace wend::app {
namespace {

constexpr const char* usage = "explain DIR --arm ID [--world ID] [--seed K] [--episode E] [--decisions N] [--robot R]";

// Which seed was asked for; else the first with which the arm was trained, as a run of some seeds only has others than 0.
std::uint64_t seed_of(const core::Experiment& experiment, const po::variables_map& values, const std::string& directory) {
  if (values.count("seed")) return values["seed"].as<std::uint64_t>();
  const std::string arm = values["arm"].as<std::string>();
  std::optional<std::map<std::string, core::DoneUnit>> done;
  for (const core::Cell& cell : experiment.cells()) {
    if (cell.driver.arm != arm) continue;
    if (cell.training.empty()) return cell.stream.seed;
    if (!done) done = core::Store(directory, true).done(core::UnitKind::training);
    if (done->count(cell.training)) return cell.stream.seed;
  }
  return 0;
}

// The arm's cell of its final state, in the world that was asked for.
core::Cell chosen(const core::Experiment& experiment, const po::variables_map& values, std::uint64_t seed) {
  const std::string arm = values["arm"].as<std::string>();
  const std::string world = values.count("world") ? values["world"].as<std::string>() : "";
  std::optional<core::Cell> found;
  for (const core::Cell& cell : experiment.cells()) {
    if (cell.driver.arm != arm || cell.stream.seed != seed || (!world.empty() && cell.world.id != world)) continue;
    if (!found || (found->world.id == cell.world.id && found->variant == cell.variant && found->point == cell.point)) found = cell;
  }
  if (found) return *found;
  const auto known = [](const std::string& what, const std::string& id, const std::vector<std::string>& ids) {
    if (id.empty() || std::find(ids.begin(), ids.end(), id) != ids.end()) return std::string();
    const std::string near = core::did_you_mean(id, ids);
    return "the experiment has no " + what + " \"" + id + "\"" + (near.empty() ? "" : ": did you mean \"" + near + "\"?");
  };
  for (const std::string& unknown : {known("arm", arm, experiment.arm_ids), known("world", world, experiment.world_ids)})
    if (!unknown.empty()) throw Usage(unknown);
  throw Usage("arm \"" + arm + "\" has no test " + (world.empty() ? "" : "in world \"" + world + "\" ") + "with seed " + std::to_string(seed));
}

// The state file that the cell tests; empty: the arm learns nothing.
std::string state_of(const core::Experiment& experiment, const core::Cell& cell, const std::string& directory) {
  if (!cell.state.empty()) return experiment.state_files.at(cell.state);
  if (cell.training.empty()) return "";
  const core::Store store(directory, true);
  const auto training = store.training(cell.training);
  if (!training) throw core::Error(Exit::data, directory + " has no finished training for arm \"" + cell.driver.arm + "\" with seed " + std::to_string(cell.stream.seed) + "; run it first");
  const auto snapshot = cell.at ? training->snapshots.find(cell.at->amount) : training->snapshots.end();
  const std::string path = directory + "/states/" + (snapshot == training->snapshots.end() ? training->final_state : snapshot->second);
  if (!std::filesystem::is_regular_file(path)) throw core::Error(Exit::data, "expected the state file " + path + ", found none: run the experiment again in another directory");
  return path;
}

}  // namespace

int explain(const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()("arm", po::value<std::string>()->value_name("ID"), "whose policy")("world", po::value<std::string>()->value_name("ID"), "where; the first that it is tested in without it")(
      "seed", po::value<std::uint64_t>()->value_name("K"), "which of the experiment's seeds; the first that was trained without it")(
      "episode", po::value<std::uint64_t>()->default_value(0)->value_name("E"), "which test episode is driven")(
      "decisions", po::value<std::uint64_t>()->default_value(0)->value_name("N"), "how many decisions of it before the policy is asked")(
      "robot", po::value<std::uint32_t>()->default_value(0)->value_name("R"), "of several robots, which one");
  add_common(options);
  const auto values = parse(arguments, usage, "Loads what an arm has learned, drives a test episode for a while and prints what the policy, and whatever stands in its slots, says of itself.", options, {"directory"});
  if (!values.count("directory") || values["directory"].as<std::vector<std::string>>().size() != 1 || !values.count("arm"))
    throw Usage(std::string("expected one run directory and --arm\nusage: wend ") + usage);
  const std::string directory = values["directory"].as<std::vector<std::string>>().front();
  const core::Catalog catalog = catalog_of(values);
  const core::Experiment experiment = load(directory + "/experiment.resolved.json", catalog, values);
  core::Question question{chosen(experiment, values, seed_of(experiment, values, directory)), values["episode"].as<std::uint64_t>(), values["decisions"].as<std::uint64_t>(), values["robot"].as<std::uint32_t>()};
  if (question.robot >= question.cell.world.robots)
    throw Usage("--robot: expected less than the world's " + std::to_string(question.cell.world.robots) + ", found " + std::to_string(question.robot));
  core::Request request;
  request.kind = core::Request::Kind::explain;
  request.unit = question;
  request.plugins = core::plugin_files(catalog, question.cell.driver, {question.cell.world});
  request.state = request.state_name = state_of(experiment, question.cell, directory);
  const Json result = ask_worker(std::move(request));
  if (values.count("json")) {
    std::cout << result.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
    return 0;
  }
  for (const Json& component : result.at("components")) {
    const std::string text = component.at("text").get<std::string>();
    std::cout << "# " << component.at("path").get<std::string>() << " (" << component.at("type").get<std::string>() << ")\n" << text << (text.ends_with('\n') ? "" : "\n");
  }
  if (result.at("components").empty()) std::cout << "no component of arm \"" << question.cell.driver.arm << "\" has anything to say of itself\n";
  return 0;
}

}  // namespace wend::app
