// What stands and drives on one map, as items of a display list.
#pragma once
#include <core/figure/map_panel.hpp>
#include <vector>

namespace wend::core {

class MapScene {
 public:
  MapScene(std::vector<Item>& items, const MapView& view, int clip) : items_(items), view_(view), clip_(clip) {}

  enum class Layer { seam, line };  // all seams lie below all lines

  void add_shape(const TraceShape& shape) const;
  void add_movers(const Trace& trace) const;
  void add_goals(const Trace& trace) const;
  void add_goal_rings(const Trace& trace) const;
  void add_way(const MapArm& arm, Layer layer) const;
  void add_starts(const std::vector<MapArm>& arms) const;
  void add_body(const MapArm& arm) const;
  void add_ending(const MapArm& arm) const;

 private:
  void add_grid(const TraceShape& shape) const;
  void add_disc(double x, double y, double radius, std::optional<Colour> fill, const Pen& pen, double least = 0) const;
  void add_number(Place at, std::uint32_t robot, Colour colour) const;
  std::vector<Place> way_of(const std::vector<double>& values, std::size_t column, std::size_t columns,
                            std::size_t count) const;

  std::vector<Item>& items_;
  const MapView& view_;
  int clip_;
};

}  // namespace wend::core
