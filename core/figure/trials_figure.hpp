// The trials of a training on one map: those that failed and those that did not, told apart by colour, dash and marker.
#pragma once
#include <core/record/trace.hpp>
#include <core/figure/display.hpp>
#include <string>
#include <vector>

namespace wend::core {

Figure trials_figure(const std::vector<const Trace*>& trials, const std::string& title);

}  // namespace wend::core
