// Composition is configuration: what stands in a slot and what a robot sees are changed on the command line.
#include <gtest/gtest.h>

#include <set>

#include "support/wend.hpp"

using namespace wend::test;

namespace {

const char* composed = R"({"name": "composed", "seed": 5,
  "worlds": [{"id": "ordinary", "type": "wend.arena", "params": {"generate": {"kind": "random_obstacles"}, "time_limit": 400}, "variants": 2}],
  "robots": {"simrobot": {"body": {"radius": 3}, "kinematics": {"type": "differential", "wheel_radius": 1, "half_track": 3},
    "actions": [[0.5, 0.5], [0, 0.5], [0.5, 0]],
    "sensors": [{"id": "eyes", "type": "wend.range", "params": {"axes_deg": [75, 45, 15, -15, -45, -75], "cone_deg": 30, "reach": 20}},
                {"id": "goal", "type": "wend.goal"}, {"id": "pose", "type": "wend.pose"}]}},
  "arms": [{"id": "window", "robot": "simrobot", "reward": {"type": "wend.clearance", "params": {"observe": ["eyes.range.*"]}},
    "policy": {"type": "wend.rolling_window", "params": {"window": ["eyes.range.*"], "sonar": ["eyes.range.*"], "switch": "A"},
               "slots": {"avoid": {"type": "wend.lspi", "params": {"observe": ["eyes.range.*"], "degree": 2, "mirror": true}}}}}],
  "test": {"episodes": 2}})";

constexpr const char* avoid = "/arms/0/policy/slots/avoid";
constexpr const char* beams = "/robots/simrobot/sensors/0/params={\"beams\": 36, \"reach\": 20}";

}  // namespace

TEST(Composition, SlotsAndSensorsAreSwappedWithoutBuilding) {
  const TemporaryDirectory place;
  const std::string file = place.write("composed.json", composed), third_party = test_plugins() + "/example_c";
  const std::string random = std::string(avoid) + "={\"type\": \"wend.random\"}",
                    theirs = std::string(avoid) + "={\"type\": \"example.turn_to_goal_c\"}";
  std::set<std::string> behaviours;
  int runs = 0;
  const auto compose = [&](std::vector<std::string> more) {
    const std::string directory = place / ("run_" + std::to_string(++runs));
    const Outcome outcome = run(run_command(file, directory, more));
    ASSERT_EQ(outcome.exit, 0) << outcome.err;
    const Json summary = read_json(directory + "/summary.json");
    EXPECT_EQ(summary["cells"], Json({{"planned", 2}, {"done", 2}, {"failed", 0}}));
    EXPECT_GT(summary["results"][0]["metrics"]["avoid_share"]["mean"].get<double>(), 0)
        << "who stands in avoid never acted";
    const auto hashes = episode_hashes(directory);
    std::string all;
    for (const std::string& hash : hashes.at("window")) all += hash;
    behaviours.insert(all);
  };
  for (const bool six : {true, false}) {
    const std::vector<std::string> sensor = six ? std::vector<std::string>{} : std::vector<std::string>{"--set", beams};
    const auto with = [&](std::vector<std::string> more) {
      more.insert(more.end(), sensor.begin(), sensor.end());
      return more;
    };
    compose(with({"--set", "/arms/0/train={\"samples\": 200}"}));
    compose(with({"--set", random}));
    compose(with({"--set", theirs, "--plugin-path", third_party}));
  }
  EXPECT_EQ(behaviours.size(), 6u) << "each composition should drive in its own way";
}
