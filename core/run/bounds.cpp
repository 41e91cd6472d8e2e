#include <algorithm>
#include <cmath>
#include <core/run/bounds.hpp>
#include <core/run/failure.hpp>
#include <limits>

namespace wend::core {
namespace {

constexpr double largest = std::numeric_limits<double>::max();

}  // namespace

Bounds::Bounds(const wend_space& space) : low_(space.width), high_(space.width) {
  for (std::uint32_t i = 0; i < space.width; ++i) {
    const wend_column& column = space.columns[i];
    if (column.count != 0) whole_.push_back(i);
    low_[i] = column.count ? 0 : std::max(column.low, -largest);
    high_[i] = column.count ? static_cast<double>(column.count - 1) : std::min(column.high, largest);
  }
}

// With finite limits, in range means finite and not NaN too; no branch, so that the loop is vectorised.
bool Bounds::allows(const double* row) const {
  unsigned inside = 1;
  for (std::size_t i = 0; i < low_.size(); ++i) inside &= unsigned{row[i] >= low_[i]} & unsigned{row[i] <= high_[i]};
  for (const std::size_t i : whole_) inside &= unsigned{row[i] == std::floor(row[i])};
  return inside != 0;
}

std::size_t Bounds::first_outside(const double* values, std::size_t rows) const {
  for (std::size_t row = 0; row < rows; ++row) {
    const double* at = values + row * width();
    if (allows(at)) continue;
    for (std::size_t i = 0; i < width(); ++i) {
      const bool whole = !std::binary_search(whole_.begin(), whole_.end(), i) || at[i] == std::floor(at[i]);
      if (!(at[i] >= low_[i] && at[i] <= high_[i] && whole)) return row * width() + i;
    }
  }
  return rows * width();
}

std::string Bounds::expected(std::size_t column) const {
  const double low = low_[column], high = high_[column];
  if (std::binary_search(whole_.begin(), whole_.end(), column)) return "a whole number 0.." + as_text(high);
  if (low == -largest && high == largest) return "a finite number";
  if (high == largest) return "a number from " + as_text(low);
  if (low == -largest) return "a number up to " + as_text(high);
  return "a number in " + as_text(low) + ".." + as_text(high);
}

double Bounds::any(std::size_t column) const {
  return std::clamp(0.0, low_[column], std::max(low_[column], high_[column]));
}

}  // namespace wend::core
