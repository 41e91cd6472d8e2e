// What a space allows, checked on every row that crosses from a plugin: finite, in range, whole where it is discrete.
#pragma once
#include <wend/abi.h>

#include <cstddef>
#include <string>
#include <vector>

namespace wend::core {

class Bounds {
 public:
  Bounds() = default;
  explicit Bounds(const wend_space& space);

  std::size_t width() const noexcept { return low_.size(); }
  // Index of the first of rows * width() values that is not allowed; rows * width() where all are.
  std::size_t first_outside(const double* values, std::size_t rows) const;
  // "a whole number 0..2", "a number in -1..1", "a number from 0", "a finite number"
  std::string expected(std::size_t column) const;
  // An allowed value, for rows that nobody looks at.
  double any(std::size_t column) const;

 private:
  bool allows(const double* row) const;

  std::vector<double> low_, high_;  // the largest finite numbers where the column has no limit
  std::vector<std::size_t> whole_;  // columns that are discrete
};

}  // namespace wend::core
