// wend/math/exp.hpp -- exp, expm1, tanh.  Include wend/math.hpp, which states the rules.
#pragma once

#include <wend/math/exact.hpp>

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

namespace wend::math {
namespace detail {

// ln 2 in parts of 42 and 53 bits: n times the first is exact for |n| < 2^11.
inline constexpr double ln2_1 = 0x1.62e42fefa3800p-1, ln2_2 = 0x1.ef35793c76730p-45;

// e^(x + y) = 2^n (1 + r + r^2 / 2 + rest), |r| <= ln(2) / 2 (and a little).
struct Exponential {
  double r, rest;
  int64_t n;
};

// |x| <= 1500, |y| <= ulp(x).
[[gnu::always_inline]] inline Exponential exponential(double x, double y) {
  const Rounded n = nearest(x * 0x1.71547652b82fep+0);
  const double above = x - n.value * ln2_1;
  const double below = n.value * ln2_2 - y;
  const double r = above - below;
  const double low = (above - r) - below;
  const double series =
      polynomial(r, 0x1.5555555555556p-3, 0x1.5555555555555p-5, 0x1.11111111109a6p-7, 0x1.6c16c16c167dap-10,
                 0x1.a01a01a7cebcdp-13, 0x1.a01a01a48116fp-16, 0x1.71de0d85293b8p-19, 0x1.27e4e1dcf773bp-22,
                 0x1.af390ba7e6f47p-26, 0x1.1f6717774d5e0p-29);
  return {r, r * r * r * series + (low + low * r), n.integer};
}

// e^(x + y), x no NaN, |y| <= ulp(x); overflow and underflow as they come.
[[gnu::always_inline]] inline double exp_of_sum(double x, double y) {
  if (x > 710) return infinity;
  if (x < -746) return 0;
  const Exponential e = exponential(x, y);
  const Pair head = sum_ordered(1, e.r);
  return scale(head.hi + (head.lo + (0.5 * e.r * e.r + e.rest)), e.n);
}

// (e^x - 1) / 2^n as a pair, and n; |x| <= 710.
struct Expm1 {
  Pair pair;
  int64_t n;
};

inline Expm1 expm1_pair(double x) {
  const Exponential e = exponential(x, 0);
  // Exact sums of 1 - 2^-n, r and r^2 / 2, for they cancel where n = 1.
  const Pair one = sum(1, e.n > 60 ? 0 : -power_of_two(-e.n));
  const Pair linear = sum(one.hi, e.r);
  const Pair square = product(0.5 * e.r, e.r);
  const Pair head = sum(linear.hi, square.hi);
  return {sum_ordered(head.hi, one.lo + linear.lo + head.lo + (square.lo + e.rest)), e.n};
}

}  // namespace detail

/// e^x; overflows to infinity, underflows through the subnormals to 0.  Error < 0.80 ulp (1 ulp if subnormal).
inline double exp(double x) {
  if (detail::is_nan(x)) return detail::not_a_number;
  return detail::exp_of_sum(x, 0);
}

/// e^x - 1 without the cancellation near 0.  Error < 0.70 ulp.
inline double expm1(double x) {
  if (detail::magnitude(x) < 0x1p-54) return x;
  if (detail::is_nan(x)) return detail::not_a_number;
  if (x > 710) return detail::infinity;
  if (x < -40) return -1;
  const detail::Expm1 e = detail::expm1_pair(x);
  return detail::scale(e.pair.hi, e.n);
}

/// tanh(x), in [-1, 1].  Error < 0.70 ulp.  With e = e^2|x| - 1: e / (e + 2), as pairs.
inline double tanh(double x) {
  const double size = detail::magnitude(x);
  if (size < 0x1p-28) return x;
  if (detail::is_nan(x)) return detail::not_a_number;
  if (size > 22) return detail::with_sign(1, x);
  const detail::Expm1 e = detail::expm1_pair(2 * size);
  const double factor = detail::power_of_two(e.n);
  const detail::Pair top = {e.pair.hi * factor, e.pair.lo * factor};
  detail::Pair bottom = detail::sum(top.hi, 2);
  bottom.lo += top.lo;
  const detail::Pair q = detail::divide(top, bottom);
  return detail::with_sign(q.hi + q.lo, x);
}

}  // namespace wend::math
