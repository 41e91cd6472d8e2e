// Traces as an experiment would record them, drawn from formulas: maps of several kinds and robots that wander on them.
#pragma once
#include <wend/abi.h>

#include <cmath>
#include <core/figure/map_panel.hpp>
#include <core/record/trace.hpp>
#include <string>
#include <vector>
#include <wend/random.hpp>

namespace wend::test {

using core::Trace;
using core::TraceShape;

inline TraceShape disc(double x, double y, double radius) {
  TraceShape shape;
  shape.form = WEND_SHAPE_DISC;
  shape.kind = WEND_OBSTACLE;
  shape.xy = {x, y};
  shape.radius = radius;
  return shape;
}

inline TraceShape lines(std::uint32_t form, std::uint32_t kind, std::vector<double> xy) {
  TraceShape shape;
  shape.form = form;
  shape.kind = kind;
  shape.xy = std::move(xy);
  return shape;
}

inline TraceShape bounds(double width, double height) {
  return lines(WEND_SHAPE_SEGMENTS, WEND_WALL,
               {0, 0, width, 0, width, 0, width, height, width, height, 0, height, 0, height, 0, 0});
}

// One robot along way-points in steps of `step` m with a sideways sway; ends with `flags`.
inline Trace drive(const std::vector<core::Place>& waypoints, double step, double sway, std::uint32_t flags,
                   core::Place goal, double goal_radius, double body_radius) {
  Trace trace;
  trace.robots = 1;
  trace.body_radius = {body_radius};
  double driven = 0;
  const auto add = [&](double x, double y, double heading) {
    trace.pose.insert(trace.pose.end(), {x, y, heading});
    trace.goal.insert(trace.goal.end(), {goal.x, goal.y, goal_radius});
    trace.time.push_back(static_cast<double>(trace.time.size()) * 0.5);
  };
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i) {
    const core::Place a = waypoints[i], b = waypoints[i + 1];
    const double length = std::hypot(b.x - a.x, b.y - a.y), heading = std::atan2(b.y - a.y, b.x - a.x);
    const int n = std::max(1, static_cast<int>(std::lround(length / step)));
    for (int k = i == 0 ? 0 : 1; k <= n; ++k, driven += length / n) {
      const double s = static_cast<double>(k) / n,
                   side = sway * std::sin(driven / (8 * sway + 1e-9)) * std::sin(3.14159265 * s);
      add(a.x + s * (b.x - a.x) - side * std::sin(heading), a.y + s * (b.y - a.y) + side * std::cos(heading), heading);
    }
  }
  trace.flags.assign(trace.time.size() - 1, 0);
  if (!trace.flags.empty()) trace.flags.back() = flags;
  trace.reward.assign(trace.flags.size(), 0);
  return trace;
}

constexpr std::uint32_t arrived = WEND_TERMINATED | WEND_ARRIVED, collided = WEND_TERMINATED | WEND_COLLIDED,
                        timed_out = WEND_TRUNCATED;

}  // namespace wend::test
