#include <algorithm>
#include <core/experiment/schema.hpp>
#include <core/experiment/scope.hpp>
#include <core/plugin/schema.hpp>
#include <utility>

namespace wend::core {

namespace {

constexpr std::size_t longest_id = 64;

bool of_an_id(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
         c == '+' || c == '-';
}

}  // namespace

void Scope::error(const std::string& pointer, std::string message, std::string hint, bool key) const {
  Diagnostic diagnostic = document.at(pointer, std::move(message), key);
  diagnostic.hint = std::move(hint);
  diagnostics.add(std::move(diagnostic));
}

void Scope::unknown(const std::string& pointer, const std::string& what, const std::string& word,
                    const std::string& where, const std::vector<std::string>& known, bool key) const {
  const std::string near = did_you_mean(word, known);
  std::string hint = "there is none";
  if (!near.empty()) {
    hint = "did you mean " + quote(near) + "?";
  } else if (!known.empty()) {
    hint = "expected " + quote_list(known);
  }
  error(pointer, "unknown " + what + " " + quote(word) + where, hint, key);
}

void Scope::check(const std::string& part, Json& value, const std::string& pointer, const std::string& subject) const {
  const SchemaPart& form = experiment_schema(part);
  Json kept = Json::object();  // what stands in open places, while the checker sees something harmless there
  for (const auto& [name, kind] : form.open) {
    if (!value.is_object() || !value.contains(name) || (kind == "object" && !value[name].is_object())) continue;
    kept[name] = std::exchange(value[name], kind == "object" ? Json::object() : Json(""));
  }
  check_schema(form.schema, value, pointer, {subject, &document, {}, "key"}, diagnostics);
  for (auto& [name, original] : kept.items()) value[name] = std::move(original);
}

bool Scope::check_id(const std::string& pointer, const std::string& what, const std::string& id) const {
  const bool good = !id.empty() && id.size() <= longest_id && std::all_of(id.begin(), id.end(), of_an_id) &&
                    id[0] != '.' && id[0] != '-';
  if (!good)
    error(pointer, what + " id " + quote(id) + " cannot be used",
          "expected 1 to 64 letters, digits and _ . + -, not a . or - first");
  return good;
}

void Scope::check_unique(const std::string& what, const std::string& pointer,
                         const std::vector<std::string>& ids) const {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto first = static_cast<std::size_t>(std::find(ids.begin(), ids.end(), ids[i]) - ids.begin());
    if (ids[i].empty() || first == i) continue;
    error(element(pointer, i) + "/id", "two " + what + "s have the id " + quote(ids[i]),
          "the first is " + element(pointer, first));
  }
}

void Scope::report_assets() const {
  for (const Assets::Problem& problem : assets.take_problems()) error(problem.pointer, problem.message, problem.hint);
}

std::string element(const std::string& pointer, std::size_t i) {
  return pointer + "/" + std::to_string(i);
}

const Json* member(const Json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

std::string text_in(const Json& object, const char* key) {
  const Json* value = member(object, key);
  return value && value->is_string() ? value->get<std::string>() : std::string();
}

std::optional<std::uint64_t> count_in(const Json& object, const char* key) {
  const Json* value = member(object, key);
  if (!value || !value->is_number_integer()) return std::nullopt;
  if (!value->is_number_unsigned() && value->get<std::int64_t>() < 0) return std::nullopt;
  return value->get<std::uint64_t>();
}

}  // namespace wend::core
