// wend/math/trig.hpp -- sin, cos, sincos, tan, wrap_angle.  Include wend/math.hpp, which states the rules.
#pragma once

#include <wend/math/exact.hpp>

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

namespace wend::math {
namespace detail {

inline constexpr Pair half_pi_pair = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
inline constexpr Pair pi_pair = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

// x = quadrant * pi/2 + hi + lo, |hi| <= pi/4 (and a little), quadrant modulo 4 in its two low bits.
struct Reduced {
  double hi, lo;
  uint64_t quadrant;
};

// |x| <= near_limit: Cody and Waite with pi/2 in parts of 40, 40 and 53 bits.  The quadrant has 13 bits, so both
// products with a 40-bit part are exact, as is x - n pi_1 (Sterbenz); the error is below 2^-119, and no double in
// this range comes closer than 2^-60 to a multiple of pi/2.
inline constexpr double near_limit = 8192;

[[gnu::always_inline]] inline Reduced reduce_near(double x) {
  constexpr double pi_1 = 0x1.921fb54442000p+0, pi_2 = 0x1.a308d31318000p-41, pi_3 = 0x1.8a2e03707344ap-81;
  const Rounded n = nearest(x * 0x1.45f306dc9c883p-1);
  const double first = x - n.value * pi_1;
  const Pair second = sum(first, -(n.value * pi_2));
  // Subtracting keeps the sign of x = -0.
  const double low = n.value * pi_3 - second.lo;
  const double hi = second.hi - low;
  return {hi, (second.hi - hi) - low, static_cast<uint64_t>(n.integer)};
}

// Any finite |x| > near_limit: Payne and Hanek 1983 in integers.  x = m 2^e; of the bits of 2/pi only the 192 from
// weight 2^(1-e) on matter, since those before make multiples of 4 quadrants and those after less than 2^-137.
[[gnu::noinline]] inline Reduced reduce_far(double x) {
  __extension__ using Wide = unsigned __int128;
  static constexpr uint64_t two_over_pi[20] = {// a word of zeros, then 1216 bits of 2/pi
                                               0,
                                               0xa2f9836e4e441529,
                                               0xfc2757d1f534ddc0,
                                               0xdb6295993c439041,
                                               0xfe5163abdebbc561,
                                               0xb7246e3a424dd2e0,
                                               0x06492eea09d1921c,
                                               0xfe1deb1cb129a73e,
                                               0xe88235f52ebb4484,
                                               0xe99c7026b45f7e41,
                                               0x3991d639835339f4,
                                               0x9c845f8bbdf9283b,
                                               0x1ff897ffde05980f,
                                               0xef2f118b5a0a6d1f,
                                               0x6d367ecf27cb09b7,
                                               0x4f463f669e5fea2d,
                                               0x7527bac7ebe5f17b,
                                               0x3d0739f78a5292ea,
                                               0x6bfb5fb11f8d5d08,
                                               0x56033046fc7b6bab};
  const uint64_t bits = to_bits(magnitude(x));
  const uint64_t mantissa = (bits & 0xfffffffffffff) | 0x10000000000000;
  const uint64_t start = (bits >> 52) - 1075 + 62;  // e + 62, e >= -39
  const auto window = [start](uint64_t i) {
    const uint64_t* word = two_over_pi + start / 64 + i;
    return static_cast<uint64_t>(((static_cast<Wide>(word[0]) << 64 | word[1]) << (start % 64)) >> 64);
  };
  const Wide low = static_cast<Wide>(mantissa) * window(2);
  const Wide middle = static_cast<Wide>(mantissa) * window(1) + (low >> 64);
  const uint64_t high = mantissa * window(0) + static_cast<uint64_t>(middle >> 64);
  // high : middle : low is x / (pi/2) with 190 bits after the point.  Keep the fraction, as a signed one.
  Wide fraction = static_cast<Wide>(high) << 66 | static_cast<Wide>(static_cast<uint64_t>(middle)) << 2 |
                  static_cast<uint64_t>(low) >> 62;
  uint64_t quadrant = high >> 62;
  const bool negative = fraction >> 127 != 0;
  if (negative) {
    fraction = -fraction;
    ++quadrant;
  }
  // fraction >= 2^66 since no double is closer than 2^-62 to a multiple of pi/2.
  const uint64_t top = static_cast<uint64_t>(fraction >> 64);
  const int zeros = top == 0 ? 64 : __builtin_clzll(top);
  fraction <<= zeros;
  if (zeros == 64) return {not_a_number, not_a_number, 0};
  const double hi = static_cast<double>(static_cast<int64_t>(fraction >> 75)) * power_of_two(-53 - zeros);
  const double lo =
      static_cast<double>(static_cast<int64_t>(fraction >> 12 & 0x7fffffffffffffff)) * power_of_two(-116 - zeros);
  const Pair angle = multiply({hi, lo}, half_pi_pair);
  if (negative != (x < 0)) {
    return {-angle.hi, -angle.lo, x < 0 ? 0 - quadrant : quadrant};
  }
  return {angle.hi, angle.lo, x < 0 ? 0 - quadrant : quadrant};
}

// x finite or not; NaN for infinities and NaN.
inline Reduced reduce(double x) {
  const double size = magnitude(x);
  if (size <= near_limit) return reduce_near(x);
  if (size < infinity) return reduce_far(x);
  return {not_a_number, not_a_number, 0};
}

// sin(x + y), |x| <= pi/4, |y| <= ulp(x) / 2, as fdlibm orders it.
[[gnu::always_inline]] inline Pair sin_pair(double x, double y) {
  const double z = x * x;
  const double cube = z * x;
  const double rest = polynomial(z, 0x1.111111110f85dp-7, -0x1.a01a019c0ddabp-13, 0x1.71de35745e2acp-19,
                                 -0x1.ae5e638976c2ap-26, 0x1.5d92341b8bff1p-33);
  const double less = (z * (0.5 * y - cube * rest) - y) + cube * 0x1.5555555555549p-3;
  return {x, -less};
}

// cos(x + y), likewise.
[[gnu::always_inline]] inline Pair cos_pair(double x, double y) {
  const double z = x * x;
  const double half = 0.5 * z;
  const double head = 1.0 - half;
  const double rest = polynomial(z, 0x1.5555555555555p-5, -0x1.6c16c16c16960p-10, 0x1.a01a019f4d0edp-16,
                                 -0x1.27e4fa15bd814p-22, 0x1.1eeb66b683028p-29, -0x1.907c0e63adbb6p-37);
  return {head, ((1.0 - head) - half) + (z * (z * rest) - x * y)};
}

// The sines and cosines of the four quadrants by masks, so that a loop over many angles vectorises.
[[gnu::always_inline]] inline void turn(Reduced r, double& s, double& c) {
  const Pair sine = sin_pair(r.hi, r.lo), cosine = cos_pair(r.hi, r.lo);
  const uint64_t a = to_bits(sine.hi + sine.lo), b = to_bits(cosine.hi + cosine.lo);
  const uint64_t swapped = (a ^ b) & (0 - (r.quadrant & 1));
  s = from_bits((a ^ swapped) ^ (r.quadrant & 2) << 62);
  c = from_bits((b ^ swapped) ^ ((r.quadrant + 1) & 2) << 62);
}

}  // namespace detail

/// s = sin(x), c = cos(x), x in rad; NaN for infinities.  Error < 0.85 ulp for every x.
inline void sincos(double x, double& s, double& c) {
  if (detail::magnitude(x) <= detail::near_limit) {
    detail::turn(detail::reduce_near(x), s, c);
  } else if (detail::magnitude(x) < detail::infinity) {
    detail::turn(detail::reduce_far(x), s, c);
  } else {
    s = c = detail::not_a_number;
  }
}

/// The bits of sincos without its branches, for loops that should vectorise.  Only for |x| <= 8192 rad (unchecked).
[[gnu::always_inline]] inline void sincos_near(double x, double& s, double& c) {
  detail::turn(detail::reduce_near(x), s, c);
}

/// sin(x), x in rad; NaN for infinities.  Error < 0.85 ulp for every x.
inline double sin(double x) {
  double s, c;
  sincos(x, s, c);
  return s;
}

/// cos(x), x in rad; NaN for infinities.  Error < 0.85 ulp for every x.
inline double cos(double x) {
  double s, c;
  sincos(x, s, c);
  return c;
}

/// tan(x), x in rad; NaN for infinities.  Error < 0.95 ulp for every x.  The quotient of sine and cosine as pairs.
inline double tan(double x) {
  if (detail::magnitude(x) < 0x1p-28) return x;
  const detail::Reduced r = detail::reduce(x);
  if (detail::is_nan(r.hi)) return detail::not_a_number;
  detail::Pair sine = detail::sin_pair(r.hi, r.lo), cosine = detail::cos_pair(r.hi, r.lo);
  // What rounding r.hi^2 loses, through -x^3/6 and -x^2/2: as a quotient the two need more than one function does.
  const double lost = detail::product(r.hi, r.hi).lo;
  sine = detail::sum_ordered(sine.hi, sine.lo - 0x1.5555555555555p-3 * r.hi * lost);
  cosine = detail::sum_ordered(cosine.hi, cosine.lo - 0.5 * lost);
  const bool odd = (r.quadrant & 1) != 0;
  const detail::Pair q = odd ? detail::divide(cosine, sine) : detail::divide(sine, cosine);
  return odd ? -(q.hi + q.lo) : q.hi + q.lo;
}

/// x (rad) modulo 2 pi in [-pi, pi), where the bounds are the doubles nearest to them; NaN for infinities.
/// x itself if it is in the range, else within 1 ulp (at the bounds 2) of the exact residue for the real pi.
inline double wrap_angle(double x) {
  constexpr double pi = detail::pi_pair.hi;
  if (x >= -pi && x < pi) return x;
  const detail::Reduced r = detail::reduce(x);
  if (detail::is_nan(r.hi)) return detail::not_a_number;
  const uint64_t quadrant = r.quadrant & 3;
  if (quadrant == 0) return r.hi;
  detail::Pair turned = quadrant == 2 ? detail::pi_pair : detail::half_pi_pair;
  if (quadrant == 3 || (quadrant == 2 && r.hi >= 0)) turned = {-turned.hi, -turned.lo};
  const detail::Pair total = detail::sum(turned.hi, r.hi);
  const double angle = total.hi + (total.lo + (turned.lo + r.lo));
  // The double pi lies below the real one: what falls between the two belongs to the lower bound.
  return angle >= pi || angle < -pi ? -pi : angle;
}

}  // namespace wend::math
