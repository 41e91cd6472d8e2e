// The robot's own motions, each an action held for a few steps, as wend.body/1 predicts them: what the turn-radius
// planner strings together.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>
#include <wend/math.hpp>
#include <wend/refs.hpp>
#include <wend/steer.hpp>

namespace rolling_window {

struct Motion {
  std::array<double, 2> action{};  // an action row
  double seconds = 0;
  std::vector<wend_motion> states;  // after each step, from the origin with heading 0
};

struct Motions {
  std::vector<Motion> all;
  double top_speed = 0;  // m/s, of the fastest motion

  Motions() = default;

  // Each motion is held until it turns by about one of `headings`, or leaves a cell of `cell` m.
  Motions(const wend::Steer& steer, wend::BodyRef body, double cell, std::size_t headings, double speed) {
    for (const std::array<double, 2>& action : actions(steer, speed)) add(steer, body, action);
    if (all.empty())
      throw wend::unsupported("planner turn_radius: expected an action that moves the robot, found none");
    int turning = 1;
    const double heading = wend::math::two_pi / static_cast<double>(headings);
    for (const Motion& motion : all)
      if (const double turn = std::fabs(motion.states[0].heading); turn > 1e-9)
        turning = std::max(turning, static_cast<int>(std::floor(std::min(heading / turn, most_steps) + 0.5)));
    for (Motion& motion : all) {
      const double turn = std::fabs(motion.states[0].heading),
                   length = wend::math::hypot(motion.states[0].x, motion.states[0].y);
      const int own = turn > 1e-9
                          ? std::max(1, static_cast<int>(std::floor(std::min(heading / turn, most_steps) + 0.5)))
                          : std::max(turning, static_cast<int>(std::ceil(std::min(1.415 * cell / length, most_steps))));
      hold(steer, body, motion, own);
    }
  }

 private:
  static constexpr double most_steps = 50;

  // All of a table; of continuous actions straight on, two curves to either side, and turns in place where it can.
  static std::vector<std::array<double, 2>> actions(const wend::Steer& steer, double speed) {
    std::vector<std::array<double, 2>> rows;
    if (steer.discrete()) {
      for (std::size_t k = 0; k < steer.table().size(); ++k) rows.push_back({static_cast<double>(k), 0});
      return rows;
    }
    const wend_limits& limits = steer.limits();
    const double v = std::min(speed, steer.top_speed());
    const double most =
        std::min(limits.turn_rate, limits.turn_radius > 0 ? v / limits.turn_radius : wend::math::pi / 2);
    const auto row = [&](double drive, double turn) { steer.drive(drive, turn, rows.emplace_back()); };
    row(v, 0), row(v, 0.5 * most), row(v, -0.5 * most), row(v, most), row(v, -most);
    if (limits.turn_radius <= 0) row(0, most), row(0, -most);
    return rows;
  }
  // Steady motion: as from rest, had there been no limit of acceleration.
  static wend_motion after(const wend::Steer& steer, wend::BodyRef body, const std::array<double, 2>& action,
                           double periods) {
    wend_motion from{}, to{};
    body.predict(0, std::span(&from, 1), action.data(), 1000 * steer.period(), std::span(&to, 1));
    from.speed = to.speed, from.turn_rate = to.turn_rate;
    body.predict(0, std::span(&from, 1), action.data(), periods * steer.period(), std::span(&to, 1));
    return to;
  }
  void add(const wend::Steer& steer, wend::BodyRef body, const std::array<double, 2>& action) {
    const wend_motion one = after(steer, body, action, 1);
    const double length = wend::math::hypot(one.x, one.y);
    if (length < 1e-9 && std::fabs(one.heading) < 1e-9) return;  // an action that stays where it is
    all.push_back({action, 0, {one}});
    top_speed = std::max(top_speed, length / steer.period());
  }
  static void hold(const wend::Steer& steer, wend::BodyRef body, Motion& motion, int steps) {
    motion.states.clear();
    for (int k = 1; k <= steps; ++k) motion.states.push_back(after(steer, body, motion.action, k));
    motion.seconds = steps * steer.period();
  }
};

}  // namespace rolling_window
