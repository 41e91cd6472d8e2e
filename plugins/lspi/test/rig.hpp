// The learner on a bench: a robot with one distance to each side that should turn to the freer one.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <wend/testing.hpp>

using wend::testing::Bench;
using wend::testing::error_of;

inline constexpr std::uint32_t straight = 0, left = 1, right = 2;

struct Learner : Bench {
  wend::Columns beams, table;
  Learner() : Bench(*wend_plugin_1.components[0]) {
    beams.box("sonar.range.0", "m", 0, 4, 0.5).box("sonar.range.1", "m", 0, 4, -0.5).box("goal.bearing", "rad");
    table.discrete("action", 3);
    observation(beams).action(table).copies(2);
    set("observe", {"sonar.range.*"}).set("basis", "powers").set("degree", 2).set("gamma", 0.9).set("ridge", 1e-3);
    set("iterations", 20).set("mirror", 0).set("mirror_actions", {0, 2, 1}).set("handed_over", "bootstrap");
    set("most_samples", 1000).set("width", 1);
  }

  void learn(const std::vector<double>& from, double action, double reward, const std::vector<double>& to,
             std::uint32_t flags) {
    const std::uint32_t row = 0;
    const wend_outcome outcome{reward, flags, 0};
    const wend_batch batch{sizeof batch, 1, &row, from.data(), &action, to.data(), &outcome};
    std::uint64_t used = 0;
    if (table_of()->learn(ref().self, &batch, &used) != WEND_OK) throw std::runtime_error(error());
    EXPECT_EQ(used, 1u);
  }
  void finish() {
    if (table_of()->finish(ref().self) != WEND_OK) throw std::runtime_error(error());
  }
  const wend_learner* table_of() const { return Bench::table<wend_learner>(WEND_LEARNER); }

  // Turning to the freer side is worth how much freer it is; straight on is worth nothing.
  void teach(int n, std::uint64_t key, bool only_left = false) {
    wend::Random random(key);
    for (int i = 0; i < n; ++i) {
      const std::vector<double> state{random.uniform(0, 4), random.uniform(0, 4), 0.3};
      const double action = only_left ? left : static_cast<double>(random.below(3));
      const double gain = state[0] - state[1];
      learn(state, action, action == left ? gain : action == right ? -gain : 0, {1, 1, 0}, WEND_TERMINATED);
    }
  }
  // One decision of both rows.
  std::vector<double> decide(double l, double r) { return act({l, r, 0, l, r, 0}); }
  std::vector<double> values(double l, double r) {
    const std::vector<double> row{l, r, 0};
    std::vector<double> q(3), spread(3, 7);
    EXPECT_EQ(Bench::table<wend_values>(WEND_VALUES)->values(ref().self, row.data(), 1, q.data(), spread.data()),
              WEND_OK);
    EXPECT_EQ(spread, std::vector<double>(3, 0));
    return q;
  }
};
