#include "track.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ga {

Track::Track(std::vector<Point> path) : path_(std::move(path)) {
  double way = 0;
  for (std::size_t k = 0; k < path_.size(); ++k) {
    if (k > 0) {
      const double dx = path_[k].x - path_[k - 1].x, dy = path_[k].y - path_[k - 1].y;
      way += std::sqrt(dx * dx + dy * dy);
    }
    ways_.push_back(way);
  }
}

Foot Track::foot(Point point, double from, double to) const noexcept {
  Foot nearest{0, std::numeric_limits<double>::infinity()};
  from = std::clamp(from, 0.0, length()), to = std::clamp(to, from, length());
  for (std::size_t k = 0; k + 1 < path_.size(); ++k) {
    if (ways_[k + 1] < from || ways_[k] > to) continue;
    const Point a = path_[k], b = path_[k + 1];
    const double length = ways_[k + 1] - ways_[k];
    double along = 0, ux = 0, uy = 0;
    if (length > 0) {
      ux = (b.x - a.x) / length, uy = (b.y - a.y) / length;
      along = (point.x - a.x) * ux + (point.y - a.y) * uy;
      along = std::clamp(along, std::max(0.0, from - ways_[k]), std::min(length, to - ways_[k]));
    }
    const double dx = a.x + along * ux - point.x, dy = a.y + along * uy - point.y;
    const double distance = std::sqrt(dx * dx + dy * dy);
    if (distance < nearest.distance) nearest = {ways_[k] + along, distance};
  }
  return nearest;
}

Point Track::at(double way) const noexcept {
  std::size_t k = 1;
  while (k + 1 < path_.size() && ways_[k] < way) ++k;
  const double length = ways_[k] - ways_[k - 1];
  const double share = length > 0 ? std::clamp((way - ways_[k - 1]) / length, 0.0, 1.0) : 1;
  const Point a = path_[k - 1], b = path_[k];
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

}  // namespace ga
