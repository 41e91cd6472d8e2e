// A robot's spaces and the defaults of the manifest, for tests of the components.
#pragma once
#include <gtest/gtest.h>

#include <wend/math.hpp>
#include <wend/testing.hpp>

extern "C" const wend_plugin wend_plugin_1;

namespace hdp_test {

// sonar.range.0-4, sonar.kind.0-4, goal.bearing; front, left, right, front-left, front-right, 10 m.
struct Spaces {
  wend::Columns observation, action;
  Spaces() {
    constexpr double half = wend::math::half_pi;
    const double at[] = {0, half, -half, half / 2, -half / 2};
    for (int i = 0; i < 5; ++i) observation.box("sonar.range." + std::to_string(i), "m", 0, 10, at[i]);
    for (int i = 0; i < 5; ++i) observation.box("sonar.kind." + std::to_string(i), "1", 0, 16, at[i]);
    observation.box("goal.bearing", "rad", -wend::math::pi, wend::math::pi);
    action.discrete("turn", 3);
  }
};

inline std::vector<double> sees(std::vector<double> ranges, std::vector<double> kinds, double bearing) {
  ranges.insert(ranges.end(), kinds.begin(), kinds.end());
  ranges.push_back(bearing);
  return ranges;
}

class Bench : public Spaces, public wend::testing::Bench {
 public:
  explicit Bench(std::size_t component = 0) : wend::testing::Bench(*wend_plugin_1.components[component]) {
    observation(Spaces::observation).action(Spaces::action);
    set("range", {"sonar.range.*"}).set("kinds", {"sonar.kind.*"}).set("goal", "goal.bearing").set("tie", "obstacle");
  }
  using wend::testing::Bench::action;
  using wend::testing::Bench::observation;
};

// wend.hdp with the manifest's defaults.
class Policy : public Bench {
 public:
  explicit Policy(const char* preset = "robust") {
    set("preset", preset).set("actions", {0, 1, 2}).set("hidden", 6).set("gain", 1).set("alpha", 0.95);
    for (const char* off : {"rate_drop", "clip", "normalise", "timeout_noise", "similar_trials"}) set(off, 0);
    set("arrival_future", "keep").set("N_a", 100).set("N_c", 80);
    set("T_c", 0.05).set("rate_every", 5).set("rate_floor", 0.005).set("similar_steps", 5).set("criterion", 3);
  }

  // One decision in training: acts on `from`, comes to `to`.
  double decide(const std::vector<double>& from, const std::vector<double>& to, double reward,
                std::uint32_t flags = 0) {
    const std::vector<double> action = act(from);
    const std::uint32_t row = 0;
    const wend_outcome outcome{reward, flags, 0};
    const wend_batch batch{sizeof batch, 1, &row, from.data(), action.data(), to.data(), &outcome};
    std::uint64_t used = 0;
    const auto* learner = table<wend_learner>(WEND_LEARNER);
    if (learner->learn(ref().self, &batch, &used) != WEND_OK) throw std::runtime_error(error());
    return action[0];
  }
  // A trial of `steps` decisions that ends so.
  void trial(std::uint32_t flags, int steps = 3) {
    begin(++trial_, WEND_TRAIN_EXPLORE);
    for (int i = 1; i <= steps; ++i) decide(free_, free_, -0.3, i == steps ? flags : 0);
  }
  double told(const std::string& name) {
    const wend_space* space = table<wend_telemetry>(WEND_TELEMETRY)->space(ref().self, WEND_PER_UPDATE);
    for (std::uint32_t i = 0; i < space->width; ++i)
      if (name == space->columns[i].name) return telemetry(WEND_PER_UPDATE)[i];
    return -1;
  }

 private:
  std::vector<double> free_ = sees({10, 10, 10, 10, 10}, {0, 0, 0, 0, 0}, 0.5);
  std::uint64_t trial_ = 0;
};

inline constexpr std::uint32_t arrived = WEND_TERMINATED | WEND_ARRIVED, crashed = WEND_TERMINATED | WEND_COLLIDED;

}  // namespace hdp_test
