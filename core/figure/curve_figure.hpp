// Curves with confidence bands.
#pragma once
#include <cmath>
#include <core/figure/display.hpp>
#include <core/figure/style.hpp>
#include <string>
#include <vector>

namespace wend::core {

struct CurvePoint {
  double x = 0, mean = 0;
  double low = std::nan(""), high = std::nan("");  // NaN: no band here
};

struct CurveSeries {
  std::string label;
  LineStyle style;
  std::vector<CurvePoint> points;  // ascending in x; a point that is not finite is a gap
  bool privileged = false;
};

struct CurveOptions {
  std::string title, x_title, y_title, note;  // note: what the band is
  bool log_x = false;
  bool share = false;  // y is a rate: its axis shows 0 to 1
};

Figure curve_figure(const std::vector<CurveSeries>& curves, const CurveOptions& options);

}  // namespace wend::core
