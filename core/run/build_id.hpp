// What computes: everything that can change a result besides the experiment.
#pragma once
#include <core/base/json.hpp>

#include <map>
#include <string>

namespace wend::core {

constexpr const char* version = WEND_VERSION;

// {"version", "worker": SHA-256 of the program, "compiler", "flags", "isa", "plugins": {component id: SHA-256 of its file}}
Json build_description(const std::map<std::string, std::string>& plugins, const std::string& worker);

// {"command", "started", "host", "cpu"}: for people, in no id.
Json session_description(const std::string& command);

}  // namespace wend::core
