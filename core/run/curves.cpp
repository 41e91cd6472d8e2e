#include <core/run/curves.hpp>

#include <cmath>

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

}  // namespace wend::core
