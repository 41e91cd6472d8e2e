// wend/config.hpp -- what a component is created with.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>
#include <wend/random.hpp>
#include <wend/space.hpp>
#include <wend/view.hpp>

namespace wend {

// Resolved parameters by path ("body/radius", "axes_deg/0"): the host has checked them against the manifest's schema
// and filled the defaults in.  A getter throws where there is no such parameter.
class Params {
 public:
  Params() = default;
  explicit Params(std::span<const wend_value> values) noexcept : values_(values) {}

  bool has(std::string_view path) const noexcept { return find(path) != nullptr; }
  double number(std::string_view path) const { return get(path).number; }
  bool flag(std::string_view path) const { return get(path).number != 0; }
  std::uint64_t count(std::string_view path) const { return static_cast<std::uint64_t>(get(path).number); }
  std::string text(std::string_view path) const {
    const wend_value& value = get(path);
    if (value.text == nullptr) throw parameter_error(std::string(path), "expected a text");
    return value.text;
  }
  double number_or(std::string_view path, double otherwise) const noexcept {
    const wend_value* value = find(path);
    return value ? value->number : otherwise;
  }
  std::string text_or(std::string_view path, std::string otherwise) const {
    const wend_value* value = find(path);
    return value && value->text ? value->text : std::move(otherwise);
  }
  // The elements of an array of numbers or texts.
  std::vector<double> numbers(std::string_view path) const {
    std::vector<double> all;
    for (std::size_t i = 0; const wend_value* value = find(element(path, i)); ++i) all.push_back(value->number);
    return all;
  }
  std::vector<std::string> texts(std::string_view path) const {
    std::vector<std::string> all;
    for (std::size_t i = 0; const wend_value* value = find(element(path, i)); ++i)
      if (value->text) all.emplace_back(value->text);
    return all;
  }
  // How many elements the array of objects, arrays or values at `path` has.
  std::size_t size(std::string_view path) const {
    std::size_t n = 0;
    while (any_below(element(path, n))) ++n;
    return n;
  }
  bool any_below(std::string_view path) const {
    for (const wend_value& value : values_) {
      const std::string_view own = value.path;
      if (own.substr(0, path.size()) == path && (own.size() == path.size() || own[path.size()] == '/')) return true;
    }
    return false;
  }
  static std::string element(std::string_view path, std::size_t i) {
    return std::string(path) + "/" + std::to_string(i);
  }

 private:
  const wend_value* find(std::string_view path) const noexcept {
    std::size_t low = 0, high = values_.size();
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (values_[middle].path < path)
        low = middle + 1;
      else
        high = middle;
    }
    return low < values_.size() && values_[low].path == path ? &values_[low] : nullptr;
  }
  const wend_value& get(std::string_view path) const {
    const wend_value* value = find(path);
    if (value == nullptr) throw parameter_error(std::string(path), "missing");
    return *value;
  }

  std::span<const wend_value> values_;  // sorted by path
};

// A component in a slot, or none where the slot is empty.
class Slot {
 public:
  explicit Slot(const wend_ref* ref) noexcept : ref_(ref) {}
  explicit operator bool() const noexcept { return ref_ != nullptr; }
  const wend_ref& operator*() const noexcept { return *ref_; }
  const wend_ref* operator->() const noexcept { return ref_; }

 private:
  const wend_ref* ref_;
};

// Valid during the constructor; the host, slots, uses and spaces behind it live as long as the component.
class Config {
 public:
  Config(const wend_host* host, const wend_config* config) noexcept
      : params({config->values, config->value_count}),
        robot({config->robot_values, config->robot_value_count}),
        observation(config->observation),
        action(config->action),
        host_(host),
        config_(config) {}

  Params params;      // the component's own parameters
  Params robot;       // worlds: the robot definition
  Space observation;  // policies, learners, rewards
  Space action;

  std::uint32_t copies() const noexcept { return config_->copies; }
  std::uint32_t robots() const noexcept { return config_->robots; }
  std::uint32_t rows() const noexcept { return config_->copies * config_->robots; }
  std::uint64_t seed() const noexcept { return config_->seed; }
  const wend_host* host() const noexcept { return host_; }
  const char* params_json() const noexcept { return config_->params; }
  const char* robot_json() const noexcept { return config_->robot; }

  // A component in a slot, if the slot is filled; one that is borrowed (the manifest asked for it, so it is there).
  Slot slot(std::string_view name) const { return Slot(find(config_->slots, config_->slot_count, name)); }
  wend_ref use(std::string_view name) const {
    const wend_ref* ref = find(config_->uses, config_->use_count, name);
    if (ref == nullptr) throw unsupported("the host lends no \"" + std::string(name) + "\"");
    return *ref;
  }
  void warn(const std::string& message) const { host_->log(host_, 2, message.c_str()); }

 private:
  static const wend_ref* find(const wend_named* all, std::uint32_t n, std::string_view name) noexcept {
    for (std::uint32_t i = 0; i < n; ++i)
      if (name == all[i].name) return &all[i].ref;
    return nullptr;
  }

  const wend_host* host_;
  const wend_config* config_;
};

}  // namespace wend
