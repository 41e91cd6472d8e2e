// StaticMap: see static_map.hpp.
#include "static_map.hpp"

namespace arena {
namespace {

constexpr double most_listed = 48;  // candidates a cell, on average
constexpr std::size_t most_reaches = 4;

}  // namespace

StaticMap::StaticMap(ScenePtr scene)
    : scene_(std::move(scene)),
      x0_(scene_->x),
      y0_(scene_->y),
      x1_(scene_->x + scene_->width),
      y1_(scene_->y + scene_->height),
      shapes_(*scene_),
      occupancy_(scene_->grid),
      touched_(CellLists::within(shapes_, 0, std::size_t{1} << 26)),
      nearest_(CellLists::nearest(shapes_)) {}

void StaticMap::prepare(double reach) {
  if (!(reach > 0) || reach == infinity || shapes_.size() == 0 || reaches_.size() >= most_reaches) return;
  const auto at = std::lower_bound(reaches_.begin(), reaches_.end(), reach,
                                   [](const Reach& own, double wanted) { return own.reach < wanted; });
  if (at != reaches_.end() && at->reach == reach) return;
  // Long lists take time and memory: what a dense scene leaves of the reach is walked through, cell by cell.
  double listed = reach;
  while (listed > 0.05 * reach && shapes_.expected(listed) > most_listed) listed *= 0.75;
  reaches_.insert(at, {reach, listed, CellLists::within(shapes_, listed, std::size_t{1} << 22)});
}

// Lists made for much longer rays are longer than the few cells that a short ray meets.
const StaticMap::Reach* StaticMap::lists_for(double reach) const noexcept {
  for (const Reach& own : reaches_)
    if (own.reach >= reach && own.reach <= 4 * reach && !own.lists.empty()) return &own;
  return nullptr;
}

double StaticMap::cast(const Ray& ray, double reach) const noexcept {
  const double best = shapes_.size() == 0 ? reach : cast_long(ray, reach);
  return occupancy_.empty() ? best : std::min(best, occupancy_.cast(ray, best));
}

void StaticMap::cast(const Kernels& kernels, Rays& rays, double reach) const noexcept {
  const Reach* found = lists_for(reach);
  if (found == nullptr) {  // or there is nothing at all
    for (std::uint32_t k = 0; k < rays.n; ++k) rays.hit.at[k] = cast(rays.at(k), rays.best.at[k]);
    return;
  }
  const CellLists& lists = found->lists;
  const bool within = kernels.find_cells(rays, lists), polygons = !lists.polygons.empty();
  kernels.meet_lists(rays, lists);
  const bool all_met = within && !polygons && found->listed >= reach;
  for (std::uint32_t k = 0; k < rays.n && !all_met; ++k) {
    const std::int32_t cell = rays.cell[k];
    if (cell < 0) {
      rays.hit.at[k] = cast_long(rays.at(k), rays.best.at[k]);
    } else if (polygons &&
               in_polygon(lists, lists.cell(static_cast<std::uint32_t>(cell)), rays.x.at[k], rays.y.at[k])) {
      rays.hit.at[k] = 0;
    } else if (rays.hit.at[k] > found->listed) {
      rays.hit.at[k] = cast_long(rays.at(k), rays.hit.at[k], found->listed);
    }
  }
  if (occupancy_.empty()) return;
  for (std::uint32_t k = 0; k < rays.n; ++k)
    rays.hit.at[k] = std::min(rays.hit.at[k], occupancy_.cast(rays.at(k), rays.hit.at[k]));
}

bool StaticMap::in_polygon(const CellLists& lists, const CellLists::Cell& cell, double x, double y) const noexcept {
  for (std::uint32_t k = cell.polygon; k < cell.polygon + cell.polygons; ++k)
    if (inside(shapes_.polygons[lists.polygons[k]], x, y)) return true;
  return false;
}

double StaticMap::cast_list(const CellLists& lists, const CellLists::Cell& cell, const Ray& ray,
                            double best) const noexcept {
  const double *x = lists.disc_x.data(), *y = lists.disc_y.data(), *radius2 = lists.disc_radius2.data();
  for (std::uint32_t k = cell.disc, end = k + cell.discs; k < end; ++k)
    best = std::min(best, hit_disc(ray, x[k], y[k], radius2[k]));
  for (std::uint32_t k = cell.edge, end = k + cell.edges; k < end; ++k) {
    const Segment& edge = lists.edges[k];
    best = std::min(best, hit_segment(ray, edge.x0, edge.y0, edge.x1, edge.y1));
  }
  return best;
}

// Cell by cell (Amanatides and Woo 1987).  A shape is listed in every cell that it comes near, so rounding of where the
// ray changes cells cannot lose one.
double StaticMap::cast_long(const Ray& ray, double reach, double start) const noexcept {
  const CellLists& lists = touched_;
  double end = reach;
  const auto clip = [&](double low, double high, double from, double direction) {
    if (std::fabs(direction) < 1e-100) {
      if (from < low || from > high) end = -1;
      return;
    }
    const double a = (low - from) / direction, b = (high - from) / direction;
    start = std::max(start, std::min(a, b)), end = std::min(end, std::max(a, b));
  };
  const double slack = shapes_.slack();
  clip(lists.x0() - slack, lists.x1() + slack, ray.x, ray.dx);
  clip(lists.y0() - slack, lists.y1() + slack, ray.y, ray.dy);
  if (start > end) return reach;
  if (start == 0 && lists.holds(ray.x, ray.y) && in_polygon(lists, lists.at(ray.x, ray.y), ray.x, ray.y)) return 0;

  const double size = lists.cell_size();
  const auto cell_at = [&](double at, double low, std::uint32_t count) {
    return static_cast<std::int64_t>(std::min(std::max(std::floor((at - low) / size), 0.0), count - 1.0));
  };
  std::int64_t i = cell_at(ray.x + start * ray.dx, lists.x0(), lists.columns());
  std::int64_t j = cell_at(ray.y + start * ray.dy, lists.y0(), lists.rows());
  const std::int64_t step_i = ray.dx > 0 ? 1 : -1, step_j = ray.dy > 0 ? 1 : -1;
  const auto next = [&](std::int64_t k, std::int64_t step, double low, double from, double direction) {
    if (std::fabs(direction) < 1e-100) return infinity;
    return (low + static_cast<double>(step > 0 ? k + 1 : k) * size - from) / direction;
  };
  double next_x = next(i, step_i, lists.x0(), ray.x, ray.dx), next_y = next(j, step_j, lists.y0(), ray.y, ray.dy);
  double best = reach;
  while (true) {
    best = cast_list(lists, lists.cell(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)), ray, best);
    if (std::min(next_x, next_y) > std::min(best, end)) return best;
    if (next_x < next_y) {
      i += step_i;
      if (i < 0 || i >= lists.columns()) return best;
      next_x = next(i, step_i, lists.x0(), ray.x, ray.dx);
    } else {
      j += step_j;
      if (j < 0 || j >= lists.rows()) return best;
      next_y = next(j, step_j, lists.y0(), ray.y, ray.dy);
    }
  }
}

double StaticMap::clearance_all(double x, double y) const noexcept {
  double best = infinity;
  for (const Disc& disc : shapes_.discs) best = std::min(best, from_disc(x, y, disc.x, disc.y, disc.radius));
  for (const Segment& e : shapes_.edges) best = std::min(best, from_segment(x, y, e.x0, e.y0, e.x1, e.y1));
  return best;  // no polygon reaches out of the cells
}

double StaticMap::clearance(double x, double y) const noexcept {
  double best = infinity;
  if (shapes_.size() != 0) {
    if (!nearest_.holds(x, y)) {
      best = clearance_all(x, y);
    } else {
      const CellLists::Cell& cell = nearest_.at(x, y);
      for (std::uint32_t k = cell.disc, end = k + cell.discs; k < end; ++k)
        best = std::min(best, from_disc(x, y, nearest_.disc_x[k], nearest_.disc_y[k], nearest_.disc_radius[k]));
      for (std::uint32_t k = cell.edge, end = k + cell.edges; k < end; ++k) {
        const Segment& e = nearest_.edges[k];
        best = std::min(best, from_segment(x, y, e.x0, e.y0, e.x1, e.y1));
      }
      for (std::uint32_t k = cell.polygon, end = k + cell.polygons; k < end; ++k)
        best = std::min(best, from_polygon(shapes_.polygons[nearest_.polygons[k]], x, y));
    }
  }
  return occupancy_.empty() ? best : std::min(best, occupancy_.clearance(x, y));
}

}  // namespace arena
