// Confidence intervals in closed form.
#pragma once
#include <cstdint>

namespace wend::core {

struct Interval {
  double low = 0, high = 0;
  double width() const { return high - low; }
};

// Wilson's score interval of a proportion, 95 % (Wilson 1927; without continuity correction): it stays in [0, 1] and is
// sound near 0 and 1, where success rates live.  n = 0 says nothing: [0, 1].
Interval wilson(std::uint64_t successes, std::uint64_t n);

}  // namespace wend::core
