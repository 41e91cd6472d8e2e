// What components tell of themselves: gathered under names that say whose it is ("avoid.residual").
#pragma once
#include <core/run/driver.hpp>
#include <core/run/stage.hpp>

#include <string>
#include <vector>

namespace wend::core {

// The telemetry of one kind (WEND_PER_STEP, ...) of a world and a driver.
class Telemetry {
 public:
  // The world's columns keep their names, as do the root policy's; what stands in slots is prefixed by its path.
  Telemetry(std::uint32_t when, const Stage* stage, const Driver* driver);

  const std::vector<std::string>& names() const noexcept { return names_; }
  // One row of values (names() wide) for each of the rows; NaN where it does not apply.
  std::vector<double> read(const std::vector<std::uint32_t>& rows) const;
  // PER_UPDATE: of the whole object.
  std::vector<double> read() const;

 private:
  struct Source {
    const Instance* instance;
    const wend_telemetry* table;
    std::size_t offset, width;
  };
  void add(const Instance& instance, const std::string& prefix);
  std::vector<double> gather(const std::uint32_t* rows, std::uint32_t n) const;

  std::uint32_t when_;
  std::vector<Source> sources_;
  std::vector<std::string> names_;
};

}  // namespace wend::core
