// Kinematics: see kinematics.hpp.
//
//   differential       v = R/2 (w_l + w_r), omega = R/(2 l_a) (w_r - w_l), l_a half the track; the pose is that of the
//                      point l_b (offset) ahead of the axle
//   unicycle           v and omega, within their limits
//   turn_then_advance  turns on the spot, then straight on for the rest of the period
#include "kinematics.hpp"

#include "arc.hpp"

namespace arena {

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
  half_radius_ = 0.5 * wheel_radius_, turning_ = wheel_radius_ / (2 * half_track_);
  if (robot.any_below("actions")) return;
  low_[0] = low_[1] = -wheel_speed_, high_[0] = high_[1] = wheel_speed_;
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
  low_[0] = speed_low_, high_[0] = speed_high_, low_[1] = -turn_rate_, high_[1] = turn_rate_;
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
  if (robot.any_below("actions")) return;
  low_[0] = -turn_, high_[0] = turn_, low_[1] = 0, high_[1] = step_;
  columns_.box("turn", "rad", -turn_, turn_).box("advance", "m", 0, step_);
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

wend::Error Kinematics::refused(std::span<const double> action) const {
  const auto found = [](double number) { return ", found " + std::to_string(number); };
  if (discrete())
    return wend::Error(WEND_E_ARGUMENT, {},
                       "action: expected a row of the action table, 0.." + std::to_string(table_.size() - 1) +
                           found(action[0]));
  return wend::Error(WEND_E_ARGUMENT, {},
                     "action: expected two finite numbers" + found(action[0]) + ", " + std::to_string(action[1]));
}

void Kinematics::move(wend_motion& motion, Twist twist, double seconds) const noexcept {
  double s, c;
  if (offset_ != 0) {
    wend::math::sincos(motion.heading, s, c);
    motion.x -= offset_ * c, motion.y -= offset_ * s;
  }
  follow<false>(motion.x, motion.y, motion.heading, twist.speed, twist.turn_rate, seconds);
  motion.heading = wend::math::wrap_angle(motion.heading);
  if (offset_ != 0) {
    wend::math::sincos(motion.heading, s, c);
    motion.x += offset_ * c, motion.y += offset_ * s;
  }
  motion.speed = twist.speed, motion.turn_rate = twist.turn_rate;
}

void Kinematics::move(Arcs& arcs, double seconds) const noexcept {
  bool near = offset_ == 0;
  for (std::uint32_t k = 0; k < arcs.n; ++k)
    near = near & (std::fabs(arcs.heading.at[k]) < 4000) & (std::fabs(arcs.turn_rate.at[k] * seconds) < 4000);
  if (near) {
    for (std::uint32_t k = arcs.n; k < arcs.padded(); ++k)
      arcs.x.at[k] = arcs.y.at[k] = arcs.heading.at[k] = arcs.speed.at[k] = arcs.turn_rate.at[k] = 0;
    kernels().follow_arcs(arcs, seconds);
    for (std::uint32_t k = 0; k < arcs.n; ++k) arcs.heading.at[k] = wend::math::wrap_angle(arcs.heading.at[k]);
    return;
  }
  for (std::uint32_t k = 0; k < arcs.n; ++k) {
    wend_motion motion{arcs.x.at[k], arcs.y.at[k], arcs.heading.at[k], 0, 0};
    move(motion, {arcs.speed.at[k], arcs.turn_rate.at[k]}, seconds);
    arcs.x.at[k] = motion.x, arcs.y.at[k] = motion.y, arcs.heading.at[k] = motion.heading;
  }
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
