// wend validate: the static checks, then create() of every distinct arm and world in a worker.
#include "command.hpp"

#include <core/base/files.hpp>
#include <core/run/pool.hpp>
#include <core/run/runner.hpp>

#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <map>

namespace wend::app {
int validate(const Arguments& arguments) {
  po::options_description options("options");
  add_experiment_options(options);
  add_common(options);
  const auto values = parse(arguments, "validate EXPERIMENT [OPTIONS]", "Checks an experiment file, then creates everything it names, once, in a worker process.", options, {"experiment"});
  if (!values.count("experiment") || values["experiment"].as<std::vector<std::string>>().size() != 1) throw Usage("expected one experiment file\nusage: wend validate EXPERIMENT");
  const core::Catalog catalog = catalog_of(values);
  const core::Experiment experiment = load(values["experiment"].as<std::vector<std::string>>().front(), catalog, values);

  const std::string scratch = std::filesystem::temp_directory_path() / ("wend-validate-" + std::to_string(::getpid()));
  core::make_directories(scratch);
  Json failures = Json::array();
  std::size_t checked = 0;
  bool plugin_failed = false;
  {
    core::PoolOptions pool_options;
    pool_options.worker = worker_path();
    pool_options.logs = scratch;
    pool_options.deadline = std::chrono::seconds(60);
    core::Pool pool(pool_options);
    std::map<std::string, core::Cell> by_id;
    for (const core::Cell& cell : experiment.plan.compositions()) {
      core::Request request;
      request.kind = core::Request::Kind::check;
      request.unit = cell;
      request.plugins = core::plugin_files(catalog, cell.driver, {cell.world});
      request.scratch = scratch;
      by_id[cell.id] = cell;
      pool.submit(cell.id, std::move(request));
    }
    while (pool.pending() > 0) {
      const auto completion = pool.next(std::chrono::seconds(1));
      if (!completion) continue;
      ++checked;
      if (completion->answer.ok) continue;
      const core::Cell& cell = by_id.at(completion->id);
      const core::Failure& failure = completion->answer.failure;
      plugin_failed |= failure.cause != "plugin";
      failures.push_back({{"arm", cell.driver.arm}, {"world", cell.world.id}, {"cause", failure.cause}, {"message", failure.message}});
    }
  }
  std::error_code ignored;
  std::filesystem::remove_all(scratch, ignored);

  if (values.count("json")) {
    std::cout << Json{{"ok", failures.empty()}, {"cells", experiment.cells().size()}, {"trainings", experiment.trainings().size()}, {"created", checked}, {"failures", failures}}.dump(2) << "\n";
  } else {
    for (const Json& failure : failures)
      std::cerr << "error: " << failure["arm"].get<std::string>() << " @ " << failure["world"].get<std::string>() << ": " << failure["message"].get<std::string>() << "\n";
    if (failures.empty()) std::cout << "valid: " << experiment.trainings().size() << " trainings, " << experiment.cells().size() << " cells, " << checked << " compositions created\n";
  }
  if (failures.empty()) return 0;
  return static_cast<int>(plugin_failed ? Exit::plugin : Exit::configuration);
}

}  // namespace wend::app
