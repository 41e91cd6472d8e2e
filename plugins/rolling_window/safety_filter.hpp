// Continuous actions: from the wanted speed and turn rate to the nearest pair after which the robot can still stop
// before anything it sees or remembers (after the dynamic window of Fox, Burgard and Thrun 1997, with arcs up to the
// stop).
#pragma once
#include <span>
#include <vector>

#include "grid_memory.hpp"
#include "percept.hpp"

namespace rolling_window {

struct Drive {
  double speed = 0, turn_rate = 0;  // m/s, rad/s
};

class SafetyFilter {
 public:
  SafetyFilter() = default;
  SafetyFilter(const wend_limits& limits, double period, double top_speed);

  // `margin`: m kept between rim and surfaces; less where the robot has less already.  `memory` may be null.
  Drive nearest_safe(const Percept& percept, const GridMemory* memory, double margin, Drive wanted) const;

  // Relative bearing in rad, nearest to `towards`, of a straight way on which a body that stands too near to something
  // gets away from it; `towards` itself where there is none.
  double way_out(const Percept& percept, const GridMemory* memory, double margin, double towards) const;

  // What the body does in the next period when asked for `wanted`, given its speed and turn rate.
  Drive reachable(const wend_motion& motion, Drive wanted) const;

 private:
  struct Candidate {
    double speed_share, turn;  // of the wanted speed; added to the wanted curve, rad/s
  };
  double least_clearance(const Percept& percept, const GridMemory* memory, double needed, double enough,
                         Drive drive) const;
  Drive brake(const Percept& percept, const GridMemory* memory, double needed, Drive wanted) const;
  static double clearance(const Percept& percept, const GridMemory* memory, double x, double y, double needed);

  wend_limits limits_{};
  double period_ = 0.1, top_speed_ = 1;
  std::vector<Candidate> candidates_;  // the nearest first
};

}  // namespace rolling_window
