// Occupancy: building the tiles, and rays through them.  The distance search is in occupancy_distance.cpp.
#include "occupancy.hpp"

namespace arena {
namespace {

constexpr double still_below = 1e-100;  // a direction this small never reaches the next line

}  // namespace

Occupancy::Occupancy(const Grid& grid)
    : x_(grid.x),
      y_(grid.y),
      cell_(grid.cell),
      columns_(grid.columns),
      rows_(grid.rows),
      tile_columns_((grid.columns + 7) / 8),
      tile_rows_((grid.rows + 7) / 8) {
  tiles_.assign(static_cast<std::size_t>(tile_columns_) * static_cast<std::size_t>(tile_rows_), 0);
  for (std::uint32_t j = 0; j < grid.rows; ++j)
    for (std::uint32_t i = 0; i < grid.columns; ++i)
      if (grid.at(i, j)) {
        tiles_[static_cast<std::size_t>(j >> 3) * static_cast<std::size_t>(tile_columns_) + (i >> 3)] |=
            std::uint64_t{1} << ((j & 7) * 8 + (i & 7));
        any_ = true;
      }
  measure_tiles();
}

// The first cell on the ray's way that it has not left before t: on a line, the cell behind it.
std::int64_t Occupancy::Axis::first_at(double t) const noexcept {
  const double guess = std::floor((from + direction * t - low) / cell);
  auto k = static_cast<std::int64_t>(std::min(std::max(guess, 0.0), static_cast<double>(count - 1)));
  const std::int64_t forward = step();
  while (leaves(k) < t && k + forward >= 0 && k + forward < count) k += forward;
  while (k - forward >= 0 && k - forward < count && leaves(k - forward) >= t) k -= forward;
  return k;
}

// When the ray leaves the tile that cell k belongs to.
double Occupancy::Axis::tile_leaves(std::int64_t k) const noexcept {
  if (still()) return infinity;
  return at(direction > 0 ? (k | 7) + 1 : k & ~std::int64_t{7});
}

double Occupancy::cast(const Ray& ray, double reach) const noexcept {
  if (!any_) return infinity;
  const auto axis = [](double low, double cell, double from, double direction, std::uint64_t count) {
    const double d = std::fabs(direction) < still_below ? 0 : direction;
    return Axis{low, cell, from, d, 1 / d, static_cast<std::int64_t>(count)};
  };
  const Axis x = axis(x_, cell_, ray.x, ray.dx, columns_), y = axis(y_, cell_, ray.y, ray.dy, rows_);
  // When the ray is within the grid's bounds.
  double start = 0, end = reach;
  for (const Axis* a : {&x, &y}) {
    if (a->still()) {
      if (a->from < a->line(0) || a->from > a->line(a->count)) return infinity;
    } else {
      const std::int64_t first = a->direction > 0 ? 0 : a->count - 1;
      start = std::max(start, a->enters(first));
      end = std::min(end, a->leaves(a->count - 1 - first));
    }
  }
  if (start > end) return infinity;
  if (!x.still() && !y.still()) return walk(x, y, x.first_at(start), y.first_at(start), start, end);

  // Parallel to an axis: on a line, the ray touches the cells of both sides.
  const auto sides = [](const Axis& a, std::int64_t(&k)[2]) {
    k[0] = cell_of(a.low, a.cell, a.count, a.from);
    k[1] = k[0];
    if (a.from == a.line(k[0]) && k[0] > 0) k[1] = k[0] - 1;
    if (a.from == a.line(k[0] + 1) && k[0] + 1 < a.count) k[1] = k[0] + 1;
  };
  std::int64_t i[2], j[2];
  if (x.still())
    sides(x, i);
  else
    i[0] = i[1] = x.first_at(start);
  if (y.still())
    sides(y, j);
  else
    j[0] = j[1] = y.first_at(start);
  double nearest = walk(x, y, i[0], j[0], start, end);
  if (i[1] != i[0]) nearest = std::min(nearest, walk(x, y, i[1], j[0], start, end));
  if (j[1] != j[0]) nearest = std::min(nearest, walk(x, y, i[0], j[1], start, end));
  return nearest;
}

// From cell (i, j), in which the ray is at `start`, until an occupied cell or `end`.
double Occupancy::walk(const Axis& x, const Axis& y, std::int64_t i, std::int64_t j, double start,
                       double end) const noexcept {
  const std::int64_t step_i = x.still() ? 0 : x.step(), step_j = y.still() ? 0 : y.step();
  double t = start;
  if (occupied(i, j)) return t;
  while (true) {
    if (tile(i, j) == 0) {  // go to where the ray leaves the tile, still within it
      const double exit = std::min(x.tile_leaves(i), y.tile_leaves(j));
      if (exit > end) return infinity;
      if (!x.still()) i = x.first_at(exit);
      if (!y.still()) j = y.first_at(exit);
    }
    const double leaves_x = x.leaves(i), leaves_y = y.leaves(j);
    t = std::min(leaves_x, leaves_y);
    if (t > end) return infinity;
    if (leaves_x < leaves_y) {
      i += step_i;
    } else if (leaves_y < leaves_x) {
      j += step_j;
    } else {  // through a corner, which touches the two cells beside it
      if (leaves_x == infinity) return infinity;
      if (occupied(i + step_i, j) || occupied(i, j + step_j)) return t;
      i += step_i;
      j += step_j;
    }
    if (static_cast<std::uint64_t>(i) >= columns_ || static_cast<std::uint64_t>(j) >= rows_) return infinity;
    if (occupied(i, j)) return t;
  }
}

}  // namespace arena
