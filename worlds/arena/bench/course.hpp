// The course of the arena's benchmarks: robots with six beams of 8 m among discs in 100 x 100 m, through the C table.
#pragma once
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>
#include <wend/plugin.hpp>
#include <wend/testing_time.hpp>

#include "../scenes/scene_file.hpp"

namespace bench {

using wend::testing::thread_seconds;

inline constexpr std::uint32_t copies = 64, beams = 6;
inline constexpr double reach = 8;                                                     // m
inline constexpr double axes[beams] = {1.3, 0.8, 0.25, -0.25, -0.8, -1.3};             // rad
inline constexpr double radius = 0.3, half_track = 0.2, wheel_radius = 0.1, dt = 0.1;  // of the robot, m and s

// Discs of 0.3 to 1.2 m; a quarter of that where they are many.  The goal is too small to be met.
inline arena::Scene scene_of(int n) {
  arena::Scene scene;
  wend::Random random(static_cast<std::uint64_t>(n));
  for (int k = 0; k < n; ++k) {
    const arena::Disc disc{random.uniform(0, 100), random.uniform(0, 100), random.uniform(0.3, 1.2)};
    if (disc.x > 3 || disc.y > 3) scene.discs.push_back({disc.x, disc.y, n < 2000 ? disc.radius : 0.25 * disc.radius});
  }
  scene.goals = {{1, 1, 0.001, {}, 0}};
  scene.name = "bench";
  return scene;
}

struct Arena {
  const wend_component* type = wend_plugin_1.components[0];
  wend_host host{};
  wend_object* self = nullptr;
  const wend_world* world = nullptr;
  const wend_geometry2d* geometry = nullptr;

  explicit Arena(int obstacles) {
    host.size = sizeof host;
    host.fail = [](const wend_host*, wend_status code, const char* param, const char* message) {
      std::fprintf(stderr, "%s: %s\n", param ? param : "", message);
      return code;
    };
    const std::string path = "/tmp/bench_arena_" + std::to_string(::getpid()) + ".json";
    std::ofstream(path) << arena::format_scene(scene_of(obstacles));
    const std::map<std::string, wend_value> values{
        {"cell", {"cell", nullptr, 1}},         {"dt", {"dt", nullptr, dt}},
        {"optimal", {"optimal", nullptr, 0}},   {"scene/0", {"scene/0", path.c_str(), 0}},
        {"substeps", {"substeps", nullptr, 1}}, {"time_limit", {"time_limit", nullptr, 1e6}},
        {"walled", {"walled", nullptr, 1}}};
    const wend_value robot[] = {{"body/radius", nullptr, radius},
                                {"kinematics/half_track", nullptr, half_track},
                                {"kinematics/type", "differential", 0},
                                {"kinematics/wheel_radius", nullptr, wheel_radius},
                                {"kinematics/wheel_speed", nullptr, 20}};
    std::vector<wend_value> table;
    for (const auto& [key, value] : values) table.push_back(value);
    wend_config config{};
    config.size = sizeof config, config.copies = copies, config.robots = 1;
    config.values = table.data(), config.value_count = static_cast<std::uint32_t>(table.size());
    config.robot_values = robot, config.robot_value_count = 5;
    if (type->create(&host, &config, &self) != WEND_OK) std::exit(1);
    ::unlink(path.c_str());
    world = static_cast<const wend_world*>(type->query(self, WEND_WORLD));
    geometry = static_cast<const wend_geometry2d*>(type->query(self, WEND_GEOMETRY2D));
  }
  ~Arena() { type->destroy(self); }
  void reset(std::uint32_t copy, std::uint64_t index) {
    const wend_episode episode{index, wend::stream(copy, index), 1, 0, WEND_TEST};
    if (world->reset(self, &copy, 1, &episode) != WEND_OK) std::exit(1);
  }
};

// Wheel speeds, rad/s: straight on, or away from what is near, to a side that is kept until it is clear again, so that
// nobody dithers on the spot.
inline std::pair<double, double> steer(const double* ranges, double& side) {
  const double left = std::min(ranges[1], ranges[2]), right = std::min(ranges[3], ranges[4]);
  const double near = std::min(left, right);
  if (near >= 3) side = left > right ? 6 : -6;
  const double turn = near < 3 ? side : 0, go = near < 1 ? 0 : 10;
  return {go - turn, go + turn};
}

// Keys and figures, as text or as one JSON object.
inline void print(const std::vector<std::pair<std::string, double>>& figures, bool json) {
  for (std::size_t i = 0; i < figures.size(); ++i)
    std::printf(json ? "%s\"%s\": %.6g" : "%s%-30s %.6g\n",
                !json    ? ""
                : i == 0 ? "{"
                         : ", ",
                figures[i].first.c_str(), figures[i].second);
  if (json) std::puts("}");
}

// A batch of 64 copies for a while: sense six beams, turn away from what is near, step.
struct Loop {
  Arena& arena;
  std::vector<std::uint32_t> all, rows;
  std::vector<wend_pose> poses = std::vector<wend_pose>(copies), rays = std::vector<wend_pose>(copies * beams);
  std::vector<double> sides = std::vector<double>(copies, 6);
  std::vector<double> ranges = std::vector<double>(copies * beams), actions = std::vector<double>(copies * 2);
  std::vector<std::uint8_t> kinds = std::vector<std::uint8_t>(copies * beams);
  std::vector<wend_outcome> outcomes = std::vector<wend_outcome>(copies);
  std::uint64_t episodes = 0;
  double restarting = 0;  // s, left out of what is told
  bool driving = true, sensing = true;

  explicit Loop(Arena& a) : arena(a) {
    for (std::uint32_t c = 0; c < copies; ++c) {
      all.push_back(c);
      for (std::uint32_t b = 0; b < beams; ++b) rows.push_back(c);
      arena.reset(c, episodes++);
    }
    sense();
    for (std::uint32_t c = 0; c < copies; ++c) arena.reset(c, episodes++);  // now the reach is known
  }
  void sense() {
    arena.geometry->poses(arena.self, all.data(), copies, poses.data());
    for (std::uint32_t c = 0; c < copies; ++c)
      for (std::uint32_t b = 0; b < beams; ++b)
        rays[c * beams + b] = {poses[c].x, poses[c].y, poses[c].heading + axes[b]};
    arena.geometry->cast(arena.self, rows.data(), rays.data(), copies * beams, reach,
                         WEND_WALL | WEND_OBSTACLE | WEND_MOVER | WEND_ROBOT, ranges.data(), kinds.data());
  }
  void move() {
    for (std::uint32_t c = 0; c < copies; ++c) {
      const auto [left, right] = steer(&ranges[c * beams], sides[c]);
      actions[2 * c] = left, actions[2 * c + 1] = right;
    }
    arena.world->step(arena.self, all.data(), copies, actions.data(), outcomes.data());
  }
  void restart_ended() {
    for (std::uint32_t c = 0; c < copies; ++c)
      if (outcomes[c].flags != 0) restart(c);
  }
  void restart(std::uint32_t copy) {
    const double begin = thread_seconds();
    arena.reset(copy, episodes++);
    outcomes[copy].flags = 0;
    restarting += thread_seconds() - begin;
  }
  double measure(double seconds) {
    const double begin = thread_seconds();
    restarting = 0;
    std::uint64_t steps = 0;
    do {
      for (int k = 0; k < 50; ++k) {
        if (sensing) sense();
        if (driving) {
          move();
          restart_ended();
        }
      }
      steps += 50 * copies;
    } while (thread_seconds() - begin < seconds);
    asm volatile("" : : "r"(ranges.data()) : "memory");  // or the compiler would drop what nobody reads
    return (thread_seconds() - begin - restarting) / static_cast<double>(steps);
  }
};

}  // namespace bench
