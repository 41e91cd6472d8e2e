// How a robot turns an action into motion.  Within a dt a body moves at constant speed and turn rate, along an exact
// arc; limits of acceleration act once a dt, on its first instant.
#pragma once
#include <cmath>
#include <span>
#include <vector>
#include <wend/config.hpp>

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
  Command command(std::span<const double> action, double a = 0, double b = 0) const;
  // Speed and turn rate during the next dt.
  Twist twist(const Command& command, const wend_motion& from) const noexcept;
  // m: how far the pose's point moves along its way in a time, at most.
  double way(Twist twist, double seconds) const noexcept {
    return (std::fabs(twist.speed) + std::fabs(offset_ * twist.turn_rate)) * seconds;
  }
  // Along the arc for a time.
  void move(wend_motion& motion, Twist twist, double seconds) const noexcept;
  // Where an action leads in `seconds`, without noise.
  wend_motion predict(wend_motion from, std::span<const double> action, double seconds) const;

  // Speeds, turn rate, accelerations, turn radius; the body's own members stay as they are.
  void limits(wend_limits& out) const noexcept;

 private:
  enum class Type { differential, unicycle, turn_then_advance };
  void read_differential(const wend::Params& robot);
  void read_unicycle(const wend::Params& robot);
  void read_turn_then_advance(const wend::Params& robot);
  void read_table(const wend::Params& robot);
  Command decode(double first, double second) const noexcept;
  double turn_radius() const noexcept;

  Type type_ = Type::unicycle;
  double dt_, period_;
  double wheel_radius_ = 1, half_track_ = 1, offset_ = 0, wheel_speed_ = 1;
  double speed_low_ = 0, speed_high_ = 0, turn_rate_ = 0;  // of the unicycle; of the others as their actions allow
  double acceleration_, turn_acceleration_;                // infinite: no limit
  double step_ = 0, turn_ = 0;                             // m, rad a decision
  Noise noise_;
  std::vector<Command> table_;
  wend::Columns columns_;
};

}  // namespace arena
