// When the robot avoids instead of seeking the subgoal.  A: the paper's, whenever a sonar reads at most D.  B: only
// where something within D is in the way: of the arc that it would drive, where a steering is given, since a body that
// cannot turn in place leaves the straight corridor while it turns.
#pragma once
#include <algorithm>
#include <cmath>
#include <wend/math.hpp>
#include <wend/steer.hpp>

#include "percept.hpp"
#include "subgoal.hpp"

namespace rolling_window {

enum class Switch { a, b, never };

struct Switching {
  Switch rule = Switch::b;
  double distance = 8;  // D, m from the rim
  double cone = 15 * wend::math::degree + 1e-9;

  double margin = 0;  // m of room on either side of the corridor

  // `steer`: a table of actions that seeking chooses from; null: the corridor is straight.
  bool avoids(const Percept& percept, Point subgoal, const wend::Steer* steer = nullptr) const {
    switch (rule) {
      case Switch::never:
        return false;
      case Switch::a:
        return nearest(percept, wend::math::pi) <= distance;
      case Switch::b:
        break;
    }
    if (nearest(percept, cone) <= distance / 2) return true;
    const double half = percept.body + margin;
    return steer && steer->discrete() ? drives_into(percept, subgoal, half, *steer) : blocked(percept, subgoal, half);
  }

 private:
  static double nearest(const Percept& percept, double within) {
    double least = 1e300;
    for (const Beam& beam : percept.sonar)
      if (std::fabs(wend::math::wrap_angle(beam.bearing)) <= within) least = std::min(least, beam.range);
    return least;
  }
  bool near(const Percept& percept, const Point& p) const {
    const double dx = p.x - percept.motion.x, dy = p.y - percept.motion.y, most = distance + percept.body;
    return dx * dx + dy * dy <= most * most;
  }
  // An obstacle within D overlaps the corridor straight to the subgoal.
  bool blocked(const Percept& percept, Point to, double half) const {
    const double dx = to.x - percept.motion.x, dy = to.y - percept.motion.y, length = std::sqrt(dx * dx + dy * dy);
    if (length <= 0) return false;
    for (const Point& p : percept.surface) {
      if (!near(percept, p)) continue;
      const double x = p.x - percept.motion.x, y = p.y - percept.motion.y;
      const double along = (x * dx + y * dy) / length, across = (x * dy - y * dx) / length;
      if (along > 0 && along <= length + percept.body && std::fabs(across) < half) return true;
    }
    return false;
  }
  // Seeking the subgoal would bring the body nearer to an obstacle than the margin, and nearer than it is.
  bool drives_into(const Percept& percept, Point to, double half, const wend::Steer& steer) const {
    wend_motion at = percept.motion;
    double gone = 0;
    for (int step = 0; step < most_steps && gone < distance; ++step) {
      const double dx = to.x - at.x, dy = to.y - at.y;
      if (dx * dx + dy * dy <= 0.25 * percept.body * percept.body) return false;
      double action[2] = {0, 0}, sine, cosine;
      steer.towards(wend::math::atan2(dy, dx) - at.heading, wend::Steer::as_fast_as_possible, action);
      const wend_motion& move = steer.table()[static_cast<std::size_t>(action[0])];
      wend::math::sincos(at.heading, sine, cosine);
      at.x += move.x * cosine - move.y * sine, at.y += move.x * sine + move.y * cosine;
      at.heading = wend::math::wrap_angle(at.heading + move.heading);
      gone += std::sqrt(move.x * move.x + move.y * move.y);
      for (const Point& p : percept.surface)
        if (const double d = squared(p, at.x, at.y);
            d < half * half && d < squared(p, percept.motion.x, percept.motion.y) - 1e-9)
          return true;
    }
    return false;
  }
  static double squared(const Point& p, double x, double y) { return (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y); }

  static constexpr int most_steps = 200;
};

}  // namespace rolling_window
