#include <algorithm>
#include <cmath>
#include <core/plugin/schema.hpp>
#include <core/plugin/schema_kind.hpp>
#include <set>

namespace wend::core {
namespace {

constexpr double exact = 9007199254740992.0;  // 2^53: integers up to here are exact in a double, as plugins get them

class Checker {
 public:
  Checker(const std::string& pointer, const SchemaContext& context, Diagnostics& diagnostics)
      : base_(pointer), context_(context), diagnostics_(diagnostics) {}

  // `path` is the value's pointer below base_.
  void check(const Json& schema, Json& value, const std::string& path) {
    if (schema.contains("oneOf")) return choose(schema, value, path);
    if (schema.contains("enum")) return one_of_values(schema, schema["enum"], value, path);
    if (schema.contains("const")) return one_of_values(schema, Json::array({schema["const"]}), value, path);
    const std::string_view kind = kind_of_schema(schema);
    if (kind_of_value(value) != kind) return mismatch(schema, value, path);
    if (kind == "number") number(schema, value, path);
    if (kind == "array") array(schema, value, path);
    if (kind == "object") object(schema, value, path);
  }

 private:
  // parameter "body/radius" of world "x"
  std::string name(const std::string& path) const {
    return (path.empty() ? context_.noun + "s" : context_.noun + " " + quote(path.substr(1), 100)) + of();
  }
  std::string of() const { return context_.subject.empty() ? "" : " of " + context_.subject; }

  void report(const std::string& path, std::string message, std::string hint = {}, bool at_key = false) {
    if (diagnostics_.full()) return diagnostics_.add(Diagnostic{});  // only counted
    Diagnostic diagnostic;
    if (context_.document != nullptr) {
      diagnostic = context_.document->at(base_ + path, std::move(message), at_key);
    } else {
      diagnostic.message = std::move(message);
      diagnostic.pointer = base_ + path;
    }
    diagnostic.hint = std::move(hint);
    diagnostic.notes.insert(diagnostic.notes.end(), context_.notes.begin(), context_.notes.end());
    diagnostics_.add(std::move(diagnostic));
  }

  void mismatch(const Json& schema, const Json& value, const std::string& path, std::string hint = {}) {
    const std::string_view kind = kind_of_schema(schema);
    if (hint.empty() && kind == "boolean") hint = "write true or false";
    if (hint.empty() && kind == "number" && value.is_string()) hint = "a number has no quotes";
    report(path, name(path) + ": expected " + allowed(schema) + ", found " + shown(value), std::move(hint));
  }

  void one_of_values(const Json& schema, const Json& values, Json& value, const std::string& path) {
    std::vector<std::string> texts;
    for (const Json& possible : values) {
      if (same_value(possible, value)) {
        value = possible;
        return;
      }
      if (possible.is_string()) texts.push_back(possible);
    }
    mismatch(schema, value, path, near(value, texts));
  }

  static std::string near(const Json& value, const std::vector<std::string>& texts) {
    const std::string best = value.is_string() ? did_you_mean(value.get_ref<const std::string&>(), texts) : "";
    return best.empty() ? "" : "did you mean " + quote(best) + "?";
  }

  void number(const Json& schema, Json& value, const std::string& path) {
    const bool integer = schema.value("type", "") == "integer";
    const double x = value.get<double>();
    if ((integer || value.is_number_integer()) && !(std::fabs(x) <= exact && (x != exact || is_exact(value))))
      return report(path, name(path) + ": expected an integer of at most 2^53 in size, found " + shown(value),
                    "larger ones are not exact");
    if (!std::isfinite(x) || (integer && x != std::floor(x))) return mismatch(schema, value, path);
    const bool inside = (!schema.contains("minimum") || x >= schema["minimum"].get<double>()) &&
                        (!schema.contains("maximum") || x <= schema["maximum"].get<double>()) &&
                        (!schema.contains("exclusiveMinimum") || x > schema["exclusiveMinimum"].get<double>()) &&
                        (!schema.contains("exclusiveMaximum") || x < schema["exclusiveMaximum"].get<double>());
    if (!inside) return mismatch(schema, value, path);
    if (integer && x >= 0)
      value = static_cast<std::uint64_t>(x);
    else if (integer)
      value = static_cast<std::int64_t>(x);
    else
      value = x;
  }

  static bool is_exact(const Json& value) {  // 2^53 + 1 becomes 2^53 as a double
    if (value.is_number_unsigned()) return value.get<std::uint64_t>() <= std::uint64_t{1} << 53;
    return value.is_number_float() || value.get<std::int64_t>() <= std::int64_t{1} << 53;
  }

  void array(const Json& schema, Json& value, const std::string& path) {
    const std::size_t n = value.size();
    if ((schema.contains("minItems") && n < schema["minItems"].get<std::size_t>()) ||
        (schema.contains("maxItems") && n > schema["maxItems"].get<std::size_t>()))
      mismatch(schema, value, path);
    if (!schema.contains("items")) return;
    for (std::size_t i = 0; i < n; ++i) check(schema["items"], value[i], path + "/" + std::to_string(i));
  }

  void object(const Json& schema, Json& value, const std::string& path) {
    static const Json none = Json::object();
    const Json& properties = schema.contains("properties") ? schema["properties"] : none;
    std::set<std::string> meant;  // what misspelt keys stand for is not reported as missing once more
    for (const auto& [key, member] : value.items())
      if (!properties.contains(key)) meant.insert(unknown(properties, value, key, path));
    if (schema.contains("required"))
      for (const Json& key : schema["required"])
        if (const std::string& required = key.get_ref<const std::string&>();
            !value.contains(required) && !properties[required].contains("default") && !meant.contains(required))
          missing(properties[required], required, path);
    for (const auto& [key, property] : properties.items()) {
      if (!value.contains(key) && property.contains("default")) value[key] = property["default"];
      if (value.contains(key)) check(property, value[key], path + "/" + pointer_token(key));
    }
  }

  std::string unknown(const Json& properties, const Json& value, const std::string& key, const std::string& path) {
    std::vector<std::string> known, free;
    for (const auto& [property, schema] : properties.items()) {
      known.push_back(property);
      if (!value.contains(property)) free.push_back(property);
    }
    const std::string best = diagnostics_.full() ? "" : did_you_mean(key, free);
    std::string hint = known.empty() ? "there are none here" : "expected " + quote_list(known);
    if (!best.empty()) hint = "did you mean " + quote(best) + "? (" + describe(properties[best]) + ")";
    const std::string own = path + "/" + pointer_token(key);
    const std::string subject = context_.subject.empty() ? "" : " for " + context_.subject;
    report(own, "unknown " + context_.noun + " " + quote(own.substr(1), 100) + subject, std::move(hint), true);
    return best;
  }

  void missing(const Json& property, const std::string& key, const std::string& path) {
    const std::string own = path + "/" + pointer_token(key);
    report(path, "missing " + context_.noun + " " + quote(own.substr(1), 100) + of(), describe(property));
  }

  void choose(const Json& schema, Json& value, const std::string& path) {
    const auto branches = alternatives(schema, kind_of_value(value));
    if (branches.empty()) return mismatch(schema, value, path);
    if (branches.size() == 1) return check(*branches.front(), value, path);
    const std::string key = discriminator(branches);
    const std::string own = path + "/" + pointer_token(key);
    std::vector<Json> values;
    std::vector<std::string> texts;
    for (const Json* branch : branches) {
      const Json& property = (*branch)["properties"][key];
      if (value.contains(key) ? same_value(value[key], property["const"]) : property.contains("default"))
        return check(*branch, value, path);
      values.push_back(property["const"]);
      if (property["const"].is_string()) texts.push_back(property["const"]);
    }
    if (!value.contains(key))
      return report(path, "missing " + context_.noun + " " + quote(own.substr(1), 100) + of(), shown_list(values));
    report(own, name(own) + ": expected " + shown_list(values) + ", found " + shown(value[key]),
           near(value[key], texts));
  }

  const std::string& base_;
  const SchemaContext& context_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_schema(const Json& schema, Json& value, const std::string& pointer, const SchemaContext& context,
                  Diagnostics& diagnostics) {
  Checker(pointer, context, diagnostics).check(schema, value, "");
}

}  // namespace wend::core
