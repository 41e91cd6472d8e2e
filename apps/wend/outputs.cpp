#include "outputs.hpp"

#include <core/base/files.hpp>
#include <core/figure/figures.hpp>
#include <core/figure/render.hpp>
#include <core/record/store.hpp>
#include <core/stats/summary.hpp>
#include <core/stats/table.hpp>

#include <filesystem>
#include <iostream>

namespace wend::app {
namespace {

// What was recorded of trainings and cells, in the order of the plan.
std::vector<core::Trace> read_traces(const core::Experiment& experiment, const std::string& directory) {
  const core::Store store(directory, true);
  std::vector<core::Trace> traces;
  for (const core::Training& training : experiment.trainings()) {
    if (training.traced_episodes == 0) continue;
    const auto result = store.training(training.id);
    if (!result) continue;
    for (const auto& [episode, file] : result->traces) traces.push_back(core::read_trace(directory + "/traces/" + file));
  }
  for (const core::Cell& cell : experiment.cells()) {
    if (cell.traced_episodes == 0) continue;
    const auto result = store.cell(cell.id);
    if (!result) continue;
    for (const auto& [episode, file] : result->traces) traces.push_back(core::read_trace(directory + "/traces/" + file));
  }
  return traces;
}

}  // namespace

core::Json write_summary(const core::Experiment& experiment, const std::string& directory) {
  const core::Store store(directory, true);
  std::vector<core::Training> trainings;
  std::vector<core::Cell> cells;
  for (core::Training training : experiment.trainings()) trainings.push_back(std::move(training));
  for (core::Cell cell : experiment.cells()) cells.push_back(std::move(cell));
  core::Json summary = core::summarize(experiment.name, trainings, cells, store);
  core::write_file(directory + "/summary.json", summary.dump(2, ' ', false, core::Json::error_handler_t::replace) + "\n");
  return summary;
}

std::vector<std::string> write_figures(const core::Experiment& experiment, const core::Json& summary, const std::string& directory) {
  const auto figures = core::figures_of(summary, read_traces(experiment, directory), experiment.figures);
  std::vector<std::pair<std::string, core::Figure>> pictures;
  std::vector<std::string> paths;
  for (const auto& [name, figure] : figures) {
    paths.push_back(directory + "/figures/" + name + ".png");
    pictures.emplace_back(paths.back(), figure);
  }
  core::make_directories(directory + "/figures");
  core::render_png(pictures);
  return paths;
}

void print_outcome(const core::Json& summary, const std::vector<std::string>& pictures, const std::string& directory) {
  std::cout << core::table(summary) << "\nsummary:  " << directory << "/summary.json\n";
  if (!pictures.empty()) std::cout << "pictures: " << directory << "/figures (" << pictures.size() << ")\n";
}

}  // namespace wend::app
