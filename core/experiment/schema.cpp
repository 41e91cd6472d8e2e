#include <core/experiment/schema.hpp>

extern const char experiment_schema_json[];

namespace wend::core {

namespace {

// The definition that a reference points to; other schemas are themselves.
const Json& target(const Json& whole, const Json& schema) {
  constexpr std::size_t prefix = std::string_view("#/$defs/").size();
  return schema.contains("$ref") ? whole["$defs"][schema["$ref"].get_ref<const std::string&>().substr(prefix)] : schema;
}

bool is_open(const Json& whole, const Json& schema) {
  if (schema.contains("$ref")) return true;
  if (schema.value("type", "") == "object") return schema.value("additionalProperties", Json()) != Json(false);
  for (const Json& alternative : schema.value("oneOf", Json::array()))
    if (is_open(whole, alternative)) return true;
  return false;
}

SchemaPart part_of(const Json& whole, const Json& definition) {
  SchemaPart part{definition, {}};
  for (const char* key : {"$schema", "$defs", "title", "additionalProperties"}) part.schema.erase(key);
  for (auto& [name, property] : part.schema["properties"].items()) {
    if (property.contains("items") && is_open(whole, property["items"])) property.erase("items");
    if (!is_open(whole, property)) continue;
    const bool object = target(whole, property).value("type", "") == "object";
    const Json source = target(whole, property);
    property = {{"type", object ? "object" : "string"}, {"description", source.value("description", "")}};
    if (source.contains("default")) property["default"] = source["default"];
    part.open[name] = object ? "object" : "string";
  }
  return part;
}

std::map<std::string, SchemaPart> parts_of(const Json& whole) {
  std::map<std::string, SchemaPart> parts;
  parts[""] = part_of(whole, whole);
  for (const auto& [name, definition] : whole["$defs"].items())
    if (definition.contains("properties")) parts[name] = part_of(whole, definition);
  return parts;
}

}  // namespace

std::string experiment_schema_text() {
  return experiment_schema_json;
}

const SchemaPart& experiment_schema(const std::string& name) {
  static const std::map<std::string, SchemaPart> parts = parts_of(Json::parse(experiment_schema_json));
  return parts.at(name);
}

}  // namespace wend::core
