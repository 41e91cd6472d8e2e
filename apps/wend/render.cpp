// wend render DIR: the pictures of a run again, from its traces; nothing is simulated.
#include "command.hpp"
#include "outputs.hpp"

#include <core/base/files.hpp>

#include <iostream>

namespace wend::app {

int render(const Arguments& arguments) {
  po::options_description options("options");
  add_common(options);
  const auto values = parse(arguments, "render DIR [--json]", "Makes the summary, the table and the pictures of a run directory again; nothing is simulated.", options, {"directory"});
  if (!values.count("directory") || values["directory"].as<std::vector<std::string>>().size() != 1) throw Usage("expected one run directory\nusage: wend render DIR");
  const std::string directory = values["directory"].as<std::vector<std::string>>().front();
  const core::Catalog catalog = catalog_of(values);
  const core::Experiment experiment = load(directory + "/experiment.resolved.json", catalog, values);
  const Json summary = write_summary(experiment, directory);
  const auto pictures = write_figures(experiment, summary, directory);
  if (values.count("json")) std::cout << Json{{"pictures", pictures}}.dump(2) << "\n";
  else for (const std::string& picture : pictures) std::cout << picture << "\n";
  return 0;
}

}  // namespace wend::app
