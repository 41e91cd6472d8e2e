// Continuous actions: pure pursuit (Coulter 1992) of a point on the path.
#pragma once
#include <algorithm>
#include <cmath>
#include <wend/math.hpp>

#include "percept.hpp"
#include "safety_filter.hpp"

namespace rolling_window {

struct Pursuit {
  double look_ahead = 0.8;                         // m
  double turn_in_place = 60 * wend::math::degree;  // from this bearing on, where the body can

  // Speed and turn rate of the arc through the target; `top_speed` m/s.
  Drive towards(const Percept& percept, Point target, const wend_limits& limits, double top_speed,
                double period) const {
    const double dx = target.x - percept.motion.x, dy = target.y - percept.motion.y;
    const double distance = std::max(1e-6, wend::math::hypot(dx, dy));
    const double bearing = wend::math::wrap_angle(wend::math::atan2(dy, dx) - percept.motion.heading);
    const double fastest = std::min(limits.turn_rate, std::fabs(bearing) / period);
    if (std::fabs(bearing) > turn_in_place && limits.turn_radius <= 0) return {0, std::copysign(fastest, bearing)};
    const double bend = std::clamp(bearing, -wend::math::half_pi, wend::math::half_pi);
    const double curvature = 2 * wend::math::sin(bend) / distance;
    double speed = top_speed;
    if (std::fabs(curvature) * speed > limits.turn_rate) speed = limits.turn_rate / std::fabs(curvature);
    return {speed, speed * curvature};
  }
};

}  // namespace rolling_window
