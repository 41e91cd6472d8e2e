// wend/math.hpp against long double libm (error in ulp), SLEEF, the C standard's special cases, and its own bits.
#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>
#include <wend/math.hpp>
#include <wend/math/normal.hpp>

#if __has_include(<sleef.h>) && defined(__x86_64__)
#include <sleef.h>  // link with -lsleef
#define WEND_TEST_HAS_SLEEF 1
#endif

namespace {

namespace m = wend::math;
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// SplitMix64: the points do not depend on what is tested.
struct Points {
  uint64_t state;

  uint64_t bits() {
    uint64_t z = state += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return z ^ z >> 31;
  }
  double in(double low, double high) { return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53; }
  // Both signs, all magnitudes between 2^low and 2^high alike.
  double scaled(int low, int high) {
    const int exponent = low + static_cast<int>(bits() % static_cast<uint64_t>(high - low));
    const double size = std::ldexp(in(1, 2), exponent);
    return bits() % 2 == 0 ? size : -size;
  }
};

// Where reductions cancel or change branch: neighbours of multiples of pi/4 and of ln(2)/2, of powers of 2 and of 1.
std::vector<double> hard_points() {
  std::vector<double> points = {6381956970095103.0 * 0x1p797,  // the double closest to a multiple of pi/2
                                0x1.921fb54442d18p+0, 8192, 1e22, 1.7976931348623157e308};
  for (int i = 1; i <= 4000; ++i) points.push_back(static_cast<double>(i * 0.785398163397448309615660845819875721L));
  for (int i = 1; i <= 2100; ++i) points.push_back(static_cast<double>(i * 0.346573590279972654708616060729088284L));
  for (int i = -1074; i <= 1023; ++i) points.push_back(std::ldexp(1.0, i));
  for (int i = 1; i <= 52; ++i) points.insert(points.end(), {1 + std::ldexp(1.0, -i), 1 - std::ldexp(1.0, -i)});
  for (const double c : {0.25, 0.5, 0.71875, 0.75, 1.0 / 0.71875, 4.0, m::sqrt2, m::sqrt2 / 2}) points.push_back(c);
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    points.insert(points.end(), {std::nextafter(points[i], 0.0), std::nextafter(points[i], inf), -points[i]});
  }
  return points;
}

// |got - expected| in units of the last place of a double beside `expected`.
double ulps(double got, long double expected) {
  if (std::isnan(got) || std::isnan(expected)) return std::isnan(got) && std::isnan(expected) ? 0 : inf;
  const double rounded = static_cast<double>(expected);
  if (std::isinf(got) || std::isinf(rounded)) return got == rounded ? 0 : inf;
  if (expected == 0) return got == 0 ? 0 : inf;
  const int exponent = std::max(std::ilogb(expected) - 52, -1074);
  return static_cast<double>(std::fabs(static_cast<long double>(got) - expected) / std::ldexp(1.0L, exponent));
}

struct Range {
  double low, high;
};

struct Unary {
  const char* name;
  double (*function)(double);
  long double (*oracle)(long double);
  std::vector<Range> ranges;  // where random points are dense
  double bound;               // ulp
};

long double tan_oracle(long double x) {
  return tanl(x);
}

const std::vector<Unary>& unary() {
  static const std::vector<Unary> all = {
      {"sin", m::sin, sinl, {{-0.8, 0.8}, {-7, 7}, {-8192, 8192}, {-1e15, 1e15}}, 0.85},
      {"cos", m::cos, cosl, {{-0.8, 0.8}, {-7, 7}, {-8192, 8192}, {-1e15, 1e15}}, 0.85},
      {"tan", m::tan, tan_oracle, {{-0.8, 0.8}, {-7, 7}, {-8192, 8192}, {-1e15, 1e15}}, 0.95},
      {"asin", m::asin, asinl, {{-1, 1}, {0.45, 0.55}, {0.99, 1}}, 0.75},
      {"acos", m::acos, acosl, {{-1, 1}, {0.45, 0.55}, {0.99, 1}, {-1, -0.99}}, 0.75},
      {"atan", m::atan, atanl, {{-1, 1}, {-5, 5}, {0.2, 0.3}, {0.7, 1.5}}, 0.60},
      {"exp", m::exp, expl, {{-1, 1}, {-20, 20}, {-750, 720}, {-746, -707}}, 0.80},
      {"expm1", m::expm1, expm1l, {{-1, 1}, {-0.4, 0.4}, {-40, 40}, {-50, 720}}, 0.70},
      {"tanh", m::tanh, tanhl, {{-1, 1}, {-0.2, 0.2}, {-25, 25}}, 0.70},
      {"log", m::log, logl, {{0, 1}, {0.6, 1.6}, {0, 1e6}}, 0.95},
      {"log1p", m::log1p, log1pl, {{-1, 1}, {-0.5, 0.7}, {-1, 1e6}}, 0.95},
  };
  return all;
}

// The widest error of `function`, and its argument.
struct Worst {
  double error = 0, x = 0, y = 0;

  void see(double error_here, double x_here, double y_here = 0) {
    if (!(error_here <= error)) *this = {error_here, x_here, y_here};
  }
};

std::string describe(const Worst& worst) {
  char text[120];
  std::snprintf(text, sizeof text, "%.4f ulp at %a, %a", worst.error, worst.x, worst.y);
  return text;
}

// WEND_MATH_POINTS=n widens the search.
int points_per_range() {
  const char* text = std::getenv("WEND_MATH_POINTS");
  return text != nullptr ? std::atoi(text) : 30000;
}

#if LDBL_MANT_DIG >= 64

TEST(Math, UnaryFunctionsStayWithinTheirBounds) {
  for (const Unary& f : unary()) {
    Worst worst;
    Points points{1};
    const auto check = [&](double x) { worst.see(ulps(f.function(x), f.oracle(static_cast<long double>(x))), x); };
    for (const Range& range : f.ranges) {
      for (int i = 0; i < points_per_range(); ++i) check(points.in(range.low, range.high));
    }
    for (int i = 0; i < points_per_range(); ++i) check(points.scaled(-1074, 1024));
    for (int i = 0; i < points_per_range(); ++i) check(points.scaled(-40, 12));
    for (const double x : hard_points()) check(x);
    EXPECT_LT(worst.error, f.bound) << f.name << ": " << describe(worst);
    RecordProperty(f.name, describe(worst));
  }
}

TEST(Math, BinaryFunctionsStayWithinTheirBounds) {
  Worst atan2, hypot, pow;
  Points points{2};
  const auto check = [&](double x, double y) {
    atan2.see(ulps(m::atan2(x, y), atan2l(x, y)), x, y);
    // Rounded twice where the result is subnormal.
    const double hypot_error = ulps(m::hypot(x, y), hypotl(x, y));
    if (m::hypot(x, y) >= DBL_MIN) hypot.see(hypot_error, x, y);
    ASSERT_LE(hypot_error, 1) << x << ' ' << y;
  };
  const auto check_pow = [&](double x, double y) { pow.see(ulps(m::pow(x, y), powl(x, y)), x, y); };
  for (int i = 0; i < 3 * points_per_range(); ++i) {
    check(points.in(-1, 1), points.in(-1, 1));
    check(points.scaled(-30, 30), points.scaled(-30, 30));
    check(points.scaled(-1074, 1024), points.scaled(-1074, 1024));
    check_pow(points.in(0, 10), points.in(-30, 30));
    check_pow(std::fabs(points.scaled(-1074, 1024)), points.in(-1.2, 1.2));
    // Near 1 with large exponents the error of the logarithm counts most.
    const double base = points.in(0.6, 1.7);
    check_pow(base, points.in(-750, 720) / std::log(base));
    check_pow(-points.in(0, 4), static_cast<double>(static_cast<int>(points.in(-300, 300))));
  }
  EXPECT_LT(atan2.error, 0.60) << describe(atan2);
  EXPECT_LT(hypot.error, 0.60) << describe(hypot);
  EXPECT_LT(pow.error, 0.85) << describe(pow);
  RecordProperty("atan2", describe(atan2));
  RecordProperty("hypot", describe(hypot));
  RecordProperty("pow", describe(pow));
}

TEST(Math, WrapAngleIsTheResidueInRange) {
  constexpr long double pi = 3.14159265358979323846264338327950288L;
  Points points{3};
  for (int i = 0; i < 100000; ++i) {
    const double x = i % 2 == 0 ? points.in(-100, 100) : points.in(-8000, 8000);
    const double angle = m::wrap_angle(x);
    ASSERT_TRUE(angle >= -m::pi && angle < m::pi) << x;
    // x is 8000 at most: the rounding of the oracle's 2 pi counts 1300 times.
    const long double turns = std::nearbyint((static_cast<long double>(x) - angle) / (2 * pi));
    ASSERT_NEAR(static_cast<double>(static_cast<long double>(x) - turns * 2 * pi - angle), 0, 1e-15) << x;
    ASSERT_EQ(m::wrap_angle(angle), angle);
  }
}

TEST(Math, NormalQuantileInvertsTheDistribution) {
  Points points{4};
  for (int i = 0; i < 100000; ++i) {
    const double p = i % 2 == 0 ? points.in(0, 1) : std::fabs(points.scaled(-54, -1));
    const double x = m::normal_quantile(p);
    const long double back = erfcl(-static_cast<long double>(x) / 1.41421356237309504880168872420969808L) / 2;
    // d log(p) / dx grows like |x| in the tail.
    ASSERT_NEAR(static_cast<double>(back / p), 1, 1e-15 * (2 + x * x)) << p;
  }
}

#endif  // LDBL_MANT_DIG

TEST(Math, KnownValues) {
  // Correctly rounded results, from mpmath with 200 bits.
  EXPECT_EQ(m::sin(6381956970095103.0 * 0x1p797), 1.0);
  EXPECT_EQ(m::cos(6381956970095103.0 * 0x1p797), -0x1.14ae72e6ba22fp-61);
  EXPECT_EQ(m::sin(1e22), -0x1.b453ab76bf397p-1);
  EXPECT_EQ(m::sin(m::pi), 0x1.1a62633145c07p-53);
  EXPECT_EQ(m::tan(m::half_pi), 0x1.d02967c31cdb5p+53);
  EXPECT_EQ(m::exp(1), 0x1.5bf0a8b145769p+1);
  EXPECT_EQ(m::log(10), 0x1.26bb1bbb55516p+1);
  EXPECT_EQ(m::atan(1), m::pi / 4);
  EXPECT_EQ(m::asin(1), m::half_pi);
  EXPECT_EQ(m::acos(-1), m::pi);
  EXPECT_EQ(m::pow(2, 0.5), m::sqrt2);
  EXPECT_EQ(m::pow(10, 22), 1e22);
  EXPECT_EQ(m::tanh(1), 0x1.85efab514f394p-1);
  EXPECT_EQ(m::hypot(0x3p700, 0x4p700), 0x5p700);
}

// Equal, NaN included, and zeros with their sign.
void expect_same(double got, double expected, const std::string& what) {
  if (std::isnan(expected)) {
    EXPECT_EQ(__builtin_bit_cast(uint64_t, got), 0x7ff8000000000000u) << what;
  } else {
    EXPECT_EQ(__builtin_bit_cast(uint64_t, got), __builtin_bit_cast(uint64_t, expected)) << what << ' ' << got;
  }
}

const std::vector<double>& special() {
  static const std::vector<double> all = {0.0,      -0.0,  0x1p-1074, -0x1p-1074, 0x1p-1022, 0.5,       -0.5,  1.0,
                                          -1.0,     2.0,   -2.0,      3.0,        -3.0,      0x1p53,    2.5,   -2.5,
                                          0x1p1023, 1e308, inf,       -inf,       nan,       -0x1p1023, 1e300, -1e300};
  return all;
}

TEST(Math, SpecialCasesAreThoseOfTheCStandard) {
  // Where the value is zero, infinite, NaN or exact, libm's answer is the standard's.
  const auto exact = [](double v) { return v == 0 || !std::isfinite(v) || v == 1 || v == -1; };
  const std::vector<double (*)(double)> libm = {std::sin, std::cos,   std::tan,  std::asin, std::acos, std::atan,
                                                std::exp, std::expm1, std::tanh, std::log,  std::log1p};
  for (std::size_t i = 0; i < unary().size(); ++i) {
    for (const double x : special()) {
      const double expected = libm[i](x);
      const std::string what = std::string(unary()[i].name) + "(" + std::to_string(x) + ")";
      if (exact(expected)) expect_same(unary()[i].function(x), expected, what);
    }
  }
  for (const double x : special()) {
    for (const double y : special()) {
      const std::string what = std::to_string(x) + ", " + std::to_string(y);
      if (exact(std::pow(x, y))) expect_same(m::pow(x, y), std::pow(x, y), "pow of " + what);
      if (exact(std::hypot(x, y))) expect_same(m::hypot(x, y), std::hypot(x, y), "hypot of " + what);
      if (x == 0 || y == 0 || !std::isfinite(x) || !std::isfinite(y)) {
        expect_same(m::atan2(x, y), std::atan2(x, y), "atan2 of " + what);
      }
    }
  }
}

TEST(Math, TinyArgumentsKeepTheirBitsAndSign) {
  for (const double x : {-0.0, 0.0, 0x1p-1074, -0x1p-1074, 0x1.8p-1040, -0x1.23456789abcdep-1000}) {
    for (double (*f)(double) : {m::sin, m::tan, m::asin, m::atan, m::expm1, m::tanh, m::log1p, m::wrap_angle}) {
      expect_same(f(x), x, "tiny");
    }
  }
}

TEST(Math, WrapAngleAtItsBounds) {
  EXPECT_EQ(m::wrap_angle(m::pi), -m::pi);
  EXPECT_EQ(m::wrap_angle(-m::pi), -m::pi);
  EXPECT_EQ(m::wrap_angle(std::nextafter(m::pi, 0)), std::nextafter(m::pi, 0));
  EXPECT_EQ(m::wrap_angle(std::nextafter(-m::pi, -4)), -m::pi);
  EXPECT_TRUE(std::isnan(m::wrap_angle(inf)));
  EXPECT_TRUE(std::isnan(m::wrap_angle(nan)));
}

TEST(Math, SincosNearHasTheBitsOfSincos) {
  Points points{5};
  for (int i = 0; i < 10000; ++i) {
    const double x = points.in(-8192, 8192);
    double s, c, s_near, c_near;
    m::sincos(x, s, c);
    m::sincos_near(x, s_near, c_near);
    ASSERT_TRUE(s == s_near && c == c_near && s == m::sin(x) && c == m::cos(x)) << x;
  }
}

#ifdef WEND_TEST_HAS_SLEEF
// Two results within 1 ulp of the truth are neighbours at most twice removed.
TEST(Math, AgreesWithSleef) {
  const std::vector<std::function<double(double)>> sleef = {
      Sleef_cinz_sind1_u10purec,  Sleef_cinz_cosd1_u10purec,  Sleef_cinz_tand1_u10purec,  Sleef_cinz_asind1_u10purec,
      Sleef_cinz_acosd1_u10purec, Sleef_cinz_atand1_u10purec, Sleef_cinz_expd1_u10purec,  Sleef_cinz_expm1d1_u10purec,
      Sleef_cinz_tanhd1_u10purec, Sleef_cinz_logd1_u10purec,  Sleef_cinz_log1pd1_u10purec};
  Points points{6};
  for (std::size_t i = 0; i < unary().size(); ++i) {
    for (const Range& range : unary()[i].ranges) {
      for (int k = 0; k < 10000; ++k) {
        const double x = points.in(range.low, range.high);
        const double ours = unary()[i].function(x), theirs = sleef[i](x);
        if (std::fpclassify(theirs) != FP_NORMAL) continue;
        ASSERT_LE(ulps(ours, static_cast<long double>(theirs)), 2) << unary()[i].name << ' ' << x;
      }
    }
  }
  for (int k = 0; k < 20000; ++k) {
    const double x = points.scaled(-20, 20), y = points.scaled(-20, 20), base = points.in(0, 10);
    ASSERT_LE(ulps(m::atan2(y, x), Sleef_cinz_atan2d1_u10purec(y, x)), 2) << x << ' ' << y;
    ASSERT_LE(ulps(m::hypot(y, x), Sleef_cinz_hypotd1_u05purec(y, x)), 2) << x << ' ' << y;
    ASSERT_LE(ulps(m::pow(base, y / 4096), Sleef_cinz_powd1_u10purec(base, y / 4096)), 2) << base << ' ' << y;
  }
}
#endif

// FNV-1a over the results' bytes.
struct Hash {
  uint64_t value = 0xcbf29ce484222325;

  void add(double x) {
    const uint64_t bits = __builtin_bit_cast(uint64_t, x);
    for (int i = 0; i < 64; i += 8) value = (value ^ (bits >> i & 0xff)) * 0x100000001b3;
  }
};

// The promise itself: these hashes are the same for every compiler, flag and CPU.  Recorded with g++ 12 -O2; equal
// with g++ -O0, g++ -O3 -march=native -ffp-contract=off and clang++ -O2 -stdlib=libc++.
TEST(Math, BitsAreTheGoldenOnes) {
  const auto random_bits = [](Points& points) { return __builtin_bit_cast(double, points.bits()); };
  const std::vector<uint64_t> golden = {0x6ce3e857db57a28c, 0x64044857bab05833, 0xffe92f569eda80ee, 0x810d388e1177f0fe,
                                        0x7ffb3aa7417751d9, 0xfce1323a015b7692, 0xe23b29c226df534,  0x1cae145e9f9c220,
                                        0xccd36fd0495b2988, 0x1b090d40f744bb18, 0xe45891c0c123cc87};
  ASSERT_EQ(golden.size(), unary().size());
  for (std::size_t i = 0; i < unary().size(); ++i) {
    Hash hash;
    Points points{7};
    for (int k = -20000; k <= 20000; ++k) hash.add(unary()[i].function(k * 0x1p-12));
    for (int k = -4000; k <= 4000; ++k) hash.add(unary()[i].function(k * 2.3));
    for (int k = 0; k < 20000; ++k) hash.add(unary()[i].function(random_bits(points)));
    EXPECT_EQ(hash.value, golden[i]) << unary()[i].name << std::hex << " 0x" << hash.value;
  }
  const std::vector<std::pair<const char*, double (*)(double, double)>> binary = {
      {"atan2", m::atan2}, {"hypot", m::hypot}, {"pow", m::pow}};
  const std::vector<uint64_t> golden_binary = {0xdd34676fda28b48c, 0xffc91abbc6c15c00, 0x1cd35ef11f4deb19};
  for (std::size_t i = 0; i < binary.size(); ++i) {
    Hash hash;
    Points points{8};
    for (int k = 0; k < 20000; ++k) {
      const double x = k * 0x1p-8, y = points.scaled(-8, 8), any = random_bits(points);
      hash.add(binary[i].second(x, y));
      hash.add(binary[i].second(y, x));
      hash.add(binary[i].second(any, y));
      hash.add(binary[i].second(any, random_bits(points)));
    }
    EXPECT_EQ(hash.value, golden_binary[i]) << binary[i].first << std::hex << " 0x" << hash.value;
  }
  Hash rest;
  Points points{9};
  for (int k = 0; k < 20000; ++k) {
    rest.add(m::wrap_angle(k * 0.7 - 7000));
    rest.add(m::wrap_angle(random_bits(points)));
    rest.add(m::normal_quantile(k / 20000.0));
    rest.add(m::sqrt(random_bits(points)));
  }
  EXPECT_EQ(rest.value, 0x57ed57e6a1a3da98u) << std::hex << " 0x" << rest.value;
}

}  // namespace
