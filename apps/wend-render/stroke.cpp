#include "stroke.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wend::render {
namespace {

using core::Place;

constexpr double pi = 3.14159265358979323846;
constexpr double most_dashes = 100'000;  // a pattern finer than that is drawn solid

double distance(Place a, Place b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

Polygon quad(Place a, Place b, double half) {
  const double length = distance(a, b);
  const double nx = -(b.y - a.y) / length * half, ny = (b.x - a.x) / length * half;
  return {{a.x + nx, a.y + ny}, {b.x + nx, b.y + ny}, {b.x - nx, b.y - ny}, {a.x - nx, a.y - ny}};
}

}  // namespace

Polygon circle(Place centre, double radius) {
  // The sagitta of n sides is radius * (pi / n)^2 / 2.
  const int n = std::clamp(static_cast<int>(std::ceil(pi * std::sqrt(radius / 0.04))), 12, 2000);
  Polygon points(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * pi * i / n;
    points[static_cast<std::size_t>(i)] = {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
  }
  return points;
}

std::vector<Polygon> dashes(const std::vector<Place>& line, bool closed, const std::vector<double>& pattern) {
  std::vector<Place> points = line;
  if (closed && points.size() > 1) points.push_back(points.front());
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += distance(points[i - 1], points[i]);
  const double period = std::accumulate(pattern.begin(), pattern.end(), 0.0);
  if (pattern.empty() || points.size() < 2 || !(period > 0) ||
      length / period * static_cast<double>(pattern.size()) > most_dashes)
    return {points};

  std::vector<Polygon> drawn;
  std::size_t phase = 0;     // even: drawing
  double left = pattern[0];  // of this phase
  drawn.push_back({points[0]});
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Place a = points[i - 1], b = points[i];
    const double span = distance(a, b);
    double at = 0;
    while (span - at > left) {
      at += left;
      const Place here{a.x + (b.x - a.x) * at / span, a.y + (b.y - a.y) * at / span};
      if (phase % 2 == 0)
        drawn.back().push_back(here);
      else
        drawn.push_back({here});
      phase = (phase + 1) % (pattern.size() * (1 + pattern.size() % 2));  // an odd pattern alternates its roles
      left = pattern[phase % pattern.size()];
    }
    left -= span - at;
    if (phase % 2 == 0) drawn.back().push_back(b);
  }
  return drawn;
}

std::vector<Polygon> stroke(const std::vector<Place>& line, double width, core::Cap cap) {
  const double half = width / 2;
  std::vector<Polygon> pieces;
  std::vector<Place> kept;
  for (const Place p : line)
    if (kept.empty() || distance(kept.back(), p) > 1e-6) kept.push_back(p);
  if (kept.size() < 2) {
    if (!kept.empty() && cap == core::Cap::round) pieces.push_back(circle(kept[0], half));
    return pieces;
  }
  for (std::size_t i = 1; i < kept.size(); ++i) pieces.push_back(quad(kept[i - 1], kept[i], half));
  const bool closed = kept.size() > 2 && distance(kept.front(), kept.back()) < 1e-6;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const bool end = i == 0 || i + 1 == kept.size();
    if (!end || closed || cap == core::Cap::round) pieces.push_back(circle(kept[i], half));
  }
  return pieces;
}

}  // namespace wend::render
