// What a plugin says about itself: its components, what they answer for, need and take as parameters.
#pragma once
#include <core/base/json.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace wend::core {

struct ComponentEntry {
  struct Slot {
    std::string interface;
    bool required = false;
    std::string summary;
  };

  std::string id, summary;
  std::string action = "any";           // "discrete", "continuous" or "any"
  std::vector<std::string> interfaces;  // "wend.policy/1"
  std::map<std::string, Slot> slots;
  std::map<std::string, std::vector<std::string>> uses;  // "world" -> interfaces it calls
  std::string forwards;                                  // the slot on whose behalf it answers, or empty
  bool privileged = false;                               // a policy that reads the true map, said or seen from `uses`
  Json parameters;                                       // schema of an object, never null
  Json robot;                                            // worlds: schema of the robot definition, or null

  bool answers(std::string_view interface) const;
};

struct Manifest {
  std::string name, version, license, file;
  std::vector<ComponentEntry> components;
};

// Strict; throws Error(Exit::plugin) that lists all that is wrong with its position.  `file` names the plugin in
// messages.
Manifest parse_manifest(const std::string& file, const std::string& text);

// What messages call it: "world", "sensor", "learner", "policy", "reward", or "component".
std::string role(const ComponentEntry& entry);

// role and id: learner "my.learner"
std::string title(const ComponentEntry& entry);

}  // namespace wend::core
