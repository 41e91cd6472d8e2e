// Fewer points for the same picture.
#pragma once
#include <core/figure/display.hpp>
#include <vector>

namespace wend::core {

// Keeps the first and the last point and stays within `tolerance` px of the line (Ramer, Douglas and Peucker, in
// stretches of bounded length, so the work is linear).  Points that are not finite are left out.
std::vector<Place> simplified(const std::vector<Place>& line, double tolerance);

}  // namespace wend::core
