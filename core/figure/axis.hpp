// Axes: round ticks, and from values to pixels.
#pragma once
#include <core/figure/display.hpp>
#include <string>
#include <vector>

namespace wend::core {

// The largest of 1, 2, 5 times a power of ten that is at most `value`, which is positive.
double round_down_nicely(double value);

struct Tick {
  double value;
  std::string label;
};

// An axis from pixel `from` to pixel `to`.  On a logarithmic one that must show 0, the zero stands half a decade below
// the smallest positive value.
class Axis {
 public:
  // Widens [low, high] to round ends; about `wanted` ticks.
  static Axis linear(double low, double high, double from, double to, int wanted = 6);
  // Of exactly [low, high].
  static Axis fixed(double low, double high, double from, double to, int wanted = 6);
  static Axis logarithmic(double smallest_positive, double high, bool zero, double from, double to);

  double pixel(double value) const;
  const std::vector<Tick>& ticks() const { return ticks_; }
  bool broken() const { return zero_; }  // between zero and the first decade

 private:
  double scaled(double value) const;

  double low_ = 0, high_ = 1, from_ = 0, to_ = 1;
  bool log_ = false, zero_ = false;
  std::vector<Tick> ticks_;
};

// "path_length_m" becomes {"path length", "m"}: what a metric's name says of its unit.
struct Quantity {
  std::string text, unit;

  std::string title() const { return unit.empty() ? text : text + " (" + unit + ")"; }
};
Quantity quantity(const std::string& name);

}  // namespace wend::core
