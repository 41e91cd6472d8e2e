// What charts have in common: frame, grid lines, ticks and titles of axes.
#pragma once
#include <core/figure/axis.hpp>
#include <core/figure/display.hpp>
#include <string>
#include <vector>

namespace wend::core {

void add_x_axis(std::vector<Item>& items, const Box& plot, const Axis& axis, const std::string& title,
                bool grid = false);
void add_y_axis(std::vector<Item>& items, const Box& plot, const Axis& axis, const std::string& title);

}  // namespace wend::core
