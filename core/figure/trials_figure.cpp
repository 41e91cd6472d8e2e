#include <algorithm>
#include <core/figure/legend.hpp>
#include <core/figure/trials_figure.hpp>
#include <core/figure/map_figure.hpp>

namespace wend::core {
namespace {

const LineStyle failed{rgb(0x009E73), {5, 3}, 1.3}, arrived{rgb(0xD55E00), {}, 2.4};  // green and red of Okabe & Ito

std::string trials(std::size_t n) {
  return grouped(static_cast<double>(n)) + (n == 1 ? " trial" : " trials");
}

}  // namespace

Figure trials_figure(const std::vector<const Trace*>& all, const std::string& title) {
  std::vector<MapArm> bad, good;
  for (const Trace* trace : all) {
    const bool success = outcome(*trace).ending == Ending::arrived;
    auto& list = success ? good : bad;
    list.push_back({success ? "arrived" : "failed", trace, 0, false, success ? arrived : failed});
  }
  std::vector<LegendLine> lines;
  if (!bad.empty()) lines.push_back({failed, "failed: " + trials(bad.size()), false, {}, {}});
  if (!good.empty()) lines.push_back({arrived, "arrived: " + trials(good.size()), false, {}, {}});
  std::vector<MapArm> ways = std::move(bad);  // what succeeded lies above
  ways.insert(ways.end(), good.begin(), good.end());
  return map_figure(ways, lines, title);
}

}  // namespace wend::core
