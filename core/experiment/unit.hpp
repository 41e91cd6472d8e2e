// The units of work, fully resolved: what a worker needs to know and nothing else, so that the canonical JSON of a unit
// is also what its id is made of.  Experiment files become units (plan.hpp); workers run them; results are recorded
// (core/record/store.hpp).
#pragma once
#include <core/base/json.hpp>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wend::core {

// A component with all parameters, defaults filled in, and what stands in its slots.
struct ComponentSpec {
  std::string type;
  Json params = Json::object();
  std::map<std::string, ComponentSpec> slots;
  Json content = Json::object();  // path -> SHA-256 of every file that the parameters name
};

struct SensorSpec {
  std::string id;  // its columns are named "<id>.<column>"
  ComponentSpec component;
};

struct RobotSpec {
  std::string name;                  // empty where the arm names no robot
  Json definition = Json::object();  // body, kinematics, actions, stop_distance: checked by the world's "robot" schema
  Json content = Json::object();     // path -> SHA-256 of every file that the definition names
  std::vector<SensorSpec> sensors;
};

struct WorldSpec {
  std::string id, type;
  Json params = Json::object();
  std::uint32_t robots = 1;
  std::uint32_t variants = 1;     // draws, or files times draws
  std::uint32_t files = 0;        // how many files a "files" parameter named; 0: the world has none
  bool one_scene = false;         // one map, drawn from the root seed, for every variant, seed, training and test
  Json content = Json::object();  // path -> SHA-256 of every file that the parameters name
};

// Keys the streams of worlds, starts and noise (never by arm, experiment name or position): see streams.hpp.
struct StreamSpec {
  std::uint64_t root = 0;  // the experiment's "seed"
  std::uint64_t seed = 0;  // 0, 1, ... below "seeds"
  bool train = false;      // draws of "<world>:train" or of "<world>"
};

// What drives: the composition that an arm puts into a world.
struct DriverSpec {
  std::string arm;  // keys the learner's own streams
  RobotSpec robot;
  ComponentSpec policy;
  std::optional<ComponentSpec> reward;
};

struct Budget {
  std::string unit = "episodes";  // "samples", "steps" (decisions) or "episodes"
  std::uint64_t amount = 0;
};

// A learner's whole training: (arm, training worlds, sweep point, seed).
struct Training {
  std::string id;  // SHA-256 of the canonical JSON of all that follows
  Json point = Json::object();
  DriverSpec driver;
  std::vector<WorldSpec> worlds;    // visited in turn, episode by episode
  std::vector<StreamSpec> streams;  // one per world
  Budget budget;
  std::uint32_t greedy_every = 0;        // after every n-th episode one is WEND_TRAIN_GREEDY and not counted; 0: none
  std::vector<std::uint64_t> snapshots;  // counts of the budget's unit at which the state is kept, ascending
  std::string until;                     // name of the update telemetry that ends it at 1; empty: the budget alone does
  std::string keep = "last";             // or "best": the snapshot that does best in `selection`
  std::uint32_t selection_episodes = 0;  // of each selection world, for keep == "best"
  std::vector<WorldSpec> selection_worlds;
  std::vector<StreamSpec> selection_streams;
  std::string initial_state;     // SHA-256 of the state file it starts from, or empty
  std::string initial_training;  // id of the training whose final state it starts from, or empty
  std::uint32_t traced_episodes = 0;  // the first so many are recorded as traces
};

// A test: (arm, world variant, sweep point, seed), of a frozen state where the arm learns.
struct Cell {
  std::string id;  // SHA-256 of the canonical JSON of all that follows
  Json point = Json::object();
  DriverSpec driver;
  WorldSpec world;
  StreamSpec stream;
  std::uint32_t variant = 0;
  std::uint32_t episodes = 1;
  std::string training;               // id of the training it tests, or empty
  std::optional<Budget> at;           // the snapshot it tests; none: the training's final state
  std::string state;                  // SHA-256 of a state file of another experiment, or empty
  std::uint32_t traced_episodes = 0;  // the first so many are recorded as traces
  bool privileged = false;            // the arm reads the true map
};

// -------------------------------------------------------------------------------------------------------- results

struct Failure {
  std::string cause;    // "plugin", "crash", "timeout", "memory", "rule", "exit", ...
  std::string message;  // where, expected, found, what to do
};

struct RobotEpisode {  // what one robot brought home from one episode
  std::uint32_t robot = 0;
  std::uint32_t flags = 0;      // WEND_TERMINATED | ...
  std::uint64_t steps = 0;      // decisions
  double reward = 0;            // undiscounted sum
  std::vector<double> metrics;  // CellResult::metrics; NaN: does not apply
};

struct Episode {
  std::uint64_t index = 0;
  std::string hash;  // chains every observation, action and outcome
  std::vector<RobotEpisode> robots;
};

struct Curve {            // of one training or test; the summary aggregates over seeds
  std::string metric, x;  // x: "train_episodes", "samples", "updates" or a name that the plugin gave
  std::optional<std::uint32_t> robot;
  std::vector<std::pair<double, double>> points;
};

struct CellResult {
  std::vector<std::string> metrics;  // names with units: "path_length_m", "avoid.residual"
  std::vector<Episode> episodes;
  std::map<std::uint64_t, std::string> traces;  // episode -> file in the scratch directory
  std::vector<Curve> curves;                    // what plugins told as series
  double decision_us = 0;                       // CPU time of the policy per decision
};

struct TrainingResult {
  std::string hash;                                // chains every observation, action and outcome of the training
  std::map<std::uint64_t, std::string> snapshots;  // count -> file in the scratch directory
  std::string final_state;                         // file in the scratch directory
  std::map<std::uint64_t, std::string> traces;     // episode -> file in the scratch directory
  std::uint64_t samples = 0, steps = 0, episodes = 0;
  std::vector<Curve> curves;
  double train_s = 0;  // CPU time
};

// -------------------------------------------------------------------------------------------------------- as JSON

void to_json(Json&, const ComponentSpec&);
void from_json(const Json&, ComponentSpec&);
void to_json(Json&, const Training&);
void from_json(const Json&, Training&);
void to_json(Json&, const Cell&);
void from_json(const Json&, Cell&);
void to_json(Json&, const CellResult&);
void from_json(const Json&, CellResult&);
void to_json(Json&, const TrainingResult&);
void from_json(const Json&, TrainingResult&);

// SHA-256, in hexadecimal, of the canonical description: the unit's JSON without its id, in which files stand by their
// content instead of their path, and driver and worlds by their own digests.  So a unit's id is the same on every
// machine, and the digests of one driver and world serve thousands of units.
std::string digest(const DriverSpec&);
std::string digest(const WorldSpec&);
Json digests(const Training&);
Json digests(const Cell&);
std::string identify(const Training&);
std::string identify(const Training&, const Json& digests);
std::string identify(const Cell&);
std::string identify(const Cell&, const Json& digests);

}  // namespace wend::core
