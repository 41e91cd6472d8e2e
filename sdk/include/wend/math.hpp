// wend/math.hpp -- elementary functions with the same bits on every CPU, compiler and optimisation level.
//
// A C library's sin or exp picks its code by the CPU it finds, so an experiment would change its numbers with the
// machine.  These use only + - * / and sqrt of IEEE doubles, which are exactly defined, in an order the compiler may
// not change.  Three conditions: rounding to nearest, no -ffast-math (an #error), no contraction to fma
// (wend_add_plugin passes -ffp-contract=off).  All are thread-safe, allocate nothing and never touch errno; every
// NaN they return is the quiet positive one; floating-point exception flags mean nothing.
// The bounds in ulp are measured against long double by tests/sdk/math_test.cpp, not proven.
#pragma once

#include <wend/math/arc.hpp>
#include <wend/math/exact.hpp>
#include <wend/math/exp.hpp>
#include <wend/math/log.hpp>
#include <wend/math/trig.hpp>

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

namespace wend::math {

inline constexpr double pi = 0x1.921fb54442d18p+1;
inline constexpr double two_pi = 0x1.921fb54442d18p+2;
inline constexpr double half_pi = 0x1.921fb54442d18p+0;
inline constexpr double ln2 = 0x1.62e42fefa39efp-1;
inline constexpr double sqrt2 = 0x1.6a09e667f3bcdp+0;
inline constexpr double degree = 0x1.1df46a2529d39p-6;  // rad

/// sqrt(x), correctly rounded as IEEE asks; NaN below 0.
inline double sqrt(double x) {
  return x >= 0 ? __builtin_sqrt(x) : detail::not_a_number;
}

/// sqrt(x^2 + y^2) without overflow or underflow on the way; infinity if either is infinite, even beside NaN.
/// Error < 0.60 ulp (1 if subnormal): one Newton step with the residual of the root (Borges 2021, TOMS Algorithm 1014,
/// without fma).
inline double hypot(double x, double y) {
  const double abs_x = detail::magnitude(x), abs_y = detail::magnitude(y);
  if (abs_x == detail::infinity || abs_y == detail::infinity) return detail::infinity;
  if (detail::is_nan(x) || detail::is_nan(y)) return detail::not_a_number;
  double a = abs_x > abs_y ? abs_x : abs_y, b = abs_x > abs_y ? abs_y : abs_x;
  if (b * 0x1p54 <= a) return a + b;
  double unscale = 1;
  if (a > 0x1p510 || b < 0x1p-450) {
    const double factor = a > 1 ? 0x1p-600 : 0x1p600;
    unscale = a > 1 ? 0x1p600 : 0x1p-600;
    a *= factor;
    b *= factor;
  }
  const double h = __builtin_sqrt(a * a + b * b);
  double residual;  // h^2 - a^2 - b^2, its large terms cancelled by hand
  if (h <= 2 * b) {
    const double d = h - b;
    residual = a * (2 * d - a) + (d - 2 * (a - b)) * d;
  } else {
    const double d = h - a;
    residual = 2 * d * (a - 2 * b) + ((4 * d - b) * b + d * d);
  }
  return (h - residual / (2 * h)) * unscale;
}

}  // namespace wend::math
