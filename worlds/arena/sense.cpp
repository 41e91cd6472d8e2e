// What sensors, planners and pictures ask of the arena, between two steps and from several threads.
#include "geometry/lanes.hpp"
#include "world.hpp"

namespace arena {
namespace {

constexpr std::uint32_t block = 64;  // rays whose directions and walls are worked out together

}  // namespace

void World::poses(wend::Rows rows, std::span<wend_pose> out) const {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const wend_motion& at = rows_[rows[k]].motion;
    out[k] = {at.x, at.y, at.heading};
  }
}

void World::bodies(wend::Rows rows, std::span<wend_disc> body, std::span<wend_disc> goal) const {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Robot& robot = rows_[rows[k]];
    body[k] = {robot.motion.x, robot.motion.y, options_.radius};
    goal[k] = {robot.goal_x, robot.goal_y, robot.goal_radius};
  }
}

// The next reset gets scenes ready for rays of this reach.
void World::note_reach(double reach) {
  for (auto& slot : reaches_) {
    double own = slot.load(std::memory_order_relaxed);
    if (own == reach) return;
    if (own == 0 && (slot.compare_exchange_strong(own, reach) || own == reach)) return;
  }
}

double World::cast_movers(const Copy& copy, const Ray& ray, double best) const {
  for (const Moving& mover : copy.movers)
    best = std::min(best, hit_disc(ray, mover.x, mover.y, mover.radius * mover.radius));
  return best;
}

double World::cast_robots(std::uint32_t row, const Ray& ray, double best) const {
  const std::uint32_t first = row - row % robots_;
  for (std::uint32_t other = first; other < first + robots_; ++other)
    if (other != row)
      best = std::min(best,
                      hit_disc(ray, rows_[other].motion.x, rows_[other].motion.y, options_.radius * options_.radius));
  return best;
}

void World::cast(wend::Rows rows, std::span<const wend_pose> rays, double reach, std::uint32_t kinds, double* distance,
                 std::uint8_t* kind) {
  if (reach > 0 && reach < infinity) note_reach(reach);
  for (std::size_t first = 0; first < rows.size(); first += block) {
    const auto n = static_cast<std::uint32_t>(std::min<std::size_t>(block, rows.size() - first));
    cast_some(&rows[first], &rays[first], n, reach, kinds, distance + first, kind ? kind + first : nullptr);
  }
}

// Of kinds at the same distance the one of the lowest number counts.
void World::cast_some(const std::uint32_t* rows, const wend_pose* rays, std::uint32_t n, double reach,
                      std::uint32_t kinds, double* distance, std::uint8_t* kind) const {
  double x[block], y[block], heading[block], dx[block], dy[block], x0[block], y0[block], x1[block], y1[block],
      wall[block];
  bool near = true;
  const Copy* copy = nullptr;
  for (std::uint32_t k = 0; k < n; ++k) {
    if (k == 0 || rows[k] != rows[k - 1]) copy = &copies_[rows[k] / robots_];
    x[k] = rays[k].x, y[k] = rays[k].y, heading[k] = rays[k].heading;
    near = near && std::fabs(heading[k]) <= 8192;
    copy->place->map.bounds(x0[k], y0[k], x1[k], y1[k]);
  }
  if (near) {
    directions(heading, n, dx, dy);
  } else {
    for (std::uint32_t k = 0; k < n; ++k) wend::math::sincos(heading[k], dy[k], dx[k]);
  }
  hit_bounds(x, y, dx, dy, x0, y0, x1, y1, n, wall);

  const CellLists* lists = nullptr;
  for (std::uint32_t k = 0; k < n; ++k) {
    if (k == 0 || rows[k] != rows[k - 1]) {
      copy = &copies_[rows[k] / robots_];
      lists = copy->place->map.lists_for(reach);
    }
    const Ray ray{x[k], y[k], dx[k], dy[k]};
    double best = reach;
    std::uint8_t first = WEND_NOTHING;
    const auto meet = [&](std::uint8_t what, double hit) {
      first = hit < best ? what : first;
      best = hit < best ? hit : best;
    };
    if (kinds & WEND_WALL) meet(WEND_WALL, wall[k]);
    if (kinds & WEND_OBSTACLE) meet(WEND_OBSTACLE, copy->place->map.cast(ray, best, lists));
    if (kinds & WEND_MOVER && !copy->movers.empty()) meet(WEND_MOVER, cast_movers(*copy, ray, best));
    if (kinds & WEND_ROBOT && robots_ > 1) meet(WEND_ROBOT, cast_robots(rows[k], ray, best));
    if (kinds & WEND_GOAL) {
      const Robot& robot = rows_[rows[k]];
      meet(WEND_GOAL, hit_disc(ray, robot.goal_x, robot.goal_y, robot.goal_radius * robot.goal_radius));
    }
    distance[k] = best;
    if (kind != nullptr) kind[k] = first;
  }
}

void World::clearance(wend::Rows rows, std::span<const double> xy, std::uint32_t kinds, std::span<double> out) const {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::uint32_t row = rows[k], own = row % robots_;
    const Copy& copy = copies_[row / robots_];
    const double x = xy[2 * k], y = xy[2 * k + 1];
    double best = infinity;
    if (kinds & WEND_WALL) best = std::min(best, copy.place->map.clearance_wall(x, y));
    if (kinds & WEND_OBSTACLE) best = std::min(best, copy.place->map.clearance(x, y));
    if (kinds & WEND_MOVER)
      for (const Moving& mover : copy.movers) best = std::min(best, from_disc(x, y, mover.x, mover.y, mover.radius));
    if (kinds & WEND_ROBOT)
      for (std::uint32_t other = 0; other < robots_; ++other)
        if (other != own) {
          const wend_motion& at = rows_[row - own + other].motion;
          best = std::min(best, from_disc(x, y, at.x, at.y, options_.radius));
        }
    if (kinds & WEND_GOAL) {
      const Robot& robot = rows_[row];
      best = std::min(best, from_disc(x, y, robot.goal_x, robot.goal_y, robot.goal_radius));
    }
    out[k] = best;
  }
}

// Walls, obstacles, movers; robots and goals are told by bodies().
void World::list_shapes(Copy& copy) {
  const Scene& scene = copy.place->scene();
  const double x0 = scene.x, y0 = scene.y, x1 = scene.x + scene.width, y1 = scene.y + scene.height;
  copy.shapes.clear();
  copy.shape_points = {x0, y0, x1, y0, x1, y0, x1, y1, x1, y1, x0, y1, x0, y1, x0, y0};
  if (scene.walled)
    copy.shapes.push_back({WEND_SHAPE_SEGMENTS, WEND_WALL, 8, copy.shape_points.data(), nullptr, 0, 0, 0});
  for (const Disc& disc : scene.discs)
    copy.shapes.push_back({WEND_SHAPE_DISC, WEND_OBSTACLE, 1, &disc.x, nullptr, disc.radius, 0, 0});
  if (!scene.segments.empty())
    copy.shapes.push_back(
        {WEND_SHAPE_SEGMENTS, WEND_OBSTACLE, 2 * scene.segments.size(), &scene.segments[0].x0, nullptr, 0, 0, 0});
  for (const Polygon& polygon : scene.polygons)
    copy.shapes.push_back(
        {WEND_SHAPE_POLYGON, WEND_OBSTACLE, polygon.points.size(), &polygon.points[0].x, nullptr, 0, 0, 0});
  if (scene.grid.columns != 0)
    copy.shapes.push_back({WEND_SHAPE_GRID, WEND_OBSTACLE, std::uint64_t{scene.grid.columns} << 32 | scene.grid.rows,
                           &scene.grid.x, scene.grid.occupied.data(), 0, 0, 0});
  copy.first_mover = copy.shapes.size();
  for (const Moving& mover : copy.movers)
    copy.shapes.push_back({WEND_SHAPE_DISC, WEND_MOVER, 1, &mover.x, nullptr, mover.radius, mover.vx, mover.vy});
}

std::span<const wend_shape> World::shapes(std::uint32_t index) {
  Copy& copy = copies_[index];
  const std::lock_guard lock(copy.listing);
  if (!copy.listed.load(std::memory_order_relaxed)) {
    list_shapes(copy);
    copy.listed.store(true, std::memory_order_relaxed);
  }
  return copy.shapes;
}

}  // namespace arena
