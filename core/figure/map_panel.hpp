// One map with its robots' ways: the part that a picture of one map and a grid of maps have in common.
#pragma once
#include <core/figure/display.hpp>
#include <core/figure/outcome.hpp>
#include <core/figure/style.hpp>
#include <core/record/trace.hpp>
#include <optional>
#include <string>
#include <vector>

namespace wend::core {

struct MapArm {
  std::string label;
  const Trace* trace = nullptr;  // borrowed while the figure is made
  std::size_t style = 0;         // which line_style; the same in all pictures of an experiment
  bool privileged = false;
  std::optional<LineStyle> own_style;  // instead

  LineStyle line() const { return own_style ? *own_style : line_style(style); }
};

// From metres, y up, to pixels, y down, with the same scale on both axes.
struct MapView {
  Box world;         // m: lower-left corner and size
  Box page;          // px
  double scale = 1;  // px / m

  Place operator()(double x, double y) const {
    return {page.x + (x - world.x) * scale, page.bottom() - (y - world.y) * scale};
  }
};

// What must be seen: shapes, movers, starts, goals and ways.  A way that leads far off the map is cut.
Box map_bounds(const std::vector<MapArm>& arms);

// The page's box is `longest` px along the longer side of `world`, which is widened to an aspect in [low, high].
MapView fit_map(Box world, Place corner, double longest, double low_aspect, double high_aspect);
MapView fit_map_height(Box world, Place corner, double height, double low_aspect, double high_aspect);

// The map and everything on it, clipped to view.page.
void add_map(Figure& figure, const MapView& view, const std::vector<MapArm>& arms);

// A bar of round length, at most `room` px, with its label right of it; `at` is its left end.  Returns its length in m.
double add_scale_bar(Figure& figure, const MapView& view, Place at, double room);

}  // namespace wend::core
