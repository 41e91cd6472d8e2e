// Progress on stderr: a bar that redraws itself on a terminal, a plain line every 10 s elsewhere, JSON lines with --json.
#pragma once
#include <core/run/runner.hpp>

#include <string>

namespace wend::app {

class ProgressReport {
 public:
  explicit ProgressReport(bool json);
  void show(const core::Progress& now);
  void tell(const core::RunFailure& failure);
  void end(const core::RunReport& report);

 private:
  std::string line(const core::Progress& now) const;
  void clear();

  bool json_, terminal_, colour_, drawn_ = false;
  double last_ = -1;
};

}  // namespace wend::app
