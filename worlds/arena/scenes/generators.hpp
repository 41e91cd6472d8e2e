// Scenes that are drawn: each a pure function of its parameters and a key.
//
// Every one leaves a way from start to goal for the body: checked by flood fill, drawn again at most 1,000 times.
// Where `starts` stay empty the world draws them per episode.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "../scene.hpp"

namespace arena {

// Discs apart from each other and from the walls.
struct RandomObstacles {
  std::array<double, 2> size{100, 100};  // m
  std::uint32_t count = 0;               // discs; 0: as many as find room in `density`
  double density = 0.12;                 // share of the area, where count is 0
  std::array<double, 2> radius{2, 6};    // m
  double gap = 14;                       // m, least distance between two surfaces
  double wall_gap = 8;                   // m, least distance of a surface to a wall
  double body = 3;                       // m, radius that must pass
  double goal_radius = 3;                // m
  std::string placement = "episode";     // "episode": drawn by the world; "random": with the map; "corners"
  double distance = 50;                  // m, least distance from start to goal, for "random"
  double clearance = 3;                  // m, between the body at its start or goal and any surface
  bool blocked = true;                   // for "random" and "corners": the straight way is obstructed

  bool operator==(const RandomObstacles&) const = default;
};

// A U between start and goal, open towards the start, symmetric across the line that joins them.
struct UTrap {
  double width = 20, depth = 15;     // m, inside
  double thickness = 2;              // m, of its three walls
  std::array<double, 2> size{0, 0};  // m, of the arena; 0: 100, or as much as the trap needs
  double before = 20, behind = 15;   // m, from the start to the opening, from the back wall to the goal
  double jitter = 0.05;              // share by which the five lengths vary
  bool turn = true;                  // the line from start to goal has any direction; else along x
  double body = 3;                   // m
  double goal_radius = 3;            // m

  bool operator==(const UTrap&) const = default;
};

// Rooms in a rectangular arrangement, joined by doors, or by passages where the walls are thick.
struct Rooms {
  std::array<double, 2> size{100, 100};  // m
  std::array<std::uint32_t, 2> rooms{2, 1};
  std::array<double, 2> door{9, 11};   // m
  double thickness = 6;                // m: of walls, the length of a passage
  double loops = 0;                    // chance of a door that the rooms' tree does not need
  std::uint32_t passages = 1;          // doors in a wall that has any
  std::uint32_t count = 0;             // discs in all, apart from walls and doors by `gap`
  std::array<double, 2> radius{2, 5};  // m
  double gap = 10;                     // m
  double body = 3;                     // m
  double goal_radius = 3;              // m

  bool operator==(const Rooms&) const = default;
};

// The room of specs "ALV": streets between six blocks, a wall with a door before the goal, discs that patrol the
// streets.
struct DoorRoom {
  std::array<double, 2> size{10, 10};              // m
  double door = 1.2;                               // m
  double door_offset = 1000;                       // m along x, at most, from its middle to the middle of the goals
  std::array<double, 2> passage{1.2, 1.4};         // m
  std::uint32_t goals = 1;                         // one a robot
  double goal_spread = 0;                          // m along x, about the door, that they share; 0: the whole width
  std::uint32_t patrols = 0;                       // 0..3
  double patrol_radius = 0.15;                     // m
  double patrol_beat = 0;                          // m before the door: patrols keep the ways to it; 0: streets
  std::array<double, 2> patrol_speed{0.04, 0.05};  // m/s
  double body = 0.15;                              // m
  double goal_radius = 0.3;                        // m

  bool operator==(const DoorRoom&) const = default;
};

// Cylinders as a cellular automaton grows them, in the frame of the BARN worlds.
struct Cellular {
  std::array<std::uint32_t, 2> cells{30, 64};    // along x, along y
  double cell = 0.15;                            // m
  std::uint32_t corridor = 34;                   // cells along y before the field begins
  std::array<double, 2> fill{0.2, 0.3};          // share of occupied cells before smoothing
  std::array<std::uint32_t, 2> smoothing{2, 4};  // iterations
  bool discs = false;                            // cylinders instead of squares
  double body = 0.3, margin = 0.05;              // m: a disc of body + margin passes
  double goal_radius = 1;                        // m

  bool operator==(const Cellular&) const = default;
};

Scene generate(const RandomObstacles&, std::uint64_t key);
Scene generate(const UTrap&, std::uint64_t key);
Scene generate(const Rooms&, std::uint64_t key);
Scene generate(const DoorRoom&, std::uint64_t key);
Scene generate(const Cellular&, std::uint64_t key);

}  // namespace arena
