// When the robot avoids instead of seeking the subgoal.  A: the paper's, whenever a sonar reads at most D.  B: only
// where something within D is in the way.
#pragma once
#include <algorithm>
#include <cmath>
#include <wend/math.hpp>

#include "percept.hpp"
#include "subgoal.hpp"

namespace rolling_window {

enum class Switch { a, b, never };

struct Switching {
  Switch rule = Switch::b;
  double distance = 8;  // D, m from the rim
  double cone = 15 * wend::math::degree + 1e-9;

  bool avoids(const Percept& percept, Point subgoal) const {
    switch (rule) {
      case Switch::never:
        return false;
      case Switch::a:
        return nearest(percept, wend::math::pi) <= distance;
      case Switch::b:
        break;
    }
    return nearest(percept, cone) <= distance / 2 || blocked(percept, subgoal);
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
  // An obstacle within D overlaps the corridor, as wide as the robot, straight to the subgoal.
  bool blocked(const Percept& percept, Point to) const {
    const double dx = to.x - percept.motion.x, dy = to.y - percept.motion.y, length = std::sqrt(dx * dx + dy * dy);
    if (length <= 0) return false;
    for (const Point& p : percept.surface) {
      if (!near(percept, p)) continue;
      const double x = p.x - percept.motion.x, y = p.y - percept.motion.y;
      const double along = (x * dx + y * dy) / length, across = (x * dy - y * dx) / length;
      if (along > 0 && along <= length + percept.body && std::fabs(across) < percept.body) return true;
    }
    return false;
  }
};

}  // namespace rolling_window
