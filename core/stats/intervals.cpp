#include <algorithm>
#include <core/stats/intervals.hpp>
#include <wend/math.hpp>

namespace wend::core {

Interval wilson(std::uint64_t successes, std::uint64_t n) {
  if (n == 0) return {0, 1};
  constexpr double z = 1.959963984540054;  // the normal quantile of 0.975
  const double count = static_cast<double>(n), rate = static_cast<double>(successes) / count;
  const double scale = 1 + z * z / count;
  const double centre = (rate + z * z / (2 * count)) / scale;
  const double half = z / scale * math::sqrt(rate * (1 - rate) / count + z * z / (4 * count * count));
  // At the ends the bound is the rate itself, which rounding would miss by an ulp.
  const double low = successes == 0 ? 0 : std::max(0.0, centre - half);
  const double high = successes >= n ? 1 : std::min(1.0, centre + half);
  return {low, high};
}

}  // namespace wend::core
