// How far a disc drives along an arc until it touches a point.
#include "arc.hpp"

#include <algorithm>
#include <cmath>
#include <wend/math.hpp>

namespace dwa {
namespace {

constexpr double never = wend::math::detail::infinity;

double along_line(Point p, double radius) noexcept {
  const double inside = radius * radius - p.y * p.y;
  if (inside <= 0 || p.x <= 0) return never;
  return std::max(p.x - std::sqrt(inside), 0.0);
}

// To the left, about (0, turn): the centre of the disc stays at the distance `turn` from there.
double along_circle(Point p, double radius, double turn) noexcept {
  const double from_centre2 = p.x * p.x + (p.y - turn) * (p.y - turn);
  if (from_centre2 >= (turn + radius) * (turn + radius)) return never;
  const double from_centre = std::sqrt(from_centre2);
  const double off =
      (p.x * p.x + p.y * p.y - 2 * p.y * turn) / (from_centre + turn);  // from_centre - turn, exact for large turns
  const double inside = radius * radius - off * off;
  if (inside <= 0) return never;
  // The chord of contact spans 2 * half around the direction of the point; sine and cosine of half / 2 lose no digits.
  const double sum = from_centre + turn;
  const double half = 2 * wend::math::atan2(std::sqrt(inside), std::sqrt(std::max(sum * sum - radius * radius, 0.0)));
  double angle = wend::math::atan2(p.x, turn - p.y) - half;
  if (angle < 0) angle += wend::math::two_pi;
  return turn * angle;
}

}  // namespace

double free_way(double v, double w, Point p, double radius) noexcept {
  if (v == 0) return never;
  if (v < 0) p.x = -p.x, w = -w, v = -v;
  radius = std::min(radius, (1 - 1e-6) * wend::math::hypot(p.x, p.y));
  if (std::fabs(w) <= 1e-9 * v) return along_line(p, radius);
  if (w < 0) p.y = -p.y, w = -w;
  return along_circle(p, radius, v / w);
}

}  // namespace dwa
