// How far the points of a rectangle are from what a body must not touch, and how much of a way comes too near to it.
#pragma once
#include <wend/abi.h>

#include <cstddef>
#include <span>
#include <vector>

namespace ga {

struct Point {
  double x, y;
};

struct Area {
  double x0, y0, x1, y1;
  bool operator==(const Area&) const = default;
};

// Clearance, m, on a lattice that covers an area; between its points it is interpolated bilinearly.
class ClearanceGrid {
 public:
  ClearanceGrid() = default;
  // Every value is infinite.  `cell` is the lattice's spacing, m.
  ClearanceGrid(const Area& area, double cell);

  const Area& area() const noexcept { return area_; }
  double cell() const noexcept { return cell_; }
  std::size_t columns() const noexcept { return columns_; }
  std::size_t rows() const noexcept { return rows_; }
  Point lattice_point(std::size_t k) const noexcept {
    return {area_.x0 + cell_ * static_cast<double>(k % columns_), area_.y0 + cell_ * static_cast<double>(k / columns_)};
  }
  // Values by row, the lowest first; what is infinite is kept as a large number.
  void set(std::size_t first, std::span<const double> clearance) noexcept;
  // Takes a disc into account.
  void add(const wend_disc& disc) noexcept;

  // m; beyond the area as at its edge.
  double at(double x, double y) const noexcept {
    const double u = position(x, area_.x0, last_column_), v = position(y, area_.y0, last_row_);
    const int i = static_cast<int>(u), j = static_cast<int>(v);
    const double s = u - i, t = v - j;
    const float* low = values_.data() + static_cast<std::size_t>(j) * columns_ + static_cast<std::size_t>(i);
    const float* high = low + columns_;
    const double below = static_cast<double>(low[0]) + s * (static_cast<double>(low[1]) - static_cast<double>(low[0]));
    const double above =
        static_cast<double>(high[0]) + s * (static_cast<double>(high[1]) - static_cast<double>(high[0]));
    return below + t * (above - below);
  }

  // m of the straight way from `a` to `b` on which the clearance is below `needed`.
  double length_within(Point a, Point b, double needed) const noexcept;
  // The same of a way of several legs, in all of which it walks side by side.
  double length_within(std::span<const Point> way, double needed) const noexcept;

 private:
  double position(double at, double origin, double last) const noexcept {
    const double p = (at - origin) * per_cell_;
    return p > 0 ? (p < last ? p : last) : 0;
  }

  Area area_{};
  double cell_ = 1, per_cell_ = 1;
  std::size_t columns_ = 0, rows_ = 0;
  double last_column_ = 0, last_row_ = 0;  // just below the last lattice line
  std::vector<float> values_;
};

}  // namespace ga
