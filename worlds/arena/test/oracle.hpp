// Rays and clearances by testing every shape, and random scenes to test them in.
#pragma once
#include <wend/math.hpp>
#include <wend/random.hpp>

#include "../geometry/static_map.hpp"

namespace arena {

// ---- the oracle: every shape, in the scene's order

inline double cast_cells(const Grid& grid, const Ray& ray) {
  double best = infinity;
  for (std::uint32_t j = 0; j < grid.rows; ++j)
    for (std::uint32_t i = 0; i < grid.columns; ++i) {
      if (!grid.at(i, j)) continue;
      double enter = 0, leave = infinity;
      const auto clip = [&](double low, std::uint32_t k, double from, double direction) {
        const double a = low + k * grid.cell, b = low + (k + 1.0) * grid.cell;
        if (std::fabs(direction) < 1e-100) {
          if (from < a || from > b) leave = -1;
          return;
        }
        const double ta = (a - from) * (1 / direction), tb = (b - from) * (1 / direction);
        enter = std::max(enter, std::min(ta, tb)), leave = std::min(leave, std::max(ta, tb));
      };
      clip(grid.x, i, ray.x, ray.dx), clip(grid.y, j, ray.y, ray.dy);
      if (enter <= leave) best = std::min(best, enter);
    }
  return best;
}

inline double clearance_cells(const Grid& grid, double x, double y) {
  double best = infinity;
  for (std::uint32_t j = 0; j < grid.rows; ++j)
    for (std::uint32_t i = 0; i < grid.columns; ++i) {
      if (!grid.at(i, j)) continue;
      const double x0 = grid.x + i * grid.cell, x1 = grid.x + (i + 1.0) * grid.cell;
      const double y0 = grid.y + j * grid.cell, y1 = grid.y + (j + 1.0) * grid.cell;
      const double depth = std::min(std::min(x - x0, x1 - x), std::min(y - y0, y1 - y));
      const double dx = std::max(std::max(x0 - x, x - x1), 0.0), dy = std::max(std::max(y0 - y, y - y1), 0.0);
      best = std::min(best, depth > 0 ? -depth : std::sqrt(dx * dx + dy * dy));
    }
  return best;
}

inline double cast_all(const Scene& scene, const Ray& ray, double reach) {
  double best = std::min(reach, cast_cells(scene.grid, ray));
  for (const Disc& disc : scene.discs) best = std::min(best, hit_disc(ray, disc.x, disc.y, disc.radius * disc.radius));
  for (const Segment& s : scene.segments) best = std::min(best, hit_segment(ray, s.x0, s.y0, s.x1, s.y1));
  for (const Polygon& polygon : scene.polygons) {
    if (inside(polygon, ray.x, ray.y)) best = 0;
    for (std::size_t i = 0, j = polygon.points.size() - 1; i < polygon.points.size(); j = i++)
      best = std::min(
          best, hit_segment(ray, polygon.points[j].x, polygon.points[j].y, polygon.points[i].x, polygon.points[i].y));
  }
  return best;
}

inline double clearance_everything(const Scene& scene, double x, double y) {
  double best = clearance_cells(scene.grid, x, y);
  for (const Disc& disc : scene.discs) best = std::min(best, from_disc(x, y, disc.x, disc.y, disc.radius));
  for (const Segment& s : scene.segments) best = std::min(best, from_segment(x, y, s.x0, s.y0, s.x1, s.y1));
  for (const Polygon& polygon : scene.polygons) best = std::min(best, from_polygon(polygon, x, y));
  return best;
}

// ---- random scenes

// Coordinates on a coarse lattice half of the time: touching shapes, shared corners, rays along lines.
struct Draw {
  wend::Random random;
  bool lattice;
  double size;
  double coordinate() {
    const double at = random.uniform(-0.1 * size, 1.1 * size);
    return lattice ? std::floor(at) : at;
  }
  double direction() {
    return lattice && random.chance(0.5) ? static_cast<double>(random.below(8)) * wend::math::pi / 4
                                         : random.uniform(-7, 7);
  }
  // On a lattice perhaps exactly along one of its lines.
  Ray ray(bool straight) {
    Ray ray{coordinate(), coordinate(), 0, 0};
    wend::math::sincos(direction(), ray.dy, ray.dx);
    if (lattice && straight) ray.dx = std::round(ray.dx), ray.dy = ray.dx == 0 ? std::round(ray.dy) : 0;
    return ray;
  }
};

inline std::shared_ptr<Scene> random_scene(Draw& draw) {
  auto scene = std::make_shared<Scene>();
  scene->width = scene->height = draw.size;
  const std::uint64_t most = draw.random.chance(0.3) ? 120 : 8;
  for (std::uint64_t n = draw.random.below(most); n > 0; --n)
    scene->discs.push_back({draw.coordinate(), draw.coordinate(), draw.random.uniform(0, 0.1 * draw.size)});
  for (std::uint64_t n = draw.random.below(most); n > 0; --n)
    scene->segments.push_back({draw.coordinate(), draw.coordinate(), draw.coordinate(), draw.coordinate()});
  for (std::uint64_t n = draw.random.below(most / 2); n > 0; --n) {
    const double x = draw.coordinate(), y = draw.coordinate(), w = 1 + draw.random.uniform(0, 5),
                 h = 1 + draw.random.uniform(0, 5);
    Polygon polygon{{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}};
    if (draw.random.chance(0.5)) polygon.points = {{x, y}, {x + w, y - 1}, {x + 0.5 * w, y + 0.3 * h}, {x + w, y + h}};
    scene->polygons.push_back(polygon);
  }
  if (draw.random.chance(0.6)) {
    Grid& grid = scene->grid;
    grid.columns = 1 + static_cast<std::uint32_t>(draw.random.below(40));
    grid.rows = 1 + static_cast<std::uint32_t>(draw.random.below(40));
    grid.cell = draw.lattice ? 1 : draw.random.uniform(0.1, 1);
    grid.x = draw.lattice ? 2 : draw.random.uniform(-3, 3), grid.y = draw.lattice ? -1 : draw.random.uniform(-3, 3);
    const double fill = draw.random.chance(0.5) ? 0.01 : 0.3;
    for (std::size_t k = std::size_t{grid.columns} * grid.rows; k > 0; --k)
      grid.occupied.push_back(draw.random.chance(fill));
  }
  return scene;
}

}  // namespace arena
