// Where a ray meets a shape, and how far a point is from one: the one expression for each, which the fast structures
// and the brute-force oracle of the tests share, so that both give the same bits.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "../scene.hpp"

namespace arena {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

struct Ray {
  double x, y, dx, dy;  // origin in m, unit direction
};

// A disc, its radius squared: a negative square is met by no ray.
[[gnu::always_inline]] inline double hit_disc(const Ray& ray, double x, double y, double radius2) noexcept {
  const double bx = x - ray.x, by = y - ray.y;
  if (bx * bx + by * by <= radius2) return 0;
  const double along = bx * ray.dx + by * ray.dy;
  const double aside = bx * ray.dy - by * ray.dx;
  const double half2 = radius2 - aside * aside;  // half the chord, squared
  if (half2 < 0 || along < 0) return infinity;
  return std::max(along - std::sqrt(half2), 0.0);
}

// A segment.  Which side of the ray an end lies on depends on that end alone, so no ray slips between two segments that
// share one, and the hit always lies between the two ends.
[[gnu::always_inline]] inline double hit_segment(const Ray& ray, double x0, double y0, double x1, double y1) noexcept {
  const double ax = x0 - ray.x, ay = y0 - ray.y, bx = x1 - ray.x, by = y1 - ray.y;
  const double side_a = ax * ray.dy - ay * ray.dx, side_b = bx * ray.dy - by * ray.dx;
  if ((side_a > 0 && side_b > 0) || (side_a < 0 && side_b < 0)) return infinity;
  const double a = ax * ray.dx + ay * ray.dy, b = bx * ray.dx + by * ray.dy;
  if (side_a == side_b) {  // both 0: along the ray
    if (a < 0 && b < 0) return infinity;
    return a < 0 || b < 0 ? 0 : std::min(a, b);
  }
  const double t = a + (b - a) * (side_a / (side_a - side_b));
  return t < 0 ? infinity : t;
}

// The walls around the bounds, seen from within; beyond them all is wall.
[[gnu::always_inline]] inline double hit_bounds(const Ray& ray, double x0, double y0, double x1, double y1) noexcept {
  if (!(ray.x > x0 && ray.x < x1 && ray.y > y0 && ray.y < y1)) return 0;
  const double tx = (ray.dx < 0 ? ray.x - x0 : x1 - ray.x) / std::fabs(ray.dx);
  const double ty = (ray.dy < 0 ? ray.y - y0 : y1 - ray.y) / std::fabs(ray.dy);
  return std::min(tx, ty);
}

inline double from_disc(double px, double py, double x, double y, double radius) noexcept {
  const double dx = px - x, dy = py - y;
  return std::sqrt(dx * dx + dy * dy) - radius;
}

inline double from_segment(double px, double py, double x0, double y0, double x1, double y1) noexcept {
  const double ex = x1 - x0, ey = y1 - y0, sx = px - x0, sy = py - y0;
  const double length2 = ex * ex + ey * ey;
  const double u = length2 > 0 ? std::min(std::max((sx * ex + sy * ey) / length2, 0.0), 1.0) : 0.0;
  const double dx = sx - u * ex, dy = sy - u * ey;
  return std::sqrt(dx * dx + dy * dy);
}

inline double from_bounds(double px, double py, double x0, double y0, double x1, double y1) noexcept {
  return std::min(std::min(px - x0, x1 - px), std::min(py - y0, y1 - py));
}

// True inside: a ray to the right crosses an odd number of edges.
inline bool inside(const Polygon& polygon, double px, double py) noexcept {
  bool odd = false;
  const std::size_t n = polygon.points.size();
  for (std::size_t i = 0, j = n - 1; i < n; j = i++) {
    const Point &a = polygon.points[i], &b = polygon.points[j];
    if ((a.y > py) == (b.y > py)) continue;
    const double side = (b.x - a.x) * (py - a.y) - (px - a.x) * (b.y - a.y);
    if ((b.y > a.y) == (side > 0)) odd = !odd;
  }
  return odd;
}

// To the outline, negative inside.
inline double from_polygon(const Polygon& polygon, double px, double py) noexcept {
  double nearest = infinity;
  const std::size_t n = polygon.points.size();
  for (std::size_t i = 0, j = n - 1; i < n; j = i++) {
    const Point &a = polygon.points[j], &b = polygon.points[i];
    nearest = std::min(nearest, from_segment(px, py, a.x, a.y, b.x, b.y));
  }
  return inside(polygon, px, py) ? -nearest : nearest;
}

}  // namespace arena
