#include <algorithm>
#include <array>
#include <cmath>
#include <core/figure/axis.hpp>
#include <core/figure/style.hpp>
#include <cstdio>

namespace wend::core {
namespace {

std::string tick_label(double value, double step) {
  if (std::fabs(value) >= 1e7 || (value != 0 && std::fabs(value) < 1e-4)) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
  }
  return grouped(value, std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 8));
}

std::vector<Tick> ticks_between(double low, double high, double step) {
  std::vector<Tick> ticks;
  const double first = std::ceil(low / step - 1e-6), last = std::floor(high / step + 1e-6);
  for (double i = first; i <= last && ticks.size() < 50; ++i) ticks.push_back({i * step, tick_label(i * step, step)});
  return ticks;
}

double round_step(double span, int wanted) {
  const double rough = span / std::max(1, wanted), power = std::pow(10, std::floor(std::log10(rough)));
  for (const double lead : {1.0, 2.0, 5.0})
    if (lead * power >= rough * 0.999) return lead * power;
  return 10 * power;
}

void untangle(double& low, double& high) {
  if (!std::isfinite(low) || !std::isfinite(high)) low = 0, high = 1;
  if (high < low) std::swap(low, high);
  if (high - low <= 1e-12 * std::max(std::fabs(low), std::fabs(high)) || high == low) {
    const double room = low == 0 ? 1 : std::fabs(low) * 0.1;
    low -= room;
    high += room;
  }
}

}  // namespace

double round_down_nicely(double value) {
  const double power = std::pow(10, std::floor(std::log10(value) + 1e-9)), lead = value / power;
  return power * (lead >= 5 - 1e-6 ? 5 : lead >= 2 - 1e-6 ? 2 : 1);
}

Axis Axis::fixed(double low, double high, double from, double to, int wanted) {
  untangle(low, high);
  Axis axis;
  axis.low_ = low;
  axis.high_ = high;
  axis.from_ = from;
  axis.to_ = to;
  axis.ticks_ = ticks_between(low, high, round_step(high - low, wanted));
  return axis;
}

Axis Axis::linear(double low, double high, double from, double to, int wanted) {
  untangle(low, high);
  const double step = round_step(high - low, wanted);
  return fixed(std::floor(low / step + 1e-6) * step, std::ceil(high / step - 1e-6) * step, from, to, wanted);
}

Axis Axis::logarithmic(double smallest_positive, double high, bool zero, double from, double to) {
  smallest_positive = smallest_positive > 0 && std::isfinite(smallest_positive) ? smallest_positive : 1;
  high = high > smallest_positive && std::isfinite(high) ? high : smallest_positive * 10;
  Axis axis;
  axis.log_ = true;
  axis.zero_ = zero;
  axis.low_ = smallest_positive * (zero ? std::pow(10, -0.5) : 1);
  axis.high_ = high;
  axis.from_ = from;
  axis.to_ = to;
  if (zero) axis.ticks_.push_back({0, "0"});
  const double decades = std::log10(high / smallest_positive);
  for (double power = std::floor(std::log10(smallest_positive) - 1e-9); power <= std::log10(high) + 1e-9; ++power)
    for (const double lead : {1.0, 2.0, 5.0}) {
      const double value = lead * std::pow(10, power);
      if (lead != 1 && decades > 2.5) continue;
      if (value < smallest_positive * 0.999 || value > high * 1.001 || axis.ticks_.size() > 50) continue;
      axis.ticks_.push_back({value, tick_label(value, value)});
    }
  return axis;
}

double Axis::scaled(double value) const {
  if (!log_) return (value - low_) / (high_ - low_);
  return value <= low_ ? 0 : std::log(value / low_) / std::log(high_ / low_);
}

double Axis::pixel(double value) const {
  return from_ + (to_ - from_) * scaled(value);
}

Quantity quantity(const std::string& name) {
  static constexpr std::array<std::pair<const char*, const char*>, 8> units = {{{"_mps", "m/s"},
                                                                                {"_us", "µs"},
                                                                                {"_ms", "ms"},
                                                                                {"_rad", "rad"},
                                                                                {"_deg", "°"},
                                                                                {"_mb", "MB"},
                                                                                {"_m", "m"},
                                                                                {"_s", "s"}}};
  Quantity result{name, ""};
  for (const auto& [suffix, unit] : units)
    if (name.size() > std::string(suffix).size() && name.ends_with(suffix)) {
      result = {name.substr(0, name.size() - std::string(suffix).size()), unit};
      break;
    }
  const std::size_t training = result.text.rfind("train_", 0) == 0 ? 6 : 0;
  if (training != 0) result.text = "training " + result.text.substr(training);
  if (name == "success" || name == "collision" || name == "timeout") result.text += " rate";
  std::replace(result.text.begin(), result.text.end(), '_', ' ');
  return result;
}

}  // namespace wend::core
