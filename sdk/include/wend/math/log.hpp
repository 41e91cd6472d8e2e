// wend/math/log.hpp -- log, log1p, pow.  Include wend/math.hpp, which states the rules.
#pragma once

#include <wend/math/exact.hpp>
#include <wend/math/exp.hpp>

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

namespace wend::math {
namespace detail {

// x = 2^k m, sqrt(1/2) <= m < sqrt(2).
struct Scaled {
  double m, k;
};

// x positive and finite.
[[gnu::always_inline]] inline Scaled scaled(double x) {
  const bool subnormal = x < 0x1p-1022;
  const uint64_t bits = to_bits(subnormal ? x * 0x1p54 : x);
  const int64_t steps = static_cast<int64_t>(bits - 0x3fe6a09e667f3bcd) >> 52;
  return {from_bits(bits - (static_cast<uint64_t>(steps) << 52)), static_cast<double>(subnormal ? steps - 54 : steps)};
}

// k ln 2 + log(1 + f) + y.  With s = f / (2 + f): log(1 + f) = 2 s + 2/3 s^3 + ... = f - (h - s (h + R)), h = f^2 / 2
// (fdlibm); k ln 2 + f is summed exactly, for they cancel where k = -1.
[[gnu::always_inline]] inline double log_of(double k, double f, double y) {
  const double s = f / (2 + f);
  const double z = s * s;
  const double series =
      z * polynomial(z, 0x1.5555555555558p-1, 0x1.99999999952ccp-2, 0x1.2492492df3ba9p-2, 0x1.c71c62e26208bp-3,
                     0x1.7462b58e46ebep-3, 0x1.39fe42e9740a7p-3, 0x1.2b59b713616c9p-3);
  const double half = 0.5 * f * f;
  const Pair head = sum_ordered(k * ln2_1, f);
  return head.hi + (head.lo - ((half - s * (half + series)) - (k * ln2_2 + y)));
}

// log(x) to about 2^-68, x positive and finite: the same series, its first three terms as pairs.
inline Pair log_pair(double x) {
  const Scaled a = scaled(x);
  const Pair s = divide({a.m - 1, 0}, sum(1, a.m));
  const Pair z = multiply(s, s);
  const double rest =
      z.hi * polynomial(z.hi, 0x1.2492492492492p-3, 0x1.c71c71c71c822p-4, 0x1.745d1745a3e7ep-4, 0x1.3b13b16b51d17p-4,
                        0x1.1110f802a59d2p-4, 0x1.e1effbda89487p-5, 0x1.acf8269f12143p-5, 0x1.b2e20ce5e5f88p-5);
  const Pair fifth = sum_ordered(0x1.999999999999ap-3, rest);
  Pair series = multiply({fifth.hi, fifth.lo - 0x1.999999999999ap-57}, z);
  const Pair third = sum_ordered(0x1.5555555555555p-2, series.hi);
  series = multiply({third.hi, third.lo + (series.lo + 0x1.5555555555555p-56)}, multiply(z, s));
  const Pair half = sum_ordered(s.hi, series.hi);
  const Pair head = sum(a.k * ln2_1, 2 * half.hi);
  return sum_ordered(head.hi, head.lo + (2 * (half.lo + (s.lo + series.lo)) + a.k * ln2_2));
}

// |x|^y for 0 < |x| < infinity, y finite.
inline double pow_of_magnitude(double x, double y) {
  // |log x| >= 2^-53 unless x = 1, so beyond 2^66 the result is 0, 1 or infinity whatever y is.
  if (magnitude(y) > 0x1p66) y = with_sign(0x1p66, y);
  const Pair log = log_pair(x);
  const Pair p = product(log.hi, y);
  const Pair exponent = sum_ordered(p.hi, p.lo + log.lo * y);
  return exp_of_sum(exponent.hi, exponent.lo);
}

enum class Parity { fraction, odd, even };

// y finite.  From 2^53 on all doubles are even.
inline Parity parity(double y) {
  if (magnitude(y) >= 0x1p53) return Parity::even;
  const int64_t integer = static_cast<int64_t>(y);
  if (static_cast<double>(integer) != y) return Parity::fraction;
  return integer % 2 == 0 ? Parity::even : Parity::odd;
}

}  // namespace detail

/// log(x), natural; -infinity at 0, NaN below.  Error < 0.95 ulp.
inline double log(double x) {
  if (!(x > 0)) return x == 0 ? -detail::infinity : detail::not_a_number;
  if (x == detail::infinity) return x;
  const detail::Scaled a = detail::scaled(x);
  return detail::log_of(a.k, a.m - 1, 0);
}

/// log(1 + x) without the rounding of 1 + x; -infinity at -1, NaN below.  Error < 0.95 ulp.
inline double log1p(double x) {
  if (detail::magnitude(x) < 0x1p-54) return x;
  if (!(x > -1)) return x == -1 ? -detail::infinity : detail::not_a_number;
  if (x == detail::infinity) return x;
  const detail::Pair u = detail::sum(1, x);
  const detail::Scaled a = detail::scaled(u.hi);
  return a.k == 0 ? detail::log_of(0, x, 0) : detail::log_of(a.k, a.m - 1, u.lo / u.hi);
}

/// x^y, C's rules for the special cases: pow(x, 0) and pow(1, y) are 1 even for NaN; NaN for x < 0 and fractional y.
/// Error < 0.85 ulp (1 ulp if subnormal).
inline double pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (detail::is_nan(x) || detail::is_nan(y)) return detail::not_a_number;
  const double size = detail::magnitude(x);
  if (detail::magnitude(y) == detail::infinity) {
    if (size == 1) return 1;
    return (size > 1) == (y > 0) ? detail::infinity : 0;
  }
  const bool below = detail::with_sign(1, x) < 0;
  const detail::Parity parity = below ? detail::parity(y) : detail::Parity::even;
  const double sign = parity == detail::Parity::odd ? -1 : 1;
  if (size == 0 || size == detail::infinity) return sign * ((size == 0) == (y < 0) ? detail::infinity : 0);
  if (parity == detail::Parity::fraction) return detail::not_a_number;
  return sign * detail::pow_of_magnitude(size, y);
}

}  // namespace wend::math
