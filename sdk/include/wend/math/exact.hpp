// wend/math/exact.hpp -- exact building blocks of wend/math.hpp: bits, rounding to an integer, sums and products
// with their rounding error.  Nothing here calls the C library: __builtin_sqrt and __builtin_fabs are instructions.
#pragma once

#include <cstdint>
#include <limits>

#if defined(__FAST_MATH__)
#error "wend/math.hpp needs IEEE arithmetic: remove -ffast-math (and -Ofast)"
#endif
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0
#error "wend/math.hpp needs double arithmetic without excess precision: on 32-bit x86 add -msse2 -mfpmath=sse"
#endif
// A contracted a * b + c rounds once instead of twice and so changes the bits.  g++ has no pragma for this:
// wend_add_plugin passes -ffp-contract=off, and only a build with -mfma (or a -march that has it) needs it.
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

namespace wend::math::detail {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
// Every NaN result is this one: the sign of a computed NaN depends on CPU and compiler.
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

[[gnu::always_inline]] inline uint64_t to_bits(double x) {
  return __builtin_bit_cast(uint64_t, x);
}
[[gnu::always_inline]] inline double from_bits(uint64_t bits) {
  return __builtin_bit_cast(double, bits);
}
[[gnu::always_inline]] inline double magnitude(double x) {
  return __builtin_fabs(x);
}
[[gnu::always_inline]] inline double with_sign(double x, double sign) {
  return __builtin_copysign(x, sign);
}
[[gnu::always_inline]] inline bool is_nan(double x) {
  return x != x;
}

// 2^n, -1022 <= n <= 1023.
[[gnu::always_inline]] inline double power_of_two(int64_t n) {
  return from_bits(static_cast<uint64_t>(n + 1023) << 52);
}

// x 2^n, -2000 <= n <= 2000.  Two factors, because 2^n alone may overflow or underflow where the product does not.
[[gnu::always_inline]] inline double scale(double x, int64_t n) {
  const int64_t half = n >> 1;
  return x * power_of_two(half) * power_of_two(n - half);
}

struct Rounded {
  double value;
  int64_t integer;
};

// The integer nearest to x, ties to even, |x| < 2^51: adding 1.5 * 2^52 leaves no bits for a fraction.
[[gnu::always_inline]] inline Rounded nearest(double x) {
  constexpr double shift = 0x1.8p52;
  const double shifted = x + shift;
  return {shifted - shift, static_cast<int64_t>(to_bits(shifted) - __builtin_bit_cast(uint64_t, shift))};
}

// An unevaluated sum hi + lo, about 106 bits when |lo| <= ulp(hi) / 2.
struct Pair {
  double hi, lo;
};

// a + b exactly, if |a| >= |b| or a = 0 (Dekker 1971).
[[gnu::always_inline]] inline Pair sum_ordered(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

// a + b exactly (Knuth).
[[gnu::always_inline]] inline Pair sum(double a, double b) {
  const double s = a + b;
  const double from_b = s - a;
  return {s, (a - (s - from_b)) + (b - from_b)};
}

// a b exactly, if |a|, |b| < 2^996 and the error, about 2^-53 a b, is no subnormal (Veltkamp, Dekker).
[[gnu::always_inline]] inline Pair product(double a, double b) {
  constexpr double split = 0x1p27 + 1;
  const double a_split = a * split, b_split = b * split;
  const double a1 = a_split - (a_split - a), b1 = b_split - (b_split - b);
  const double a2 = a - a1, b2 = b - b1;
  const double p = a * b;
  return {p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
}

[[gnu::always_inline]] inline Pair multiply(Pair a, Pair b) {
  const Pair p = product(a.hi, b.hi);
  return sum_ordered(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

// a / b: hi is the rounded quotient of the hi parts, lo what is missing.
[[gnu::always_inline]] inline Pair divide(Pair a, Pair b) {
  const double q = a.hi / b.hi;
  const Pair p = product(q, b.hi);
  return {q, (((a.hi - p.hi) - p.lo) + (a.lo - q * b.lo)) / b.hi};
}

// c0 + c1 x + c2 x^2 + ..., as (c0 + c1 x) + x^2 ((c2 + c3 x) + ...): half the latency of Horner's rule.
template <class... Doubles>
[[gnu::always_inline]] inline double polynomial_by_pairs(double x, double xx, double c0, double c1, Doubles... more) {
  if constexpr (sizeof...(more) == 0) {
    return c0 + c1 * x;
  } else if constexpr (sizeof...(more) == 1) {
    return (c0 + c1 * x) + xx * (more + ...);
  } else {
    return (c0 + c1 * x) + xx * polynomial_by_pairs(x, xx, more...);
  }
}

template <class... Doubles>
[[gnu::always_inline]] inline double polynomial(double x, Doubles... coefficients) {
  return polynomial_by_pairs(x, x * x, coefficients...);
}

}  // namespace wend::math::detail
