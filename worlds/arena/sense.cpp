// What sensors, planners and pictures ask of the arena, between two steps and from several threads.
#include "world.hpp"

namespace arena {

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

namespace {

// Discs that move, met by some rays of a block in portions.
class Portion {
 public:
  Portion(Rays& rays, std::uint32_t first, std::uint32_t last) : rays_(rays), first_(first), last_(last) {}
  ~Portion() { meet(); }
  void add(double x, double y, double radius) {
    x_[n_] = x, y_[n_] = y, radius2_[n_] = radius * radius;
    if (++n_ == size) meet();
  }

 private:
  static constexpr std::uint32_t size = 32;
  void meet() {
    if (n_ > 0) kernels().meet_discs(rays_, first_, last_, {x_, y_, radius2_, n_});
    n_ = 0;
  }
  Rays& rays_;
  std::uint32_t first_, last_, n_ = 0;
  double x_[size], y_[size], radius2_[size];
};

}  // namespace

// Rays that follow one another in one scene are cast together, whose rows they ever are.
void World::cast(wend::Rows rows, std::span<const wend_pose> rays, double reach, std::uint32_t kinds, double* distance,
                 std::uint8_t* kind) {
  if (reach > 0 && reach < infinity) note_reach(reach);
  const std::size_t n = rows.size();
  for (std::size_t first = 0, last = 0; first < n; first = last) {
    const StaticMap* map = maps_[rows[first]];
    const std::size_t most = std::min<std::size_t>(n, first + block);
    last = one_map_ ? most : first + 1;
    while (last < most && maps_[rows[last]] == map) ++last;
    cast_block(*map, rows.subspan(first, last - first), &rays[first], reach, kinds, distance + first,
               kind ? kind + first : nullptr);
  }
}

void World::cast_block(const StaticMap& map, wend::Rows rows, const wend_pose* poses, double reach,
                       std::uint32_t kinds, double* distance, std::uint8_t* kind) const {
  const Kernels& k = kernels();
  Rays rays;
  rays.n = static_cast<std::uint32_t>(rows.size());
  if (!k.aim(rays, poses, reach))
    for (std::uint32_t i = 0; i < rays.n; ++i) wend::math::sincos(rays.heading.at[i], rays.dy.at[i], rays.dx.at[i]);
  if (kinds & WEND_WALL && map.walled()) {
    k.meet_bounds(rays, map.bounds());
    k.keep_nearer(rays, WEND_WALL);
  }
  if (kinds & WEND_OBSTACLE && !map.empty()) {
    map.cast(k, rays, reach);
    k.keep_nearer(rays, WEND_OBSTACLE);
  }
  for (const std::uint32_t what : {WEND_MOVER, WEND_ROBOT, WEND_GOAL}) {
    if (!(kinds & what) || (what == WEND_MOVER && !movers_) || (what == WEND_ROBOT && robots_ == 1)) continue;
    meet_moving(rays, rows, what);
    k.keep_nearer(rays, what);
  }
  std::copy(rays.best.at, rays.best.at + rays.n, distance);
  for (std::uint32_t i = 0; kind != nullptr && i < rays.n; ++i)
    kind[i] = static_cast<std::uint8_t>(static_cast<std::int32_t>(rays.kind.at[i]));
}

void World::meet_moving(Rays& rays, wend::Rows rows, std::uint32_t what) const {
  std::copy(rays.best.at, rays.best.at + rays.n, rays.hit.at);
  for (std::uint32_t k = 0, end = 0; k < rays.n; k = end) {
    const std::uint32_t row = rows[k], own = row % robots_;
    for (end = k + 1; end < rays.n && rows[end] == row;) ++end;
    Portion portion(rays, k, end);
    if (what == WEND_MOVER)
      for (const Moving& mover : copies_[row / robots_].movers) portion.add(mover.x, mover.y, mover.radius);
    if (what == WEND_ROBOT)
      for (std::uint32_t other = row - own; other < row - own + robots_; ++other)
        if (other != row) portion.add(rows_[other].motion.x, rows_[other].motion.y, options_.radius);
    if (what == WEND_GOAL) portion.add(rows_[row].goal_x, rows_[row].goal_y, rows_[row].goal_radius);
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
