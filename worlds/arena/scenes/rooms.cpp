// Rooms in rows and columns: a tree of doors joins them all, start and goal are in opposite corner rooms.
#include <algorithm>
#include <numeric>

#include "generators.hpp"
#include "placement.hpp"

namespace arena {
namespace {

struct Door {
  double low, high;  // m, along the wall
};

struct Wall {
  std::uint32_t a, b;  // rooms on both sides: row * columns + column
  bool open = false;
};

struct Plan {
  explicit Plan(const Rooms& p)
      : columns(p.rooms[0]),
        rows(p.rooms[1]),
        width((p.size[0] - (columns - 1) * p.thickness) / columns),
        height((p.size[1] - (rows - 1) * p.thickness) / rows) {}
  std::uint32_t columns, rows;
  double width, height;  // m, of a room
};

void check(const Rooms& p, const Plan& plan) {
  if (p.door[0] > p.door[1]) refuse("door", "expected the narrowest door first, found the wider one");
  if (p.radius[0] > p.radius[1]) refuse("radius", "expected the smallest radius first, found the larger one");
  if (plan.columns * plan.rows < 2) refuse("rooms", "expected two rooms or more, found one");
  if (p.door[0] <= 2 * p.body) refuse("door", "expected doors wider than the body's diameter, found narrower ones");
  const double wall = std::min(plan.columns > 1 ? plan.height : 1e300, plan.rows > 1 ? plan.width : 1e300);
  if (wall < p.passages * (p.door[1] + p.thickness))
    refuse("passages",
           "expected walls long enough for their doors, found shorter ones: choose a larger size, fewer rooms "
           "or narrower doors");
  if (std::min(plan.width, plan.height) < 4 * p.body)
    refuse("rooms",
           "expected rooms at least two bodies wide, found narrower ones: choose a larger size or fewer rooms");
}

// Kruskal's tree over walls in random order; other walls open by chance.
std::vector<Wall> choose_walls(const Rooms& p, const Plan& plan, wend::Random& random) {
  std::vector<Wall> walls;
  for (std::uint32_t row = 0; row < plan.rows; ++row) {
    for (std::uint32_t column = 0; column < plan.columns; ++column) {
      const std::uint32_t room = row * plan.columns + column;
      if (column + 1 < plan.columns) walls.push_back({room, room + 1});
      if (row + 1 < plan.rows) walls.push_back({room, room + plan.columns});
    }
  }
  random.shuffle(walls);
  std::vector<std::uint32_t> tree(std::size_t{plan.columns} * plan.rows);
  std::iota(tree.begin(), tree.end(), 0u);
  for (Wall& wall : walls) {
    const std::uint32_t from = tree[wall.a], to = tree[wall.b];
    wall.open = from != to || random.chance(p.loops);
    if (from != to) std::replace(tree.begin(), tree.end(), from, to);
  }
  return walls;
}

// One door in each of `passages` equal parts of the wall.
std::vector<Door> draw_doors(const Rooms& p, double low, double length, wend::Random& random) {
  std::vector<Door> doors;
  const double part = length / p.passages;
  for (std::uint32_t i = 0; i < p.passages; ++i) {
    const double width = random.uniform(p.door[0], p.door[1]), edge = p.thickness / 2;
    const double at = low + i * part + random.uniform(edge, part - width - edge);
    doors.push_back({at, at + width});
  }
  return doors;
}

// The pieces of a wall between its doors.  `across` is where it begins in the other direction.
void build_wall(Scene& scene, bool upright, double across, double thickness, double low, double high,
                const std::vector<Door>& doors) {
  for (std::size_t i = 0; i <= doors.size(); ++i) {
    const double from = i == 0 ? low : doors[i - 1].high, to = i == doors.size() ? high : doors[i].low;
    scene.polygons.push_back(upright ? rectangle(across, from, thickness, to - from)
                                     : rectangle(from, across, to - from, thickness));
  }
}

void build_walls(Scene& scene, const Rooms& p, const Plan& plan, wend::Random& random) {
  for (const Wall& wall : choose_walls(p, plan, random)) {
    const std::uint32_t column = wall.a % plan.columns, row = wall.a / plan.columns;
    const double x = column * (plan.width + p.thickness), y = row * (plan.height + p.thickness);
    const bool upright = wall.b == wall.a + 1;
    const double low = upright ? y : x, length = upright ? plan.height : plan.width;
    std::vector<Door> doors;
    if (wall.open) doors = draw_doors(p, low, length, random);
    build_wall(scene, upright, upright ? x + plan.width : y + plan.height, p.thickness, low, low + length, doors);
  }
  for (std::uint32_t row = 0; row + 1 < plan.rows; ++row)  // where four walls meet
    for (std::uint32_t column = 0; column + 1 < plan.columns; ++column)
      scene.polygons.push_back(rectangle((column + 1) * plan.width + column * p.thickness,
                                         (row + 1) * plan.height + row * p.thickness, p.thickness, p.thickness));
}

void throw_discs(Scene& scene, const Rooms& p, wend::Random& random) {
  for (std::uint32_t i = 0; i < p.count; ++i) {
    const double r = random.uniform(p.radius[0], p.radius[1]);
    Point at{};
    if (!draw_place(scene, random, 0, 0, p.size[0], p.size[1], r + p.gap, at)) return;
    scene.discs.push_back({at.x, at.y, r});
  }
}

}  // namespace

Scene generate(const Rooms& p, std::uint64_t key) {
  const Plan plan(p);
  check(p, plan);
  for (int attempt = 0; attempt < most_tries; ++attempt) {
    wend::Random random(wend::stream(key, static_cast<std::uint64_t>(attempt)));
    Scene scene;
    scene.name = "rooms";
    scene.width = p.size[0], scene.height = p.size[1];
    build_walls(scene, p, plan, random);
    throw_discs(scene, p, random);
    Point start{}, goal{};
    const double room = std::min(2 * p.body, std::min(plan.width, plan.height) / 3);
    if (!draw_place(scene, random, 0, 0, plan.width, plan.height, room, start) ||
        !draw_place(scene, random, p.size[0] - plan.width, p.size[1] - plan.height, p.size[0], p.size[1], room, goal) ||
        !joined(scene, start, goal, p.body))
      continue;
    scene.starts = {{start.x, start.y, 0, true}};
    scene.goals = {{goal.x, goal.y, p.goal_radius, {}, 0}};
    return scene;
  }
  refuse("door",
         "expected a way from start to goal, found none in 1000 tries: choose wider doors, fewer discs or a "
         "smaller body");
}

}  // namespace arena
