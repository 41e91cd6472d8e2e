// Streets between six blocks and a wall with one door before the goals, after the ALV experiments; discs patrol the
// streets, each along its middle.
#include <algorithm>
#include <cmath>

#include "generators.hpp"
#include "placement.hpp"

namespace arena {
namespace {

constexpr double wall_thickness = 0.03;  // share of the height

struct Streets {
  double bottom, middle, top;  // m, widths of those along x
  double block;                // m, height of a row of blocks
  double wall;                 // m, y of the wall before the goals
  double low_block() const noexcept { return bottom; }
  double high_block() const noexcept { return bottom + block + middle; }
};

// Three blocks and four streets along x, in one row.
struct Row {
  std::array<double, 3> at, width;  // m
};

Row draw_row(const DoorRoom& p, wend::Random& random) {
  std::array<double, 4> street{};
  for (double& width : street) width = random.uniform(p.passage[0], p.passage[1]);
  std::array<double, 3> share{};
  for (double& s : share) s = random.uniform(0.75, 1.25);
  const double left = p.size[0] - street[0] - street[1] - street[2] - street[3];
  Row row{};
  double x = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    row.width[i] = left * share[i] / (share[0] + share[1] + share[2]);
    row.at[i] = x + street[i];
    x = row.at[i] + row.width[i];
  }
  return row;
}

void check(const DoorRoom& p) {
  if (p.passage[0] > p.passage[1]) refuse("passage", "expected the narrowest street first, found the wider one");
  if (p.patrol_speed[0] > p.patrol_speed[1]) refuse("patrol_speed", "expected the slowest first, found the faster one");
  if (p.passage[0] <= 2 * p.body)
    refuse("passage", "expected streets wider than the body's diameter, found narrower ones");
  if (p.door <= 2 * p.body) refuse("door", "expected a door wider than the body's diameter, found a narrower one");
  if (4 * p.passage[1] > 0.85 * p.size[0] || 3 * p.passage[1] > 0.55 * p.size[1] || p.door > 0.8 * p.size[0])
    refuse("size",
           "expected room for blocks between the streets, found none: choose a larger size or narrower streets");
  if (p.goal_spread > 0 && p.goal_spread < p.goals * (4 * p.body + 2 * p.goal_radius))
    refuse("goal_spread", "expected room for a robot on each goal, found less: choose a larger one, or 0 for the whole width");
  if (2 * p.patrol_radius >= p.passage[0])
    refuse("patrol_radius", "expected patrols that fit into the streets, found wider ones");
}

// The middle of that street between the blocks of a row, or beside them, which is nearest to `x`.
double gap_near(const Row& row, double x, double width) {
  double nearest = row.at[0] / 2;
  for (std::size_t i = 0; i < 3; ++i) {
    const double gap = (row.at[i] + row.width[i] + (i < 2 ? row.at[i + 1] : width)) / 2;
    if (std::fabs(gap - x) < std::fabs(nearest - x)) nearest = gap;
  }
  return nearest;
}

// To and fro along the middle of a street.
Mover patrol(const DoorRoom& p, wend::Random& random, Point from, Point to) {
  Mover mover;
  mover.radius = p.patrol_radius;
  mover.waypoints = {from, to};
  mover.speed = random.uniform(p.patrol_speed[0], p.patrol_speed[1]);
  mover.x = from.x, mover.y = from.y;
  return mover;
}

Scene draw(const DoorRoom& p, wend::Random& random) {
  const double width = p.size[0], height = p.size[1], thickness = wall_thickness * height;
  Streets s{};
  s.bottom = random.uniform(p.passage[0], p.passage[1]);
  s.middle = random.uniform(p.passage[0], p.passage[1]);
  s.top = random.uniform(p.passage[0], p.passage[1]);
  s.wall = height * random.uniform(0.74, 0.8) - thickness;
  s.block = (s.wall - s.bottom - s.middle - s.top) / 2;

  Scene scene;
  scene.name = "door_room";
  scene.width = width, scene.height = height;
  const Row low = draw_row(p, random), high = draw_row(p, random);
  for (std::size_t i = 0; i < 3; ++i) {
    scene.polygons.push_back(rectangle(low.at[i], s.low_block(), low.width[i], s.block));
    scene.polygons.push_back(rectangle(high.at[i], s.high_block(), high.width[i], s.block));
  }
  const double door = random.uniform(0.1 * width, 0.9 * width - p.door);
  scene.polygons.push_back(rectangle(0, s.wall, door, thickness));
  scene.polygons.push_back(rectangle(door + p.door, s.wall, width - door - p.door, thickness));

  const double ground = s.wall + thickness, room = std::min(2 * p.body, (height - ground) / 3);
  const double spread = p.goal_spread > 0 ? std::min(p.goal_spread, width) : width;
  const double first = std::clamp(door + (p.door - spread) / 2, 0.0, width - spread);
  for (std::uint32_t i = 0; i < p.goals; ++i) {  // each in its own part of the room behind the door
    const double part = spread / p.goals;
    scene.goals.push_back({random.uniform(first + i * part + room, first + (i + 1) * part - room),
                           random.uniform((ground + height) / 2, height - room),
                           p.goal_radius,
                           {},
                           0});
  }
  const double end = p.passage[0] / 2, before_wall = s.wall - s.top / 2, between = s.bottom + s.block + s.middle / 2;
  const std::size_t street = static_cast<std::size_t>(random.below(2));
  const double upright = (low.at[street] + low.width[street] + low.at[street + 1]) / 2;
  if (p.patrol_beat > 0) {
    const double about = door + p.door / 2, low_gap = gap_near(low, about, width), high_gap = gap_near(high, about, width);
    const double left = std::max(end, about - p.patrol_beat / 2), right = std::min(width - end, about + p.patrol_beat / 2);
    if (p.patrols > 0) scene.movers.push_back(patrol(p, random, {left, before_wall}, {right, before_wall}));
    if (p.patrols > 1) scene.movers.push_back(patrol(p, random, {high_gap, between}, {high_gap, before_wall}));
    if (p.patrols > 2) scene.movers.push_back(patrol(p, random, {low_gap, s.bottom / 2}, {low_gap, between}));
    return scene;
  }
  if (p.patrols > 0) scene.movers.push_back(patrol(p, random, {end, between}, {width - end, between}));
  if (p.patrols > 1) scene.movers.push_back(patrol(p, random, {end, before_wall}, {width - end, before_wall}));
  if (p.patrols > 2) scene.movers.push_back(patrol(p, random, {upright, s.bottom / 2}, {upright, s.bottom + s.block}));
  return scene;
}

// Along x from the door's middle to the middle of the goals.  The last rectangle is the wall to the right of the door.
double from_door(const Scene& scene, const DoorRoom& p) {
  double middle = 0;
  for (const Goal& goal : scene.goals) middle += goal.x / static_cast<double>(scene.goals.size());
  return std::fabs(scene.polygons.back().points.front().x - p.door / 2 - middle);
}

}  // namespace

Scene generate(const DoorRoom& p, std::uint64_t key) {
  check(p);
  for (int attempt = 0; attempt < most_tries; ++attempt) {
    wend::Random random(wend::stream(key, static_cast<std::uint64_t>(attempt)));
    Scene scene = draw(p, random);
    if (from_door(scene, p) > p.door_offset) continue;
    const bool room = std::all_of(scene.goals.begin(), scene.goals.end(), [&](const Goal& goal) {
      return clearance(scene, {goal.x, goal.y}) > p.body;
    });
    if (room && all_joined(scene, p.body)) return scene;
  }
  refuse("door", "expected a way through the door, found none in 1000 tries: choose a wider door, a smaller body or a larger "
                 "door_offset");
}

}  // namespace arena
