// wend plugins list|show: what was found, and what a component takes.  No plugin is loaded.
#include "command.hpp"

#include <core/plugin/schema.hpp>

#include <iostream>

namespace wend::app {
namespace {

using core::ComponentEntry;

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

Json entry_json(const ComponentEntry& entry, const std::string& file) {
  Json slots = Json::object();
  for (const auto& [name, slot] : entry.slots) slots[name] = {{"interface", slot.interface}, {"required", slot.required}, {"summary", slot.summary}};
  Json json = {{"id", entry.id}, {"summary", entry.summary}, {"interfaces", entry.interfaces}, {"slots", slots}, {"uses", entry.uses},
               {"action", entry.action}, {"privileged", entry.privileged}, {"parameters", entry.parameters}, {"file", file}};
  if (!entry.robot.is_null()) json["robot"] = entry.robot;
  return json;
}

int list(const core::Catalog& catalog, bool json) {
  Json all = {{"components", Json::array()}, {"unusable", Json::array()}};
  for (const core::PluginFile& file : catalog.files()) {
    if (!file.problem.empty()) all["unusable"].push_back({{"file", file.path}, {"problem", file.problem}});
    if (!file.manifest) continue;
    if (!json) std::cout << file.manifest->name << " " << file.manifest->version << "  " << file.path << (file.shadowed ? "  (shadowed by " + file.shadowed_by + ")" : "") << "\n";
    for (const ComponentEntry& entry : file.manifest->components) {
      Json row = {{"id", entry.id}, {"role", core::role(entry)}, {"summary", entry.summary}, {"file", file.path}, {"shadowed", catalog.file_of(entry.id) != file.path}};
      if (!json) std::cout << "  " << entry.id << std::string(entry.id.size() < 28 ? 28 - entry.id.size() : 1, ' ') << core::role(entry) << std::string(9 - std::min<std::size_t>(8, core::role(entry).size()), ' ') << entry.summary << "\n";
      all["components"].push_back(std::move(row));
    }
  }
  if (json) {
    std::cout << all.dump(2) << "\n";
    return 0;
  }
  for (const auto& broken : all["unusable"]) std::cout << "unusable: " << broken["file"].get<std::string>() << ": " << broken["problem"].get<std::string>() << "\n";
  if (all["components"].empty()) std::cout << "no plugins found; WEND_PLUGIN_PATH or --plugin-path says where to look\n";
  return 0;
}

void print_schema(const Json& schema, const std::string& indent) {
  if (schema.contains("oneOf")) {
    std::string between;
    for (const Json& branch : schema["oneOf"]) {
      std::cout << between;
      between = indent + "or\n";
      print_schema(branch, indent);
    }
    return;
  }
  if (schema.contains("items")) return print_schema(schema["items"], indent);
  if (!schema.contains("properties")) return;
  for (const auto& [name, property] : schema["properties"].items()) {
    std::cout << indent << name << ": " << core::describe(property) << "\n";
    if (property.contains("description")) std::cout << indent << "    " << property["description"].get<std::string>() << "\n";
    print_schema(property, indent + "    ");
  }
}

int show(const core::Catalog& catalog, const std::string& id, bool json) {
  if (const auto problem = catalog.problem(id)) throw core::Error(Exit::plugin, *problem);
  const ComponentEntry* entry = catalog.find(id);
  if (entry == nullptr) {
    const std::string near = core::did_you_mean(id, catalog.ids());
    throw core::Error(Exit::plugin, "no plugin has a component \"" + id + "\"" + (near.empty() ? "" : ": did you mean \"" + near + "\"?") + "\nwend plugins list shows them all");
  }
  if (json) {
    std::cout << entry_json(*entry, catalog.file_of(id)).dump(2) << "\n";
    return 0;
  }
  std::cout << core::title(*entry) << "\n  " << entry->summary << "\n  file: " << catalog.file_of(id) << "\n  interfaces: " << join(entry->interfaces) << "\n";
  if (entry->privileged) std::cout << "  privileged: it reads the true map\n";
  for (const auto& [name, slot] : entry->slots)
    std::cout << "  slot " << name << ": " << slot.interface << (slot.required ? ", required" : ", optional") << (slot.summary.empty() ? "" : ": " + slot.summary) << "\n";
  for (const auto& [name, interfaces] : entry->uses) std::cout << "  uses " << name << ": " << join(interfaces) << "\n";
  std::cout << "parameters:\n";
  print_schema(entry->parameters, "  ");
  if (!entry->robot.is_null()) {
    std::cout << "robot definition:\n";
    print_schema(entry->robot, "  ");
  }
  return 0;
}

}  // namespace

int plugins(const Arguments& arguments) {
  po::options_description options("options");
  add_common(options);
  const auto values = parse(arguments, "plugins list | plugins show ID", "Lists the plugins that were found, or explains one component and its parameters.", options, {"what"});
  const auto what = values.count("what") ? values["what"].as<std::vector<std::string>>() : std::vector<std::string>{"list"};
  const bool json = values.count("json") > 0;
  if (what.size() == 1 && what[0] == "list") return list(catalog_of(values), json);
  if (what.size() == 2 && what[0] == "show") return show(catalog_of(values), what[1], json);
  throw Usage("expected list or show ID\nusage: wend plugins list | plugins show ID");
}

}  // namespace wend::app
