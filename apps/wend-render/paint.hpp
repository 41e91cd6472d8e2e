// A display list painted as PNG.
#pragma once
#include <core/figure/display.hpp>
#include <vector>

#include "font.hpp"

namespace wend::render {

constexpr double largest_side = 20000, most_pixels = 1e8;

// Throws Error(Exit::data) where the picture would be larger than the limits above.
Canvas paint(const core::Figure& figure, double scale, Fonts& fonts);

}  // namespace wend::render
