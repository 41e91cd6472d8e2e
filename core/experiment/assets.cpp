#include <glob.h>

#include <algorithm>
#include <core/base/diagnostics.hpp>
#include <core/base/error.hpp>
#include <core/base/sha256.hpp>
#include <core/experiment/assets.hpp>
#include <filesystem>
#include <utility>

namespace wend::core {

namespace {

bool is_file(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

// Does the alternative of a oneOf describe this value?  Objects are told apart by a property that is const.
bool fits(const Json& alternative, const Json& value) {
  const std::string type = alternative.value("type", "");
  if (!value.is_object() || type != "object")
    return (value.is_array() && type == "array") || (value.is_string() && type == "string");
  const Json properties = alternative.value("properties", Json::object());
  for (const auto& [name, property] : properties.items()) {
    if (!property.contains("const")) continue;
    const Json chosen = value.contains(name) ? value[name] : property.value("default", Json());
    if (chosen != property["const"]) return false;
  }
  return true;
}

bool names_files(const Json& schema) {
  return schema.value("type", "") == "array" && (schema.value("format", "") == "files" ||
                                                 schema.value("items", Json::object()).value("format", "") == "files");
}

}  // namespace

Assets::Assets(std::string directory, std::map<std::string, std::string> variables)
    : directory_(std::move(directory)), variables_(std::move(variables)) {}

std::vector<Assets::Problem> Assets::take_problems() {
  return std::exchange(problems_, {});
}

std::string Assets::substituted(const std::string& name, const std::string& pointer) {
  std::string result;
  for (std::size_t i = 0; i < name.size();) {
    const std::size_t begin = name.find("${", i), end = begin == std::string::npos ? begin : name.find('}', begin);
    if (end == std::string::npos) return result + name.substr(i);
    const std::string variable = name.substr(begin + 2, end - begin - 2);
    const auto found = variables_.find(variable);
    if (found == variables_.end()) {
      std::vector<std::string> known;
      for (const auto& entry : variables_) known.push_back(entry.first);
      problems_.push_back({pointer, "unknown variable " + quote(variable) + " in a file's name",
                           known.empty() ? "there are none here" : "expected " + quote_list(known)});
      return "";
    }
    result += name.substr(i, begin - i) + found->second;
    i = end + 1;
  }
  return result;
}

std::vector<std::string> Assets::find(const std::string& name, bool pattern, const std::string& pointer) {
  const std::string relative = substituted(name, pointer);
  if (relative.empty()) return {};
  const std::string path = (std::filesystem::absolute(directory_) / relative).lexically_normal().string();
  std::vector<std::string> found;
  if (is_file(path)) {
    found.push_back(path);
  } else if (pattern) {
    glob_t matches{};
    if (::glob(path.c_str(), GLOB_NOSORT, nullptr, &matches) == 0)
      for (std::size_t i = 0; i < matches.gl_pathc; ++i)
        if (is_file(matches.gl_pathv[i])) found.emplace_back(matches.gl_pathv[i]);
    ::globfree(&matches);
    std::sort(found.begin(), found.end());
  }
  const bool wild = pattern && relative.find_first_of("*?[") != std::string::npos;
  if (found.empty())
    problems_.push_back(
        {pointer, (wild ? "no file matches " : "there is no file ") + quote(name, 200), "looked for " + path});
  for (const std::string& file : found) {
    if (valid_utf8(file) == file) continue;
    problems_.push_back({pointer, "the name of the file " + quote(file, 200) + " is not UTF-8", "rename it"});
    return {};
  }
  return found;
}

std::string Assets::hash_of(const std::string& path, const std::string& pointer) {
  const auto [entry, fresh] = hashes_.try_emplace(path);
  if (!fresh) return entry->second;
  try {
    entry->second = sha256_of_file(path);
  } catch (const Error& error) {
    problems_.push_back({pointer, error.what(), ""});
  }
  return entry->second;
}

// An array of names and patterns becomes one of paths.
std::uint32_t Assets::expand(Json& value, const std::string& pointer, Json& content) {
  Json paths = Json::array();
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::string at = pointer + "/" + std::to_string(i);
    if (!value[i].is_string()) {
      paths.push_back(value[i]);
      continue;
    }
    for (const std::string& path : find(value[i].get<std::string>(), true, at)) {
      content[path] = hash_of(path, at);
      paths.push_back(path);
    }
  }
  value = std::move(paths);
  return static_cast<std::uint32_t>(value.size());
}

std::uint32_t Assets::resolve(const Json& schema, Json& value, const std::string& pointer, Json& content) {
  if (!schema.is_object()) return 0;
  if (names_files(schema)) {
    if (value.is_string()) value = Json::array({value});
    return value.is_array() ? expand(value, pointer, content) : 0;
  }
  if (value.is_string() && !value.get_ref<const std::string&>().empty() && schema.value("format", "") == "file") {
    const std::vector<std::string> found = find(value.get<std::string>(), false, pointer);
    if (found.empty()) return 0;
    content[found[0]] = hash_of(found[0], pointer);
    value = found[0];
    return 0;
  }
  std::uint32_t files = 0;
  if (schema.contains("oneOf")) {
    for (const Json& alternative : schema["oneOf"])
      if (fits(alternative, value)) return resolve(alternative, value, pointer, content);
  } else if (value.is_object() && schema.contains("properties")) {
    for (const auto& [name, property] : schema["properties"].items())
      if (value.contains(name)) files = std::max(files, resolve(property, value[name], pointer + "/" + name, content));
  } else if (value.is_array() && schema.contains("items")) {
    for (std::size_t i = 0; i < value.size(); ++i)
      files = std::max(files, resolve(schema["items"], value[i], pointer + "/" + std::to_string(i), content));
  }
  return files;
}

}  // namespace wend::core
