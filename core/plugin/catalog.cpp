#include <algorithm>
#include <core/base/diagnostics.hpp>
#include <core/base/error.hpp>
#include <core/base/files.hpp>
#include <core/plugin/catalog.hpp>
#include <core/plugin/elf.hpp>
#include <cstdlib>
#include <filesystem>
#include <set>

namespace wend::core {
namespace {

namespace fs = std::filesystem;

// Without a slash at the end, ".." or ".", so that messages and provenance name a place in one way only.
std::string absolute(const std::string& path) {
  std::error_code error;
  fs::path whole = fs::absolute(path, error).lexically_normal();
  if (error) return path;
  if (!whole.has_filename() && whole.has_parent_path()) whole = whole.parent_path();
  return whole.string();
}

// The same file under another name, or a directory that is on the path twice, counts once.
std::string identity(const std::string& path) {
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  return error ? path : real.string();
}

PluginFile examine(const std::string& path) {
  PluginFile file;
  file.path = path;
  try {
    file.manifest = parse_manifest(path, manifest_section(path));
  } catch (const Error& error) {
    file.problem = error.what();
  } catch (const std::exception& error) {
    file.problem = std::string("cannot be examined: ") + error.what();
  }
  return file;
}

bool exists(const std::string& path) {
  std::error_code error;
  return fs::exists(path, error);
}

void add_part(std::vector<std::string>& all, const std::string& path) {
  if (!path.empty()) all.push_back(absolute(path));
}

}  // namespace

Catalog Catalog::search(const std::vector<std::string>& directories) {
  Catalog catalog;
  std::set<std::string> seen;
  for (const std::string& given : directories) {
    const std::size_t first = catalog.files_.size();
    const std::string place = absolute(given);
    std::error_code error;
    if (!seen.insert(identity(place)).second) continue;
    if (!fs::is_directory(place, error)) {
      catalog.add_file(place);
    } else {
      catalog.add_directory(place, seen);
    }
    catalog.register_components(first);
  }
  return catalog;
}

Catalog Catalog::of(std::vector<Manifest> manifests) {
  Catalog catalog;
  for (Manifest& manifest : manifests) {
    PluginFile file;
    file.path = manifest.file;
    file.manifest = std::move(manifest);
    catalog.files_.push_back(std::move(file));
  }
  catalog.register_components(0);
  return catalog;
}

void Catalog::add_file(const std::string& path) {
  if (exists(path)) {
    files_.push_back(examine(path));
  } else {
    PluginFile file;
    file.path = path;
    file.problem = "no such file or directory";
    files_.push_back(std::move(file));
  }
}

void Catalog::add_directory(const std::string& directory, std::set<std::string>& seen) {
  std::vector<std::string> paths;
  std::error_code error;
  for (fs::directory_iterator entry(directory, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().extension() == ".so") paths.push_back(entry->path().string());
  if (error) {
    PluginFile file;
    file.path = directory;
    file.problem = "the directory cannot be read: " + error.message();
    files_.push_back(std::move(file));
  }
  std::sort(paths.begin(), paths.end());
  for (const std::string& path : paths)
    if (seen.insert(identity(path)).second) files_.push_back(examine(path));
}

// The files from `first` on are one directory: two owners of one id there are a mistake; an owner before them wins.
void Catalog::register_components(std::size_t first) {
  for (std::size_t i = first; i < files_.size(); ++i) {
    if (!files_[i].manifest) continue;
    std::size_t shadowed = 0;
    const auto& components = files_[i].manifest->components;
    for (std::size_t k = 0; k < components.size(); ++k) {
      const auto [owner, fresh] = owners_.try_emplace(components[k].id, Owner{i, k, ""});
      if (fresh) continue;
      PluginFile& other = files_[owner->second.file];
      if (owner->second.file < first) {
        ++shadowed;
        if (files_[i].shadowed_by.empty()) files_[i].shadowed_by = other.path;
        continue;
      }
      owner->second.problem = "component " + quote(components[k].id) +
                              " is in two plugins of one directory: " + other.path + " and " + files_[i].path +
                              "; remove one of them";
      for (PluginFile* file : {&other, &files_[i]})
        if (file->problem.empty()) file->problem = owner->second.problem;
    }
    files_[i].shadowed = shadowed == components.size();
  }
}

const ComponentEntry* Catalog::find(const std::string& id) const {
  const auto owner = owners_.find(id);
  if (owner == owners_.end() || !owner->second.problem.empty()) return nullptr;
  return &files_[owner->second.file].manifest->components[owner->second.component];
}

std::string Catalog::file_of(const std::string& id) const {
  return find(id) != nullptr ? files_[owners_.at(id).file].path : std::string();
}

std::vector<std::string> Catalog::ids(std::string_view interface) const {
  std::vector<std::string> all;
  for (const auto& [id, owner] : owners_)
    if (const ComponentEntry* entry = find(id); entry != nullptr && (interface.empty() || entry->answers(interface)))
      all.push_back(id);
  return all;
}

std::optional<std::string> Catalog::problem(const std::string& id) const {
  const auto owner = owners_.find(id);
  if (owner == owners_.end() || owner->second.problem.empty()) return std::nullopt;
  return owner->second.problem;
}

std::vector<std::string> search_path(const std::vector<std::string>& from_command_line) {
  std::vector<std::string> all;
  for (const std::string& path : from_command_line) add_part(all, path);
  if (const char* variable = std::getenv("WEND_PLUGIN_PATH")) {
    const std::string paths = variable;
    for (std::size_t begin = 0; begin <= paths.size();) {
      const std::size_t end = std::min(paths.find(':', begin), paths.size());
      add_part(all, paths.substr(begin, end - begin));
      begin = end + 1;
    }
  }
  const char *data = std::getenv("XDG_DATA_HOME"), *home = std::getenv("HOME");
  std::string user;
  if (data != nullptr && data[0] == '/')
    user = std::string(data) + "/wend/plugins";  // the standard ignores relative ones
  else if (home != nullptr && home[0] != '\0')
    user = std::string(home) + "/.local/share/wend/plugins";
  const std::string own = program_directory() + "/../lib/wend/plugins";
  for (const std::string& standard : {user, own})
    if (!standard.empty() && exists(standard)) add_part(all, standard);
  return all;
}

}  // namespace wend::core
