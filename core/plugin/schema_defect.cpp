#include <algorithm>
#include <cmath>
#include <core/plugin/schema.hpp>
#include <core/plugin/schema_kind.hpp>

namespace wend::core {
namespace {

const std::vector<std::string> keywords{
    "type",       "enum",     "const", "default", "minimum",    "maximum",  "exclusiveMinimum",     "exclusiveMaximum",
    "minItems",   "maxItems", "items", "format",  "properties", "required", "additionalProperties", "oneOf",
    "description"};
const std::vector<std::string> types{"number", "integer", "boolean", "string", "array", "object"};

bool is_count(const Json& value) {
  return value.is_number_unsigned() && value.get<std::uint64_t>() <= 1'000'000;
}

class Inspector {
 public:
  Inspector(const Document* document, Diagnostics& diagnostics) : document_(document), diagnostics_(diagnostics) {}

  void inspect(const Json& schema, const std::string& at) {
    if (!schema.is_object()) return report(at, "expected a schema, found " + shown(schema));
    const std::size_t before = diagnostics_.size();
    for (const auto& [key, value] : schema.items())
      if (std::find(keywords.begin(), keywords.end(), key) == keywords.end()) unknown(key, at);
    if (schema.contains("description") && !schema["description"].is_string())
      report(at + "/description", "expected a text, found " + shown(schema["description"]));
    if (!kind(schema, at)) return;
    bounds(schema, at);
    count_of_items(schema, at);
    format(schema, at);
    if (schema.contains("items")) inspect(schema["items"], at + "/items");
    if (kind_of_schema(schema) == "array" && !schema.contains("items")) report(at, "an array needs \"items\"");
    members(schema, at);
    one_of(schema, at);
    if (schema.contains("default") && diagnostics_.size() == before) default_value(schema, at);
  }

 private:
  void report(const std::string& at, std::string message, std::string hint = {}, bool at_key = false) {
    if (diagnostics_.full()) return diagnostics_.add(Diagnostic{});
    Diagnostic diagnostic;
    if (document_ != nullptr) diagnostic = document_->at(at, message, at_key);
    diagnostic.message = "schema: " + std::move(message);
    diagnostic.pointer = at;
    diagnostic.hint = std::move(hint);
    diagnostics_.add(std::move(diagnostic));
  }

  void unknown(const std::string& key, const std::string& at) {
    const std::string best = did_you_mean(key, keywords);
    report(at + "/" + pointer_token(key), "unknown keyword " + quote(key),
           best.empty() ? "" : "did you mean " + quote(best) + "?", true);
  }

  // What kind of value the schema allows; false where nothing more can be checked.
  bool kind(const Json& schema, const std::string& at) {
    if (schema.contains("type")) {
      const Json& type = schema["type"];
      if (!type.is_string() || std::find(types.begin(), types.end(), type.get<std::string>()) == types.end())
        return report(at + "/type", "expected one type of " + quote_list(types) + ", found " + shown(type)), false;
    }
    const int ways = schema.contains("enum") + schema.contains("const") + schema.contains("oneOf");
    if (ways > 1) return report(at, "\"enum\", \"const\" and \"oneOf\" exclude each other"), false;
    if (ways == 0 && !schema.contains("type"))
      return report(at, "expected \"type\", \"enum\", \"const\" or \"oneOf\""), false;
    if (schema.contains("enum")) {
      if (!schema["enum"].is_array() || schema["enum"].empty())
        return report(at + "/enum", "expected an array of values, found " + shown(schema["enum"])), false;
      return values(schema, schema["enum"], at + "/enum");
    }
    return !schema.contains("const") || values(schema, Json::array({schema["const"]}), at + "/const");
  }

  bool values(const Json& schema, const Json& all, const std::string& at) {
    const std::string_view expected = kind_of_schema(schema);
    for (auto value = all.begin(); value != all.end(); ++value) {
      const std::string_view own = kind_of_value(*value);
      if (own != expected || own == "array" || own == "object" || own == "null")
        return report(at, "expected numbers, strings or booleans of one type, found " + shown(*value)), false;
      if (std::any_of(all.begin(), value, [&](const Json& other) { return same_value(other, *value); }))
        return report(at, shown(*value) + " stands here twice"), false;
    }
    return true;
  }

  void bounds(const Json& schema, const std::string& at) {
    bool good = true;
    for (const char* key : {"minimum", "maximum", "exclusiveMinimum", "exclusiveMaximum"}) {
      if (!schema.contains(key)) continue;
      if (kind_of_schema(schema) != "number" || !schema.contains("type"))
        good = false, report(at + "/" + key, quote(key) + " is for numbers", "", true);
      else if (!schema[key].is_number())
        good = false, report(at + "/" + key, "expected a number, found " + shown(schema[key]));
    }
    for (const auto& [one, other] :
         {std::pair("minimum", "exclusiveMinimum"), std::pair("maximum", "exclusiveMaximum")})
      if (schema.contains(one) && schema.contains(other))
        good = false, report(at, quote(one) + " and " + quote(other) + " exclude each other");
    if (!good) return;
    const double low = schema.value("exclusiveMinimum", schema.value("minimum", -HUGE_VAL));
    const double high = schema.value("exclusiveMaximum", schema.value("maximum", HUGE_VAL));
    const bool open = schema.contains("exclusiveMinimum") || schema.contains("exclusiveMaximum");
    if (low > high || (low == high && open)) report(at, "no number lies in the range: " + allowed(schema));
  }

  void count_of_items(const Json& schema, const std::string& at) {
    bool good = true;
    for (const char* key : {"minItems", "maxItems", "items"}) {
      if (!schema.contains(key)) continue;
      if (kind_of_schema(schema) != "array")
        good = false, report(at + "/" + key, quote(key) + " is for arrays", "", true);
      else if (std::string_view(key) != "items" && !is_count(schema[key]))
        good = false, report(at + "/" + key, "expected a count, found " + shown(schema[key]));
    }
    if (good && schema.contains("minItems") && schema.contains("maxItems") && schema["minItems"] > schema["maxItems"])
      report(at, "\"minItems\" is more than \"maxItems\"");
  }

  void format(const Json& schema, const std::string& at) {
    if (!schema.contains("format")) return;
    const std::string type = schema.value("type", "");
    const Json& format = schema["format"];
    const bool texts = type == "array" && schema.contains("items") && schema["items"].is_object() &&
                       kind_of_schema(schema["items"]) == "string";
    if (!((type == "string" && (format == "file" || format == "files")) || (texts && format == "files")))
      report(at + "/format",
             "expected \"file\" for a string or \"files\" for an array of strings, found " + shown(format));
  }

  void members(const Json& schema, const std::string& at) {
    const bool object = kind_of_schema(schema) == "object";
    for (const char* key : {"properties", "required", "additionalProperties"})
      if (schema.contains(key) && !object) return report(at + "/" + key, quote(key) + " is for objects", "", true);
    if (schema.contains("additionalProperties") && schema["additionalProperties"] != Json(false))
      report(at + "/additionalProperties", "expected false, found " + shown(schema["additionalProperties"]));
    const Json properties = schema.value("properties", Json::object());
    if (!properties.is_object()) return report(at + "/properties", "expected an object, found " + shown(properties));
    for (const auto& [key, property] : properties.items()) {
      const std::string own = at + "/properties/" + pointer_token(key);
      const bool plain = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
        return std::isalnum(c) || c == '_' || c == '-' || c == '.' || c == '$';
      });
      if (!plain) report(own, "a property is named with letters, digits and _-.$, found " + quote(key), "", true);
      inspect(property, own);
    }
    const Json required = schema.value("required", Json::array());
    if (!required.is_array()) return report(at + "/required", "expected an array, found " + shown(required));
    for (std::size_t i = 0; i < required.size(); ++i)
      if (!required[i].is_string() || !properties.contains(required[i].get<std::string>()))
        report(at + "/required/" + std::to_string(i), "expected the name of a property, found " + shown(required[i]));
  }

  void one_of(const Json& schema, const std::string& at) {
    if (!schema.contains("oneOf")) return;
    const Json& branches = schema["oneOf"];
    if (!branches.is_array() || branches.empty())
      return report(at + "/oneOf", "expected an array of schemas, found " + shown(branches));
    const std::size_t before = diagnostics_.size();
    for (std::size_t i = 0; i < branches.size(); ++i) {
      const std::string own = at + "/oneOf/" + std::to_string(i);
      inspect(branches[i], own);
      if (diagnostics_.size() > before) continue;
      const std::string_view kind = kind_of_schema(branches[i]);
      if (kind.empty())
        report(own, "\"oneOf\" cannot stand directly in \"oneOf\"");
      else if (schema.contains("type") && kind != kind_of_schema(schema))
        report(own, "the alternative is no " + schema["type"].get<std::string>());
      else if (kind != "object" && alternatives(schema, kind).size() > 1)
        report(own, "two alternatives are of the type " + std::string(kind) + ": nothing tells them apart");
    }
    if (diagnostics_.size() > before) return;
    const auto objects = alternatives(schema, "object");
    if (objects.size() < 2) return;
    const std::string key = discriminator(objects);
    if (key.empty())
      return report(at + "/oneOf",
                    "nothing tells the alternatives apart: expected a property that is \"const\" in each");
    const auto defaults = std::count_if(objects.begin(), objects.end(), [&](const Json* branch) {
      return (*branch)["properties"][key].contains("default");
    });
    if (defaults > 1) report(at + "/oneOf", quote(key) + " has a default in more than one alternative");
  }

  void default_value(const Json& schema, const std::string& at) {
    Json value = schema["default"];
    Diagnostics mistakes;
    check_schema(schema, value, "", SchemaContext{}, mistakes);
    if (!mistakes.any()) return;
    const Diagnostic& first = mistakes.sorted().front();
    const std::string reason = first.message.starts_with("parameters: ") ? first.message.substr(12) : first.message;
    report(at + "/default", "the default does not satisfy it: " + reason);
  }

  const Document* document_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_schema_itself(const Json& schema, const std::string& pointer, const Document* document,
                         Diagnostics& diagnostics) {
  Inspector(document, diagnostics).inspect(schema, pointer);
}

std::optional<std::string> schema_defect(const Json& schema) {
  Diagnostics diagnostics;
  check_schema_itself(schema, "", nullptr, diagnostics);
  if (!diagnostics.any()) return std::nullopt;
  const Diagnostic& first = diagnostics.sorted().front();
  const std::string hint = first.hint.empty() ? "" : " (" + first.hint + ")";
  return (first.pointer.empty() ? "" : first.pointer + ": ") +
         first.message.substr(std::string_view("schema: ").size()) + hint;
}

}  // namespace wend::core
