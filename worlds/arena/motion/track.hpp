// Where something that moves by itself is at a time: a pure function, so nothing drifts and nothing is remembered.
#pragma once
#include <vector>

#include "../scene.hpp"

namespace arena {

// To and fro along way-points; or at constant velocity between walls; or at rest.
class Track {
 public:
  struct State {
    double x, y, vx, vy;  // m, m/s
  };

  Track(const std::vector<Point>& waypoints, double speed, Point rest);
  // A mover: without way-points it bounces off the scene's bounds with its rim.
  Track(const Mover&, const Scene&);

  State at(double seconds) const noexcept;
  bool moves() const noexcept { return kind_ != Kind::rest; }
  double speed() const noexcept;
  // s until a patrol repeats itself; 0 for everything else.
  double cycle() const noexcept { return kind_ == Kind::patrol ? 2 * along_.back() / speed_ : 0; }

 private:
  enum class Kind { rest, patrol, bounce };
  Kind kind_ = Kind::rest;
  std::vector<Point> points_;
  std::vector<double> along_;  // m from the first way-point to each
  double speed_ = 0;
  Point from_{0, 0}, velocity_{0, 0}, low_{0, 0}, high_{0, 0};
};

}  // namespace arena
