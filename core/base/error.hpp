// The host's own errors: a message for a person and the exit code it leads to.
#pragma once
#include <stdexcept>
#include <string>

namespace wend::core {

enum class Exit : int { ok = 0, cells_failed = 1, usage = 2, configuration = 3, plugin = 4, data = 5, mismatch = 6 };

class Error : public std::runtime_error {
 public:
  Error(Exit exit, const std::string& message) : std::runtime_error(message), exit_(exit) {}
  Exit exit() const noexcept { return exit_; }

 private:
  Exit exit_;
};

}  // namespace wend::core
