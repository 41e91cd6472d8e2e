// Candidate lists: the plane cut into square cells, each with the few static shapes that can matter for a question
// asked from within it.  Built by halving squares: a square's list is a part of the list of the square around it.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "hits.hpp"

namespace arena {

inline constexpr std::uint32_t most_lanes = 8;
// Up to this many discs are met one after the other by several rays at once; more, several at once by one ray.
inline constexpr std::uint32_t most_in_turn = 24;

// A scene's discs and edges (segments, and the outlines of polygons), and its polygons as wholes.
struct Shapes {
  std::vector<Disc> discs;
  std::vector<Segment> edges;
  std::vector<Polygon> polygons;
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // m, around them all and the scene's bounds

  explicit Shapes(const Scene&);
  std::size_t size() const noexcept { return discs.size() + edges.size(); }
  // How many are within a distance of a point, were they spread evenly.
  double expected(double distance) const noexcept;
  // m, far above the rounding of a hit and far below what matters
  double slack() const noexcept { return 1e-6 * (1 + (x1 - x0) + (y1 - y0)); }
};

class CellLists {
 public:
  struct Cell {
    std::uint32_t disc = 0, discs = 0, edge = 0, edges = 0, polygon = 0, polygons = 0;  // first, count
  };

  CellLists() = default;
  // Per cell all shapes that are within `reach` of one of its points.  No lists (empty() holds) where they would have
  // more than `limit` entries.  Where reach > 0 the discs are in the order of `disc_near`, and more than a few are
  // filled up to whole lanes with some that nothing hits.
  static CellLists within(const Shapes&, double reach, std::size_t limit);
  // Per cell all shapes that are the nearest to one of its points; polygons: those that hold one of its points.
  static CellLists nearest(const Shapes&);

  bool empty() const noexcept { return cells_.empty(); }
  bool holds(double x, double y) const noexcept { return x >= x0_ && y >= y0_ && x < x1_ && y < y1_; }
  const Cell& at(double x, double y) const noexcept {  // of a point that it holds
    const auto column = std::min(static_cast<std::uint32_t>((x - x0_) * per_metre_), columns_ - 1);
    const auto row = std::min(static_cast<std::uint32_t>((y - y0_) * per_metre_), rows_ - 1);
    return cells_[std::size_t{row} * columns_ + column];
  }
  const Cell& cell(std::size_t index) const noexcept { return cells_[index]; }  // row by row
  const Cell& cell(std::uint32_t column, std::uint32_t row) const noexcept {
    return cells_[std::size_t{row} * columns_ + column];
  }
  double x0() const noexcept { return x0_; }
  double y0() const noexcept { return y0_; }
  double x1() const noexcept { return x1_; }
  double y1() const noexcept { return y1_; }
  double cell_size() const noexcept { return size_; }
  double per_metre() const noexcept { return per_metre_; }
  std::uint32_t columns() const noexcept { return columns_; }
  std::uint32_t rows() const noexcept { return rows_; }

  // The lists' entries by value; discs with the square of the radius.
  std::vector<double> disc_x, disc_y, disc_radius2;
  std::vector<double> disc_radius;  // nearest() only
  std::vector<double> disc_near;    // within() a reach only: m, no point of the cell is nearer to this disc
  std::vector<Segment> edges;
  std::vector<std::uint32_t> polygons;

 private:
  struct Builder;
  double x0_ = 0, y0_ = 0, x1_ = 0, y1_ = 0, size_ = 1, per_metre_ = 1;
  std::uint32_t columns_ = 0, rows_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace arena
