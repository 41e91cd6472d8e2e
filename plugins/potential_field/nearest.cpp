// The nearest point of every obstacle of a map.
#include "nearest.hpp"

#include <algorithm>
#include <cmath>
#include <wend/math.hpp>

namespace potential_field {
namespace {

// From (x, y) to the nearest point of the segment a b.
Near to_segment(double x, double y, const double* a, const double* b) noexcept {
  const double ux = b[0] - a[0], uy = b[1] - a[1], length2 = ux * ux + uy * uy;
  const double t = length2 > 0 ? std::clamp(((x - a[0]) * ux + (y - a[1]) * uy) / length2, 0.0, 1.0) : 0;
  const double dx = a[0] + t * ux - x, dy = a[1] + t * uy - y;
  return {dx, dy, wend::math::hypot(dx, dy)};
}

// Even-odd rule.
bool inside(double x, double y, const wend_shape& polygon) noexcept {
  bool in = false;
  for (std::uint64_t i = 0, j = polygon.count - 1; i < polygon.count; j = i++) {
    const double *a = polygon.xy + 2 * i, *b = polygon.xy + 2 * j;
    if ((a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) in = !in;
  }
  return in;
}

// The part of a grid that lies within reach, and what of it is occupied.
struct Patch {
  const wend_shape& grid;
  std::int64_t first_column, first_row, columns, rows;

  Patch(const wend_shape& shape, double x, double y, double reach) : grid(shape) {
    const auto total_columns = static_cast<std::int64_t>(shape.count >> 32);
    const auto total_rows = static_cast<std::int64_t>(shape.count & 0xffffffffu);
    const auto cell_of = [&](double at, double corner, std::int64_t total) {
      return static_cast<std::int64_t>(
          std::clamp(std::floor((at - corner) / shape.xy[2]), -1.0, static_cast<double>(total)));
    };
    first_column = std::max<std::int64_t>(cell_of(x - reach, shape.xy[0], total_columns), 0);
    first_row = std::max<std::int64_t>(cell_of(y - reach, shape.xy[1], total_rows), 0);
    columns = std::min(cell_of(x + reach, shape.xy[0], total_columns), total_columns - 1) - first_column + 1;
    rows = std::min(cell_of(y + reach, shape.xy[1], total_rows), total_rows - 1) - first_row + 1;
  }
  bool occupied(std::int64_t column, std::int64_t row) const noexcept {
    const auto width = static_cast<std::int64_t>(grid.count >> 32);
    return grid.cells[(first_row + row) * width + first_column + column] != 0;
  }
  Near to_cell(double x, double y, std::int64_t column, std::int64_t row) const noexcept {
    const double size = grid.xy[2], left = grid.xy[0] + static_cast<double>(first_column + column) * size;
    const double bottom = grid.xy[1] + static_cast<double>(first_row + row) * size;
    const double dx = std::clamp(x, left, left + size) - x, dy = std::clamp(y, bottom, bottom + size) - y;
    return {dx, dy, wend::math::hypot(dx, dy)};
  }
};

}  // namespace

std::span<const Near> Obstacles::around(double x, double y, double reach, std::span<const wend_shape> shapes) {
  near_.clear();
  reach_ = reach;
  for (const wend_shape& shape : shapes) {
    if (shape.kind & (WEND_GOAL | WEND_ROBOT)) continue;
    if (shape.form == WEND_SHAPE_DISC) {
      const double dx = shape.xy[0] - x, dy = shape.xy[1] - y, d = wend::math::hypot(dx, dy);
      const double share = d > 0 ? std::max(d - shape.radius, 0.0) / d : 0;
      add(dx * share, dy * share, d * share);
    } else if (shape.form == WEND_SHAPE_SEGMENTS) {
      for (std::uint64_t i = 0; i + 1 < shape.count; i += 2) add_segment(x, y, shape.xy + 2 * i, shape.xy + 2 * i + 2);
    } else if (shape.form == WEND_SHAPE_POLYGON) {
      add_polygon(x, y, shape);
    } else {
      add_patches(x, y, shape);
    }
  }
  return near_;
}

void Obstacles::add(double dx, double dy, double distance) {
  if (distance < reach_) near_.push_back({dx, dy, distance});
}

void Obstacles::add_segment(double x, double y, const double* a, const double* b) {
  const Near near = to_segment(x, y, a, b);
  add(near.dx, near.dy, near.distance);
}

void Obstacles::add_polygon(double x, double y, const wend_shape& polygon) {
  if (polygon.count == 0) return;
  if (inside(x, y, polygon)) return add(0, 0, 0);
  Near nearest{0, 0, wend::math::detail::infinity};
  for (std::uint64_t i = 0, j = polygon.count - 1; i < polygon.count; j = i++) {
    const Near near = to_segment(x, y, polygon.xy + 2 * j, polygon.xy + 2 * i);
    if (near.distance < nearest.distance) nearest = near;
  }
  add(nearest.dx, nearest.dy, nearest.distance);
}

// Cells that touch, also at a corner, and lie within reach are one obstacle.
void Obstacles::add_patches(double x, double y, const wend_shape& grid) {
  const Patch patch(grid, x, y, reach_);
  if (patch.columns <= 0 || patch.rows <= 0) return;
  visited_.assign(static_cast<std::size_t>(patch.columns * patch.rows), 0);
  for (std::int64_t seed = 0; seed < patch.columns * patch.rows; ++seed) {
    if (visited_[static_cast<std::size_t>(seed)] || !patch.occupied(seed % patch.columns, seed / patch.columns))
      continue;
    Near nearest{0, 0, wend::math::detail::infinity};
    visited_[static_cast<std::size_t>(seed)] = 1;
    open_.assign(1, static_cast<std::uint32_t>(seed));
    while (!open_.empty()) {
      const std::int64_t cell = open_.back(), column = cell % patch.columns, row = cell / patch.columns;
      open_.pop_back();
      const Near near = patch.to_cell(x, y, column, row);
      if (near.distance < nearest.distance) nearest = near;
      for (std::int64_t r = std::max<std::int64_t>(row - 1, 0); r <= std::min(row + 1, patch.rows - 1); ++r)
        for (std::int64_t c = std::max<std::int64_t>(column - 1, 0); c <= std::min(column + 1, patch.columns - 1);
             ++c) {
          auto& visited = visited_[static_cast<std::size_t>(r * patch.columns + c)];
          if (visited || !patch.occupied(c, r)) continue;
          visited = 1;
          open_.push_back(static_cast<std::uint32_t>(r * patch.columns + c));
        }
    }
    add(nearest.dx, nearest.dy, nearest.distance);
  }
}

}  // namespace potential_field
