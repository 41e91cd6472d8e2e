// A body's way in a dt: the one expression for it, which single bodies and blocks of them share.
#pragma once
#include <cmath>
#include <wend/math.hpp>

namespace arena {

// The chord of an arc of length l that turns by 2h is l sin(h)/h long and points h beside the heading.  Leaves the
// heading unwrapped.  `near`: without branches, for |h| and |heading + h| of at most 8192 rad.
template <bool near>
[[gnu::always_inline]] inline void follow(double& x, double& y, double& heading, double speed, double turn_rate,
                                          double seconds) noexcept {
  const double half = 0.5 * turn_rate * seconds;
  const bool straight = std::fabs(half) < 1e-4;  // the next term of the series is below an ulp
  double s = 0, c = 0;
  if constexpr (near) {
    wend::math::sincos_near(half, s, c);
  } else if (!straight) {
    wend::math::sincos(half, s, c);
  }
  const double series = 1 - half * half / 6, quotient = s / half;
  const double chord = speed * seconds * (straight ? series : quotient);
  const double middle = heading + half;
  if constexpr (near) {
    wend::math::sincos_near(middle, s, c);
  } else {
    wend::math::sincos(middle, s, c);
  }
  x += chord * c, y += chord * s;
  heading += 2 * half;
}

}  // namespace arena
