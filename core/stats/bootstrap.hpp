// The interquartile mean and percentile bootstrap intervals (95 %), as rliable defines them (Agarwal et al. 2021: Deep
// reinforcement learning at the edge of the statistical precipice).
//
// What is drawn is a unit: an episode, or, where a training stands behind several episodes, the training's seed with
// all of them, because they share its luck.  Strata (variants of a world) keep their number of units in every
// repetition.
#pragma once
#include <core/stats/intervals.hpp>
#include <cstdint>
#include <optional>
#include <vector>

namespace wend::core {

struct BootstrapOptions {
  std::uint64_t repetitions = 50'000;
  // Fewer repetitions where they cost more than this many units and values, but never below 1,000: with 2,000 the ends
  // of an interval scatter by about 4 % of its width.  0: always all of them, as a report does.
  std::uint64_t work = 2'000'000;
};

constexpr std::uint64_t fewest_repetitions = 1'000;

// What repetitions of this cost (units drawn plus values looked at) are worth doing.
std::uint64_t affordable(const BootstrapOptions& options, std::uint64_t cost);

// The mean without the lowest and highest floor(n / 4) values: scipy.stats.trim_mean(values, 0.25).  Not of an empty
// list.
double interquartile_mean(std::vector<double> values);

// numpy.quantile's default: linear between the two nearest order statistics.  Reorders `values`, which is not empty.
double quantile(std::vector<double>& values, double p);

// How often each unit is drawn, repetition by repetition.  The numbers depend on the strata alone, so equal data have
// equal intervals wherever they stand.
class Resampler {
 public:
  explicit Resampler(std::vector<std::uint32_t> strata);  // units of each stratum; units are numbered through
  const std::vector<std::uint32_t>& next();
  std::uint32_t units() const { return static_cast<std::uint32_t>(counts_.size()); }

 private:
  std::vector<std::uint32_t> strata_, counts_;
  std::uint64_t position_ = 0;
};

struct Measurement {
  double value;  // finite
  std::uint32_t unit;
};

enum class Centre { interquartile_mean, mean };

// The intervals of several metrics of the same episodes, from the same draws; nothing for a metric without values.
std::vector<std::optional<Interval>> bootstrap(const std::vector<std::uint32_t>& strata,
                                               const std::vector<std::vector<Measurement>>& metrics, Centre centre,
                                               const BootstrapOptions& options = {});

// Rates over seeds: seeds[i] has `n` episodes, of which counts[k] are of kind k.
struct SeedCounts {
  std::uint64_t n = 0;
  std::vector<std::uint64_t> counts;
};
std::vector<Interval> bootstrap_rates(const std::vector<SeedCounts>& seeds, const BootstrapOptions& options = {});

}  // namespace wend::core
