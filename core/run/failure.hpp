// Why a unit of work failed: thrown inside a worker, reported with its cause, and nothing but that unit is lost.
#pragma once
#include <stdexcept>
#include <string>

namespace wend::core {

class UnitFailed : public std::runtime_error {
 public:
  // cause: "plugin" (it returned an error), "rule" (it broke one of the header's), "load", "state", "training",
  // "files".
  UnitFailed(std::string cause, const std::string& message) : std::runtime_error(message), cause_(std::move(cause)) {}
  const std::string& cause() const noexcept { return cause_; }

 private:
  std::string cause_;
};

// As a message shows it: the shortest digits that are this number, or NaN, infinity, -infinity.
std::string as_text(double value);

}  // namespace wend::core
