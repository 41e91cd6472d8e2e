// The clearance grid of a row's world: what stands still is measured once a map, what moves is added where it is now.
#pragma once
#include <cstdint>
#include <vector>
#include <wend/refs.hpp>

#include "clearance_grid.hpp"

namespace ga {

class Surroundings {
 public:
  // `cell`: m, or 0 for a third of the body's radius.
  Surroundings(wend::GeometryRef world, std::uint32_t robots, double cell, bool see_robots)
      : world_(world), robots_(robots), cell_(cell), see_robots_(see_robots) {}

  // As they are now.  `scene` and `variant` name the map.
  ClearanceGrid of(std::uint32_t row, std::uint64_t scene, std::uint32_t variant);

 private:
  struct Map {
    std::uint64_t scene;
    std::uint32_t variant;
    ClearanceGrid grid;
  };
  const ClearanceGrid& still(std::uint32_t row, std::uint64_t scene, std::uint32_t variant, const Area& area,
                             double cell);
  ClearanceGrid measured(std::uint32_t row, const Area& area, double cell) const;
  Area area(std::uint32_t row) const;

  static constexpr std::size_t most_maps = 16;
  wend::GeometryRef world_;
  std::uint32_t robots_;
  double cell_;
  bool see_robots_;
  std::vector<Map> maps_;
  std::size_t oldest_ = 0;
};

}  // namespace ga
