// The window's subgoal, equation (12) of Liu et al. 2013: the goal if it lies inside, else the free point p on the rim
// with the least f(p) = g(p) + h(p).
#pragma once
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>
#include <wend/math.hpp>

#include "percept.hpp"

namespace rolling_window {

struct Subgoal {
  Point at;
  double f = 0;
  bool is_goal = false;
  bool free = true;  // a straight way to it is free inside the window
};

// How far a disc of radius `body` gets from `from` along a unit vector before it touches one of the points; at most
// `length`.
inline double free_length(std::span<const Point> surface, Point from, double ux, double uy, double body,
                          double length) {
  for (const Point& p : surface) {
    const double dx = p.x - from.x, dy = p.y - from.y, along = dx * ux + dy * uy, across = dx * uy - dy * ux;
    if (along <= 0 || std::fabs(across) >= body) continue;
    length = std::fmin(length, std::fmax(0.0, along - std::sqrt(body * body - across * across)));
  }
  return length;
}

class SubgoalChooser {
 public:
  SubgoalChooser() = default;
  SubgoalChooser(double radius, std::size_t candidates) : radius_(radius) {
    for (std::size_t k = 0; k < candidates; ++k) {
      const double angle = wend::math::two_pi * static_cast<double>(k) / static_cast<double>(candidates);
      directions_.push_back({wend::math::cos(angle), wend::math::sin(angle)});
    }
  }
  double radius() const noexcept { return radius_; }

  // `free`: m that the body can go straight from its place along a unit vector, at most the length given.
  // `h`: estimated m from a point to the goal.  Candidates are counted from the direction of the goal, so that equal
  // ones do not depend on the frame.
  template <class Free, class Estimate>
  Subgoal choose(const Percept& percept, Free&& free, Estimate&& h) const {
    const Point at = percept.at();
    double ux = 1, uy = 0;
    if (percept.goal_distance > 0) {
      ux = (percept.goal.x - at.x) / percept.goal_distance, uy = (percept.goal.y - at.y) / percept.goal_distance;
    }
    if (percept.goal_distance <= radius_) {
      const bool open = free(ux, uy, percept.goal_distance) >= percept.goal_distance - percept.goal_radius - 1e-9;
      if (open) return {percept.goal, percept.goal_distance, true, true};
    }
    Subgoal best{percept.goal, 1e300, false, false}, farthest{percept.goal, -1e300, false, false};
    for (const Point& d : directions_) {
      const double x = ux * d.x - uy * d.y, y = ux * d.y + uy * d.x;
      const double length = free(x, y, radius_);
      const Point p{at.x + radius_ * x, at.y + radius_ * y};
      if (length >= radius_) {
        const double f = radius_ + h(p);
        if (f < best.f - 1e-9) best = {p, f, false, true};
      } else if (length > farthest.f + 1e-9) {
        farthest = {p, length, false, false};
      }
    }
    if (best.free) return best;
    // No way out of the window: towards the farthest that is free.
    return farthest;
  }

 private:
  double radius_ = 8;
  std::vector<Point> directions_;
};

}  // namespace rolling_window
