// Legends: which line is which arm, what the signs on a map mean.
#pragma once
#include <core/figure/map_panel.hpp>
#include <string>
#include <vector>

namespace wend::core {

struct LegendLine {
  LineStyle style;
  std::string label;
  bool privileged = false;
  std::optional<Ending> ending;  // with a second row: its marker and `note`
  std::string note;
};

double legend_width(const std::vector<LegendLine>& lines);
double legend_height(const std::vector<LegendLine>& lines);

// One below the other; `at` is the upper left corner, `width` what they may take.
void add_legend(std::vector<Item>& items, const std::vector<LegendLine>& lines, Place at, double width);

// Side by side in as many rows as it takes; returns the height.  `items` may be null, to measure.
double add_legend_row(std::vector<Item>* items, const std::vector<LegendLine>& lines, Place at, double width);

// Start, goal and movers as far as the traces have them, and the given end markers, side by side in rows.
double add_map_key(std::vector<Item>* items, const std::vector<MapArm>& arms, const std::vector<Ending>& endings,
                   Place at, double width);

}  // namespace wend::core
