// What the tests of scenes share: files of this folder and of the real data, parameters as the host hands them over.
#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../scenes/source.hpp"

namespace arena {

inline std::string map_path(const std::string& name) {
  return std::string(WEND_ARENA_FOLDER) + "/test/maps/" + name;
}

// Where the real data are; a test without them is skipped.
inline std::string data_path(const std::string& name) {
  const char* set = std::getenv("WEND_DATA");
  const std::string root = set && *set ? set : std::string(WEND_ARENA_FOLDER) + "/../../../shared/data";
  return root + "/" + name;
}
#define SKIP_WITHOUT(path) \
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "needs " << path << " (set WEND_DATA)"

// Flattened and sorted by path, as the host does it.
class Parameters {
 public:
  explicit Parameters(const nlohmann::json& json) {
    flatten(json, "");
    std::sort(entries_.begin(), entries_.end(), [](const auto& a, const auto& b) { return a->path < b->path; });
    for (const auto& entry : entries_)
      values_.push_back({entry->path.c_str(), entry->is_text ? entry->text.c_str() : nullptr, entry->number});
  }
  wend::Params params() const { return wend::Params(values_); }

 private:
  struct Entry {
    std::string path, text;
    double number = 0;
    bool is_text = false;
  };
  void flatten(const nlohmann::json& json, const std::string& path) {
    if (json.is_structured()) {
      for (const auto& item : json.items()) flatten(item.value(), path.empty() ? item.key() : path + "/" + item.key());
      return;
    }
    auto entry = std::make_unique<Entry>();
    entry->path = path;
    entry->is_text = json.is_string();
    if (json.is_string()) entry->text = json.get<std::string>();
    if (json.is_number()) entry->number = json.get<double>();
    if (json.is_boolean()) entry->number = json.get<bool>() ? 1 : 0;
    entries_.push_back(std::move(entry));
  }
  std::vector<std::unique_ptr<Entry>> entries_;
  std::vector<wend_value> values_;
};

inline SceneSource source_of(const nlohmann::json& json) {
  return read_source(Parameters(json).params());
}

// "parameter: message" of what `call` throws; the folder of the maps is left out of it.
template <class Call>
std::string error_of(Call&& call) {
  try {
    call();
  } catch (const wend::Error& error) {
    std::string text = error.parameter().empty() ? error.what() : error.parameter() + ": " + error.what();
    const std::string folder = map_path("");
    for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder))
      text.erase(at, folder.size());
    return text;
  }
  return "no error";
}

}  // namespace arena
