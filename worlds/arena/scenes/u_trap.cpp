// A U between start and goal: what a planner that looks no farther than its window can't leave.
#include <algorithm>
#include <cmath>
#include <wend/math.hpp>

#include "generators.hpp"
#include "placement.hpp"

namespace arena {
namespace {

// The trap lies along the u axis, which leads from start to goal, and across the v axis; (0, 0) is half-way.
struct Frame {
  double x, y, cosine, sine;
  Point at(double u, double v) const noexcept { return {x + u * cosine - v * sine, y + u * sine + v * cosine}; }
  Polygon box(double u0, double u1, double v0, double v1) const {
    return {{at(u0, v0), at(u1, v0), at(u1, v1), at(u0, v1)}};
  }
};

struct Lengths {
  double width, depth, thickness, before, behind;
  double half() const noexcept { return (before + depth + thickness + behind) / 2; }
  // m from the middle to the farthest point.
  double reach() const noexcept {
    const double u0 = before - half(), u1 = half() - behind, v = width / 2 + thickness, u = std::max(-u0, u1);
    return std::max(half(), std::sqrt(u * u + v * v));
  }
};

// Room for the robot between the trap and the walls, and around it at start and goal.
double margin(const UTrap& p) {
  return 3 * p.body + 1;
}

std::array<double, 2> arena_size(const UTrap& p) {
  const double more = 1 + p.jitter;
  const Lengths longest{more * p.width, more * p.depth, more * p.thickness, more * p.before, more * p.behind};
  const double needed = std::ceil(2 * (longest.reach() + margin(p)));
  return {p.size[0] > 0 ? p.size[0] : std::max(100.0, needed), p.size[1] > 0 ? p.size[1] : std::max(100.0, needed)};
}

Scene draw(const UTrap& p, wend::Random& random) {
  const auto vary = [&](double length) { return length * random.uniform(1 - p.jitter, 1 + p.jitter); };
  Lengths l{};
  l.width = vary(p.width), l.depth = vary(p.depth), l.thickness = vary(p.thickness);
  l.before = vary(p.before), l.behind = vary(p.behind);
  const double direction = random.uniform(-wend::math::pi, wend::math::pi);
  const std::array<double, 2> size = arena_size(p);
  const Frame f{size[0] / 2, size[1] / 2, p.turn ? wend::math::cos(direction) : 1,
                p.turn ? wend::math::sin(direction) : 0};

  Scene scene;
  scene.name = "u_trap";
  scene.width = size[0], scene.height = size[1];
  const double opening = l.before - l.half(), back = opening + l.depth, inner = l.width / 2,
               outer = inner + l.thickness;
  scene.polygons = {f.box(opening, back, inner, outer), f.box(opening, back, -outer, -inner),
                    f.box(back, back + l.thickness, -outer, outer)};
  const Point start = f.at(-l.half(), 0), goal = f.at(l.half(), 0);
  scene.starts = {{start.x, start.y, 0, true}};
  scene.goals = {{goal.x, goal.y, p.goal_radius, {}, 0}};
  return scene;
}

bool fits(const Scene& scene, const UTrap& p) {
  const auto inside = [&](const Point& q) {
    const double m = margin(p);
    return q.x >= m && q.y >= m && q.x <= scene.width - m && q.y <= scene.height - m;
  };
  for (const Polygon& polygon : scene.polygons)
    if (!std::all_of(polygon.points.begin(), polygon.points.end(), inside)) return false;
  return inside({scene.starts[0].x, scene.starts[0].y}) && inside({scene.goals[0].x, scene.goals[0].y});
}

}  // namespace

Scene generate(const UTrap& p, std::uint64_t key) {
  for (int attempt = 0; attempt < most_tries; ++attempt) {
    wend::Random random(wend::stream(key, static_cast<std::uint64_t>(attempt)));
    Scene scene = draw(p, random);
    const Point start{scene.starts[0].x, scene.starts[0].y}, goal{scene.goals[0].x, scene.goals[0].y};
    if (fits(scene, p) && std::min(clearance(scene, start), clearance(scene, goal)) > p.body &&
        joined(scene, start, goal, p.body))
      return scene;
  }
  refuse("size",
         "expected room for the trap, start, goal and a robot beside them, found none in 1000 tries: choose a "
         "larger size, or 0 for one that fits");
}

}  // namespace arena
