// How far a disc drives along an arc until it touches a point, in closed form.
#pragma once

namespace dwa {

struct Point {
  double x, y;  // m, in the robot's frame: x ahead, y to the left
};

// m along the path of a robot that drives at speed v (m/s, may be negative) and turn rate w (rad/s) until a disc of
// `radius` (m) around its centre touches the point; infinite if it never does, which includes v == 0.  A point that is
// already within the disc blocks the arcs that approach it and no others.
double free_way(double v, double w, Point point, double radius) noexcept;

}  // namespace dwa
