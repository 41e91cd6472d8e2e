// From an experiment file to a plan: everything is checked before anything runs, and everything that is wrong is told
// at once.
#pragma once
#include <core/base/diagnostics.hpp>
#include <core/experiment/plan.hpp>
#include <core/plugin/catalog.hpp>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wend::core {

struct Options {
  std::vector<std::string> set;                  // "/pointer=value": JSON, or else text; applied in this order
  std::map<std::string, std::string> variables;  // for ${NAME} in the names of files
  std::vector<std::string> only;                 // "arm=a,world=b": values of one key are alternatives
  std::optional<std::pair<std::uint64_t, std::uint64_t>>
      seeds;  // these instead of 0 ... below "seeds"; the second excluded
};

struct Experiment {
  std::string name, file;
  Json resolved;  // the file with --set applied, all defaults and absolute paths; it gives the same plan again
  Json figures = Json::object();
  std::vector<std::string> world_ids, arm_ids;     // in the order of the file, for tables; not filtered
  std::vector<Json> points;                        // of the sweep, {pointer: value}; {} alone without one
  std::map<std::string, std::string> state_files;  // SHA-256 -> path: what Training::initial_state and Cell::state name
  Plan plan;

  Units<Training> trainings() const { return Units<Training>(plan); }
  Units<Cell> cells() const { return Units<Cell>(plan); }
};

// Nothing, and why in `diagnostics`, where the file cannot be used.  Throws Error(Exit::data) where it cannot be read.
std::optional<Experiment> load_experiment(const std::string& path, const Catalog& catalog, const Options& options,
                                          Diagnostics& diagnostics);

}  // namespace wend::core
