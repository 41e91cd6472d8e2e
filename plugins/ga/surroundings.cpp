#include "surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ga {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_points = 1e6;
constexpr double most_lines = 3e5;  // along the longer side, however thin the area is

void include(Area& area, double x, double y) noexcept {
  area = {std::min(area.x0, x), std::min(area.y0, y), std::max(area.x1, x), std::max(area.y1, y)};
}

void include(Area& area, const wend_shape& shape) noexcept {
  if (shape.form == WEND_SHAPE_DISC) {
    include(area, shape.xy[0] - shape.radius, shape.xy[1] - shape.radius);
    include(area, shape.xy[0] + shape.radius, shape.xy[1] + shape.radius);
  } else if (shape.form == WEND_SHAPE_GRID) {
    const auto columns = static_cast<double>(shape.count >> 32), rows = static_cast<double>(shape.count & 0xffffffff);
    include(area, shape.xy[0], shape.xy[1]);
    include(area, shape.xy[0] + columns * shape.xy[2], shape.xy[1] + rows * shape.xy[2]);
  } else {
    for (std::uint64_t k = 0; k < shape.count; ++k) include(area, shape.xy[2 * k], shape.xy[2 * k + 1]);
  }
}

}  // namespace

// Within the walls; without any, around all that stands, the robots and their goals, with a tenth to pass outside.
Area Surroundings::area(std::uint32_t row) const {
  Area walls{infinity, infinity, -infinity, -infinity}, all = walls;
  for (const wend_shape& shape : world_.shapes(row / robots_)) {
    if (shape.kind == WEND_WALL) include(walls, shape);
    if (shape.kind == WEND_WALL || shape.kind == WEND_OBSTACLE) include(all, shape);
  }
  if (walls.x0 < walls.x1 && walls.y0 < walls.y1) return walls;
  const std::uint32_t first = row - row % robots_;
  for (std::uint32_t other = first; other < first + robots_; ++other) {
    wend_disc body, goal;
    world_.bodies(wend::Rows(&other, 1), std::span(&body, 1), std::span(&goal, 1));
    for (const wend_disc& disc : {body, goal}) {
      include(all, disc.x - 4 * disc.radius, disc.y - 4 * disc.radius);
      include(all, disc.x + 4 * disc.radius, disc.y + 4 * disc.radius);
    }
  }
  const double around = 0.1 * std::max(all.x1 - all.x0, all.y1 - all.y0);
  return {all.x0 - around, all.y0 - around, all.x1 + around, all.y1 + around};
}

ClearanceGrid Surroundings::of(std::uint32_t row, std::uint64_t scene, std::uint32_t variant) {
  const std::uint32_t first = row - row % robots_;
  std::vector<std::uint32_t> team(robots_);
  for (std::uint32_t k = 0; k < robots_; ++k) team[k] = first + k;
  std::vector<wend_disc> bodies(robots_), goals(robots_);
  world_.bodies(team, bodies, goals);

  const Area area = this->area(row);
  const double width = area.x1 - area.x0, height = area.y1 - area.y0;
  const double coarsest = std::max(std::sqrt(width * height / most_points), std::max(width, height) / most_lines);
  const double wanted = cell_ > 0 ? cell_ : bodies[row - first].radius / 3;
  ClearanceGrid grid = still(row, scene, variant, area, std::max({wanted, coarsest, 1e-9}));
  for (const wend_shape& shape : world_.shapes(row / robots_))
    if (shape.kind == WEND_MOVER && shape.form == WEND_SHAPE_DISC) grid.add({shape.xy[0], shape.xy[1], shape.radius});
  if (see_robots_)
    for (std::uint32_t k = 0; k < robots_; ++k)
      if (team[k] != row) grid.add(bodies[k]);
  return grid;
}

const ClearanceGrid& Surroundings::still(std::uint32_t row, std::uint64_t scene, std::uint32_t variant,
                                         const Area& area, double cell) {
  for (const Map& map : maps_)
    if (map.scene == scene && map.variant == variant && map.grid.area() == area && map.grid.cell() == cell)
      return map.grid;
  Map map{scene, variant, measured(row, area, cell)};
  if (maps_.size() < most_maps) return maps_.emplace_back(std::move(map)).grid;
  Map& place = maps_[oldest_++ % most_maps];
  place = std::move(map);
  return place.grid;
}

ClearanceGrid Surroundings::measured(std::uint32_t row, const Area& area, double cell) const {
  constexpr std::size_t portion = 4096;
  ClearanceGrid grid(area, cell);
  const std::size_t n = grid.columns() * grid.rows();
  std::vector<double> xy(2 * portion), clearance(portion);
  const std::vector<std::uint32_t> rows(portion, row);
  for (std::size_t first = 0; first < n; first += portion) {
    const std::size_t count = std::min(portion, n - first);
    for (std::size_t k = 0; k < count; ++k) {
      const Point point = grid.lattice_point(first + k);
      xy[2 * k] = point.x, xy[2 * k + 1] = point.y;
    }
    world_.clearance(std::span(rows).first(count), std::span(xy).first(2 * count), WEND_WALL | WEND_OBSTACLE,
                     std::span(clearance).first(count));
    grid.set(first, std::span<const double>(clearance).first(count));
  }
  return grid;
}

}  // namespace ga
