// The dynamic window: which velocities can be reached in one period and stopped from in time, and which is best.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "arc.hpp"

namespace dwa {

struct Motion {
  double v, w;  // m/s, rad/s
};

struct Settings {
  double period;                            // s
  double radius;                            // m, of the body with its margin
  double speed_low, speed_high, turn_rate;  // m/s, m/s, rad/s
  double acceleration, turn_acceleration;   // m/s^2, rad/s^2; may be infinite
  double turn_radius;                       // m; 0 where the body turns in place
  double look_ahead;                        // m: a longer free way counts as this
  double alpha, beta, gamma;                // weights of heading, distance, velocity
  std::uint32_t v_samples, w_samples;
};

struct Situation {
  Motion now;
  double goal_distance, goal_bearing;  // m, rad
  std::span<const Point> obstacles;
};

// A candidate and what it is worth.
struct Candidate {
  Motion motion;
  double way;       // m, free along the arc, at most look_ahead
  bool admissible;  // the robot can stop within the way
  double value;     // of the objective; 0 where it is not admissible
};

class Window {
 public:
  explicit Window(const Settings& settings);

  // The candidates of the grid over the dynamic window; valid until the next call.  `smooth`ed values are means over
  // the neighbours in the grid, so that a velocity beside inadmissible ones is worth less.
  std::span<const Candidate> search(const Situation& situation);
  // The same for given motions.  No smoothing: they have no neighbours.
  std::span<const Candidate> search(const Situation& situation, std::span<const Motion> motions);

  Candidate judge(const Situation& situation, Motion motion) const;
  // m, free along the arc, at most look_ahead; of a turn on the spot, what is then free straight ahead.
  double way(const Situation& situation, Motion motion) const;

 private:
  double turned(double w) const noexcept;  // rad, in one period and while the turn is braked
  void smooth();
  Settings settings_;
  std::vector<Candidate> candidates_;
  std::vector<double> values_;
};

}  // namespace dwa
