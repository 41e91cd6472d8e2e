// Room and reachability in a scene that is being drawn.
#include "placement.hpp"

#include <algorithm>
#include <cmath>
#include <wend/error.hpp>

#include "free_space.hpp"

namespace arena {
namespace {

double to_segment(const Point& p, const Point& a, const Point& b) noexcept {
  const double dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
  const double t = length > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length, 0.0, 1.0) : 0.0;
  const double ex = p.x - (a.x + t * dx), ey = p.y - (a.y + t * dy);
  return std::sqrt(ex * ex + ey * ey);
}

double to_polygon(const Point& p, const std::vector<Point>& points) noexcept {
  double nearest = 1e300;
  bool inside = false;
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
    const Point &a = points[i], &b = points[j];
    nearest = std::min(nearest, to_segment(p, a, b));
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside ? -nearest : nearest;
}

// A disc that fits with half a cell to spare at both ends of a step fits all along it.
FreeSpace spacious(const Scene& scene, double body, double cell, const std::vector<Point>& also) {
  const double longest = std::max(scene.width, scene.height);
  if (cell <= 0) cell = body > 0 ? body / 4 : longest / 400;
  cell = std::max(cell, longest / 2000);
  return FreeSpace(scene, cell, body + cell / 2, also);
}

}  // namespace

double clearance(const Scene& scene, Point p) noexcept {
  double nearest = 1e300;
  if (scene.walled)
    nearest = std::min({p.x - scene.x, p.y - scene.y, scene.x + scene.width - p.x, scene.y + scene.height - p.y});
  for (const Disc& d : scene.discs) {
    const double dx = p.x - d.x, dy = p.y - d.y;
    nearest = std::min(nearest, std::sqrt(dx * dx + dy * dy) - d.radius);
  }
  for (const Segment& s : scene.segments) nearest = std::min(nearest, to_segment(p, {s.x0, s.y0}, {s.x1, s.y1}));
  for (const Polygon& polygon : scene.polygons) nearest = std::min(nearest, to_polygon(p, polygon.points));
  return nearest;
}

bool draw_place(const Scene& scene, wend::Random& random, double x0, double y0, double x1, double y1, double room,
                Point& out) {
  for (int i = 0; i < most_tries; ++i) {
    out.x = random.uniform(x0, x1);
    out.y = random.uniform(y0, y1);
    if (clearance(scene, out) >= room) return true;
  }
  return false;
}

bool joined(const Scene& scene, Point from, Point to, double body, double cell) {
  const FreeSpace space = spacious(scene, body, cell, {from, to});
  const std::ptrdiff_t goal = space.index(to);
  return goal >= 0 && space.reachable(space.index(from))[static_cast<std::size_t>(goal)] != 0;
}

bool all_joined(const Scene& scene, double body) {
  const FreeSpace space = spacious(scene, body, 0, {});
  const std::uint8_t* const end = space.cells() + space.size();
  const std::uint8_t* const first = std::find(space.cells(), end, std::uint8_t{1});
  return first != end && std::equal(space.cells(), end, space.reachable(first - space.cells()).begin());
}

void refuse(const std::string& parameter, const std::string& message) {
  throw wend::parameter_error("generate/" + parameter, message);
}

Polygon rectangle(double x, double y, double width, double height) {
  return {{{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}};
}

}  // namespace arena
