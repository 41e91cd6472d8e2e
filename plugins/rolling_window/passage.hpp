// Where a body may pass and how dear a way is: inflation by the body's radius, and a cost for being near obstacles.
#pragma once
#include <algorithm>
#include <cmath>

#include "grid_memory.hpp"

namespace rolling_window {

struct Passage {
  double inflation = 3;  // m: least clearance of the centre
  double range = 3;      // m beyond the inflation within which a way is dearer
  double weight = 3;     // a way along the inflation costs 1 + weight times its length
  double margin = 0;     // m beyond the inflation, entered only where there is no other way
  // A robot that stands nearer to something than the inflation (noise, drift) may leave: around it the least
  // clearance is what it has now.
  Point start;
  double start_clearance = 1e300, escape_radius = 0;

  double least(double x, double y) const noexcept {
    if (start_clearance >= inflation) return inflation;
    const double dx = x - start.x, dy = y - start.y;
    return dx * dx + dy * dy <= escape_radius * escape_radius ? start_clearance : inflation;
  }
  // >= 1, or infinite where the body does not fit.  `slack` in m forgives the rounding of a place to its cell.
  double factor(double clearance, double x, double y, double slack = 0) const noexcept {
    if (clearance < least(x, y) - slack) return infinite;
    double factor = 1;
    const double room = clearance - inflation - margin;
    if (range > 0 && room < range) {
      const double near = std::min(1 - room / range, 1.0);
      factor += weight * near * near;
    }
    if (room < 0) factor += squeeze * std::min(1.0, -room / margin);
    return factor;
  }
  void start_at(const Point& p, double clearance, double body) noexcept {
    start = p;
    start_clearance = clearance * (1 - 1e-6) - 1e-9;
    escape_radius = 1.5 * body;
  }

  static constexpr double squeeze = 30;  // a way without any margin costs this much more
  static constexpr double infinite = 1e300;
};

}  // namespace rolling_window
