// wend/reading.hpp -- the columns a policy or reward picked by name, read with a check that they are numbers.
#pragma once
#include <cmath>
#include <span>
#include <string>
#include <vector>
#include <wend/space.hpp>

namespace wend {

class Reading {
 public:
  Reading() = default;
  // The columns that fit the patterns, in order; `parameter` is the one that held the patterns.
  Reading(Space space, const std::vector<std::string>& patterns, const std::string& parameter)
      : space_(space), columns_(space.select(patterns, parameter)) {}
  // The one column of that name.
  Reading(Space space, const std::string& name, const std::string& parameter)
      : space_(space), columns_{space.index(name, parameter)} {}

  std::size_t size() const noexcept { return columns_.size(); }
  const wend_column& column(std::size_t i) const noexcept { return space_[columns_[i]]; }
  double bearing(std::size_t i) const noexcept { return column(i).at; }  // rad, of a beam

  // The i-th picked column of an observation row.
  double operator()(std::span<const double> observation, std::size_t i = 0) const {
    const double value = observation[columns_[i]];
    if (!std::isfinite(value)) throw not_finite(i, value);
    return value;
  }

 private:
  Error not_finite(std::size_t i, double value) const {
    const char* found = std::isnan(value) ? "NaN" : value > 0 ? "infinity" : "-infinity";
    return Error(WEND_E_ARGUMENT, {},
                 "observation \"" + std::string(column(i).name) + "\": expected a finite number, found " + found);
  }

  Space space_;
  std::vector<std::uint32_t> columns_;
};

}  // namespace wend
