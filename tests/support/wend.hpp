// The program under test and a small experiment to try it with.
#pragma once
#include <core/base/json.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "program.hpp"

namespace wend::test {

using core::Json;

// wend of the build tree with these arguments.
std::vector<std::string> wend_command(std::vector<std::string> arguments);
Outcome run_wend(std::vector<std::string> arguments, const Setting& setting = {});

// `wend run FILE --out DIR --no-pictures` with more arguments.
std::vector<std::string> run_command(const std::string& file, const std::string& directory,
                                     const std::vector<std::string>& more = {});

// Two arms without learning, one that trains LSPI in the rolling window; `variants` maps, two seeds.  Seconds at most.
Json small_experiment(int variants);

// An empty room and a slow continuous robot that needs more than 500 decisions; one arm with this policy.
Json long_way(const std::string& scene_file, const Json& policy);
std::string empty_room();  // its scene file's text

Json read_json(const std::string& path);
std::string fingerprint(const std::string& directory);  // of the summary in a run directory

// The hash of every episode that is recorded, by arm, in the order of world, variant and seed.
std::map<std::string, std::vector<std::string>> episode_hashes(const std::string& directory);

std::set<std::string> cell_ids(const std::string& directory);

// How many cells are committed in a run directory; 0 where there is none yet.
std::size_t committed_cells(const std::string& directory);

std::string plugin_path(const std::string& name);  // of a shipped one, in the build tree
std::string test_plugins();                        // the folder of those that tests bring along

}  // namespace wend::test
