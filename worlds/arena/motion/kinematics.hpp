// How a robot turns an action into motion.  Within a dt a body moves at constant speed and turn rate, along an exact
// arc; limits of acceleration act once a dt, on its first instant.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>
#include <wend/config.hpp>

#include "../geometry/lanes.hpp"

namespace arena {

struct Twist {
  double speed = 0, turn_rate = 0;  // m/s, rad/s
};

// What one decision asks for.
struct Command {
  double turn = 0;  // rad, in place, at the first instant of the period
  Twist twist;      // from then on
};

struct Noise {
  double speed = 0, turn_rate = 0;  // relative standard deviations, drawn once a decision
};

class Kinematics {
 public:
  // Reads the robot definition: "kinematics", "actions" and "noise".  Throws wend::Error.
  Kinematics(const wend::Params& robot, double dt, double period);

  // The columns of an action row.
  const wend::Columns& columns() const noexcept { return columns_; }
  // True where an action row is the number of a row of the action table.
  bool discrete() const noexcept { return !table_.empty(); }
  const Noise& noise() const noexcept { return noise_; }

  // `a`, `b`: standard normal numbers, or 0 for no noise.
  Command command(std::span<const double> action, double a = 0, double b = 0) const {
    if (discrete() ? !(action[0] >= 0 && action[0] < static_cast<double>(table_.size()))
                   : !(std::fabs(action[0]) < unlimited && std::fabs(action[1]) < unlimited))
      throw refused(action);
    Command command = discrete() ? table_[static_cast<std::size_t>(action[0])] : decode(action[0], action[1]);
    command.twist.speed *= 1 + noise_.speed * a;
    command.twist.turn_rate *= 1 + noise_.turn_rate * b;
    command.turn *= 1 + noise_.turn_rate * b;
    return command;
  }
  // Speed and turn rate during the next dt.
  Twist twist(const Command& command, const wend_motion& from) const noexcept {
    Twist twist = command.twist;
    if (acceleration_ < unlimited)
      twist.speed = clamp(twist.speed, from.speed - acceleration_ * dt_, from.speed + acceleration_ * dt_);
    if (turn_acceleration_ < unlimited)
      twist.turn_rate =
          clamp(twist.turn_rate, from.turn_rate - turn_acceleration_ * dt_, from.turn_rate + turn_acceleration_ * dt_);
    return twist;
  }
  // m: how far the pose's point moves along its way in a time, at most.
  double way(Twist twist, double seconds) const noexcept {
    return (std::fabs(twist.speed) + std::fabs(offset_ * twist.turn_rate)) * seconds;
  }
  // Along the arc for a time.
  void move(wend_motion& motion, Twist twist, double seconds) const noexcept;
  // The same of a block, with the same bits; speed and turn rate stay as they are.
  void move(Arcs& arcs, double seconds) const noexcept;
  // Where an action leads in `seconds`, without noise.
  wend_motion predict(wend_motion from, std::span<const double> action, double seconds) const;

  // Speeds, turn rate, accelerations, turn radius; the body's own members stay as they are.
  void limits(wend_limits& out) const noexcept;

 private:
  static constexpr double unlimited = std::numeric_limits<double>::infinity();
  static double clamp(double value, double low, double high) noexcept { return std::min(std::max(value, low), high); }
  enum class Type { differential, unicycle, turn_then_advance };
  void read_differential(const wend::Params& robot);
  void read_unicycle(const wend::Params& robot);
  void read_turn_then_advance(const wend::Params& robot);
  void read_table(const wend::Params& robot);
  // An action row's two numbers, within the limits: wheel speeds, or speed and turn rate, or turn and advance.
  Command decode(double first, double second) const noexcept {
    const double a = clamp(first, low_[0], high_[0]), b = clamp(second, low_[1], high_[1]);
    switch (type_) {
      case Type::differential:
        return {0, {half_radius_ * (a + b), turning_ * (b - a)}};
      case Type::unicycle:
        return {0, {a, b}};
      case Type::turn_then_advance:
        break;
    }
    return {a, {b / period_, 0}};
  }
  wend::Error refused(std::span<const double> action) const;
  double turn_radius() const noexcept;

  Type type_ = Type::unicycle;
  double dt_, period_;
  double wheel_radius_ = 1, half_track_ = 1, offset_ = 0, wheel_speed_ = 1;
  double speed_low_ = 0, speed_high_ = 0, turn_rate_ = 0;  // of the unicycle; of the others as their actions allow
  double acceleration_, turn_acceleration_;                // infinite: no limit
  double step_ = 0, turn_ = 0;                             // m, rad a decision
  // Of an action row's numbers; a table's are its own, but for a unicycle.
  double low_[2] = {-unlimited, -unlimited}, high_[2] = {unlimited, unlimited};
  double half_radius_ = 0, turning_ = 0;  // R/2, R/(2 l_a)
  Noise noise_;
  std::vector<Command> table_;
  wend::Columns columns_;
};

}  // namespace arena
