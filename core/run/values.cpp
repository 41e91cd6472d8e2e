#include <core/run/values.hpp>

#include <algorithm>
#include <cstring>

namespace wend::core {

FlatValues::FlatValues(const Json& params) : json_(params.dump()) {
  flatten(params, "");
  std::sort(values_.begin(), values_.end(),
            [](const wend_value& a, const wend_value& b) { return std::strcmp(a.path, b.path) < 0; });
}

void FlatValues::flatten(const Json& value, const std::string& path) {
  if (value.is_structured()) {
    std::size_t i = 0;
    for (const auto& item : value.items()) {
      const std::string name = value.is_array() ? std::to_string(i++) : item.key();
      flatten(item.value(), path.empty() ? name : path + "/" + name);
    }
    return;
  }
  if (value.is_null()) return;
  wend_value flat{texts_.emplace_back(path).c_str(), nullptr, 0};
  if (value.is_string()) flat.text = texts_.emplace_back(value.get_ref<const std::string&>()).c_str();
  else if (value.is_boolean()) flat.number = value.get<bool>() ? 1 : 0;
  else flat.number = value.get<double>();
  values_.push_back(flat);
}

}  // namespace wend::core
