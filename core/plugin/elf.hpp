// Reads the manifest out of a shared object without loading it: no code of a plugin runs.
#pragma once
#include <string>

namespace wend::core {

// The text of the section .wend.manifest of a plugin file.  Throws Error(Exit::plugin) with the exact reason, without
// the path, where the file is no x86-64 shared object, is damaged or truncated (dlopen would die of SIGBUS), has no
// manifest or does not export wend_plugin_1.
std::string manifest_section(const std::string& path);

}  // namespace wend::core
