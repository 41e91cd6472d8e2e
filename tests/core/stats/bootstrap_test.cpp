// Oracles are numbers of scipy 1.10.1 and numpy 1.24.2; the commands stand beside them.
#include <gtest/gtest.h>

#include <algorithm>
#include <core/stats/bootstrap.hpp>
#include <numeric>

namespace wend::core {
namespace {

constexpr BootstrapOptions all{50'000, 0};

// x = [(i*37%101)/10 + (40 if i%17==0 else 0) for i in range(120)]
std::vector<double> sample() {
  std::vector<double> x;
  for (int i = 0; i < 120; ++i) x.push_back(i * 37 % 101 / 10.0 + (i % 17 == 0 ? 40 : 0));
  return x;
}

std::vector<Measurement> measure(const std::vector<double>& values, std::uint32_t per_unit = 1) {
  std::vector<Measurement> out;
  for (std::uint32_t i = 0; i < values.size(); ++i) out.push_back({values[i], i / per_unit});
  return out;
}

void expect_near(const Interval& found, double low, double high, double tolerance) {
  EXPECT_NEAR(found.low, low, tolerance);
  EXPECT_NEAR(found.high, high, tolerance);
}

TEST(InterquartileMean, IsScipysTrimMean) {
  // a = [3.5,-1,2,8,100,4,4,.25,-7,9]; [scipy.stats.trim_mean(a[:m], .25) for m in (1, 2, 3, 4, 5, 7, 8, 10)]
  const std::vector<double> a = {3.5, -1, 2, 8, 100, 4, 4, 0.25, -7, 9};
  const std::pair<int, double> cases[] = {{1, 3.5}, {2, 1.25}, {3, 1.5},   {4, 2.75},
                                          {5, 4.5}, {7, 4.3},  {8, 3.375}, {10, 3.625}};
  for (const auto& [m, expected] : cases)
    EXPECT_DOUBLE_EQ(interquartile_mean(std::vector<double>(a.begin(), a.begin() + m)), expected) << m;
  EXPECT_DOUBLE_EQ(interquartile_mean(sample()), 5.36);
}

TEST(Quantile, IsNumpys) {
  // [numpy.quantile(a, p) for p in (0, .025, .3, .5, .975, 1)]
  const std::pair<double, double> cases[] = {{0, -7},     {0.025, -5.65},  {0.3, 1.475},
                                             {0.5, 3.75}, {0.975, 79.525}, {1, 100}};
  for (const auto& [p, expected] : cases) {
    std::vector<double> a = {3.5, -1, 2, 8, 100, 4, 4, 0.25, -7, 9};
    EXPECT_NEAR(quantile(a, p), expected, 1e-12) << p;
  }
  std::vector<double> one = {2};
  EXPECT_EQ(quantile(one, 0.975), 2);
}

TEST(Bootstrap, AgreesWithScipyOnOneStratum) {
  // scipy.stats.bootstrap((x,), statistic, n_resamples=200000, method="percentile"), statistic = trim_mean 0.25 and
  // mean
  const auto iqm = bootstrap({120}, {measure(sample())}, Centre::interquartile_mean, all);
  expect_near(iqm[0].value(), 4.5733, 6.1417, 0.03);
  const auto mean = bootstrap({120}, {measure(sample())}, Centre::mean, all);
  expect_near(mean[0].value(), 5.9067, 9.5508, 0.06);
}

TEST(Bootstrap, StrataKeepTheirSizes) {
  // s = sort(x).reshape(3, 40): 40 drawn with replacement in each row, 100,000 times; quantiles of trim_mean
  std::vector<double> x = sample();
  std::sort(x.begin(), x.end());
  const auto found = bootstrap({40, 40, 40}, {measure(x)}, Centre::interquartile_mean, all);
  expect_near(found[0].value(), 5.1333, 5.5883, 0.015);  // a third of the width of the unstratified interval
}

TEST(Bootstrap, AUnitBringsAllItsValues) {
  // c = sort(x).reshape(12, 10): 12 rows drawn with replacement, 100,000 times; quantiles of trim_mean
  std::vector<double> x = sample();
  std::sort(x.begin(), x.end());
  const auto found = bootstrap({12}, {measure(x, 10)}, Centre::interquartile_mean, all);
  expect_near(found[0].value(), 2.9933, 7.7783, 0.06);
}

TEST(Bootstrap, RatesOverSeeds) {
  // k = [10,10,9,10,3,10,8,10,10,10] of 10 each; k = [9,10,29,1] of n = [10,20,30,5]: quantiles of sum(k) / sum(n)
  std::vector<SeedCounts> seeds;
  for (const std::uint64_t k : {10, 10, 9, 10, 3, 10, 8, 10, 10, 10}) seeds.push_back({10, {k, 10 - k}});
  const auto found = bootstrap_rates(seeds, all);
  expect_near(found[0], 0.75, 1, 1e-12);
  expect_near(found[1], 0, 0.25, 1e-12);
  const std::vector<SeedCounts> uneven = {{10, {9}}, {20, {10}}, {30, {29}}, {5, {1}}};
  expect_near(bootstrap_rates(uneven, all)[0], 0.44, 0.95, 1e-9);
}

TEST(Bootstrap, IsTheSameWhereverItStandsAndInWhateverOrder) {
  std::vector<Measurement> values = measure(sample());
  const auto alone = bootstrap({120}, {values}, Centre::interquartile_mean);
  std::reverse(values.begin(), values.end());
  const auto beside = bootstrap({120}, {{}, measure({1, 2, 3}), values}, Centre::interquartile_mean);
  EXPECT_FALSE(beside[0]);
  EXPECT_EQ(alone[0]->low, beside[2]->low);
  EXPECT_EQ(alone[0]->high, beside[2]->high);
}

TEST(Bootstrap, SurvivesRepetitionsThatDrawNoValue) {
  const auto found = bootstrap({120}, {{{5.0, 7}}}, Centre::interquartile_mean);
  EXPECT_EQ(found[0]->low, 5);
  EXPECT_EQ(found[0]->high, 5);
}

TEST(Bootstrap, FewerRepetitionsForMoreData) {
  EXPECT_EQ(affordable({50'000, 2'000'000}, 10), 50'000u);
  EXPECT_EQ(affordable({50'000, 2'000'000}, 1'000), 2'000u);
  EXPECT_EQ(affordable({50'000, 2'000'000}, 1'000'000), 1'000u);
  EXPECT_EQ(affordable({50'000, 0}, 1'000'000), 50'000u);
  EXPECT_EQ(affordable({500, 2'000'000}, 1'000'000), 500u);
}

TEST(Resampler, DrawsEveryUnitAlikeWithinItsStratum) {
  Resampler resampler({3, 7});
  std::vector<std::uint64_t> sums(10);
  for (int i = 0; i < 30000; ++i) {
    const auto& counts = resampler.next();
    EXPECT_EQ(std::accumulate(counts.begin(), counts.begin() + 3, 0u), 3u);
    EXPECT_EQ(std::accumulate(counts.begin() + 3, counts.end(), 0u), 7u);
    for (std::size_t u = 0; u < 10; ++u) sums[u] += counts[u];
  }
  // Each unit is drawn once a repetition on average; the standard deviation of a sum is below sqrt(30000).
  for (const std::uint64_t sum : sums) EXPECT_NEAR(static_cast<double>(sum), 30000, 5 * 173.2);
}

}  // namespace
}  // namespace wend::core
