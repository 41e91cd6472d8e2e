// A path of straight legs, and where on it a point is.
#pragma once
#include <vector>

#include "clearance_grid.hpp"

namespace ga {

struct Foot {
  double way;       // m along the path to its nearest point
  double distance;  // m to that point
};

class Track {
 public:
  Track() = default;
  explicit Track(std::vector<Point> path);

  const std::vector<Point>& path() const noexcept { return path_; }
  double length() const noexcept { return ways_.empty() ? 0 : ways_.back(); }
  // The nearest point of the path between these two ways along it: a path may cross itself.
  Foot foot(Point point, double from, double to) const noexcept;
  Point at(double way) const noexcept;

 private:
  std::vector<Point> path_;
  std::vector<double> ways_;  // m to each vertex
};

}  // namespace ga
