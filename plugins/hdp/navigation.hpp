// The robot's state and reinforcement of the paper, equations (14)-(21), from a range sensor that tells kinds and the
// bearing of the goal.  Policy and reward share it.
//
//   symbol    here        meaning
//   d_i, l    ranges_     distance that sensor i reads, m, and its range
//   gamma_i   kinds_      +1 goal, -1 obstacle or wall, 0 nothing
//   x_i       look()      gamma_i (l - d_i) / l                                     (14)
//   theta     deviation() of the heading from the goal's direction, in [-1, 1]       (15), (16)
//   Sen       seen()      max x_i where a goal is seen, min x_i where an obstacle is  (19)
#pragma once
#include <cmath>
#include <string>
#include <string_view>
#include <wend/config.hpp>
#include <wend/math.hpp>
#include <wend/reading.hpp>

namespace hdp {

enum class Theta { printed, clipped };
enum class Tie { obstacle, goal, larger };

inline Theta theta_of(const std::string& name) {
  return name == "printed" ? Theta::printed : Theta::clipped;
}
inline Tie tie_of(const std::string& name) {
  return name == "goal" ? Tie::goal : name == "larger" ? Tie::larger : Tie::obstacle;
}

// (16) of delta = theta_1 - theta_2 in [-pi, pi): as printed it jumps from 1/2 to 1 at 90 degrees.
inline double deviation(double delta, Theta form) noexcept {
  if (delta >= wend::math::half_pi) return 1;
  if (delta <= -wend::math::half_pi) return -1;
  return delta / (form == Theta::printed ? wend::math::pi : wend::math::half_pi);
}

// (19); 0 where nothing is in range.
inline double seen(std::span<const double> x, Tie tie) noexcept {
  double most = 0, least = 0;
  for (const double value : x) most = std::max(most, value), least = std::min(least, value);
  if (most > 0 && least < 0) {
    if (tie == Tie::larger) return most >= -least ? most : least;
    return tie == Tie::goal ? most : least;
  }
  return most > 0 ? most : least;
}

// (20) and (21) of a step without a collision.  x is the state: the x_i, then theta.
inline double reinforcement(std::span<const double> x, Tie tie, double beta) noexcept {
  const auto sensors = x.first(x.size() - 1);
  bool any = false;
  for (const double value : sensors) any |= value != 0;
  const double weight = any ? beta : 0;
  return -(1 - weight) * std::fabs(x.back()) + weight * seen(sensors, tie);
}

class Navigation {
 public:
  Navigation(wend::Space space, const wend::Params& params, Theta theta)
      : ranges_(space, params.texts("range"), "range"),
        kinds_(space, params.texts("kinds"), "kinds"),
        goal_(space, params.text("goal"), "goal"),
        theta_(theta) {
    if (ranges_.size() != kinds_.size())
      throw wend::parameter_error("kinds", "expected as many columns as in range, " + std::to_string(ranges_.size()) +
                                               ", found " + std::to_string(kinds_.size()));
    expect_unit(goal_.column(0), "rad", "goal");
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      const double reach = ranges_.column(i).high;
      expect_unit(ranges_.column(i), "m", "range");
      if (!(reach > 0) || std::isinf(reach))
        throw wend::parameter_error("range", "column \"" + std::string(ranges_.column(i).name) +
                                                 "\": expected a distance with a finite range, found none");
      expect_unit(kinds_.column(i), "1", "kinds");
      if (ranges_.bearing(i) != kinds_.bearing(i))
        throw wend::parameter_error("kinds", "column " + std::to_string(i) + ": expected the bearing of \"" +
                                                 ranges_.column(i).name + "\", found another");
    }
  }

  std::size_t sensors() const noexcept { return ranges_.size(); }
  std::size_t size() const noexcept { return ranges_.size() + 1; }
  double bearing(std::size_t i) const noexcept { return ranges_.bearing(i); }

  // X(t) of (17): x_1 .. x_n, theta.
  void look(std::span<const double> observation, std::span<double> x) const {
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      const auto kind = static_cast<std::uint32_t>(kinds_(observation, i));
      const double reach = ranges_.column(i).high;
      const double gamma = kind == WEND_NOTHING ? 0 : kind == WEND_GOAL ? 1 : -1;
      x[i] = gamma == 0 ? 0 : gamma * (reach - ranges_(observation, i)) / reach;
    }
    // theta_1 - theta_2 is minus the goal's bearing relative to the heading.
    x[ranges_.size()] = deviation(wend::math::wrap_angle(-goal_(observation)), theta_);
  }

 private:
  static void expect_unit(const wend_column& column, std::string_view unit, const char* parameter) {
    if (column.unit != unit)
      throw wend::parameter_error(parameter, "column \"" + std::string(column.name) + "\": expected the unit " +
                                                 std::string(unit) + ", found " + column.unit);
  }

  wend::Reading ranges_, kinds_, goal_;
  Theta theta_;
};

}  // namespace hdp
