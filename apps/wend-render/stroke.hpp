// From lines with a pen to the polygons that cover them.
#pragma once
#include <core/figure/display.hpp>
#include <vector>

namespace wend::render {

using Polygon = std::vector<core::Place>;

// The drawn stretches of a line: itself if the pen has no dash.  A closed line returns to its first point.
std::vector<Polygon> dashes(const std::vector<core::Place>& line, bool closed, const std::vector<double>& pattern);

// Convex polygons that together cover what a pen of `width` and this cap touches; joins are round.
std::vector<Polygon> stroke(const std::vector<core::Place>& line, double width, core::Cap cap);

// A circle as a polygon within 0.02 px.
Polygon circle(core::Place centre, double radius);

}  // namespace wend::render
