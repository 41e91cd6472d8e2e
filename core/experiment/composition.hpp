// Components as an experiment composes them: types looked up in the catalog, parameters checked, slots filled, to any
// depth.
#pragma once
#include <core/experiment/scope.hpp>
#include <core/experiment/unit.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace wend::core {

// A component that calls interfaces of its world.
struct Need {
  std::string pointer, who;  // who: sensor "wend.range"
  std::vector<std::string> interfaces;
};

struct Composed {
  ComponentSpec spec;
  const ComponentEntry* entry = nullptr;  // nullptr: what was wrong is reported
  std::uint32_t files = 0;                // how many files its longest "files" parameter names
};

// `value` is the type alone, or an object of type, params and slots; it becomes the object, with defaults and paths
// filled in.  `interface` is what its place asks for; `needs` grows by what it and the components in its slots need.
Composed compose(const Scope& scope, Json& value, const std::string& pointer, const std::string& interface,
                 std::vector<Need>& needs);

// The same for an object with further keys, which the caller has checked.
Composed compose_object(const Scope& scope, Json& object, const std::string& pointer, const std::string& interface,
                        std::vector<Need>& needs);

// Does the component answer for the interface, or, if it forwards a slot, what stands in there?
bool answers(const Catalog& catalog, const ComponentSpec& spec, std::string_view interface);

// Is `true_of` true of the entry of the component, or of one in its slots, at any depth?
bool any_entry(const Catalog& catalog, const ComponentSpec& spec, bool (*true_of)(const ComponentEntry&));

}  // namespace wend::core
