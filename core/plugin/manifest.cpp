#include <wend/abi.h>

#include <algorithm>
#include <core/base/document.hpp>
#include <core/base/error.hpp>
#include <core/plugin/manifest.hpp>
#include <core/plugin/schema.hpp>
#include <core/plugin/schema_kind.hpp>
#include <set>

namespace wend::core {
namespace {

// All that this version of the host knows; a plugin may add its own under other names than wend.
const std::vector<std::string> known_interfaces{WEND_WORLD,     WEND_SENSOR, WEND_POLICY,    WEND_LEARNER,
                                                WEND_REWARD,    WEND_STATE,  WEND_VALUES,    WEND_SCENE,
                                                WEND_TELEMETRY, WEND_BODY,   WEND_GEOMETRY2D};
const std::vector<std::string> component_keys{"id",     "summary",    "interfaces", "slots",    "uses",
                                              "action", "parameters", "robot",      "forwards", "privileged"};

bool is_name(std::string_view text) {
  return !text.empty() && text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.-") == std::string_view::npos;
}

class Reader {
 public:
  Reader(const Document& document, Diagnostics& diagnostics) : document_(document), diagnostics_(diagnostics) {}

  Manifest manifest() {
    Manifest out;
    const Json& root = document_.root();
    if (!is(root, "object", "")) return out;
    keys(root, {"wend", "name", "version", "license", "components"}, "", "a manifest");
    const Json& version = need(root, "wend", "number", "");
    if (version.is_number() && version != Json(1))
      report("/wend", "expected manifest version 1, found " + version.dump(),
             "this host is older or newer than the plugin's SDK");
    out.name = name(root, "name", "");
    out.version = text(root, "version", "");
    out.license = text(root, "license", "", false);
    const Json& components = need(root, "components", "array", "");
    if (components.is_array() && components.empty()) report("/components", "expected at least one component");
    std::set<std::string> ids;
    for (std::size_t i = 0; components.is_array() && i < components.size(); ++i) {
      const std::string at = "/components/" + std::to_string(i);
      if (!is(components[i], "object", at)) continue;
      out.components.push_back(component(components[i], at));
      const std::string& id = out.components.back().id;
      if (!id.empty() && !ids.insert(id).second) report(at + "/id", "two components are called " + quote(id));
    }
    return out;
  }

 private:
  void report(const std::string& at, std::string message, std::string hint = {}, bool at_key = false) {
    Diagnostic diagnostic = document_.at(at, std::move(message), at_key);
    diagnostic.hint = std::move(hint);
    diagnostics_.add(std::move(diagnostic));
  }

  static std::string sub(const std::string& at, const std::string& key) { return at + "/" + pointer_token(key); }

  bool is(const Json& value, std::string_view kind, const std::string& at) {
    if (kind_of_value(value) == kind) return true;
    report(at, "expected " + std::string(kind == "array" || kind == "object" ? "an " : "a ") + std::string(kind) +
                   ", found " + shown(value));
    return false;
  }

  void keys(const Json& object, const std::vector<std::string>& known, const std::string& at, const std::string& of) {
    for (const auto& [key, value] : object.items()) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      const std::string best = did_you_mean(key, known);
      report(sub(at, key), "unknown key " + quote(key) + " in " + of,
             best.empty() ? "expected " + quote_list(known) : "did you mean " + quote(best) + "?", true);
    }
  }

  // The member of that kind, or null where it is missing or of another kind, which is reported.
  const Json& need(const Json& object, const std::string& key, std::string_view kind, const std::string& at,
                   bool required = true) {
    static const Json none;
    const auto found = object.find(key);
    if (found == object.end()) {
      if (required) report(at, "missing key " + quote(key));
      return none;
    }
    return is(*found, kind, sub(at, key)) ? *found : none;
  }

  std::string text(const Json& object, const std::string& key, const std::string& at, bool required = true) {
    const Json& value = need(object, key, "string", at, required);
    return value.is_string() ? value.get<std::string>() : std::string();
  }

  std::string name(const Json& object, const std::string& key, const std::string& at) {
    const std::string value = text(object, key, at);
    if (object.contains(key) && object[key].is_string() && !is_name(value))
      report(sub(at, key), "expected a name of a-z, 0-9, _ . and -, found " + quote(value));
    return value;
  }

  bool flag(const Json& object, const std::string& key, const std::string& at) {
    const Json& value = need(object, key, "boolean", at, false);
    return value.is_boolean() && value.get<bool>();
  }

  std::string interface(const Json& value, const std::string& at) {
    if (!is(value, "string", at)) return {};
    const std::string id = value.get<std::string>();
    const std::size_t slash = id.find('/');
    const std::string version = slash == std::string::npos ? "" : id.substr(slash + 1);
    const bool well_formed = is_name(id.substr(0, slash)) && !version.empty() && version.size() < 6 &&
                             version.find_first_not_of("0123456789") == std::string::npos;
    const bool known = std::find(known_interfaces.begin(), known_interfaces.end(), id) != known_interfaces.end();
    if (known || (well_formed && !id.starts_with("wend."))) return id;
    const std::string best = did_you_mean(id, known_interfaces);
    const std::string hint = best.empty() ? "" : "did you mean " + quote(best) + "?";
    report(at,
           well_formed ? "this host knows no interface " + quote(id)
                       : "expected an interface like \"wend.policy/1\", found " + quote(id),
           hint);
    return id;
  }

  std::vector<std::string> interfaces(const Json& object, const std::string& at) {
    std::vector<std::string> all;
    const Json& list = need(object, "interfaces", "array", at);
    for (std::size_t i = 0; list.is_array() && i < list.size(); ++i) {
      const std::string own = at + "/interfaces/" + std::to_string(i);
      const std::string id = interface(list[i], own);
      if (!id.empty() && std::find(all.begin(), all.end(), id) != all.end())
        report(own, quote(id) + " stands here twice");
      if (!id.empty()) all.push_back(id);
    }
    if (list.is_array() && list.empty()) report(at + "/interfaces", "expected at least one interface");
    return all;
  }

  Json schema(const Json& object, const std::string& key, const std::string& at) {
    const Json& value = need(object, key, "object", at, false);
    if (!value.is_object()) return {{"type", "object"}, {"properties", Json::object()}};
    const std::string own = sub(at, key);
    check_schema_itself(value, own, &document_, diagnostics_);
    const bool object_type = value.contains("type") && value["type"] == Json("object");
    if (!object_type) report(own, "expected a schema with \"type\": \"object\"");
    return value;
  }

  ComponentEntry component(const Json& object, const std::string& at) {
    ComponentEntry out;
    keys(object, component_keys, at, "a component");
    out.id = name(object, "id", at);
    out.summary = text(object, "summary", at);
    out.interfaces = interfaces(object, at);
    slots(object, at, out);
    uses(object, at, out);
    if (object.contains("action")) out.action = text(object, "action", at);
    if (out.action != "discrete" && out.action != "continuous" && out.action != "any" && object["action"].is_string())
      report(at + "/action", "expected \"discrete\", \"continuous\" or \"any\", found " + quote(out.action));
    out.forwards = text(object, "forwards", at, false);
    if (!out.forwards.empty() && !out.slots.contains(out.forwards))
      report(at + "/forwards", "expected the name of a slot, found " + quote(out.forwards));
    out.privileged = flag(object, "privileged", at);
    out.parameters = schema(object, "parameters", at);
    if (object.contains("robot")) out.robot = schema(object, "robot", at);
    roles(object, at, out);
    return out;
  }

  void slots(const Json& object, const std::string& at, ComponentEntry& out) {
    const Json& all = need(object, "slots", "object", at, false);
    if (!all.is_object()) return;
    for (const auto& [key, slot] : all.items()) {
      const std::string own = sub(at + "/slots", key);
      if (!is_name(key)) report(own, "expected a name of a-z, 0-9, _ . and -, found " + quote(key), "", true);
      if (!is(slot, "object", own)) continue;
      keys(slot, {"interface", "required", "summary"}, own, "a slot");
      ComponentEntry::Slot& entry = out.slots[key];
      if (need(slot, "interface", "string", own).is_string())
        entry.interface = interface(slot["interface"], own + "/interface");
      entry.required = flag(slot, "required", own);
      entry.summary = text(slot, "summary", own, false);
    }
  }

  void uses(const Json& object, const std::string& at, ComponentEntry& out) {
    const Json& all = need(object, "uses", "object", at, false);
    if (!all.is_object()) return;
    for (const auto& [key, use] : all.items()) {
      const std::string own = sub(at + "/uses", key);
      if (key != "world") report(own, "unknown use " + quote(key), "the host lends \"world\"", true);
      if (!is(use, "object", own)) continue;
      keys(use, {"interfaces"}, own, "a use");
      out.uses[key] = interfaces(use, own);
    }
  }

  // What an interface asks for beside it, and what it makes of the component.
  void roles(const Json& object, const std::string& at, ComponentEntry& out) {
    if (out.answers(WEND_LEARNER) && out.forwards.empty())
      for (const char* beside : {WEND_POLICY, WEND_STATE})
        if (!out.answers(beside)) report(at + "/interfaces", "a learner also answers for " + quote(beside));
    if (object.contains("robot") && !out.answers(WEND_WORLD))
      report(at + "/robot", "only a world has \"robot\"", "", true);
    if (out.answers(WEND_WORLD) && !out.uses.empty()) report(at + "/uses", "a world uses nothing", "", true);
    const auto used = out.uses.find("world");
    if (!out.answers(WEND_POLICY) || used == out.uses.end()) return;
    for (const std::string& id : used->second) out.privileged |= id == WEND_GEOMETRY2D || id == WEND_SCENE;
  }

  const Document& document_;
  Diagnostics& diagnostics_;
};

}  // namespace

bool ComponentEntry::answers(std::string_view interface) const {
  return std::find(interfaces.begin(), interfaces.end(), interface) != interfaces.end();
}

Manifest parse_manifest(const std::string& file, const std::string& text) {
  Diagnostics diagnostics;
  Manifest manifest;
  const auto document = Document::parse(file + " (.wend.manifest)", text, diagnostics);
  if (document) manifest = Reader(*document, diagnostics).manifest();
  if (diagnostics.any()) {
    std::string all = diagnostics.text();
    all.pop_back();  // the last newline
    throw Error(Exit::plugin, all);
  }
  manifest.file = file;
  return manifest;
}

std::string role(const ComponentEntry& entry) {
  for (const auto& [id, word] :
       {std::pair(WEND_WORLD, "world"), std::pair(WEND_SENSOR, "sensor"), std::pair(WEND_LEARNER, "learner"),
        std::pair(WEND_POLICY, "policy"), std::pair(WEND_REWARD, "reward")})
    if (entry.answers(id) && !(std::string_view(word) == "learner" && !entry.forwards.empty())) return word;
  return "component";
}

std::string title(const ComponentEntry& entry) {
  return role(entry) + " " + quote(entry.id);
}

}  // namespace wend::core
