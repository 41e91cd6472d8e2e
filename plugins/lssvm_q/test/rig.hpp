// The component on a bench: two robots with a distance ahead and a goal.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <wend/testing.hpp>

using wend::testing::Bench;
using wend::testing::error_of;

inline constexpr std::uint32_t left = 0, right = 1, actions = 2;

struct Learner : Bench {
  wend::Columns columns, table;
  explicit Learner(std::uint32_t robots = 2) : Bench(*wend_plugin_1.components[0]) {
    columns.box("sonar.range.0", "m", 0, 4)
        .box("goal.distance", "m")
        .box("goal.bearing", "rad")
        .box("goal.radius", "m");
    table.discrete("action", actions);
    this->robots(robots).observation(columns).action(table);
    set("observe", {"sonar.range.*"}).set("distance_power", 1).set("goal", "goal").set("goal_reach", 10);
    set("bearing_weight", 0.5).set("distance_weight", 1).set("gamma", 0.9).set("sigma", 0.3).set("C", 100);
    set("advice_C", 10).set("actions", "nominal").set("action_distance", 2).set("window", 200).set("advice_window", 50);
    set("retrain_every", 20).set("sweeps", 1).set("final_sweeps", 5).set("theta", 0.01).set("collisions", "learn");
    set("forget", "redundant").set("caution", 0).set("advice", 1).set("temperature", {1.0, 9.0}).set("annealing", 0.5);
    set("switch/kind", "after_episodes").set("switch/episodes", 3);
  }

  static std::vector<double> see(double range, double distance, double bearing = 0) {
    return {range, distance, bearing, 0.3};
  }
  std::uint64_t learn(const std::vector<double>& from, double action, double reward, const std::vector<double>& to,
                      std::uint32_t flags = 0, std::uint32_t row = 0) {
    const wend_outcome outcome{reward, flags, 0};
    const wend_batch batch{sizeof batch, 1, &row, from.data(), &action, to.data(), &outcome};
    return learn(batch);
  }
  std::uint64_t learn(const wend_batch& batch) {
    std::uint64_t used = 0;
    if (Bench::table<wend_learner>(WEND_LEARNER)->learn(ref().self, &batch, &used) != WEND_OK)
      throw std::runtime_error(error());
    return used;
  }
  void finish() {
    if (Bench::table<wend_learner>(WEND_LEARNER)->finish(ref().self) != WEND_OK) throw std::runtime_error(error());
  }
  // Left is worth the free distance, right is worth 2; each step ends the episode.
  void teach(int n, std::uint64_t key) {
    begin(key, WEND_TRAIN_EXPLORE);
    wend::Random random(key);
    for (int i = 0; i < n; ++i) {
      const double range = random.uniform(0, 4), distance = random.uniform(1, 3);
      const auto action = static_cast<double>(random.below(2));
      learn(see(range, distance), action, action == left ? range : 2, see(range, distance - 0.5), WEND_TERMINATED);
    }
  }
  std::vector<double> values(double range, double distance) {
    const std::vector<double> row = see(range, distance);
    std::vector<double> out(2 * actions);
    if (Bench::table<wend_values>(WEND_VALUES)->values(ref().self, row.data(), 1, out.data(), out.data() + actions) !=
        WEND_OK)
      throw std::runtime_error(error());
    return out;
  }
  double told(std::size_t k) { return telemetry(WEND_PER_UPDATE)[k]; }
};

enum Told {
  samples,
  advice_samples,
  trainings,
  temperature,
  agreement,
  deep,
  switch_episode,
  switch_step,
  residual,
  condition,
  bellman_error
};
