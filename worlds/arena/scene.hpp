// A scene: all that stands in an arena before an episode begins, drawn by a generator or read from a file.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace arena {

struct Point {
  double x, y;  // m
};

struct Disc {
  double x, y, radius;  // m
};

struct Segment {
  double x0, y0, x1, y1;  // m
};

// A filled simple polygon, counter-clockwise.
struct Polygon {
  std::vector<Point> points;
};

// Occupied cells, row-major from the lower-left corner.
struct Grid {
  double x = 0, y = 0;  // m, lower-left corner
  double cell = 1;      // m
  std::uint32_t columns = 0, rows = 0;
  std::vector<std::uint8_t> occupied;  // 1 is occupied

  bool at(std::int64_t column, std::int64_t row) const noexcept {
    return column >= 0 && row >= 0 && column < columns && row < rows &&
           occupied[static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column)] != 0;
  }
};

// A disc that moves: to and fro along way-points at `speed`, or, without way-points, at constant velocity, bouncing off
// the arena's bounds.  A patrol's phase is drawn from the episode's seed where `random_phase` says so.
struct Mover {
  double radius = 0;
  std::vector<Point> waypoints;
  double speed = 0;  // m/s
  double x = 0, y = 0, vx = 0, vy = 0;
  bool random_phase = true;
};

// A goal may move to and fro along way-points.
struct Goal {
  double x = 0, y = 0, radius = 0;
  std::vector<Point> waypoints;
  double speed = 0;
};

struct Start {
  double x = 0, y = 0;
  double heading = 0;
  bool random_heading = false;
};

struct Scene {
  std::string name;
  double x = 0, y = 0, width = 100, height = 100;  // m, bounds
  bool walled = true;                              // the bounds are walls; else the space beyond is free
  std::vector<Disc> discs;
  std::vector<Segment> segments;
  std::vector<Polygon> polygons;  // rectangles are polygons too
  Grid grid;                      // columns == 0: none
  std::vector<Mover> movers;
  std::vector<Start> starts;  // one per robot; fewer: the rest are drawn where there is room
  std::vector<Goal> goals;    // likewise
  double optimal_length = -1; // m, where the file gives it (a .scen record); negative: to be computed
};

using ScenePtr = std::shared_ptr<const Scene>;  // shared read-only by the copies of a world

}  // namespace arena
