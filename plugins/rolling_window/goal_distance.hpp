// The cost of the best known way from any cell to the goal: A* backwards over the memory, 8-connected, no corner
// cutting, unknown cells free.  It goes on only as far as it is asked (reverse resumable A*, Silver 2005), so that one
// search serves the path of the robot, the window's h(p) and the heuristic of the turn-radius planner.
#pragma once
#include <cstdint>
#include <vector>

#include "grid_memory.hpp"
#include "passage.hpp"

namespace rolling_window {

class GoalDistance {
 public:
  // Starts anew.  The goal's cells are those within `goal_radius` of it; `slack` as in Passage::factor.
  void begin(const GridMemory& memory, const Passage& passage, Point goal, double goal_radius, Point robot,
             double slack);

  // m (weighted by clearance) from a cell's centre to the goal; infinite where there is no way.
  double cost(std::size_t cell);
  double cost(double x, double y) { return memory_->contains(x, y) ? cost(memory_->cell_at(x, y)) : Passage::infinite; }

  // Cell centres from `from` to the goal's first cell; false where there is no way.
  bool path(Point from, std::vector<Point>& out);

  std::uint64_t expanded() const noexcept { return expanded_; }

 private:
  struct Entry {
    float f;
    std::uint32_t cell;
  };
  void open(std::uint32_t cell, float g, std::uint8_t direction);
  void expand(std::uint32_t cell);
  float factor(std::uint32_t cell);
  float heuristic(std::uint32_t cell) const noexcept;
  void refresh(std::uint32_t cell);

  const GridMemory* memory_ = nullptr;
  Passage passage_;
  double slack_ = 0;
  long target_column_ = 0, target_row_ = 0;
  std::uint32_t generation_ = 0;
  std::uint64_t expanded_ = 0;
  struct Node {
    std::uint32_t generation = 0;
    float g = 0, factor = -1;
    std::uint8_t direction = 0, closed = 0;
  };
  std::vector<Node> nodes_;
  std::vector<Entry> heap_;
};

}  // namespace rolling_window
