#include <wend/abi.h>

#include <algorithm>
#include <core/experiment/composition.hpp>
#include <core/plugin/schema.hpp>
#include <utility>

namespace wend::core {

namespace {

// What people call something that answers for the interface.
std::string called(const std::string& interface) {
  for (const auto& [id, word] : {std::pair{WEND_WORLD, "world type"},
                                 {WEND_SENSOR, "sensor"},
                                 {WEND_POLICY, "policy"},
                                 {WEND_LEARNER, "learner"},
                                 {WEND_REWARD, "reward"}})
    if (interface == id) return word;
  return "component for " + quote(interface);
}

const ComponentEntry* look_up(const Scope& scope, const std::string& type, const std::string& pointer,
                              const std::string& interface) {
  const std::vector<std::string> fitting = scope.catalog.ids(interface);
  if (const auto problem = scope.catalog.problem(type)) {
    scope.error(pointer, called(interface) + " " + quote(type) + " cannot be used: " + *problem);
    return nullptr;
  }
  const ComponentEntry* entry = scope.catalog.find(type);
  if (entry == nullptr) {
    scope.unknown(pointer, called(interface), type, "", fitting);
  } else if (!entry->answers(interface)) {
    scope.error(pointer, "expected a " + called(interface) + ", found " + title(*entry),
                fitting.empty() ? "" : "expected " + quote_list(fitting));
    entry = nullptr;
  }
  return entry;
}

void fill_slots(const Scope& scope, Json& object, const std::string& pointer, const ComponentEntry& entry,
                ComponentSpec& spec, std::vector<Need>& needs) {
  Json none = Json::object();
  Json& slots = object.contains("slots") ? object["slots"] : none;
  if (!slots.is_object()) {
    scope.error(pointer + "/slots", "expected components by slot, found " + quote(slots.dump()));
    return;
  }
  std::vector<std::string> names;
  for (const auto& slot : entry.slots) names.push_back(slot.first);
  for (auto& [name, value] : slots.items()) {
    const std::string at = pointer + "/slots/" + pointer_token(name);
    const auto slot = entry.slots.find(name);
    if (slot == entry.slots.end()) {
      scope.unknown(at, "slot", name, " of " + title(entry), names, true);
    } else {
      Composed inner = compose(scope, value, at, slot->second.interface, needs);
      if (inner.entry) spec.slots.emplace(name, std::move(inner.spec));
    }
  }
  for (const auto& [name, slot] : entry.slots)
    if (slot.required && !slots.contains(name))
      scope.error(pointer, title(entry) + " needs a " + called(slot.interface) + " in its slot " + quote(name),
                  "add \"slots\": {" + quote(name) + ": {\"type\": ...}}");
}

}  // namespace

Composed compose_object(const Scope& scope, Json& object, const std::string& pointer, const std::string& interface,
                        std::vector<Need>& needs) {
  Composed result;
  result.spec.type = text_in(object, "type");
  if (result.spec.type.empty() && !member(object, "type")) return result;  // reported as missing
  if (!object["type"].is_string()) return result;
  result.entry = look_up(scope, result.spec.type, pointer + "/type", interface);
  if (result.entry == nullptr) return result;
  const ComponentEntry& entry = *result.entry;

  Json& params = object.emplace("params", Json::object()).first.value();
  result.files = scope.assets.resolve(entry.parameters, params, pointer + "/params", result.spec.content);
  scope.report_assets();
  check_schema(entry.parameters, params, pointer + "/params",
               {title(entry), &scope.document, {"all parameters: wend plugins show " + entry.id}, "parameter"},
               scope.diagnostics);
  result.spec.params = params;
  fill_slots(scope, object, pointer, entry, result.spec, needs);
  const auto world = entry.uses.find("world");
  if (world != entry.uses.end()) needs.push_back({pointer, title(entry), world->second});
  return result;
}

Composed compose(const Scope& scope, Json& value, const std::string& pointer, const std::string& interface,
                 std::vector<Need>& needs) {
  if (value.is_string()) value = Json{{"type", value}};
  if (!value.is_object()) {
    scope.error(pointer, "expected a " + called(interface) + ", found " + quote(value.dump()),
                "a type alone, or {\"type\": ..., \"params\": {...}, \"slots\": {...}}");
    return {};
  }
  const std::string type = text_in(value, "type");
  scope.check("component_object", value, pointer, called(interface) + (type.empty() ? "" : " " + quote(type)));
  return compose_object(scope, value, pointer, interface, needs);
}

bool answers(const Catalog& catalog, const ComponentSpec& spec, std::string_view interface) {
  const ComponentEntry* entry = catalog.find(spec.type);
  if (entry == nullptr) return false;
  if (entry->forwards.empty()) return entry->answers(interface);
  const auto slot = spec.slots.find(entry->forwards);
  return slot != spec.slots.end() && answers(catalog, slot->second, interface);
}

bool any_entry(const Catalog& catalog, const ComponentSpec& spec, bool (*true_of)(const ComponentEntry&)) {
  const ComponentEntry* entry = catalog.find(spec.type);
  if (entry != nullptr && true_of(*entry)) return true;
  return std::any_of(spec.slots.begin(), spec.slots.end(),
                     [&](const auto& slot) { return any_entry(catalog, slot.second, true_of); });
}

}  // namespace wend::core
