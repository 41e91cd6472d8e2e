// PNG files from display lists, through the program wend-render: it alone needs an imaging library.
#pragma once
#include <core/figure/display.hpp>
#include <string>
#include <utility>
#include <vector>

namespace wend::core {

struct RenderOptions {
  double scale = 2;     // pixels of the picture per pixel of the figure
  std::string program;  // empty: wend-render beside the running program
  int patience = 120;   // s for one picture, then the program is ended
};

// Writes each figure to its path, making folders as needed; a file is whole or not there.
// Throws Error(Exit::data) with wend-render's message at the first picture that fails.
void render_png(const std::vector<std::pair<std::string, Figure>>& pictures, const RenderOptions& options = {});

}  // namespace wend::core
