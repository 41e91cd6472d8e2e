#include <algorithm>
#include <core/base/diagnostics.hpp>
#include <core/plugin/schema.hpp>
#include <core/plugin/schema_kind.hpp>

namespace wend::core {
namespace {

const Json& member(const Json& object, const char* key) {
  static const Json none;
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() ? *found : none;
}

std::string plain(const Json& number) {  // 1.0 as 1
  std::string text = number.dump();
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

std::string range(const Json& schema) {
  const Json &low = member(schema, "minimum"), &above = member(schema, "exclusiveMinimum");
  const Json &high = member(schema, "maximum"), &below = member(schema, "exclusiveMaximum");
  const bool bounded_below = !low.is_null() || !above.is_null(), bounded_above = !high.is_null() || !below.is_null();
  if (bounded_below && bounded_above)
    return (above.is_null() ? " in [" + plain(low) : " in (" + plain(above)) + ", " +
           (below.is_null() ? plain(high) + "]" : plain(below) + ")");
  if (bounded_below) return above.is_null() ? " >= " + plain(low) : " > " + plain(above);
  if (bounded_above) return below.is_null() ? " <= " + plain(high) : " < " + plain(below);
  return "";
}

std::string array_text(const Json& schema) {
  const Json &least = member(schema, "minItems"), &most = member(schema, "maxItems");
  const std::string items = schema.contains("items") ? allowed(schema["items"]) : "anything";
  if (least.is_null() && most.is_null()) return "array of " + items;
  std::string count;
  if (most.is_null())
    count = "at least " + plain(least);
  else if (least.is_null())
    count = "at most " + plain(most);
  else
    count = least == most ? plain(least) : plain(least) + " to " + plain(most);
  return "array of " + count + " (" + items + ")";
}

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> all;
  for (const auto& [key, value] : object.items()) all.push_back(key);
  return all;
}

std::string one_of_text(const Json& schema) {
  std::string out;
  for (const char* kind : {"number", "string", "boolean", "array"})
    for (const Json* branch : alternatives(schema, kind)) out += (out.empty() ? "" : " or ") + allowed(*branch);
  const auto objects = alternatives(schema, "object");
  if (objects.empty()) return out;
  if (!out.empty()) out += " or ";
  if (objects.size() == 1) return out + allowed(*objects.front());
  const std::string name = discriminator(objects);
  std::vector<Json> values;
  for (const Json* branch : objects) values.push_back((*branch)["properties"][name]["const"]);
  return out + "object with " + quote(name) + " " + shown_list(values);
}

}  // namespace

std::string_view kind_of_value(const Json& value) {
  if (value.is_number()) return "number";
  if (value.is_string()) return "string";
  if (value.is_boolean()) return "boolean";
  if (value.is_array()) return "array";
  return value.is_object() ? "object" : "null";
}

std::string_view kind_of_schema(const Json& schema) {
  if (const Json& type = member(schema, "type"); type.is_string()) {
    const std::string_view name = type.get_ref<const std::string&>();
    return name == "integer" ? "number" : name;
  }
  if (const Json& values = member(schema, "enum"); values.is_array() && !values.empty())
    return kind_of_value(values[0]);
  return schema.is_object() && schema.contains("const") ? kind_of_value(schema["const"]) : std::string_view();
}

std::vector<const Json*> alternatives(const Json& schema, std::string_view kind) {
  std::vector<const Json*> all;
  for (const Json& branch : member(schema, "oneOf"))
    if (kind_of_schema(branch) == kind) all.push_back(&branch);
  return all;
}

std::string discriminator(const std::vector<const Json*>& objects) {
  const auto constant = [](const Json* branch, const std::string& name) -> const Json& {
    return member(member(member(*branch, "properties"), name.c_str()), "const");
  };
  for (const std::string& name : keys(member(*objects.front(), "properties"))) {
    std::vector<Json> values;
    for (const Json* branch : objects) {
      const Json& value = constant(branch, name);
      const bool other =
          std::none_of(values.begin(), values.end(), [&](const Json& v) { return same_value(v, value); });
      if (!value.is_null() && other) values.push_back(value);
    }
    if (values.size() == objects.size()) return name;
  }
  return "";
}

bool same_value(const Json& a, const Json& b) {
  return kind_of_value(a) == kind_of_value(b) && a == b;
}

std::string shown(const Json& value) {
  if (value.is_string()) return quote(value.get_ref<const std::string&>());
  if (value.is_array()) return value.empty() ? "an empty array" : "an array of " + std::to_string(value.size());
  if (value.is_object()) return value.empty() ? "an empty object" : "an object";
  return value.dump();
}

std::string shown_list(const std::vector<Json>& values) {
  std::string out;
  for (std::size_t i = 0; i < values.size(); ++i)
    out += (i == 0 ? "" : i + 1 == values.size() ? " or " : ", ") + shown(values[i]);
  return out;
}

std::string allowed(const Json& schema) {
  if (schema.contains("const")) return shown(schema["const"]);
  if (schema.contains("enum")) return shown_list(schema["enum"].get_ref<const Json::array_t&>());
  if (schema.contains("oneOf")) return one_of_text(schema);
  const std::string type =
      member(schema, "type").is_string() ? schema["type"].get_ref<const std::string&>() : "anything";
  if (type == "number" || type == "integer") return type + range(schema);
  if (type == "array") return array_text(schema);
  if (type == "string" && schema.contains("format")) return "name of a file";
  if (type != "object") return type;
  const auto names = keys(member(schema, "properties"));
  return names.empty() ? "object without keys" : "object with " + quote_list(names, "and", 8);
}

std::string describe(const Json& schema) {
  if (!schema.is_object()) return "anything";
  std::string text = allowed(schema);
  if (!schema.contains("default")) return text;
  std::string value = schema["default"].dump(-1, ' ', false, Json::error_handler_t::replace);
  if (schema["default"].is_number()) value = plain(schema["default"]);
  if (value.size() > 60) value = shown(schema["default"]);
  return text + ", default " + value;
}

}  // namespace wend::core
