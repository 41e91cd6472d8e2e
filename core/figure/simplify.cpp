#include <algorithm>
#include <cmath>
#include <core/figure/simplify.hpp>
#include <utility>

namespace wend::core {
namespace {

constexpr std::size_t stretch = 512;

double distance_to_segment(Place p, Place a, Place b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

void mark(const std::vector<Place>& line, std::size_t first, std::size_t last, double tolerance,
          std::vector<char>& keep) {
  std::vector<std::pair<std::size_t, std::size_t>> open = {{first, last}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    std::size_t farthest = from;
    double most = tolerance;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double d = distance_to_segment(line[i], line[from], line[to]);
      if (d > most) most = d, farthest = i;
    }
    if (farthest == from) continue;
    keep[farthest] = 1;
    open.push_back({from, farthest});
    open.push_back({farthest, to});
  }
}

}  // namespace

std::vector<Place> simplified(const std::vector<Place>& line, double tolerance) {
  std::vector<Place> finite;
  for (const Place p : line)
    if (std::isfinite(p.x) && std::isfinite(p.y)) finite.push_back(p);
  if (finite.size() < 3) return finite;
  std::vector<char> keep(finite.size(), 0);
  for (std::size_t first = 0; first + 1 < finite.size(); first += stretch) {
    const std::size_t last = std::min(first + stretch, finite.size() - 1);
    keep[first] = keep[last] = 1;
    mark(finite, first, last, tolerance, keep);
  }
  std::vector<Place> kept;
  for (std::size_t i = 0; i < finite.size(); ++i)
    if (keep[i]) kept.push_back(finite[i]);
  return kept;
}

}  // namespace wend::core
