// The length of the shortest way on a grid of eight neighbours, without cutting corners: what SPL is measured against.
#pragma once
#include <memory>
#include <vector>

#include "free_space.hpp"

namespace arena {

struct OptimalOptions {
  double cell = 1;         // m
  double body_radius = 0;  // m
  double goal_radius = 0;  // m: the way ends where the centre of a cell lies within it; 0: at the goal itself
};

// Distances to one goal from everywhere.  Between the goal's cell and a start's the way runs through centres of cells;
// its two ends are straight legs to the points themselves, so that a start between centres is not rounded.
class DistanceField {
 public:
  DistanceField(std::shared_ptr<const FreeSpace>, Point goal, double goal_radius = 0);

  // m from `start` to the goal; negative where no way leads there, or where the body does not fit at the start.
  double length(Point start) const noexcept;

 private:
  std::shared_ptr<const FreeSpace> space_;
  Point goal_;
  double goal_radius_;
  std::vector<double> steps_;  // cells, per cell of the space; infinite where unreachable
};

// One start; negative if unreachable.  For many starts on one map build the FreeSpace and the DistanceField once.
double optimal_length(const Scene&, Point start, Point goal, OptimalOptions);

// A cell that resolves the scene for this body: the grid's own, a third of the body, or 1/200 of a point robot's arena.
double suitable_cell(const Scene&, double body_radius) noexcept;

}  // namespace arena
