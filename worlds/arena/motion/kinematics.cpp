// Kinematics: see kinematics.hpp.
//
//   differential       v = R/2 (w_l + w_r), omega = R/(2 l_a) (w_r - w_l), l_a half the track; the pose is that of the
//                      point l_b (offset) ahead of the axle
//   unicycle           v and omega, within their limits
//   turn_then_advance  turns on the spot, then straight on for the rest of the period
#include "kinematics.hpp"

#include <cmath>
#include <limits>
#include <wend/math.hpp>

namespace arena {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

double clamp(double value, double low, double high) noexcept {
  return std::min(std::max(value, low), high);
}

// sin(h) / h
double sinc(double h) noexcept {
  if (std::fabs(h) < 1e-4) return 1 - h * h / 6;  // the next term is below an ulp
  return wend::math::sin(h) / h;
}

}  // namespace

Kinematics::Kinematics(const wend::Params& robot, double dt, double period)
    : dt_(dt),
      period_(period),
      acceleration_(unlimited),
      turn_acceleration_(unlimited),
      noise_{robot.number_or("noise/speed", 0), robot.number_or("noise/turn_rate", 0)} {
  const std::string type = robot.text("kinematics/type");
  if (type == "differential") {
    read_differential(robot);
  } else if (type == "unicycle") {
    read_unicycle(robot);
  } else if (type == "turn_then_advance") {
    read_turn_then_advance(robot);
  } else {
    throw wend::parameter_error("kinematics/type",
                                "expected differential, unicycle or turn_then_advance, found " + type);
  }
  read_table(robot);
}

void Kinematics::read_differential(const wend::Params& robot) {
  type_ = Type::differential;
  wheel_radius_ = robot.number("kinematics/wheel_radius");
  half_track_ = robot.number("kinematics/half_track");
  offset_ = robot.number_or("kinematics/offset", 0);
  wheel_speed_ = robot.number_or("kinematics/wheel_speed", 1);
  speed_high_ = wheel_radius_ * wheel_speed_;
  speed_low_ = -speed_high_;
  turn_rate_ = wheel_radius_ * wheel_speed_ / half_track_;
  if (!robot.any_below("actions"))
    columns_.box("wheel_left", "rad/s", -wheel_speed_, wheel_speed_)
        .box("wheel_right", "rad/s", -wheel_speed_, wheel_speed_);
}

void Kinematics::read_unicycle(const wend::Params& robot) {
  type_ = Type::unicycle;
  speed_low_ = robot.number("kinematics/speed/0");
  speed_high_ = robot.number("kinematics/speed/1");
  turn_rate_ = robot.number("kinematics/turn_rate");
  acceleration_ = robot.number_or("kinematics/acceleration", unlimited);
  turn_acceleration_ = robot.number_or("kinematics/turn_acceleration", unlimited);
  if (speed_low_ > speed_high_)
    throw wend::parameter_error("kinematics/speed",
                                "expected [low, high] with low <= high, found a low above the high");
  if (!robot.any_below("actions"))
    columns_.box("speed", "m/s", speed_low_, speed_high_).box("turn_rate", "rad/s", -turn_rate_, turn_rate_);
}

void Kinematics::read_turn_then_advance(const wend::Params& robot) {
  type_ = Type::turn_then_advance;
  if (robot.has("kinematics/step") == robot.has("kinematics/speed"))
    throw wend::parameter_error("kinematics", "expected one of \"step\" (m a decision) and \"speed\" (m/s), found " +
                                                  std::string(robot.has("kinematics/step") ? "both" : "neither"));
  step_ = robot.has("kinematics/step") ? robot.number("kinematics/step") : robot.number("kinematics/speed") * period_;
  turn_ = robot.number_or("kinematics/turn", wend::math::pi);
  speed_high_ = step_ / period_;
  turn_rate_ = turn_ / period_;
  if (!robot.any_below("actions")) columns_.box("turn", "rad", -turn_, turn_).box("advance", "m", 0, step_);
}

void Kinematics::read_table(const wend::Params& robot) {
  const std::size_t n = robot.size("actions");
  if (n == 0) return;
  double low = unlimited, high = -unlimited, turning = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const std::string path = wend::Params::element("actions", k);
    const std::vector<double> row = robot.numbers(path);
    if (row.size() != 2) throw wend::parameter_error(path, "expected two numbers, found " + std::to_string(row.size()));
    const Command command = table_.emplace_back(decode(row[0], row[1]));
    low = std::min(low, command.twist.speed);
    high = std::max(high, command.twist.speed);
    turning = std::max(turning, std::fabs(command.twist.turn_rate) + std::fabs(command.turn) / period_);
  }
  columns_.discrete("action", n);
  if (type_ != Type::unicycle) speed_low_ = low, speed_high_ = high, turn_rate_ = turning;
}

// An action row's two numbers, within the limits.
Command Kinematics::decode(double first, double second) const noexcept {
  switch (type_) {
    case Type::differential: {
      // A table's wheel speeds are its own; continuous ones have been offered within the limits.
      const double most = columns_.width() == 2 ? wheel_speed_ : unlimited;
      const double left = clamp(first, -most, most), right = clamp(second, -most, most);
      return {0, {0.5 * wheel_radius_ * (left + right), wheel_radius_ / (2 * half_track_) * (right - left)}};
    }
    case Type::unicycle:
      return {0, {clamp(first, speed_low_, speed_high_), clamp(second, -turn_rate_, turn_rate_)}};
    case Type::turn_then_advance:
      break;
  }
  const bool free = columns_.width() != 2;
  return {free ? first : clamp(first, -turn_, turn_), {(free ? second : clamp(second, 0, step_)) / period_, 0}};
}

Command Kinematics::command(std::span<const double> action, double a, double b) const {
  Command command;
  if (discrete()) {
    if (!(action[0] >= 0 && action[0] < static_cast<double>(table_.size())))
      throw wend::Error(WEND_E_ARGUMENT, {},
                        "action: expected a row of the action table, 0.." + std::to_string(table_.size() - 1) +
                            ", found " + std::to_string(action[0]));
    command = table_[static_cast<std::size_t>(action[0])];
  } else {
    if (!std::isfinite(action[0]) || !std::isfinite(action[1]))
      throw wend::Error(
          WEND_E_ARGUMENT, {},
          "action: expected two finite numbers, found " + std::to_string(action[0]) + ", " + std::to_string(action[1]));
    command = decode(action[0], action[1]);
  }
  command.twist.speed *= 1 + noise_.speed * a;
  command.twist.turn_rate *= 1 + noise_.turn_rate * b;
  command.turn *= 1 + noise_.turn_rate * b;
  return command;
}

Twist Kinematics::twist(const Command& command, const wend_motion& from) const noexcept {
  Twist twist = command.twist;
  if (acceleration_ < unlimited)
    twist.speed = clamp(twist.speed, from.speed - acceleration_ * dt_, from.speed + acceleration_ * dt_);
  if (turn_acceleration_ < unlimited)
    twist.turn_rate =
        clamp(twist.turn_rate, from.turn_rate - turn_acceleration_ * dt_, from.turn_rate + turn_acceleration_ * dt_);
  return twist;
}

// The chord of an arc of length l that turns by 2h is l sin(h)/h long and points h beside the heading.
void Kinematics::move(wend_motion& motion, Twist twist, double seconds) const noexcept {
  const double half = 0.5 * twist.turn_rate * seconds;
  const double chord = twist.speed * seconds * sinc(half);
  double s, c;
  if (offset_ != 0) {
    wend::math::sincos(motion.heading, s, c);
    motion.x -= offset_ * c, motion.y -= offset_ * s;
  }
  wend::math::sincos(motion.heading + half, s, c);
  motion.x += chord * c, motion.y += chord * s;
  motion.heading = wend::math::wrap_angle(motion.heading + 2 * half);
  if (offset_ != 0) {
    wend::math::sincos(motion.heading, s, c);
    motion.x += offset_ * c, motion.y += offset_ * s;
  }
  motion.speed = twist.speed, motion.turn_rate = twist.turn_rate;
}

wend_motion Kinematics::predict(wend_motion motion, std::span<const double> action, double seconds) const {
  const Command wanted = command(action);
  if (type_ == Type::turn_then_advance) {  // the same decision in each period
    for (double left = seconds; left > 0; left -= period_) {
      motion.heading = wend::math::wrap_angle(motion.heading + wanted.turn);
      move(motion, wanted.twist, std::min(left, period_));
      if (left - period_ < 1e-9 * period_) break;
    }
    return motion;
  }
  double left = seconds;
  while (left > 0) {
    const Twist next = twist(wanted, motion);
    const bool settled = next.speed == wanted.twist.speed && next.turn_rate == wanted.twist.turn_rate;
    const double piece = settled || left - dt_ < 1e-9 * dt_ ? left : dt_;
    move(motion, next, piece);
    left -= piece;
  }
  return motion;
}

// Of the tightest curve that is driven forward; 0 where the robot turns on the spot, infinite where it cannot turn.
double Kinematics::turn_radius() const noexcept {
  if (!discrete())
    return type_ == Type::unicycle && speed_low_ > 0 ? (turn_rate_ > 0 ? speed_low_ / turn_rate_ : unlimited) : 0;
  double radius = unlimited;
  for (const Command& command : table_) {
    const double turning = std::fabs(command.twist.turn_rate) + std::fabs(command.turn) / period_;
    if (turning > 0 && command.twist.speed >= 0) radius = std::min(radius, command.twist.speed / turning);
  }
  return radius;
}

void Kinematics::limits(wend_limits& out) const noexcept {
  out.speed_low = speed_low_, out.speed_high = speed_high_, out.turn_rate = turn_rate_;
  out.acceleration = acceleration_, out.turn_acceleration = turn_acceleration_;
  out.turn_radius = turn_radius();
}

}  // namespace arena
