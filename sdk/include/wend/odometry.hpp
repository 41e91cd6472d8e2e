// wend/odometry.hpp -- where a robot believes it is when it adds up its own motion.  Shared by the sensors that need
// it, so that the pose and the goal of one robot are wrong in the same way.
//
// From the true poses of two decisions: turn dh, and the chord's parts along and across the mid heading h + dh / 2.
//   along' = along (1 + s) + distance sqrt|along| n1                            s = scale * N(0, 1) once an episode
//   dh'    = dh + b along + heading sqrt|along| n2 + turn sqrt|dh| n3           b = bend * N(0, 1) once an episode
// (Thrun, Burgard, Fox: Probabilistic Robotics, 5.4: variances grow with the distance driven and the angle turned.)
#pragma once
#include <wend/abi.h>

#include <cmath>
#include <string>
#include <wend/config.hpp>
#include <wend/math.hpp>
#include <wend/random.hpp>

namespace wend {

struct Drift {
  double scale = 0;     // relative standard deviation of an episode's constant error of distance
  double bend = 0;      // rad/m, standard deviation of an episode's constant error of heading
  double distance = 0;  // m per sqrt(m)
  double heading = 0;   // rad per sqrt(m)
  double turn = 0;      // rad per sqrt(rad)

  Drift() = default;
  Drift(const Params& params, const std::string& path)
      : scale(params.number_or(path + "/scale", 0)),
        bend(params.number_or(path + "/bend", 0)),
        distance(params.number_or(path + "/distance", 0)),
        heading(params.number_or(path + "/heading", 0)),
        turn(params.number_or(path + "/turn", 0)) {}
  bool none() const noexcept { return scale == 0 && bend == 0 && distance == 0 && heading == 0 && turn == 0; }
};

class Odometry {
 public:
  // A new episode, from the row's seed; the next pose is where it starts and known exactly.
  void begin(std::uint64_t seed, const Drift& drift) {
    drift_ = drift;
    errors_ = Random(stream(seed, "wend.odometry"));
    scale_ = 1 + drift.scale * errors_.normal();
    bend_ = drift.bend * errors_.normal();
    started_ = false;
  }

  // Takes in the true pose, `period` s after the last one; returns the believed pose, speed and turn rate.
  const wend_motion& update(const wend_pose& truth, double period) {
    if (!started_) {
      started_ = true;
      believed_ = {truth.x, truth.y, truth.heading, 0, 0};
    } else {
      integrate(truth, period);
    }
    last_ = truth;
    return believed_;
  }

 private:
  void integrate(const wend_pose& truth, double period) {
    double turn = math::wrap_angle(truth.heading - last_.heading), s, c;
    math::sincos(last_.heading + turn / 2, s, c);
    const double dx = truth.x - last_.x, dy = truth.y - last_.y;
    double along = dx * c + dy * s;
    const double across = dy * c - dx * s;
    if (drift_.none()) {
      believed_.x = truth.x, believed_.y = truth.y, believed_.heading = truth.heading;
    } else {
      const double n1 = errors_.normal(), n2 = errors_.normal(), n3 = errors_.normal();
      const double root = std::sqrt(std::fabs(along));
      turn += bend_ * along + drift_.heading * root * n2 + drift_.turn * std::sqrt(std::fabs(turn)) * n3;
      along = along * scale_ + drift_.distance * root * n1;
      math::sincos(believed_.heading + turn / 2, s, c);
      believed_.x += along * c - across * s;
      believed_.y += along * s + across * c;
      believed_.heading = math::wrap_angle(believed_.heading + turn);
    }
    const double half = turn / 2;  // the arc over its chord
    believed_.speed = along * (std::fabs(half) < 1e-9 ? 1 : half / math::sin(half)) / period;
    believed_.turn_rate = turn / period;
  }

  Drift drift_;
  Random errors_{0};
  double scale_ = 1, bend_ = 0;
  bool started_ = false;
  wend_pose last_{};
  wend_motion believed_{};
};

}  // namespace wend
