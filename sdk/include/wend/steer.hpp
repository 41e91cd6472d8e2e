// wend/steer.hpp -- turns "go that way, so fast" into an action, whatever the robot's actions are: a table, speed and
// turn rate, a turn and an advance, or two numbers that are affine in speed and turn rate (wheel speeds).  Asks the
// body only, so who uses it is not privileged.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>
#include <wend/config.hpp>
#include <wend/math.hpp>
#include <wend/period.hpp>
#include <wend/refs.hpp>
#include <wend/space.hpp>

namespace wend {

class Steer {
 public:
  static constexpr double as_fast_as_possible = std::numeric_limits<double>::infinity();

  Steer() = default;
  // `period`: s between two decisions.
  Steer(Space action, BodyRef body, double period, std::uint32_t robot = 0)
      : period_(period), limits_(body.limits(robot)) {
    if (action.width() == 1 && action[0].count > 0) {
      tabulate(body, robot, action[0].count);
    } else if (action.width() == 2 && action[0].count == 0 && action[1].count == 0) {
      for (std::size_t i = 0; i < 2; ++i) low_[i] = action[i].low, high_[i] = action[i].high;
      calibrate(action, body, robot);
    } else {
      throw unsupported("cannot steer with the actions " + action.names() +
                        ": expected one discrete action, or two numbers such as speed and turn_rate");
    }
  }
  // From what a policy is created with; its manifest asks for wend.world/1 and wend.body/1 of "world".
  explicit Steer(const Config& config)
      : Steer(config.action, BodyRef(config.use("world")), period_of(config.use("world"))) {}

  // The action that turns towards `bearing` (rad, relative to the heading) and drives at `speed` (m/s) once aligned.
  void towards(double bearing, double speed, std::span<double> action) const {
    const double error = math::wrap_angle(bearing);
    if (discrete()) {
      action[0] = static_cast<double>(choose(error, speed));
      return;
    }
    // A body that turns in place slows down for large errors; one that cannot needs its speed to turn at all.
    const double share = limits_.turn_radius > 0 ? 1 : std::max(0.0, math::cos(error));
    drive(std::min(speed, top_speed()) * share, turn_rate(error), action);
  }

  // Continuous actions only: the action for a speed (m/s) and a turn rate (rad/s), held within what the body can do.
  void drive(double speed, double turn, std::span<double> action) const {
    speed = std::clamp(speed, limits_.speed_low, limits_.speed_high);
    double most = limits_.turn_rate;
    if (limits_.turn_radius > 0) most = std::min(most, std::fabs(speed) / limits_.turn_radius);
    turn = std::clamp(turn, -most, most);
    const double v = speed - at_rest_[0], w = turn - at_rest_[1];
    for (std::size_t i = 0; i < 2; ++i)
      action[i] = std::clamp(rest_[i] + inverse_[i][0] * v + inverse_[i][1] * w, low_[i], high_[i]);
  }

  bool discrete() const noexcept { return !table_.empty(); }
  // Discrete actions only: where each leads in one period, from rest at the origin.
  std::span<const wend_motion> table() const noexcept { return table_; }
  const wend_limits& limits() const noexcept { return limits_; }
  double period() const noexcept { return period_; }
  // m/s; infinite where neither the body nor the action space bounds it.
  double top_speed() const noexcept { return std::min(limits_.speed_high, bounded_speed_); }

 private:
  void tabulate(BodyRef body, std::uint32_t robot, std::uint64_t count) {
    std::vector<double> actions(count);
    for (std::size_t k = 0; k < count; ++k) actions[k] = static_cast<double>(k);
    table_.resize(count);
    body.predict(robot, std::vector<wend_motion>(count), actions.data(), period_, table_);
  }

  // The two numbers are affine in speed and turn rate, at least near rest.  Small probes stay below acceleration
  // limits.
  void calibrate(Space action, BodyRef body, std::uint32_t robot) {
    if (std::string(action[0].name) == "speed" && std::string(action[1].name) == "turn_rate") {
      bounded_speed_ = high_[0];
      return;
    }
    if (std::string(action[0].name) == "turn" && std::string(action[1].name) == "advance") {  // rad and m a period
      inverse_[0][0] = inverse_[1][1] = 0;
      inverse_[0][1] = inverse_[1][0] = period_;
      bounded_speed_ = high_[1] / period_;
      return;
    }
    double probes[3][2], step[2];
    for (std::size_t i = 0; i < 2; ++i) {
      rest_[i] = std::clamp(0.0, low_[i], high_[i]);
      step[i] = 1e-3 * std::min(1.0, high_[i] - low_[i]) * (rest_[i] < high_[i] ? 1 : -1);
      for (auto& probe : probes) probe[i] = rest_[i];
    }
    probes[1][0] += step[0], probes[2][1] += step[1];
    const wend_motion still[3]{};
    wend_motion to[3];
    body.predict(robot, still, &probes[0][0], period_, to);
    at_rest_[0] = to[0].speed, at_rest_[1] = to[0].turn_rate;
    const double a = (to[1].speed - at_rest_[0]) / step[0], b = (to[2].speed - at_rest_[0]) / step[1];
    const double c = (to[1].turn_rate - at_rest_[1]) / step[0], d = (to[2].turn_rate - at_rest_[1]) / step[1];
    const double determinant = a * d - b * c;
    if (!(std::fabs(determinant) > 1e-12))
      throw unsupported("cannot steer with the actions " + action.names() + ": they do not set speed and turn rate");
    inverse_[0][0] = d / determinant, inverse_[0][1] = -b / determinant;
    inverse_[1][0] = -c / determinant, inverse_[1][1] = a / determinant;
  }

  // The fastest turn that one more period and then full braking do not carry past the error.
  double turn_rate(double error) const {
    const double left = std::fabs(error), a = limits_.turn_acceleration;
    double rate = left / period_;
    if (std::isfinite(a) && a > 0) rate = std::min(rate, a * (std::sqrt(period_ * period_ + 2 * left / a) - period_));
    return std::copysign(rate, error);
  }

  // The least error after one period; among equals the straightest, then the nearest to the wanted speed, then the
  // first.
  std::size_t choose(double error, double speed) const {
    constexpr double tie = 1e-9;
    const auto turned = [&](std::size_t k) { return std::fabs(math::wrap_angle(error - table_[k].heading)); };
    const auto bend = [&](std::size_t k) { return std::fabs(table_[k].heading); };
    const auto off_speed = [&](std::size_t k) {
      const double advance = std::copysign(math::hypot(table_[k].x, table_[k].y), table_[k].x);
      return std::isfinite(speed) ? std::fabs(speed * period_ - advance) : -advance;
    };
    std::size_t best = 0;
    for (std::size_t k = 1; k < table_.size(); ++k) {
      const double by_turn = turned(k) - turned(best), by_bend = bend(k) - bend(best);
      if (std::fabs(by_turn) > tie   ? by_turn < 0
          : std::fabs(by_bend) > tie ? by_bend < 0
                                     : off_speed(k) < off_speed(best) - tie)
        best = k;
    }
    return best;
  }

  double period_ = 1;
  wend_limits limits_{};
  std::vector<wend_motion> table_;
  // action = rest + inverse * ((speed, turn rate) - those of `rest`)
  double low_[2]{}, high_[2]{}, rest_[2]{}, at_rest_[2]{}, inverse_[2][2]{{1, 0}, {0, 1}};
  double bounded_speed_ = std::numeric_limits<double>::infinity();
};

}  // namespace wend
