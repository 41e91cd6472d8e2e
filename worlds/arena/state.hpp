// What an arena remembers: of a scene, of a copy, of a robot.
#pragma once
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "geometry/static_map.hpp"
#include "motion/kinematics.hpp"
#include "motion/track.hpp"
#include "scenes/optimal.hpp"

namespace arena {

// A scene made ready, shared by all copies that are in it.
struct Place {
  std::uint64_t key;
  std::uint32_t variant;
  StaticMap map;
  std::vector<Track> movers, goals;
  bool moving_goals = false;
  std::shared_ptr<const FreeSpace> space;                    // where this world's robot may stand, made on demand
  std::vector<std::shared_ptr<const DistanceField>> fields;  // to each of the scene's own goals, likewise

  Place(std::uint64_t k, std::uint32_t v, const ScenePtr& scene);
  const Scene& scene() const noexcept { return map.scene(); }
};

// A disc that moves by itself, at the present and at the previous dt.
struct Moving {
  double x = 0, y = 0;  // adjacent: a wend_shape points at them
  double radius = 0;
  double vx = 0, vy = 0, old_x = 0, old_y = 0;
  double phase = 0;  // s
};

struct Robot {
  wend_motion motion{};
  Command command;
  double goal_x = 0, goal_y = 0, goal_radius = 0;
  std::uint32_t ended = 0;  // the flags that ended it
  bool acting = false;      // in this period
  bool collided = false;    // in this dt

  double old_x = 0, old_y = 0;  // m, at the previous dt
  double at_least = 0;          // m: the centre is no nearer than this to what stands still

  double path = 0, turned = 0, nearest = 0;  // m, rad, m of clearance
  double optimal = 0;                        // m, NaN where unknown
  std::uint64_t ticks = 0, decisions = 0, noise = 0;
};

// One of the independent copies.  Shapes are listed when somebody asks, and then kept up to date.
struct Copy {
  std::shared_ptr<Place> place;
  std::vector<Moving> movers;
  std::uint64_t ticks = 0;  // dt since the reset
  std::vector<wend_shape> shapes;
  std::vector<double> shape_points;
  std::size_t first_mover = 0;  // among the shapes
  std::atomic<bool> listed{false};
  std::mutex listing;
};

}  // namespace arena
