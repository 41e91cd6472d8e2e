// wend/random.hpp against the published vectors, Random123, and the distributions' moments and shapes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <vector>
#include <wend/random.hpp>

#if __has_include(<Random123/philox.h>)
#include <Random123/philox.h>
#define WEND_TEST_HAS_RANDOM123 1
#endif

namespace {

using Counter = std::array<uint64_t, 4>;
using Key = std::array<uint64_t, 2>;

// Random123's kat_vectors, philox 4x64 10.
TEST(Philox, GivesThePublishedVectors) {
  constexpr uint64_t ones = ~uint64_t{0};
  EXPECT_EQ(wend::philox({0, 0, 0, 0}, {0, 0}),
            (Counter{0x16554d9eca36314c, 0xdb20fe9d672d0fdc, 0xd7e772cee186176b, 0x7e68b68aec7ba23b}));
  EXPECT_EQ(wend::philox({ones, ones, ones, ones}, {ones, ones}),
            (Counter{0x87b092c3013fe90b, 0x438c3c67be8d0224, 0x9cc7d7c69cd777b6, 0xa09caebf594f0ba0}));
  EXPECT_EQ(wend::philox({0x243f6a8885a308d3, 0x13198a2e03707344, 0xa4093822299f31d0, 0x082efa98ec4e6c89},
                         {0x452821e638d01377, 0xbe5466cf34e90c6c}),
            (Counter{0xa528f45403e61d95, 0x38c72dbd566e9788, 0xa5a1610e72fd18b5, 0x57bd43b5e52b7fe6}));
}

#ifdef WEND_TEST_HAS_RANDOM123
TEST(Philox, HasTheBitsOfRandom123) {
  Counter counter = {};
  for (uint64_t i = 0; i < 20000; ++i) {
    // Every output is the next counter: the inputs spread over all bits.
    const Key key = {counter[1] + i, i % 3 == 0 ? 0 : counter[2]};
    if (i % 5 == 0) counter = {i, 0, 0, 0};
    const r123::Philox4x64::ctr_type theirs_in = {{counter[0], counter[1], counter[2], counter[3]}};
    const r123::Philox4x64::key_type theirs_key = {{key[0], key[1]}};
    const auto theirs = r123::Philox4x64()(theirs_in, theirs_key);
    const Counter ours = wend::philox(counter, key);
    ASSERT_EQ(ours, (Counter{theirs[0], theirs[1], theirs[2], theirs[3]})) << i;
    counter = ours;
  }
}
#endif

TEST(Stream, IsAPhiloxOfTheNameOrIndex) {
  EXPECT_EQ(wend::detail::fnv1a64(""), 0xcbf29ce484222325u);
  EXPECT_EQ(wend::detail::fnv1a64("foobar"), 0x85944171f73967e8u);  // Noll's test vector
  EXPECT_EQ(wend::stream(7, "foobar"), wend::philox({0x85944171f73967e8, 6, 0, 0x77656e64}, {7, 0x73747265616d})[0]);
  EXPECT_EQ(wend::stream(7, 42), wend::philox({42, 0, 1, 0x77656e64}, {7, 0x73747265616d})[0]);
  EXPECT_NE(wend::stream(7, 0), wend::stream(7, ""));
  EXPECT_EQ(wend::stream(0, "world"), 1517543987029161784u);
  EXPECT_EQ(wend::stream(0, 1), 16748825405902191450u);
}

TEST(Stream, KeysOfNeighboursDiffer) {
  std::vector<uint64_t> keys;
  for (uint64_t parent = 0; parent < 100; ++parent) {
    for (uint64_t index = 0; index < 100; ++index) keys.push_back(wend::stream(parent, index));
    for (uint64_t index = 0; index < 100; ++index) keys.push_back(wend::stream(parent, std::to_string(index)));
  }
  std::sort(keys.begin(), keys.end());
  EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
}

TEST(Uniform, ReadsWordsByPosition) {
  const Counter block = wend::philox({5, 0, 0, 0}, {99, 0});
  double out[2];
  wend::uniform(99, 22, out, 2);
  EXPECT_EQ(out[0], static_cast<double>(block[2] >> 11) * 0x1p-53);
  EXPECT_EQ(out[1], static_cast<double>(block[3] >> 11) * 0x1p-53);
}

TEST(Uniform, AnyCutOfAStreamGivesTheSameNumbers) {
  std::vector<double> whole(64);
  wend::uniform(3, 0, whole.data(), whole.size());
  for (uint64_t start = 0; start < 20; ++start) {
    for (uint64_t n = 0; n < 20; ++n) {
      std::vector<double> part(n + 1, -1.0);
      wend::uniform(3, start, part.data(), n);
      wend::Random random(3, start);
      for (uint64_t i = 0; i < n; ++i) {
        ASSERT_EQ(part[i], whole[start + i]);
        ASSERT_EQ(random.uniform(), whole[start + i]);
      }
      ASSERT_EQ(part[n], -1.0) << "written past the end";
      ASSERT_EQ(random.position(), start + n);
    }
  }
}

TEST(Random, PositionIsTheWholeState) {
  wend::Random random(11);
  std::vector<double> weights = {1, 2, 3};
  std::vector<int> cards(10);
  std::iota(cards.begin(), cards.end(), 0);
  for (int i = 0; i < 50; ++i) {
    wend::Random again(11, random.position());
    const uint64_t before = random.position();
    ASSERT_EQ(random.normal(), again.normal());
    ASSERT_EQ(random.normal(1, 2), again.normal(1, 2));
    ASSERT_EQ(random.uniform(-1, 1), again.uniform(-1, 1));
    ASSERT_EQ(random.chance(0.5), again.chance(0.5));
    ASSERT_EQ(random.weighted(weights), again.weighted(weights));
    ASSERT_EQ(random.position(), before + 5) << "each takes one position";
    ASSERT_EQ(random.below(1000), again.below(1000));
    std::vector<int> cards_again = cards;
    random.shuffle(cards);
    again.shuffle(std::span(cards_again));
    ASSERT_EQ(cards, cards_again);
  }
}

TEST(Random, EdgesOfEachDistribution) {
  wend::Random random(12);
  EXPECT_EQ(random.below(0), 0u);
  EXPECT_EQ(random.below(1), 0u);
  EXPECT_FALSE(random.chance(0));
  EXPECT_TRUE(random.chance(1));
  EXPECT_EQ(random.weighted({}), 0u);
  const double none[] = {0, -1, std::nan("")}, one[] = {0, -1, 2, std::nan("")}, endless[] = {1, HUGE_VAL};
  EXPECT_EQ(random.weighted(none), 3u);
  EXPECT_EQ(random.weighted(one), 2u);
  EXPECT_EQ(random.weighted(endless), 2u);
  std::vector<int> empty;
  random.shuffle(empty);
  EXPECT_EQ(random.normal(3, 0), 3);
  EXPECT_EQ(random.uniform(2, 2), 2);
}

// Moments of n draws, as deviations from the expected ones in standard errors.
struct Moments {
  double mean, variance, skewness;
};

template <class Draw>
Moments moments(int n, Draw draw) {
  std::vector<double> x(static_cast<std::size_t>(n));
  double mean = 0, second = 0, third = 0;
  for (double& value : x) mean += (value = draw()) / n;
  for (const double value : x) {
    second += (value - mean) * (value - mean) / n;
    third += (value - mean) * (value - mean) * (value - mean) / n;
  }
  return {mean, second, third / std::pow(second, 1.5)};
}

TEST(Distribution, UniformHasItsMoments) {
  constexpr int n = 1000000;
  wend::Random random(21);
  const Moments m = moments(n, [&] { return random.uniform(); });
  EXPECT_NEAR(m.mean, 0.5, 4 * std::sqrt(1.0 / 12 / n));
  EXPECT_NEAR(m.variance, 1.0 / 12, 4 * std::sqrt(1.0 / 180 / n));
  EXPECT_NEAR(m.skewness, 0, 0.01);
  wend::Random other(22);
  const Moments shifted = moments(n, [&] { return other.uniform(-3, 5); });
  EXPECT_NEAR(shifted.mean, 1, 8 * 4 * std::sqrt(1.0 / 12 / n));
}

TEST(Distribution, NormalHasItsMoments) {
  constexpr int n = 1000000;
  wend::Random random(23);
  const Moments m = moments(n, [&] { return random.normal(2, 3); });
  EXPECT_NEAR(m.mean, 2, 4 * 3 / std::sqrt(n));
  EXPECT_NEAR(m.variance, 9, 4 * 9 * std::sqrt(2.0 / n));
  EXPECT_NEAR(m.skewness, 0, 4 * std::sqrt(6.0 / n));
}

// Kolmogorov and Smirnov: sqrt(n) D exceeds 1.95 with probability 0.001.
template <class Draw, class Cdf>
double kolmogorov(int n, Draw draw, Cdf cdf) {
  std::vector<double> x(static_cast<std::size_t>(n));
  for (double& value : x) value = cdf(draw());
  std::sort(x.begin(), x.end());
  double widest = 0;
  for (int i = 0; i < n; ++i) {
    const double p = x[static_cast<std::size_t>(i)];
    widest = std::max({widest, std::fabs(p - 1.0 * i / n), std::fabs(p - (i + 1.0) / n)});
  }
  return std::sqrt(n) * widest;
}

TEST(Distribution, ShapesPassKolmogorovSmirnov) {
  wend::Random random(31);
  EXPECT_LT(kolmogorov(
                200000, [&] { return random.uniform(); }, [](double x) { return x; }),
            1.95);
  EXPECT_LT(kolmogorov(
                200000, [&] { return random.normal(); }, [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }),
            1.95);
}

// Sum of (observed - expected)^2 / expected.
double chi_square(std::span<const int> observed, std::span<const double> expected) {
  double sum = 0;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    sum += (observed[i] - expected[i]) * (observed[i] - expected[i]) / expected[i];
  }
  return sum;
}

TEST(Distribution, BelowIsEven) {
  wend::Random random(41);
  std::vector<int> count(101);
  for (int i = 0; i < 1010000; ++i) ++count[random.below(101)];
  EXPECT_LT(chi_square(count, std::vector<double>(101, 10000.0)), 149.4);  // 100 degrees of freedom, p = 0.001
}

TEST(Distribution, BelowRejectsTheSurplus) {
  // Without rejection, two of the three thirds of [0, 3 * 2^62) would come up twice as often as the last.
  wend::Random random(42);
  std::vector<int> count(3);
  for (int i = 0; i < 30000; ++i) ++count[random.below(uint64_t{3} << 62) >> 62];
  EXPECT_LT(chi_square(count, std::vector<double>(3, 10000.0)), 13.8);
  EXPECT_GT(random.position(), 38000u) << "a quarter of the words is rejected";
  EXPECT_LT(random.position(), 42000u);
}

TEST(Distribution, WeightedFollowsItsWeights) {
  wend::Random random(43);
  const std::vector<double> weights = {1, 0, 2, 0.5, 6.5, -4};
  std::vector<int> count(6);
  for (int i = 0; i < 100000; ++i) ++count[random.weighted(weights)];
  EXPECT_EQ(count[1] + count[5], 0);
  const std::vector<int> seen = {count[0], count[2], count[3], count[4]};
  EXPECT_LT(chi_square(seen, std::vector<double>{10000, 20000, 5000, 65000}), 16.3);
}

TEST(Distribution, ChanceHasItsProbability) {
  wend::Random random(44);
  int hits = 0;
  for (int i = 0; i < 100000; ++i) hits += random.chance(0.3);
  EXPECT_NEAR(hits, 30000, 4 * std::sqrt(100000 * 0.3 * 0.7));
}

TEST(Distribution, EveryOrderIsAsLikely) {
  wend::Random random(45);
  std::vector<int> count(24);
  for (int i = 0; i < 240000; ++i) {
    std::array<int, 4> cards = {0, 1, 2, 3};
    random.shuffle(cards);
    int rank = 0;
    for (int k = 0; k < 4; ++k) {
      int smaller = 0;
      for (int j = k + 1; j < 4; ++j)
        smaller += cards[static_cast<std::size_t>(j)] < cards[static_cast<std::size_t>(k)];
      rank = rank * (4 - k) + smaller;
    }
    ++count[static_cast<std::size_t>(rank)];
  }
  EXPECT_LT(chi_square(count, std::vector<double>(24, 10000.0)), 49.7);  // 23 degrees of freedom
}

TEST(Distribution, BitsAreTheGoldenOnes) {
  wend::Random random(51);
  uint64_t hash = 0xcbf29ce484222325;
  const auto add = [&hash](uint64_t bits) { hash = (hash ^ bits) * 0x100000001b3; };
  for (int i = 0; i < 20000; ++i) {
    add(__builtin_bit_cast(uint64_t, random.uniform(-2, 3)));
    add(__builtin_bit_cast(uint64_t, random.normal(0.1, 0.7)));
    add(random.below(static_cast<uint64_t>(i) * 1234567890123457));
  }
  EXPECT_EQ(hash, 16348132727761442604u);
}

}  // namespace
