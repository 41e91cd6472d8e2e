// The two archives that unit.cpp shows its structures to: one writes them as JSON, the other reads them back, strictly.
#pragma once
#include <cmath>
#include <concepts>
#include <core/base/error.hpp>
#include <core/base/json.hpp>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace wend::core {

// `value` with every path that `content` knows replaced by what the file holds.
inline Json without_paths(const Json& value, const Json& content) {
  if (content.empty()) return value;
  if (value.is_string()) {
    const auto found = content.find(value.get_ref<const std::string&>());
    return found == content.end() ? value : Json("sha256:" + found->get<std::string>());
  }
  Json result = value;
  if (value.is_structured())
    for (Json& element : result) element = without_paths(element, content);
  return result;
}

class UnitWriter {
 public:
  explicit UnitWriter(bool canonical) : canonical_(canonical) {}

  template <class T>
  void operator()(const char* name, const T& value) {
    json[name] = written(value);
  }
  void with_files(const char* name, const Json& value, const Json& content) {
    json[name] = canonical_ ? without_paths(value, content) : value;
    if (!canonical_) json["content"] = content;
  }

  Json json = Json::object();

 private:
  Json written(const Json& value) { return value; }
  Json written(const std::string& value) { return value; }
  Json written(std::integral auto value) { return value; }
  Json written(double value) {  // JSON has no NaN and no infinity
    if (std::isnan(value)) return nullptr;
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    return value;
  }
  Json written(const std::pair<double, double>& value) {
    return Json::array({written(value.first), written(value.second)});
  }
  template <class T>
  Json written(const std::optional<T>& value) {
    return value ? written(*value) : Json();
  }
  template <class T>
  Json written(const std::vector<T>& values) {
    Json result = Json::array();
    for (const T& value : values) result.push_back(written(value));
    return result;
  }
  template <class T>
  Json written(const std::map<std::string, T>& values) {
    Json result = Json::object();
    for (const auto& [key, value] : values) result[key] = written(value);
    return result;
  }
  Json written(const std::map<std::uint64_t, std::string>& values) {
    Json result = Json::object();
    for (const auto& [key, value] : values) result[std::to_string(key)] = value;
    return result;
  }
  template <class T>
  Json written(const T& value) requires std::is_class_v<T> {
    UnitWriter inner(canonical_);
    fields(inner, value);
    return std::move(inner.json);
  }

  bool canonical_;
};

class UnitReader {
 public:
  UnitReader(const Json& json, std::string path) : json_(json), path_(std::move(path)) {
    if (!json.is_object()) expected("an object", json, path_);
  }

  template <class T>
  void operator()(const char* name, T& value) {
    read(at(name), value, path_ + "/" + name);
  }
  void with_files(const char* name, Json& value, Json& content) {
    (*this)(name, value);
    (*this)("content", content);
  }

 private:
  [[noreturn]] static void expected(const std::string& what, const Json& found, const std::string& path) {
    throw Error(Exit::data, "unit " + (path.empty() ? "/" : path) + ": expected " + what + ", found " +
                                found.dump(-1, ' ', false, Json::error_handler_t::replace).substr(0, 60));
  }
  const Json& at(const char* name) const {
    const auto found = json_.find(name);
    if (found == json_.end()) throw Error(Exit::data, "unit " + path_ + "/" + name + ": missing");
    return *found;
  }

  void read(const Json& json, Json& value, const std::string& path) {
    if (!json.is_object()) expected("an object", json, path);
    value = json;
  }
  void read(const Json& json, std::string& value, const std::string& path) {
    if (!json.is_string()) expected("text", json, path);
    value = json.get_ref<const std::string&>();
  }
  void read(const Json& json, bool& value, const std::string& path) {
    if (!json.is_boolean()) expected("true or false", json, path);
    value = json.get<bool>();
  }
  template <std::unsigned_integral T>
  void read(const Json& json, T& value, const std::string& path) {
    constexpr T greatest = std::numeric_limits<T>::max();
    const bool whole = json.is_number_unsigned() || (json.is_number_integer() && json.get<std::int64_t>() >= 0);
    if (!whole || json.get<std::uint64_t>() > greatest)
      expected("a whole number from 0 to " + std::to_string(greatest), json, path);
    value = static_cast<T>(json.get<std::uint64_t>());
  }
  void read(const Json& json, double& value, const std::string& path) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (json.is_null()) {
      value = std::numeric_limits<double>::quiet_NaN();
    } else if (json.is_number()) {
      value = json.get<double>();
    } else if (json == "inf" || json == "-inf") {
      value = json == "inf" ? infinity : -infinity;
    } else {
      expected("a number, null, \"inf\" or \"-inf\"", json, path);
    }
  }
  void read(const Json& json, std::pair<double, double>& value, const std::string& path) {
    if (!json.is_array() || json.size() != 2) expected("a pair of numbers", json, path);
    read(json[0], value.first, path + "/0");
    read(json[1], value.second, path + "/1");
  }
  template <class T>
  void read(const Json& json, std::optional<T>& value, const std::string& path) {
    value.reset();
    if (!json.is_null()) read(json, value.emplace(), path);
  }
  template <class T>
  void read(const Json& json, std::vector<T>& values, const std::string& path) {
    if (!json.is_array()) expected("an array", json, path);
    values.assign(json.size(), T());
    for (std::size_t i = 0; i < json.size(); ++i) read(json[i], values[i], path + "/" + std::to_string(i));
  }
  template <class T>
  void read(const Json& json, std::map<std::string, T>& values, const std::string& path) {
    if (!json.is_object()) expected("an object", json, path);
    values.clear();
    for (const auto& [key, value] : json.items()) read(value, values[key], path + "/" + key);
  }
  void read(const Json& json, std::map<std::uint64_t, std::string>& values, const std::string& path) {
    if (!json.is_object()) expected("an object", json, path);
    values.clear();
    for (const auto& [key, value] : json.items()) {
      if (key.empty() || key.size() > 19 || key.find_first_not_of("0123456789") != std::string::npos)
        expected("whole numbers as keys", json, path);
      read(value, values[std::stoull(key)], path + "/" + key);
    }
  }
  template <class T>
  void read(const Json& json, T& value, const std::string& path) requires std::is_class_v<T> {
    UnitReader inner(json, path);
    fields(inner, value);
  }

  const Json& json_;
  std::string path_;
};

}  // namespace wend::core
