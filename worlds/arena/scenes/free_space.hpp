// Where a disc's centre may stand in a scene, on a grid.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../scene.hpp"

namespace arena {

// Cells of the plane, with a border of blocked ones so that neighbours need no test.  A cell is free where the disc,
// centred in it, touches nothing that stands still.  Segments block at least half a cell to either side: they have no
// thickness, and no way may slip through them between two centres.
class FreeSpace {
 public:
  // Covers the scene's bounds; where they are open, a strip around them too, and the points in `also`.
  // Throws wend::Error where that makes more than 16 million cells.
  FreeSpace(const Scene&, double cell, double body_radius, const std::vector<Point>& also = {});

  double cell() const noexcept { return cell_; }
  std::size_t size() const noexcept { return free_.size(); }
  std::ptrdiff_t stride() const noexcept { return static_cast<std::ptrdiff_t>(columns_); }
  const std::uint8_t* cells() const noexcept { return free_.data(); }  // 1 is free
  bool free(std::size_t i) const noexcept { return free_[i] != 0; }

  // The cell that holds a point, or -1 where the point is outside.
  std::ptrdiff_t index(Point) const noexcept;
  Point centre(std::size_t i) const noexcept;

  // Which cells can be reached from a cell: 1 each; none from a blocked one.
  std::vector<std::uint8_t> reachable(std::ptrdiff_t from) const;

  // A point robot fits where its cell is free, and nowhere else; a wider one may fit beside a free cell.
  bool exact() const noexcept { return exact_; }

 private:
  void lay_out(const Scene&, double body_radius, const std::vector<Point>& also);
  void block_walls(const Scene&, double body_radius);
  void block_grid(const Grid&, double body_radius);
  // Blocks the cells of a rectangle whose centre `touches` says the body can't stand at.
  template <class Touches>
  void block(double x0, double y0, double x1, double y1, Touches&& touches);

  double x_ = 0, y_ = 0, cell_ = 1;  // lower-left corner of cell 0, border included
  std::size_t columns_ = 0, rows_ = 0;
  bool exact_ = true;
  std::vector<std::uint8_t> free_;
};

}  // namespace arena
