// wend/math/arc.hpp -- asin, acos, atan, atan2.  Include wend/math.hpp, which states the rules.
#pragma once

#include <wend/math/exact.hpp>
#include <wend/math/trig.hpp>

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

namespace wend::math {
namespace detail {

// The angle of the point (along, across), 0 <= across, along, neither both 0 nor infinite, 2^-510 < larger < 2^510,
// in [0, pi/2].  With t = smaller / larger and c in {0, 1/2, 1}: atan t = atan c + atan((t - c) / (1 + c t)), and the
// quotient stays within 1/4.
inline Pair first_quadrant(double across, double along) {
  const bool steep = across > along;
  const double small = steep ? along : across, large = steep ? across : along;
  Pair base = {0, 0}, denominator = {large, 0};
  double numerator = small;
  if (small > 0.71875 * large) {
    base = {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55};
    numerator = small - large;  // exact, as is the other one (Sterbenz)
    denominator = sum_ordered(large, small);
  } else if (small > 0.25 * large) {
    base = {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56};
    numerator = 2 * small - large;
    denominator = sum_ordered(2 * large, small);
  }
  const Pair q = divide({numerator, 0}, denominator);
  const double z = q.hi * q.hi;
  const double rest = polynomial(z, -0x1.5555555555555p-2, 0x1.9999999999815p-3, -0x1.2492492469c29p-3,
                                 0x1.c71c719302309p-4, -0x1.745d067597759p-4, 0x1.3b10a28e789aap-4,
                                 -0x1.10bd064002fffp-4, 0x1.d7412a8d5c85ap-5, -0x1.5005923b76ca6p-5);
  Pair angle = sum_ordered(base.hi, q.hi);
  angle.lo += base.lo + (q.lo * (1 - z) + q.hi * (z * rest));
  if (!steep) return angle;
  const Pair mirrored = sum_ordered(half_pi_pair.hi, -angle.hi);
  return {mirrored.hi, mirrored.lo + (half_pi_pair.lo - angle.lo)};
}

// (asin(sqrt(z)) / sqrt(z) - 1) / z on [0, 1/4].
[[gnu::always_inline]] inline double asin_rest(double z) {
  return polynomial(z, 0x1.5555555555556p-3, 0x1.3333333332ecap-4, 0x1.6db6db6e31f13p-5, 0x1.f1c71c1db0623p-6,
                    0x1.6e8bb1c8209a2p-6, 0x1.1c4d35cf95421p-6, 0x1.c9cf07674736ap-7, 0x1.782651caa6547p-7,
                    0x1.52420b04b37bep-7, 0x1.65a9c4dfcf8b2p-8, 0x1.1d189408314eep-6, -0x1.e6aaa8a0a04ccp-7,
                    0x1.d72b2bc8155f8p-6);
}

// acos(x) / 2 = asin(sqrt((1 - x) / 2)) for 1/2 <= x <= 1, the root with its rounding error.
inline Pair half_acos(double x) {
  const double z = 0.5 * (1 - x);
  const double root = __builtin_sqrt(z);
  const Pair square = product(root, root);
  const double missing = root > 0 ? ((z - square.hi) - square.lo) / (2 * root) : 0;
  return {root, missing + root * (z * asin_rest(z))};
}

}  // namespace detail

/// asin(x) in rad, in [-pi/2, pi/2]; NaN for |x| > 1.  Error < 0.75 ulp.
inline double asin(double x) {
  const double size = detail::magnitude(x);
  if (!(size <= 1)) return detail::not_a_number;
  if (size < 0.5) return x + x * (x * x * detail::asin_rest(x * x));
  const detail::Pair half = detail::half_acos(size);
  const detail::Pair head = detail::sum_ordered(detail::half_pi_pair.hi, -2 * half.hi);
  return detail::with_sign(head.hi + (head.lo + (detail::half_pi_pair.lo - 2 * half.lo)), x);
}

/// acos(x) in rad, in [0, pi]; NaN for |x| > 1.  Error < 0.75 ulp.
inline double acos(double x) {
  const double size = detail::magnitude(x);
  if (!(size <= 1)) return detail::not_a_number;
  if (size < 0.5) {
    const detail::Pair head = detail::sum_ordered(detail::half_pi_pair.hi, -x);
    return head.hi + (head.lo + (detail::half_pi_pair.lo - x * (x * x * detail::asin_rest(x * x))));
  }
  const detail::Pair half = detail::half_acos(size);
  if (x > 0) return 2 * (half.hi + half.lo);
  const detail::Pair head = detail::sum_ordered(detail::pi_pair.hi, -2 * half.hi);
  return head.hi + (head.lo + (detail::pi_pair.lo - 2 * half.lo));
}

/// atan(x) in rad, in [-pi/2, pi/2].  Error < 0.60 ulp.
inline double atan(double x) {
  const double size = detail::magnitude(x);
  if (size < 0x1p-28) return x;
  if (size > 0x1p60) return detail::with_sign(detail::half_pi_pair.hi, x);
  if (detail::is_nan(x)) return detail::not_a_number;
  const detail::Pair angle = detail::first_quadrant(size, 1);
  return detail::with_sign(angle.hi + angle.lo, x);
}

/// The angle of the point (x, y) in rad, in [-pi, pi]; C's rules for zeros and infinities.  Error < 0.60 ulp.
inline double atan2(double y, double x) {
  if (detail::is_nan(x) || detail::is_nan(y)) return detail::not_a_number;
  const bool behind = detail::with_sign(1, x) < 0;
  double across = detail::magnitude(y), along = detail::magnitude(x);
  const double large = across > along ? across : along;
  if (large == detail::infinity || across == 0 || along == 0) {
    // The eight directions: only which are zero, finite or infinite counts.
    if (across == along && across > 0) {
      return detail::with_sign(behind ? 0x1.2d97c7f3321d2p+1 : 0x1.921fb54442d18p-1, y);
    }
    if (across > along) return detail::with_sign(detail::half_pi_pair.hi, y);
    return detail::with_sign(behind ? detail::pi_pair.hi : 0, y);
  }
  if (!behind && across < along * 0x1p-60) return y / x;
  if (large > 0x1p500 || large < 0x1p-500) {
    const double factor = large > 1 ? 0x1p-600 : 0x1p600;
    across *= factor;
    along *= factor;
  }
  detail::Pair angle = detail::first_quadrant(across, along);
  if (behind) {
    const detail::Pair mirrored = detail::sum_ordered(detail::pi_pair.hi, -angle.hi);
    angle = {mirrored.hi, mirrored.lo + (detail::pi_pair.lo - angle.lo)};
  }
  return detail::with_sign(angle.hi + angle.lo, y);
}

}  // namespace wend::math
