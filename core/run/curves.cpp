#include <core/base/sha256.hpp>
#include <core/run/curves.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace wend::core {

void CurveBook::add(const std::string& metric, const std::string& x_name, std::optional<std::uint32_t> robot, double x, double y) {
  if (!std::isfinite(x) || !std::isfinite(y)) return;
  Line& line = lines_[{metric, x_name, robot}];
  if (line.bins.empty() || line.bins.back().n == line.per_bin) {
    if (line.bins.size() == most_points) {  // pairs become one, and bins take twice as many from here on
      for (std::size_t i = 0; i < most_points / 2; ++i) {
        const Bin &a = line.bins[2 * i], &b = line.bins[2 * i + 1];
        line.bins[i] = {b.x, a.sum + b.sum, a.n + b.n};
      }
      line.bins.resize(most_points / 2);
      line.per_bin *= 2;
    }
    line.bins.emplace_back();
  }
  Bin& bin = line.bins.back();
  bin.x = x;
  bin.sum += y;
  ++bin.n;
}

std::vector<Curve> CurveBook::take() {
  std::vector<Curve> curves;
  for (const auto& [key, line] : lines_) {
    Curve curve{std::get<0>(key), std::get<1>(key), std::get<2>(key), {}};
    for (const Bin& bin : line.bins) curve.points.emplace_back(bin.x, bin.sum / static_cast<double>(bin.n));
    curves.push_back(std::move(curve));
  }
  lines_.clear();
  return curves;
}

void SeriesBook::add(const std::string& metric, const std::string& x_name, double x, double y) {
  if (!std::isfinite(x) || !std::isfinite(y)) return;
  Series& series = all_[{metric, x_name}];
  if (!series.present.empty() && x <= series.present.back().first) series.close();
  if (series.present.size() < most_points) series.present.emplace_back(x, y);
}

void SeriesBook::Series::close() {
  const std::string bytes(reinterpret_cast<const char*>(present.data()), present.size() * sizeof(present[0]));
  runs.emplace(sha256(bytes), std::move(present));
  if (runs.size() > most_runs) runs.erase(std::prev(runs.end()));
  present.clear();
}

SeriesBook::Points SeriesBook::mean(const Runs& runs) {
  std::vector<double> xs;
  for (const auto& [hash, run] : runs)
    for (const auto& point : run) xs.push_back(point.first);
  std::sort(xs.begin(), xs.end());
  xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
  std::vector<double> sums(xs.size(), 0.0);
  std::vector<std::size_t> counts(xs.size(), 0);
  for (const auto& [hash, run] : runs) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < xs.size(); ++i) {
      while (next < run.size() && run[next].first <= xs[i]) ++next;
      if (next == 0) continue;
      sums[i] += run[next - 1].second;
      ++counts[i];
    }
  }
  Points points;
  for (std::size_t i = 0; i < xs.size(); ++i) points.emplace_back(xs[i], sums[i] / static_cast<double>(counts[i]));
  return points;
}

std::vector<Curve> SeriesBook::take() {
  std::vector<Curve> curves;
  for (auto& [key, series] : all_) {
    series.close();
    curves.push_back({key.first, key.second, std::nullopt, mean(series.runs)});
  }
  all_.clear();
  return curves;
}

}  // namespace wend::core
