// What stands still in a scene, made fast to ask: the first surface on a ray, and the distance to the nearest one.
// Every answer has the bits that testing all shapes would give: each hit is one expression and min has no order.
#pragma once
#include <memory>
#include <vector>

#include "cells.hpp"
#include "occupancy.hpp"

namespace arena {

class StaticMap {
 public:
  explicit StaticMap(ScenePtr);

  const Scene& scene() const noexcept { return *scene_; }
  const ScenePtr& pointer() const noexcept { return scene_; }

  // Gets ready for rays of this reach, which are then answered faster.  Not while others ask.
  void prepare(double reach);

  // m to the first obstacle on the ray, if less than `reach`; else something >= reach.
  double cast(const Ray& ray, double reach) const noexcept { return cast(ray, reach, lists_for(reach)); }
  // The same, with the lists that lists_for() has found for this reach or a longer one.
  double cast(const Ray&, double reach, const CellLists*) const noexcept;
  const CellLists* lists_for(double reach) const noexcept;
  // m to the wall around the bounds; infinite without one.
  double cast_wall(const Ray& ray) const noexcept {
    return scene_->walled ? hit_bounds(ray, x0_, y0_, x1_, y1_) : infinity;
  }
  // The bounds, infinite where they are no walls.
  void bounds(double& x0, double& y0, double& x1, double& y1) const noexcept {
    const bool walled = scene_->walled;
    x0 = walled ? x0_ : -infinity, y0 = walled ? y0_ : -infinity;
    x1 = walled ? x1_ : infinity, y1 = walled ? y1_ : infinity;
  }
  // m to the nearest obstacle, negative inside; infinite without any.
  double clearance(double x, double y) const noexcept;
  double clearance_wall(double x, double y) const noexcept {
    return scene_->walled ? from_bounds(x, y, x0_, y0_, x1_, y1_) : infinity;
  }

 private:
  struct Reach {
    double reach;
    CellLists lists;  // empty: too many candidates
  };
  double cast_short(const CellLists&, const Ray&, double reach) const noexcept;
  double cast_long(const Ray&, double reach) const noexcept;
  double cast_list(const CellLists&, const CellLists::Cell&, const Ray&, double best) const noexcept;
  double clearance_all(double x, double y) const noexcept;
  bool in_polygon(const CellLists&, const CellLists::Cell&, double x, double y) const noexcept;

  ScenePtr scene_;
  double x0_, y0_, x1_, y1_;  // the scene's bounds
  Shapes shapes_;
  Occupancy occupancy_;
  CellLists touched_;  // per cell what it touches, for rays of any length
  CellLists nearest_;
  std::vector<Reach> reaches_;  // ascending
};

}  // namespace arena
