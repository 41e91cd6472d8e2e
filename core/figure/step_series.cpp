#include <algorithm>
#include <cmath>
#include <core/figure/step_series.hpp>

namespace wend::core {
namespace {

// The column of the telemetry called `name`; as many as there are: none.
std::size_t column_of(const Trace& trace, const std::string& name) {
  const auto& names = trace.telemetry_names;
  const auto exact = std::find(names.begin(), names.end(), name);
  if (exact != names.end()) return static_cast<std::size_t>(exact - names.begin());
  const auto of_slot = std::find_if(names.begin(), names.end(), [&](const auto& other) { return other.ends_with("." + name); });
  return static_cast<std::size_t>(of_slot - names.begin());
}

}  // namespace

std::vector<CurvePoint> step_series(const std::vector<const Trace*>& episodes, const std::string& name) {
  std::vector<CurvePoint> points;
  double began = 0;
  for (const Trace* trace : episodes) {
    const std::size_t robots = trace->robots, width = trace->telemetry_names.size(), column = column_of(*trace, name);
    const bool reward = name == "reward" && column == width;
    if (robots == 0 || (!reward && column == width)) continue;
    if (!points.empty()) points.push_back({std::nan(""), std::nan("")});
    const std::size_t steps = std::min(trace->reward.size() / robots, trace->time.size());
    for (std::size_t t = 0; t < steps; ++t) {
      const std::size_t place = reward ? t * robots : t * robots * width + column;
      const auto& values = reward ? trace->reward : trace->telemetry;
      if (place < values.size()) points.push_back({began + trace->time[t], values[place]});
    }
    if (!trace->time.empty()) began += trace->time.back();
  }
  const bool any = std::any_of(points.begin(), points.end(), [](const CurvePoint& p) { return std::isfinite(p.mean); });
  if (!any) points.clear();  // a value that never applied
  return points;
}

}  // namespace wend::core
