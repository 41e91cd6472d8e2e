// Occupancy: the distance to the nearest occupied cell, by rings of tiles around the point.
#include "occupancy.hpp"

namespace arena {
namespace {

// Below this share of the best distance so far a ring may still hold a nearer cell: a margin for rounding.
constexpr double margin = 1 - 1e-9;

}  // namespace

// The cell whose lines are on both sides of `at`, or the outermost one.
std::int64_t Occupancy::cell_of(double low, double cell, std::int64_t count, double at) noexcept {
  const double guess = std::floor((at - low) / cell);
  auto k = static_cast<std::int64_t>(std::min(std::max(guess, 0.0), static_cast<double>(count - 1)));
  while (k + 1 < count && low + static_cast<double>(k + 1) * cell <= at) ++k;
  while (k > 0 && low + static_cast<double>(k) * cell > at) --k;
  return k;
}

// Chebyshev distances between tiles in two passes (Rosenfeld and Pfaltz 1966), exact for this metric.
void Occupancy::measure_tiles() {
  constexpr std::uint16_t far = 65535;
  away_.resize(tiles_.size());
  const auto index = [this](std::int64_t i, std::int64_t j) { return static_cast<std::size_t>(j * tile_columns_ + i); };
  const auto better = [&](std::size_t k, std::int64_t i, std::int64_t j) {
    if (i < 0 || j < 0 || i >= tile_columns_ || j >= tile_rows_) return;
    const std::uint16_t other = away_[index(i, j)];
    if (other != far && other + 1 < away_[k]) away_[k] = static_cast<std::uint16_t>(other + 1);
  };
  for (std::size_t k = 0; k < tiles_.size(); ++k) away_[k] = tiles_[k] != 0 ? 0 : far;
  for (std::int64_t j = 0; j < tile_rows_; ++j)
    for (std::int64_t i = 0; i < tile_columns_; ++i) {
      const std::size_t k = index(i, j);
      better(k, i - 1, j), better(k, i - 1, j - 1), better(k, i, j - 1), better(k, i + 1, j - 1);
    }
  for (std::int64_t j = tile_rows_; j-- > 0;)
    for (std::int64_t i = tile_columns_; i-- > 0;) {
      const std::size_t k = index(i, j);
      better(k, i + 1, j), better(k, i + 1, j + 1), better(k, i, j + 1), better(k, i - 1, j + 1);
    }
}

double Occupancy::clearance(double x, double y) const noexcept {
  if (!any_) return infinity;
  const std::int64_t i = cell_of(x_, cell_, static_cast<std::int64_t>(columns_), x);
  const std::int64_t j = cell_of(y_, cell_, static_cast<std::int64_t>(rows_), y);
  if (occupied(i, j)) {
    const double depth =
        std::min(std::min(x - column_line(i), column_line(i + 1) - x), std::min(y - row_line(j), row_line(j + 1) - y));
    if (depth > 0) return -depth;
  }
  return search_tiles(x, y, i, j);
}

double Occupancy::search_tiles(double x, double y, std::int64_t i, std::int64_t j) const noexcept {
  const std::int64_t tx = i >> 3, ty = j >> 3;
  double best2 = infinity;
  for (std::int64_t ring = away_[static_cast<std::size_t>(ty * tile_columns_ + tx)];; ++ring) {
    const std::int64_t left = tx - ring, right = tx + ring, bottom = ty - ring, top = ty + ring;
    // No cell of this ring or of a later one is nearer than this.
    double nearer = infinity;
    if (left >= 0) nearer = std::min(nearer, x - column_line((left + 1) * 8));
    if (right < tile_columns_) nearer = std::min(nearer, column_line(right * 8) - x);
    if (bottom >= 0) nearer = std::min(nearer, y - row_line((bottom + 1) * 8));
    if (top < tile_rows_) nearer = std::min(nearer, row_line(top * 8) - y);
    if (nearer == infinity || (nearer > 0 && nearer * margin * nearer > best2)) return std::sqrt(best2);
    for (std::int64_t a = std::max<std::int64_t>(left, 0); a <= std::min(right, tile_columns_ - 1); ++a) {
      if (bottom >= 0) search_tile(a, bottom, x, y, i, best2);
      if (top < tile_rows_ && top != bottom) search_tile(a, top, x, y, i, best2);
    }
    for (std::int64_t b = std::max<std::int64_t>(bottom + 1, 0); b <= std::min(top - 1, tile_rows_ - 1); ++b) {
      if (left >= 0) search_tile(left, b, x, y, i, best2);
      if (right < tile_columns_ && right != left) search_tile(right, b, x, y, i, best2);
    }
  }
}

// In each row of a tile only the occupied cells next to column i, to the left and to the right, can be the nearest.
void Occupancy::search_tile(std::int64_t tx, std::int64_t ty, double x, double y, std::int64_t i,
                            double& best2) const noexcept {
  const std::uint64_t bits = tiles_[static_cast<std::size_t>(ty * tile_columns_ + tx)];
  if (bits == 0) return;
  const std::int64_t first = tx * 8, at = std::min<std::int64_t>(std::max<std::int64_t>(i - first, -1), 8);
  for (std::int64_t row = 0; row < 8; ++row) {
    const auto line = static_cast<std::uint32_t>(bits >> (row * 8) & 0xff);
    if (line == 0) continue;
    const std::int64_t j = ty * 8 + row;
    const double dy = std::max(std::max(row_line(j) - y, y - row_line(j + 1)), 0.0);
    const auto try_column = [&](std::int64_t k) {
      const double dx = std::max(std::max(column_line(k) - x, x - column_line(k + 1)), 0.0);
      best2 = std::min(best2, dx * dx + dy * dy);
    };
    const std::uint32_t left = at < 0 ? 0 : line & ((1u << (at + 1)) - 1);
    const std::uint32_t right = at > 7 ? 0 : line >> (at < 0 ? 0 : at);
    if (left != 0) try_column(first + 31 - __builtin_clz(left));
    if (right != 0) try_column(first + (at < 0 ? 0 : at) + __builtin_ctz(right));
  }
}

}  // namespace arena
