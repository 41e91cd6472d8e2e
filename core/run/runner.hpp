// Runs an experiment into a directory: trainings, then the cells that test them, on a pool of workers; what is already
// there is not done again.
#pragma once
#include <core/experiment/experiment.hpp>
#include <core/plugin/catalog.hpp>
#include <core/run/pool.hpp>

#include <functional>
#include <string>
#include <vector>

namespace wend::core {

struct RunOptions {
  std::string directory;
  std::string command;        // as typed, for the record
  std::string worker;         // path of wend-worker; without isolation it is hashed all the same
  std::uint32_t jobs = 1;
  std::uint32_t batch = 16;
  bool isolated = true;
  bool retry_failed = false;
  bool allow_mixed_builds = false;
  bool fail_fast = false;
  std::uint64_t deadline_s = 3600;  // of one training or cell
};

struct RunFailure {
  std::string unit;     // "cell", "training"
  std::string what;     // arm @ world, variant, seed
  Failure failure;
};

struct Progress {
  std::uint64_t planned = 0, done = 0, failed = 0;   // cells
  std::uint64_t trainings = 0, trainings_done = 0;
  std::uint64_t resumed = 0;                         // cells that were there already
  std::uint64_t steps = 0;                           // decisions of this session
  double seconds = 0;                                // of this session
};

struct RunReport {
  Progress progress;
  std::vector<RunFailure> failures;
  std::vector<std::string> warnings;
  bool stopped = false;  // by a signal, or by fail_fast
};

struct RunListener {
  std::function<void(const Progress&)> progress;
  std::function<void(const RunFailure&)> failure;
  std::function<bool()> stopping;  // asked often; true: finish what runs, start nothing
};

// Throws Error where the directory cannot be used.
RunReport run_experiment(const Experiment& experiment, const Catalog& catalog, const RunOptions& options, const RunListener& listener);

// The files of the plugins that a component tree names.
std::map<std::string, std::string> plugin_files(const Catalog& catalog, const DriverSpec& driver, const std::vector<WorldSpec>& worlds);

}  // namespace wend::core
