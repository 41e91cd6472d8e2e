// Blocks the cells of a grid that a disc can't stand in: walls, discs, segments, polygons, occupied cells.
#include "free_space.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <wend/error.hpp>

namespace arena {
namespace {

double squared_distance(double px, double py, const Point& a, const Point& b) noexcept {
  const double dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
  const double t = length > 0 ? std::clamp(((px - a.x) * dx + (py - a.y) * dy) / length, 0.0, 1.0) : 0.0;
  const double ex = px - (a.x + t * dx), ey = py - (a.y + t * dy);
  return ex * ex + ey * ey;
}

// Even-odd rule, or nearer to an edge than the radius.
bool touches_polygon(double x, double y, const std::vector<Point>& points, double squared_radius) noexcept {
  bool inside = false;
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
    const Point &a = points[i], &b = points[j];
    if (squared_distance(x, y, a, b) <= squared_radius) return true;
    if ((a.y > y) != (b.y > y) && x < a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

// Whole cells from an anchor, robust against a quotient that falls just short of a whole number.
double cells_below(double length, double cell) noexcept {
  return std::floor(length / cell + 1e-9);
}
double cells_above(double length, double cell) noexcept {
  return std::ceil(length / cell - 1e-9);
}

}  // namespace

FreeSpace::FreeSpace(const Scene& scene, double cell, double body_radius, const std::vector<Point>& also)
    : cell_(cell), exact_(body_radius <= 0) {
  lay_out(scene, body_radius, also);
  if (scene.walled) block_walls(scene, body_radius);
  for (const Disc& disc : scene.discs) {
    const double r = disc.radius + body_radius;
    block(disc.x - r, disc.y - r, disc.x + r, disc.y + r,
          [&](double x, double y) { return (x - disc.x) * (x - disc.x) + (y - disc.y) * (y - disc.y) <= r * r; });
  }
  const double half = std::max(body_radius, cell_ / 2);
  for (const Segment& s : scene.segments) {
    block(std::min(s.x0, s.x1) - half, std::min(s.y0, s.y1) - half, std::max(s.x0, s.x1) + half,
          std::max(s.y0, s.y1) + half, [&](double x, double y) {
            return squared_distance(x, y, {s.x0, s.y0}, {s.x1, s.y1}) <= half * half;
          });
  }
  for (const Polygon& polygon : scene.polygons) {
    double x0 = polygon.points.at(0).x, y0 = polygon.points[0].y, x1 = x0, y1 = y0;
    for (const Point& p : polygon.points) {
      x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
      y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
    }
    block(x0 - body_radius, y0 - body_radius, x1 + body_radius, y1 + body_radius,
          [&](double x, double y) { return touches_polygon(x, y, polygon.points, body_radius * body_radius); });
  }
  block_grid(scene.grid, body_radius);
}

// The lattice passes through the corner of the scene's grid, so that a cell of the same size is the same cell.
void FreeSpace::lay_out(const Scene& scene, double body_radius, const std::vector<Point>& also) {
  const double anchor_x = scene.grid.columns > 0 ? scene.grid.x : scene.x;
  const double anchor_y = scene.grid.columns > 0 ? scene.grid.y : scene.y;
  const double strip = scene.walled ? 0 : std::max(4 * cell_, 4 * body_radius);
  double x0 = scene.x - strip, y0 = scene.y - strip;
  double x1 = scene.x + scene.width + strip, y1 = scene.y + scene.height + strip;
  if (!scene.walled) {
    for (const Point& p : also) {
      x0 = std::min(x0, p.x - strip), x1 = std::max(x1, p.x + strip);
      y0 = std::min(y0, p.y - strip), y1 = std::max(y1, p.y + strip);
    }
  }
  const double left = cells_below(x0 - anchor_x, cell_), right = cells_above(x1 - anchor_x, cell_);
  const double low = cells_below(y0 - anchor_y, cell_), high = cells_above(y1 - anchor_y, cell_);
  if (!(cell_ > 0) || !((right - left + 2) * (high - low + 2) <= 16e6))
    throw wend::Error("an arena of " + std::to_string(x1 - x0) + " m x " + std::to_string(y1 - y0) + " m in cells of " +
                      std::to_string(cell_) + " m: expected at most 16 million cells; choose larger cells");
  x_ = anchor_x + (left - 1) * cell_;
  y_ = anchor_y + (low - 1) * cell_;
  columns_ = static_cast<std::size_t>(right - left) + 2;
  rows_ = static_cast<std::size_t>(high - low) + 2;
  free_.assign(columns_ * rows_, 0);
  for (std::size_t row = 1; row + 1 < rows_; ++row)
    std::fill_n(free_.begin() + static_cast<std::ptrdiff_t>(row * columns_ + 1), columns_ - 2, std::uint8_t{1});
}

void FreeSpace::block_walls(const Scene& scene, double body_radius) {
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (free_[i] == 0) continue;
    const Point c = centre(i);
    if (std::min(c.x - scene.x, c.y - scene.y) <= body_radius ||
        std::min(scene.x + scene.width - c.x, scene.y + scene.height - c.y) <= body_radius)
      free_[i] = 0;
  }
}

// Only cells at the edge of an occupied region reach beyond themselves.
void FreeSpace::block_grid(const Grid& grid, double body_radius) {
  for (std::int64_t row = 0; row < grid.rows; ++row) {
    for (std::int64_t column = 0; column < grid.columns; ++column) {
      if (!grid.at(column, row)) continue;
      bool edge = false;
      for (std::int64_t k = 0; k < 9; ++k) edge = edge || !grid.at(column - 1 + k % 3, row - 1 + k / 3);
      const double r = edge ? body_radius : 0;
      const double x0 = grid.x + static_cast<double>(column) * grid.cell, x1 = x0 + grid.cell;
      const double y0 = grid.y + static_cast<double>(row) * grid.cell, y1 = y0 + grid.cell;
      block(x0 - r, y0 - r, x1 + r, y1 + r, [&](double x, double y) {
        const double dx = std::max({x0 - x, x - x1, 0.0}), dy = std::max({y0 - y, y - y1, 0.0});
        return dx * dx + dy * dy <= r * r;
      });
    }
  }
}

template <class Touches>
void FreeSpace::block(double x0, double y0, double x1, double y1, Touches&& touches) {
  const auto first = [&](double v, double corner, std::size_t n) {
    return static_cast<std::size_t>(std::clamp(std::floor((v - corner) / cell_ - 0.5), 0.0, static_cast<double>(n)));
  };
  const auto last = [&](double v, double corner, std::size_t n) {
    return static_cast<std::size_t>(std::clamp(std::ceil((v - corner) / cell_ + 0.5), 0.0, static_cast<double>(n)));
  };
  const std::size_t right = last(x1, x_, columns_), high = last(y1, y_, rows_);
  for (std::size_t row = first(y0, y_, rows_); row < high; ++row) {
    const double y = y_ + (static_cast<double>(row) + 0.5) * cell_;
    for (std::size_t column = first(x0, x_, columns_); column < right; ++column) {
      std::uint8_t& cell = free_[row * columns_ + column];
      if (cell != 0 && touches(x_ + (static_cast<double>(column) + 0.5) * cell_, y)) cell = 0;
    }
  }
}

std::ptrdiff_t FreeSpace::index(Point p) const noexcept {
  const double column = std::floor((p.x - x_) / cell_), row = std::floor((p.y - y_) / cell_);
  if (!(column >= 1 && row >= 1 && column + 1 < static_cast<double>(columns_) && row + 1 < static_cast<double>(rows_)))
    return -1;
  return static_cast<std::ptrdiff_t>(row) * stride() + static_cast<std::ptrdiff_t>(column);
}

Point FreeSpace::centre(std::size_t i) const noexcept {
  return {x_ + (static_cast<double>(i % columns_) + 0.5) * cell_,
          y_ + (static_cast<double>(i / columns_) + 0.5) * cell_};
}

std::vector<std::uint8_t> FreeSpace::reachable(std::ptrdiff_t from) const {
  std::vector<std::uint8_t> reached(free_.size(), 0);
  if (from < 0 || !free(static_cast<std::size_t>(from))) return reached;
  std::vector<std::ptrdiff_t> open{from};
  reached[static_cast<std::size_t>(from)] = 1;
  while (!open.empty()) {
    const std::ptrdiff_t i = open.back();
    open.pop_back();
    for (const std::ptrdiff_t next : {i - 1, i + 1, i - stride(), i + stride()}) {
      const auto n = static_cast<std::size_t>(next);
      if (free_[n] == 0 || reached[n] != 0) continue;
      reached[n] = 1;
      open.push_back(next);
    }
  }
  return reached;
}

}  // namespace arena
