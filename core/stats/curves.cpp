#include <algorithm>
#include <cmath>
#include <core/stats/curves.hpp>
#include <limits>

namespace wend::core {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

// In ascending x; of points with the same x the last one.
Points ordered(const Points& points) {
  Points out;
  for (const auto& point : points)
    if (std::isfinite(point.first) && std::isfinite(point.second)) out.push_back(point);
  std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::size_t n = 0;
  for (std::size_t i = 0; i < out.size(); ++i)
    if (i + 1 == out.size() || out[i].first != out[i + 1].first) out[n++] = out[i];
  out.resize(n);
  return out;
}

std::vector<double> union_of_x(const std::vector<Points>& seeds) {
  std::vector<double> xs;
  for (const Points& points : seeds)
    for (const auto& point : points) xs.push_back(point.first);
  std::sort(xs.begin(), xs.end());
  xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
  if (xs.size() <= most_curve_points) return xs;
  std::vector<double> thin;
  for (std::size_t i = 0; i < most_curve_points; ++i) thin.push_back(xs[i * (xs.size() - 1) / (most_curve_points - 1)]);
  return thin;
}

// The value of each x: the last one at or before it.
std::vector<double> carried(const Points& points, const std::vector<double>& xs) {
  std::vector<double> ys;
  std::size_t next = 0;
  for (const double x : xs) {
    while (next < points.size() && points[next].first <= x) ++next;
    ys.push_back(next == 0 ? missing : points[next - 1].second);
  }
  return ys;
}

Interval share(const std::vector<std::vector<double>>& ys, std::size_t p) {
  std::uint64_t ones = 0, n = 0;
  for (const auto& seed : ys) {
    n += !std::isnan(seed[p]);
    ones += seed[p] == 1;
  }
  return wilson(ones, n);
}

// The bootstrap of the mean over seeds at all points, from the same draws.
std::vector<Interval> bands(const std::vector<std::vector<double>>& ys, std::size_t points,
                            const BootstrapOptions& options) {
  Resampler resampler({static_cast<std::uint32_t>(ys.size())});
  const std::uint64_t repetitions = affordable(options, points * ys.size());
  std::vector<std::vector<double>> means(points);
  std::vector<double> sums(points), counts(points);
  for (std::uint64_t i = 0; i < repetitions; ++i) {
    const auto& times = resampler.next();
    std::fill(sums.begin(), sums.end(), 0.0);
    std::fill(counts.begin(), counts.end(), 0.0);
    for (std::size_t s = 0; s < ys.size(); ++s) {
      const double n = times[s];
      if (n == 0) continue;
      for (std::size_t p = 0; p < points; ++p) {
        const bool there = !std::isnan(ys[s][p]);
        sums[p] += there ? n * ys[s][p] : 0.0;
        counts[p] += there ? n : 0.0;
      }
    }
    for (std::size_t p = 0; p < points; ++p)
      if (counts[p] > 0) means[p].push_back(sums[p] / counts[p]);
  }
  std::vector<Interval> out;
  for (auto& list : means) {
    if (list.empty()) {  // one seed of very many, never drawn
      out.push_back({missing, missing});
    } else {
      out.push_back({quantile(list, 0.025), quantile(list, 0.975)});
    }
  }
  return out;
}

}  // namespace

Json aggregate(const std::vector<Points>& seeds, const BootstrapOptions& options) {
  std::vector<Points> curves;
  for (const Points& points : seeds) {
    curves.push_back(ordered(points));
    if (curves.back().empty()) curves.pop_back();
  }
  const std::vector<double> xs = union_of_x(curves);
  std::vector<std::vector<double>> ys;
  bool is_share = true;
  for (const Points& points : curves) {
    ys.push_back(carried(points, xs));
    for (const double y : ys.back()) is_share &= std::isnan(y) || y == 0 || y == 1;
  }
  std::vector<Interval> intervals;
  if (is_share) {
    for (std::size_t p = 0; p < xs.size(); ++p) intervals.push_back(share(ys, p));
  } else {
    intervals = bands(ys, xs.size(), options);
  }
  Json out = Json::array();
  for (std::size_t p = 0; p < xs.size(); ++p) {
    double sum = 0;
    std::size_t n = 0;
    for (const auto& seed : ys) {
      if (std::isnan(seed[p])) continue;
      sum += seed[p];
      ++n;
    }
    const double mean = sum / static_cast<double>(n);
    if (std::isfinite(mean) && std::isfinite(intervals[p].low) && std::isfinite(intervals[p].high))
      out.push_back({xs[p], mean, intervals[p].low, intervals[p].high});
  }
  return out;
}

}  // namespace wend::core
