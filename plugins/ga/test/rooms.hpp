// Clearance grids of rooms whose distances are known in closed form.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "clearance_grid.hpp"

namespace ga::testing {

// Signed distance to a rectangle, m.
inline double to_rectangle(double x, double y, const Area& r) {
  const double dx = std::max(r.x0 - x, x - r.x1), dy = std::max(r.y0 - y, y - r.y1);
  if (dx <= 0 && dy <= 0) return std::max(dx, dy);
  return std::hypot(std::max(dx, 0.0), std::max(dy, 0.0));
}

// A square room of `side` m with walls around, and rectangles in it.
inline double clearance_in(double side, const std::vector<Area>& rectangles, double x, double y) {
  double least = std::min({x, y, side - x, side - y});
  for (const Area& r : rectangles) least = std::min(least, to_rectangle(x, y, r));
  return least;
}

inline ClearanceGrid room(double side, const std::vector<Area>& rectangles, double cell = 0.05) {
  ClearanceGrid grid({0, 0, side, side}, cell);
  std::vector<double> values;
  for (std::size_t k = 0; k < grid.columns() * grid.rows(); ++k) {
    const Point at = grid.lattice_point(k);
    values.push_back(clearance_in(side, rectangles, at.x, at.y));
  }
  grid.set(0, values);
  return grid;
}

}  // namespace ga::testing
