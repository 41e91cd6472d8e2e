// Parameters as a plugin gets them: JSON flattened into (path, number or text), sorted by path.
#pragma once
#include <core/base/json.hpp>
#include <wend/abi.h>

#include <deque>
#include <string>
#include <vector>

namespace wend::core {

class FlatValues {
 public:
  FlatValues() = default;
  explicit FlatValues(const Json& params);
  FlatValues(FlatValues&&) = default;
  FlatValues& operator=(FlatValues&&) = default;

  const wend_value* data() const noexcept { return values_.data(); }
  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(values_.size()); }
  const char* text() const noexcept { return json_.c_str(); }

 private:
  void flatten(const Json& value, const std::string& path);

  std::string json_;
  std::deque<std::string> texts_;  // a deque: the tables point into it
  std::vector<wend_value> values_;
};

}  // namespace wend::core
