// Values with intervals: one row an arm, one panel a world.
#pragma once
#include <cmath>
#include <core/figure/display.hpp>
#include <core/figure/style.hpp>
#include <string>
#include <vector>

namespace wend::core {

struct Estimate {
  double value = std::nan(""), low = std::nan(""), high = std::nan("");  // a NaN value: the arm has none here
};

struct IntervalArm {
  std::string label;
  LineStyle style;
  bool privileged = false;
};

struct IntervalPanel {
  std::string title;
  std::vector<Estimate> values;  // one per arm
};

struct IntervalOptions {
  std::string title, x_title, note;
  bool share = false;  // rates: 0 to 100 %
};

Figure interval_figure(const std::vector<IntervalArm>& arms, const std::vector<IntervalPanel>& panels,
                       const IntervalOptions& options);

}  // namespace wend::core
