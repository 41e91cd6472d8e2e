#include <algorithm>
#include <core/stats/bootstrap.hpp>
#include <numeric>
#include <utility>
#include <wend/random.hpp>

namespace wend::core {
namespace {

constexpr std::uint64_t key = 0x626f6f7473747261;  // "bootstra"

// The centre of values in ascending order, each `counts[unit]` times; nothing if none was drawn.  `cut` is the divisor
// of the part that is left out at each end: 4, or 0 for nothing.
std::optional<double> centre_of(const std::vector<Measurement>& sorted, const std::vector<std::uint32_t>& counts,
                                std::uint64_t cut) {
  std::uint64_t n = 0;
  for (const Measurement& m : sorted) n += counts[m.unit];
  if (n == 0) return {};
  const std::uint64_t skip = cut == 0 ? 0 : n / cut, keep = n - 2 * skip;
  std::size_t i = 0;
  std::uint64_t seen = 0;
  while ((seen += counts[sorted[i].unit]) <= skip) ++i;
  std::uint64_t taken = std::min(seen - skip, keep);
  double sum = static_cast<double>(static_cast<std::int64_t>(taken)) * sorted[i].value;
  while (taken < keep) {
    const Measurement& m = sorted[++i];
    const std::uint64_t times = std::min<std::uint64_t>(counts[m.unit], keep - taken);
    sum += static_cast<double>(static_cast<std::int64_t>(times)) * m.value;
    taken += times;
  }
  return sum / static_cast<double>(static_cast<std::int64_t>(keep));
}

Interval percentiles(std::vector<double>& values) {
  return {quantile(values, 0.025), quantile(values, 0.975)};
}

}  // namespace

std::uint64_t affordable(const BootstrapOptions& options, std::uint64_t cost) {
  if (options.work == 0 || cost == 0) return options.repetitions;
  return std::min(options.repetitions, std::max(fewest_repetitions, options.work / cost));
}

double interquartile_mean(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto cut = static_cast<std::ptrdiff_t>(values.size() / 4);
  const double sum = std::accumulate(values.begin() + cut, values.end() - cut, 0.0);
  return sum / static_cast<double>(values.size() - 2 * static_cast<std::size_t>(cut));
}

double quantile(std::vector<double>& values, double p) {
  const double at = p * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(values.begin(), nth, values.end());
  const double low = *nth;
  if (below + 1 == values.size()) return low;
  const double high = *std::min_element(nth + 1, values.end());
  return low + (at - static_cast<double>(below)) * (high - low);
}

Resampler::Resampler(std::vector<std::uint32_t> strata) : strata_(std::move(strata)) {
  counts_.resize(std::accumulate(strata_.begin(), strata_.end(), std::size_t{0}));
}

const std::vector<std::uint32_t>& Resampler::next() {
  std::fill(counts_.begin(), counts_.end(), 0);
  Random random(key, position_);
  std::uint32_t* first = counts_.data();
  for (const std::uint32_t size : strata_) {
    // Two units from one word: each half times the size, upper part.  The bias is below size / 2^32.
    for (std::uint32_t i = 0; i < size; i += 2) {
      const std::uint64_t word = random.word();
      ++first[(word >> 32) * size >> 32];
      if (i + 1 < size) ++first[(word & 0xffffffff) * size >> 32];
    }
    first += size;
  }
  position_ = random.position();
  return counts_;
}

std::vector<std::optional<Interval>> bootstrap(const std::vector<std::uint32_t>& strata,
                                               const std::vector<std::vector<Measurement>>& metrics, Centre centre,
                                               const BootstrapOptions& options) {
  Resampler resampler(strata);
  std::vector<std::vector<Measurement>> sorted = metrics;
  std::uint64_t most = resampler.units();
  for (auto& metric : sorted) {
    std::sort(metric.begin(), metric.end(), [](const Measurement& a, const Measurement& b) {
      return a.value != b.value ? a.value < b.value : a.unit < b.unit;  // total, so that sums round alike everywhere
    });
    most = std::max<std::uint64_t>(most, metric.size());
  }
  const std::uint64_t repetitions = affordable(options, most);
  std::vector<std::vector<double>> centres(metrics.size());
  for (auto& list : centres) list.reserve(repetitions);
  for (std::uint64_t i = 0; i < repetitions; ++i) {
    const auto& counts = resampler.next();
    for (std::size_t m = 0; m < sorted.size(); ++m) {
      if (const auto value = centre_of(sorted[m], counts, centre == Centre::mean ? 0 : 4)) centres[m].push_back(*value);
    }
  }
  std::vector<std::optional<Interval>> out(metrics.size());
  for (std::size_t m = 0; m < metrics.size(); ++m)
    if (!centres[m].empty()) out[m] = percentiles(centres[m]);
  return out;
}

std::vector<Interval> bootstrap_rates(const std::vector<SeedCounts>& seeds, const BootstrapOptions& options) {
  if (seeds.empty()) return {};
  const std::size_t kinds = seeds[0].counts.size();
  Resampler resampler({static_cast<std::uint32_t>(seeds.size())});
  const std::uint64_t repetitions = affordable(options, seeds.size() * (1 + kinds));
  std::vector<std::vector<double>> rates(kinds);
  std::vector<std::uint64_t> sums(kinds);
  for (std::uint64_t i = 0; i < repetitions; ++i) {
    const auto& times = resampler.next();
    std::uint64_t n = 0;
    std::fill(sums.begin(), sums.end(), 0);
    for (std::size_t s = 0; s < seeds.size(); ++s) {
      if (times[s] == 0) continue;
      n += times[s] * seeds[s].n;
      for (std::size_t k = 0; k < kinds; ++k) sums[k] += times[s] * seeds[s].counts[k];
    }
    if (n == 0) continue;
    for (std::size_t k = 0; k < kinds; ++k) rates[k].push_back(static_cast<double>(sums[k]) / static_cast<double>(n));
  }
  std::vector<Interval> out;
  for (auto& list : rates) out.push_back(list.empty() ? Interval{0, 1} : percentiles(list));
  return out;
}

}  // namespace wend::core
