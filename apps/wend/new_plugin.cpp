// wend new plugin NAME: copies the template and puts the name in.
#include "command.hpp"

#include <core/base/files.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>

namespace wend::app {
namespace {

namespace fs = std::filesystem;

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) text.replace(at, what.size(), with);
  return text;
}

// "wall_follower" -> "WallFollower"
std::string class_name(const std::string& name) {
  std::string text;
  bool upper = true;
  for (const char c : name) {
    if (c == '_' || c == '-') {
      upper = true;
      continue;
    }
    text += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    upper = false;
  }
  return text;
}

void check_name(const std::string& name) {
  const bool good = !name.empty() && std::islower(static_cast<unsigned char>(name.front())) && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::islower(c) || std::isdigit(c) || c == '_';
  });
  if (!good) throw Usage("expected a name of lower-case letters, digits and _ that begins with a letter, found \"" + name + "\"");
}

}  // namespace

int new_plugin(const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()("dir", po::value<std::string>()->value_name("DIR"), "where to put it (default: ./NAME)")("json", "machine-readable output");
  const auto values = parse(arguments, "new plugin NAME [--dir DIR]", "Makes a folder with a policy of your own, its manifest, its build file and an experiment to try it in.", options, {"what"});
  const auto what = values.count("what") ? values["what"].as<std::vector<std::string>>() : std::vector<std::string>{};
  if (what.size() != 2 || what[0] != "plugin") throw Usage("expected plugin NAME\nusage: wend new plugin NAME [--dir DIR]");
  const std::string& name = what[1];
  check_name(name);
  const fs::path target = values.count("dir") ? values["dir"].as<std::string>() : name;
  if (fs::exists(target) && !fs::is_empty(target)) throw core::Error(Exit::data, target.string() + " is there already and not empty: name another place with --dir");

  const fs::path source = share_directory("template");
  Json written = Json::array();
  for (const auto& entry : fs::recursive_directory_iterator(source)) {
    if (!entry.is_regular_file()) continue;
    const fs::path file = target / replaced(fs::relative(entry.path(), source).string(), "NAME", name);
    core::make_directories(file.parent_path());
    core::write_file(file, replaced(replaced(core::read_file(entry.path()), "@NAME@", name), "@CLASS@", class_name(name)));
    written.push_back(file.string());
  }
  std::sort(written.begin(), written.end());
  if (values.count("json")) {
    std::cout << Json{{"plugin", name}, {"files", written}}.dump(2) << "\n";
    return 0;
  }
  for (const auto& file : written) std::cout << "  " << file.get<std::string>() << "\n";
  std::cout << "\nbuild it and try it:\n  cmake -S " << target.string() << " -B " << (target / "build").string() << " && cmake --build " << (target / "build").string() << "\n  wend run "
            << (target / "try.json").string() << " --plugin-path " << (target / "build").string() << " --out runs/" << name << "\n";
  return 0;
}

}  // namespace wend::app
