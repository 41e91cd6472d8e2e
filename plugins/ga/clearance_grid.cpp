#include "clearance_grid.hpp"

#include <algorithm>
#include <cmath>

namespace ga {
namespace {

constexpr float far_away = 1e6f;  // m: stands for infinite, which cannot be interpolated

// Lattice lines along a side.
std::size_t lines(double side, double cell) {
  return std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(side / cell)) + 1);
}

}  // namespace

ClearanceGrid::ClearanceGrid(const Area& area, double cell)
    : area_(area),
      cell_(cell),
      per_cell_(1 / cell),
      columns_(lines(area.x1 - area.x0, cell)),
      rows_(lines(area.y1 - area.y0, cell)),
      last_column_((static_cast<double>(columns_) - 1) * (1 - 1e-12)),
      last_row_((static_cast<double>(rows_) - 1) * (1 - 1e-12)),
      values_(columns_ * rows_, far_away) {}

void ClearanceGrid::set(std::size_t first, std::span<const double> clearance) noexcept {
  for (std::size_t k = 0; k < clearance.size(); ++k)
    values_[first + k] = static_cast<float>(std::min(clearance[k], static_cast<double>(far_away)));
}

void ClearanceGrid::add(const wend_disc& disc) noexcept {
  for (std::size_t j = 0; j < rows_; ++j) {
    const double dy = area_.y0 + cell_ * static_cast<double>(j) - disc.y, dy2 = dy * dy;
    float* row = values_.data() + j * columns_;
    for (std::size_t i = 0; i < columns_; ++i) {
      const double dx = area_.x0 + cell_ * static_cast<double>(i) - disc.x;
      row[i] = std::min(row[i], static_cast<float>(std::sqrt(dx * dx + dy2) - disc.radius));
    }
  }
}

double ClearanceGrid::length_within(Point a, Point b, double needed) const noexcept {
  const Point way[] = {a, b};
  return length_within(way, needed);
}

// Clearance changes by no more than the way, so from a place that has something to spare, or lacks something, a step of
// so much stays on the same side.  Steps are no shorter than a cell; in between, clearance counts as linear.
double ClearanceGrid::length_within(std::span<const Point> way, double needed) const noexcept {
  struct Walk {
    Point at, direction;
    double left, spare;  // m
  };
  constexpr std::size_t most = 16;
  Walk walks[most];
  double within = 0;
  for (std::size_t first = 1; first < way.size(); first += most) {
    std::size_t n = 0;
    for (std::size_t k = first; k < std::min(first + most, way.size()); ++k) {
      const double dx = way[k].x - way[k - 1].x, dy = way[k].y - way[k - 1].y, length = std::sqrt(dx * dx + dy * dy);
      const double spare = at(way[k - 1].x, way[k - 1].y) - needed;
      if (length > 0) walks[n++] = {way[k - 1], {dx / length, dy / length}, length, spare};
    }
    while (n > 0) {
      for (std::size_t k = 0; k < n; ++k) {
        Walk& walk = walks[k];
        const double step = std::min(std::max(std::fabs(walk.spare), cell_), walk.left);
        walk.at.x += step * walk.direction.x, walk.at.y += step * walk.direction.y;
        walk.left -= step;
        const double spare = at(walk.at.x, walk.at.y) - needed;
        if (walk.spare < 0 || spare < 0) {
          const double lacking = std::min(walk.spare, 0.0) + std::min(spare, 0.0);
          within -= step * (lacking / (std::fabs(walk.spare) + std::fabs(spare)));
        }
        walk.spare = spare;
      }
      for (std::size_t k = n; k-- > 0;)
        if (!(walks[k].left > 0)) walks[k] = walks[--n];
    }
  }
  return within;
}

}  // namespace ga
