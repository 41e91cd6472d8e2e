// The memory of one episode: an occupancy grid that grows with what the robot sees, and for each cell the nearest
// remembered surface point, so that the clearance anywhere costs one look-up and one root.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "percept.hpp"

namespace rolling_window {

class GridMemory {
 public:
  struct Settings {
    double cell = 1;            // m
    double influence = 6;       // m: clearances are known up to here
    double range_noise = 0.02;  // relative standard deviation of readings
    std::size_t most_cells = 1000000;
  };

  GridMemory() = default;
  explicit GridMemory(const Settings& settings);

  void clear() noexcept;  // keeps its storage

  // Enters one scan.  `body`: beams start on the rim of this radius, m.
  void observe(const Percept& percept);

  // Makes the grid cover a box, as far as most_cells allows; otherwise it rolls to be centred there.
  void cover(double x0, double y0, double x1, double y1);

  // m from a point to the nearest remembered surface, at most influence().
  double clearance(double x, double y) const noexcept;
  // The same from a cell's centre.
  double clearance(std::size_t cell) const noexcept;

  // Counts the changes of what is occupied, and of the grid's extent.
  std::uint64_t version() const noexcept { return version_; }
  std::uint64_t extent_version() const noexcept { return extent_version_; }

  bool contains(double x, double y) const noexcept;
  std::size_t cell_at(double x, double y) const noexcept;  // of a point that it contains
  Point centre(std::size_t cell) const noexcept;
  bool occupied(std::size_t cell) const noexcept { return evidence_[cell] > 0; }
  std::size_t columns() const noexcept { return columns_; }
  std::size_t rows() const noexcept { return rows_; }
  std::size_t size() const noexcept { return columns_ * rows_; }
  double cell() const noexcept { return settings_.cell; }
  double influence() const noexcept { return settings_.influence; }

 private:
  static constexpr std::int16_t none = INT16_MIN;
  struct Source {  // offset in cells to the occupied cell whose point is nearest
    std::int16_t dx, dy;
  };
  struct Dot {
    float x, y;  // m, relative to the cell's lower-left corner
  };

  long column_of(double x) const noexcept;  // in the unbounded grid
  long row_of(double y) const noexcept;
  std::size_t index(long column, long row) const noexcept {
    return static_cast<std::size_t>(row - first_row_) * columns_ + static_cast<std::size_t>(column - first_column_);
  }
  bool inside(long column, long row) const noexcept {
    return column >= first_column_ && row >= first_row_ && column < first_column_ + static_cast<long>(columns_) &&
           row < first_row_ + static_cast<long>(rows_);
  }
  void resize(long column0, long row0, long column1, long row1);
  void carve(const Percept& percept, const Beam& beam);
  void mark(const Percept& percept, const Beam& beam);
  void spread(std::size_t from);
  void collect_orphans(std::size_t removed);
  void adopt_orphans();
  double squared_distance(double x, double y, std::size_t at) const noexcept;

  Settings settings_;
  long reach_cells_ = 0;
  long first_column_ = 0, first_row_ = 0;
  std::size_t columns_ = 0, rows_ = 0;
  std::uint64_t version_ = 0, extent_version_ = 0;
  std::vector<std::int8_t> evidence_;  // > 0: occupied
  std::vector<Source> nearest_;
  std::vector<Dot> dots_;
  std::vector<std::size_t> removed_, orphans_;
  std::vector<std::int8_t> old_evidence_;
  std::vector<Source> old_nearest_;
  std::vector<Dot> old_dots_;
};

}  // namespace rolling_window
