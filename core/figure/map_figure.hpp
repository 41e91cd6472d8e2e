// Pictures of maps: all arms on one map, and a grid of such maps.
#pragma once
#include <core/figure/legend.hpp>
#include <string>
#include <vector>

namespace wend::core {

// One map, its title above, the scale bar below, the legend with outcomes beside it or, where the map is wide, below.
Figure map_figure(const std::vector<MapArm>& arms, const std::string& title);

// The same with a legend of its own, and the meaning of the end markers below it.
Figure map_figure(const std::vector<MapArm>& arms, const std::vector<LegendLine>& legend, const std::string& title);

struct MapPanel {
  std::string title;
  std::vector<MapArm> arms;
};

// Several maps, each to its own scale with its own bar, and one legend.  Below each map stand its arms' end markers in
// the legend's order or, if there is only one arm, its outcome in words.
Figure map_grid(const std::vector<MapPanel>& panels, const std::string& title);

}  // namespace wend::core
