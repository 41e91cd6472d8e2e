// What a plugin must leave as it found it, because it would reach the results of others in the same process: how
// numbers are rounded, the locale, the working directory.
#pragma once
#include <cfenv>
#include <string>

namespace wend::core {

class ProcessState {
 public:
  ProcessState();

  // Puts back what has changed since, and names it; empty: all is as it was.
  std::string restore() const;

 private:
  std::fenv_t environment_;
  int rounding_;
  unsigned mode_;  // of the vector unit: rounding, flush to zero, traps
  std::string locale_, directory_;
};

}  // namespace wend::core
