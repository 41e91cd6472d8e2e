// An occupancy grid as tiles of 8 x 8 bits: rays cell by cell with exact boundaries, and the distance to the nearest
// occupied cell.  Cells are closed squares: what touches a boundary or a corner touches every cell that shares it.
#pragma once
#include <cstdint>
#include <vector>

#include "hits.hpp"

namespace arena {

class Occupancy {
 public:
  Occupancy() = default;
  explicit Occupancy(const Grid&);

  bool empty() const noexcept { return columns_ == 0; }
  // m to the first occupied cell, or something >= reach.
  double cast(const Ray&, double reach) const noexcept;
  // m to the nearest occupied cell; inside one minus the distance to its edge.  Infinite where no cell is occupied.
  double clearance(double x, double y) const noexcept;

 private:
  // One axis of a ray: where it crosses the lines between columns (or rows), and in which order.
  struct Axis {
    double low, cell, from, direction, inverse;
    std::int64_t count;

    double line(std::int64_t k) const noexcept { return low + static_cast<double>(k) * cell; }
    bool still() const noexcept { return direction == 0; }
    double at(std::int64_t k) const noexcept { return (line(k) - from) * inverse; }
    // When the ray enters and leaves cell k.
    double enters(std::int64_t k) const noexcept { return at(direction > 0 ? k : k + 1); }
    double leaves(std::int64_t k) const noexcept { return still() ? infinity : at(direction > 0 ? k + 1 : k); }
    std::int64_t step() const noexcept { return direction > 0 ? 1 : -1; }
    std::int64_t first_at(double t) const noexcept;
    double tile_leaves(std::int64_t k) const noexcept;
  };

  bool occupied(std::int64_t i, std::int64_t j) const noexcept {
    if (static_cast<std::uint64_t>(i) >= columns_ || static_cast<std::uint64_t>(j) >= rows_) return false;
    return (tile(i, j) >> ((j & 7) * 8 + (i & 7)) & 1) != 0;
  }
  std::uint64_t tile(std::int64_t i, std::int64_t j) const noexcept {
    return tiles_[static_cast<std::size_t>(j >> 3) * tile_columns_ + static_cast<std::size_t>(i >> 3)];
  }
  double walk(const Axis& x, const Axis& y, std::int64_t i, std::int64_t j, double start, double reach) const noexcept;
  void measure_tiles();
  double search_tiles(double x, double y, std::int64_t i, std::int64_t j) const noexcept;
  void search_tile(std::int64_t tx, std::int64_t ty, double x, double y, std::int64_t i, double& best2) const noexcept;
  double column_line(std::int64_t k) const noexcept { return x_ + static_cast<double>(k) * cell_; }
  double row_line(std::int64_t k) const noexcept { return y_ + static_cast<double>(k) * cell_; }
  static std::int64_t cell_of(double low, double cell, std::int64_t count, double at) noexcept;

  double x_ = 0, y_ = 0, cell_ = 1;
  std::uint64_t columns_ = 0, rows_ = 0;
  std::int64_t tile_columns_ = 0, tile_rows_ = 0;
  std::vector<std::uint64_t> tiles_;
  std::vector<std::uint16_t> away_;  // per tile: rings of tiles to the nearest that is not empty, at most 65535
  bool any_ = false;
};

}  // namespace arena
