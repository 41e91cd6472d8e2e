// What a row perceives at one decision: its motion, its goal and the surface points that its beams met.
#pragma once
#include <wend/abi.h>

#include <vector>

namespace rolling_window {

struct Point {
  double x = 0, y = 0;  // m, in the frame of the pose
};

struct Beam {
  double bearing = 0;           // rad, relative to the heading
  double range = 0;             // m, from the rim
  double cosine = 1, sine = 0;  // of bearing + heading
  bool hit = false;             // it met a surface: range < reach
};

struct Percept {
  wend_motion motion{};  // pose, speed and turn rate as the pose sensor believes them; all 0 without one
  Point goal;
  double goal_distance = 0, goal_bearing = 0, goal_radius = 0;
  double body = 0;  // m, radius of the robot
  std::vector<Beam> window, sonar;
  std::vector<Point> surface;  // where the beams of both met something

  Point at() const noexcept { return {motion.x, motion.y}; }
};

}  // namespace rolling_window
