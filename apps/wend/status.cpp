// wend status DIR: what is done, what failed and why, read beside a run or after it.
#include "command.hpp"

#include <core/base/files.hpp>
#include <core/record/store.hpp>

#include <iostream>

namespace wend::app {
namespace {

std::string unit_name(const core::Store& store, const std::string& id) {
  const auto description = store.description(id);
  if (!description) return id.substr(0, 12);
  const Json& d = *description;
  std::string text = d.contains("driver") ? d["driver"].value("arm", "?") : "?";
  if (d.contains("world")) text += " @ " + d["world"].value("id", "?") + ", variant " + std::to_string(d.value("variant", 0));
  else if (d.contains("worlds") && !d["worlds"].empty()) text += " @ " + d["worlds"][0].value("id", "?");
  const Json& stream = d.contains("stream") ? d["stream"] : d.contains("streams") && !d["streams"].empty() ? d["streams"][0] : Json::object();
  return text + ", seed " + std::to_string(stream.value("seed", std::uint64_t{0}));
}

}  // namespace

int status(const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()("json", "machine-readable output");
  const auto values = parse(arguments, "status DIR [--json]", "What is done in a run directory, and what failed and why.", options, {"directory"});
  if (!values.count("directory") || values["directory"].as<std::vector<std::string>>().size() != 1) throw Usage("expected one run directory\nusage: wend status DIR");
  const std::string directory = values["directory"].as<std::vector<std::string>>().front();
  const core::Store store(directory, true);
  Json all = {{"directory", directory}, {"trainings", {{"done", store.done(core::UnitKind::training).size()}}}, {"cells", {{"done", store.done(core::UnitKind::cell).size()}}}, {"failures", Json::array()}};
  for (const auto& [kind, name] : {std::pair{core::UnitKind::training, "training"}, std::pair{core::UnitKind::cell, "cell"}}) {
    const auto failed = store.failed(kind);
    all[std::string(name) + "s"]["failed"] = failed.size();
    for (const auto& [id, unit] : failed)
      all["failures"].push_back({{"unit", name}, {"id", id}, {"what", unit_name(store, id)}, {"cause", unit.failure.cause}, {"message", unit.failure.message}, {"attempts", unit.attempts}});
  }
  try {
    const Json summary = Json::parse(core::read_file(directory + "/summary.json"));
    all["cells"]["planned"] = summary.at("cells").at("planned");
  } catch (const std::exception&) {
    all["cells"]["planned"] = nullptr;  // no summary yet: the run was cut short
  }
  if (values.count("json")) {
    std::cout << all.dump(2) << "\n";
    return 0;
  }
  std::cout << directory << "\n  cells      " << all["cells"]["done"] << " done, " << all["cells"]["failed"] << " failed";
  if (!all["cells"]["planned"].is_null()) std::cout << ", of " << all["cells"]["planned"];
  std::cout << "\n  trainings  " << all["trainings"]["done"] << " done, " << all["trainings"]["failed"] << " failed\n";
  for (const Json& failure : all["failures"])
    std::cout << "  failed " << failure["unit"].get<std::string>() << " " << failure["what"].get<std::string>() << " (" << failure["attempts"] << "x)\n    " << failure["cause"].get<std::string>() << ": " << failure["message"].get<std::string>() << "\n";
  return 0;
}

}  // namespace wend::app
