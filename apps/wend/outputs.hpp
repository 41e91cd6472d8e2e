// What a run directory gets once its cells are done: summary.json, the table, the figures.
#pragma once
#include <core/base/json.hpp>
#include <core/experiment/experiment.hpp>

#include <string>
#include <vector>

namespace wend::app {

// Writes DIR/summary.json and returns it.
core::Json write_summary(const core::Experiment& experiment, const std::string& directory);

// Writes DIR/figures/*.png and returns their paths.
std::vector<std::string> write_figures(const core::Experiment& experiment, const core::Json& summary, const std::string& directory);

// The table and the pictures' paths, to stdout.
void print_outcome(const core::Json& summary, const std::vector<std::string>& pictures, const std::string& directory);

}  // namespace wend::app
