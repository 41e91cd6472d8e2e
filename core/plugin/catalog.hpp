// All plugins on the search path, known from their manifests alone: nothing is loaded here.
#pragma once
#include <core/plugin/manifest.hpp>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace wend::core {

struct PluginFile {
  std::string path;                  // absolute
  std::optional<Manifest> manifest;  // nothing where the file is unusable
  std::string problem;               // why it is, or why one of its components is; else empty
  bool shadowed = false;             // earlier directories have all of its components
  std::string shadowed_by;           // the first file that takes the place of one of its components, if any
};

class Catalog {
 public:
  // The plugins in `directories` (or single .so files), an earlier one before a later one.
  static Catalog search(const std::vector<std::string>& directories);

  // Plugins whose manifests are known otherwise, as if all were files of one directory.
  static Catalog of(std::vector<Manifest> manifests);

  const std::vector<PluginFile>& files() const { return files_; }  // in search order, sorted by name within a directory

  // nullptr where no usable plugin has it, or where problem() says why it is unusable.
  const ComponentEntry* find(const std::string& id) const;
  std::string file_of(const std::string& id) const;  // empty where find() is nullptr

  // Sorted; with `interface` only those that answer for it.
  std::vector<std::string> ids(std::string_view interface = {}) const;

  // Why a component that is there cannot be used: two files of one directory have it.
  std::optional<std::string> problem(const std::string& id) const;

 private:
  struct Owner {
    std::size_t file = 0, component = 0;
    std::string problem;
  };
  void add_directory(const std::string& directory, std::set<std::string>& seen);
  void add_file(const std::string& path);
  void register_components(std::size_t first);

  std::vector<PluginFile> files_;
  std::map<std::string, Owner> owners_;
};

// Where plugins are looked for: the command line's --plugin-path entries, WEND_PLUGIN_PATH (separated by colons),
// $XDG_DATA_HOME/wend/plugins, and the folder of the build tree or the installation that the program runs from.
// Standard places that do not exist are left out.
std::vector<std::string> search_path(const std::vector<std::string>& from_command_line);

}  // namespace wend::core
