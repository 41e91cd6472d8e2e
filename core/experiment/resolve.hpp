// An experiment file at one point of its sweep: checked, all defaults filled in, all names looked up.
#pragma once
#include <core/experiment/scope.hpp>
#include <core/experiment/unit.hpp>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wend::core {

struct WorldDraw {  // "ordinary" or "ordinary:train"
  std::size_t world = 0;
  bool train = false;
  bool operator==(const WorldDraw&) const = default;
};

struct TrainSpec {
  Budget budget;                  // amount 0: nothing is trained, the state is tested as it is
  std::vector<WorldDraw> worlds;  // empty: the training draws of the tested world
  std::uint32_t greedy_every = 0;
  std::vector<std::uint64_t> at;  // ascending
  std::optional<std::uint32_t> snapshot_episodes;
  std::vector<WorldDraw> selection;  // empty: where it is trained
  std::string until;  // name of a value of the learner's, or empty
  std::string keep = "last";
  std::string state;      // SHA-256 of a state file, or empty
  std::string state_arm;  // id of the arm whose training it starts from, or empty
};

struct ArmSpec {
  std::string id;
  ComponentSpec policy;
  std::optional<ComponentSpec> reward;
  std::vector<std::size_t> worlds;          // where it is tested, in the order of the file
  std::map<std::size_t, RobotSpec> robots;  // by world, for all worlds that it enters
  std::optional<TrainSpec> train;
  bool privileged = false;
};

struct Resolved {
  Json file;  // the experiment file with all defaults and absolute paths
  std::uint64_t seed = 0, seeds = 1;
  std::uint32_t episodes = 10, traced_episodes = 1, traced_training = 0;
  std::uint64_t traced_seeds = 1;
  std::vector<WorldSpec> worlds;
  std::vector<ArmSpec> arms;
  std::map<std::string, std::string> state_files;  // SHA-256 -> path
};

// Nothing, and why in the diagnostics of `scope`, where the file cannot be used.
std::optional<Resolved> resolve(const Scope& scope, Json file);

// One part of it: the training of an arm whose other members are resolved.  `file` is its "train".
std::optional<TrainSpec> resolve_train(const Scope& scope, Resolved& experiment, const ArmSpec& arm, Json& file,
                                       const std::string& pointer);

// Once all arms are there: can each that starts from another arm's training do so?
void check_state_arms(const Scope& scope, const Resolved& experiment);

}  // namespace wend::core
