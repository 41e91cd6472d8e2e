// Discs thrown at random, kept where they leave the gaps: the ordinary, dense and large maps of the LSPI experiments.
#include <algorithm>
#include <wend/math.hpp>

#include "generators.hpp"
#include "placement.hpp"

namespace arena {
namespace {

void check(const RandomObstacles& p) {
  if (p.radius[0] > p.radius[1]) refuse("radius", "expected the smallest radius first, found the larger one");
  if (2 * (p.wall_gap + p.radius[0]) > std::min(p.size[0], p.size[1]))
    refuse("wall_gap", "expected room for a disc between the walls, found none: choose a larger size or a smaller gap");
}

// Where no number of discs is given, the area under them limits it, or the gaps do.
void check_number(const RandomObstacles& p) {
  const double smallest = p.radius[0] + p.gap / 2;
  const double most = p.size[0] * p.size[1] / (wend::math::pi * smallest * smallest);
  const double r = (p.radius[0] + p.radius[1]) / 2,
               wanted = p.density * p.size[0] * p.size[1] / (wend::math::pi * r * r);
  if (p.count == 0 && std::min(most, wanted) > 20000)
    refuse("density", "expected at most 20000 discs, found more: choose fewer, larger ones, or a smaller size");
}

// Throws discs until there are enough or 2,000 in a row found no room.
void throw_discs(Scene& scene, const RandomObstacles& p, wend::Random& random) {
  const double wanted = p.density * p.size[0] * p.size[1];
  double covered = 0;
  for (int misses = 0; misses < 2000;) {
    if (p.count > 0 ? scene.discs.size() == p.count : covered >= wanted) return;
    const double r = random.uniform(p.radius[0], p.radius[1]), edge = p.wall_gap + r;
    const double x = random.uniform(edge, p.size[0] - edge), y = random.uniform(edge, p.size[1] - edge);
    const bool room = std::none_of(scene.discs.begin(), scene.discs.end(), [&](const Disc& d) {
      const double least = p.gap + r + d.radius;
      return (x - d.x) * (x - d.x) + (y - d.y) * (y - d.y) < least * least;
    });
    if (!room || x < edge || y < edge || x > p.size[0] - edge || y > p.size[1] - edge) {
      ++misses;
      continue;
    }
    misses = 0;
    covered += wend::math::pi * r * r;
    scene.discs.push_back({x, y, r});
  }
}

bool obstructed(const Scene& scene, Point from, Point to, double body) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = dx * dx + dy * dy;
  return std::any_of(scene.discs.begin(), scene.discs.end(), [&](const Disc& d) {
    const double t = std::clamp(((d.x - from.x) * dx + (d.y - from.y) * dy) / length, 0.0, 1.0);
    const double ex = d.x - (from.x + t * dx), ey = d.y - (from.y + t * dy), reach = d.radius + body;
    return ex * ex + ey * ey < reach * reach;
  });
}

// False where the map offers no such pair.
bool place(Scene& scene, const RandomObstacles& p, wend::Random& random) {
  const double room = p.body + p.clearance;
  for (int i = 0; i < 200; ++i) {
    Point start{room, room}, goal{p.size[0] - room, p.size[1] - room};
    if (p.placement == "random") {
      if (!draw_place(scene, random, 0, 0, p.size[0], p.size[1], room, start)) return false;
      if (!draw_place(scene, random, 0, 0, p.size[0], p.size[1], room, goal)) return false;
    } else if (clearance(scene, start) < room || clearance(scene, goal) < room) {
      return false;
    }
    const double dx = goal.x - start.x, dy = goal.y - start.y;
    const bool far = p.placement == "corners" || dx * dx + dy * dy >= p.distance * p.distance;
    if (far && (!p.blocked || obstructed(scene, start, goal, p.body)) && joined(scene, start, goal, p.body)) {
      scene.starts = {{start.x, start.y, 0, true}};
      scene.goals = {{goal.x, goal.y, p.goal_radius, {}, 0}};
      return true;
    }
    if (p.placement == "corners") return false;
  }
  return false;
}

}  // namespace

Scene generate(const RandomObstacles& p, std::uint64_t key) {
  check(p);
  check_number(p);
  int short_of = 0;
  for (int attempt = 0; attempt < most_tries; ++attempt) {
    wend::Random random(wend::stream(key, static_cast<std::uint64_t>(attempt)));
    Scene scene;
    scene.name = "random_obstacles";
    scene.width = p.size[0], scene.height = p.size[1];
    throw_discs(scene, p, random);
    if (scene.discs.size() < p.count) {
      if (++short_of == 20) break;
      continue;
    }
    if (p.placement == "episode" ? all_joined(scene, p.body) : place(scene, p, random)) return scene;
  }
  if (short_of == 20)
    refuse("count", "expected room for " + std::to_string(p.count) +
                        " discs, found none in 20 tries: choose fewer, smaller ones, or smaller gaps");
  refuse("gap",
         "expected a map with a way from start to goal, found none in 1000 tries: choose larger gaps, a smaller "
         "body, or less distance");
}

}  // namespace arena
