// What stands still in a scene, made fast to ask: the first surface on a ray, and the distance to the nearest one.
// Every answer has the bits that testing all shapes would give: each hit is one expression and min has no order.
#pragma once
#include <memory>
#include <vector>

#include "lanes.hpp"
#include "occupancy.hpp"

namespace arena {

class StaticMap {
 public:
  explicit StaticMap(ScenePtr);

  const Scene& scene() const noexcept { return *scene_; }
  const ScenePtr& pointer() const noexcept { return scene_; }

  bool empty() const noexcept { return shapes_.size() == 0 && occupancy_.empty(); }

  // Gets ready for rays of this reach, which are then answered faster.  Not while others ask.
  void prepare(double reach);

  // m to the first obstacle on the ray, if less than `reach`; else something >= reach.
  double cast(const Ray&, double reach) const noexcept;
  // The same of a block of rays: hit, where best is the reach of each, none above `reach`.
  void cast(const Kernels&, Rays&, double reach) const noexcept;
  // m to the wall around the bounds; infinite without one.
  double cast_wall(const Ray& ray) const noexcept {
    return scene_->walled ? hit_bounds(ray, x0_, y0_, x1_, y1_) : infinity;
  }
  // The bounds, where they are walls.
  bool walled() const noexcept { return scene_->walled; }
  Bounds bounds() const noexcept { return {x0_, y0_, x1_, y1_}; }
  // m to the nearest obstacle, negative inside; infinite without any.
  double clearance(double x, double y) const noexcept;
  double clearance_wall(double x, double y) const noexcept {
    return scene_->walled ? from_bounds(x, y, x0_, y0_, x1_, y1_) : infinity;
  }

 private:
  struct Reach {
    double reach;   // m, of the rays
    double listed;  // m, of the lists: less where the full reach would have too many candidates
    CellLists lists;
  };
  const Reach* lists_for(double reach) const noexcept;
  // From `start` m on, before which there is nothing.
  double cast_long(const Ray&, double reach, double start = 0) const noexcept;
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
