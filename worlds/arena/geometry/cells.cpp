// Candidate lists: see cells.hpp.
#include "cells.hpp"

#include <cmath>

namespace arena {

Shapes::Shapes(const Scene& scene)
    : discs(scene.discs),
      edges(scene.segments),
      polygons(scene.polygons),
      x0(scene.x),
      y0(scene.y),
      x1(scene.x + scene.width),
      y1(scene.y + scene.height) {
  for (const Polygon& polygon : polygons)
    for (std::size_t i = 0, j = polygon.points.size() - 1; i < polygon.points.size(); j = i++)
      edges.push_back({polygon.points[j].x, polygon.points[j].y, polygon.points[i].x, polygon.points[i].y});
  const auto cover = [this](double x, double y, double around) {
    x0 = std::min(x0, x - around), x1 = std::max(x1, x + around);
    y0 = std::min(y0, y - around), y1 = std::max(y1, y + around);
  };
  for (const Disc& disc : discs) cover(disc.x, disc.y, disc.radius);
  for (const Segment& edge : edges) cover(edge.x0, edge.y0, 0), cover(edge.x1, edge.y1, 0);
}

double Shapes::expected(double distance) const noexcept {
  double area = 0;  // of the shapes, widened by the distance
  const auto round = [](double radius) { return 3.14 * radius * radius; };
  for (const Disc& disc : discs) area += round(disc.radius + distance);
  for (const Segment& e : edges)
    area += round(distance) + 2 * distance * from_segment(e.x0, e.y0, e.x1, e.y1, e.x1, e.y1);
  return area / ((x1 - x0) * (y1 - y0));
}

// Halves squares down to the cells, and keeps in each what its rule lets through.
struct CellLists::Builder {
  const Shapes& shapes;
  CellLists& out;
  double reach;  // m; negative: only what is nearest
  std::size_t limit;
  bool full = false;

  struct Candidates {
    std::vector<std::uint32_t> discs, edges, polygons;
  };
  std::vector<Candidates> levels;
  std::vector<double> distances;
  std::vector<std::pair<double, std::uint32_t>> order;

  double from(std::uint32_t kind, std::uint32_t i, double x, double y) const {
    if (kind == 0) return from_disc(x, y, shapes.discs[i].x, shapes.discs[i].y, shapes.discs[i].radius);
    const Segment& edge = shapes.edges[i];
    return from_segment(x, y, edge.x0, edge.y0, edge.x1, edge.y1);
  }

  // Of the candidates of the square around, those of the square of this centre and half diagonal.  A distance changes
  // by no more than the point moves, so what is nearest somewhere in the square is, at its centre, at most a diagonal
  // farther than the nearest there.
  void filter(const Candidates& from_all, Candidates& to, double x, double y, double half) {
    distances.clear();
    double nearest = infinity;
    for (const std::uint32_t i : from_all.discs) nearest = std::min(nearest, distances.emplace_back(from(0, i, x, y)));
    for (const std::uint32_t i : from_all.edges) nearest = std::min(nearest, distances.emplace_back(from(1, i, x, y)));
    const double most = (reach < 0 ? nearest + 2 * half : reach + half) + shapes.slack();
    to.discs.clear(), to.edges.clear(), to.polygons.clear();
    std::size_t k = 0;
    for (const std::uint32_t i : from_all.discs)
      if (distances[k++] <= most) to.discs.push_back(i);
    for (const std::uint32_t i : from_all.edges)
      if (distances[k++] <= most) to.edges.push_back(i);
    for (const std::uint32_t i : from_all.polygons)
      if (from_polygon(shapes.polygons[i], x, y) <= half + shapes.slack()) to.polygons.push_back(i);
  }

  void add(const Disc& disc, double radius2, double near) {
    out.disc_x.push_back(disc.x), out.disc_y.push_back(disc.y), out.disc_radius2.push_back(radius2);
    (reach < 0 ? out.disc_radius : out.disc_near).push_back(reach < 0 ? disc.radius : near);
  }

  // The nearest to the cell's centre first: a ray that has met something may leave out what is farther away.
  void sort_discs(std::vector<std::uint32_t>& discs, double x, double y) {
    order.clear();
    for (const std::uint32_t i : discs) order.emplace_back(from(0, i, x, y), i);
    std::sort(order.begin(), order.end());
    for (std::size_t k = 0; k < discs.size(); ++k) discs[k] = order[k].second;
  }

  void emit(Candidates& list, std::uint32_t column, std::uint32_t row) {
    const auto count = [](const auto& all) { return static_cast<std::uint32_t>(all.size()); };
    const double half = 0.5 * out.size_, x = out.x0_ + column * out.size_ + half, y = out.y0_ + row * out.size_ + half;
    const double around = half * 1.4142135623730952 + shapes.slack();
    const std::uint32_t first = count(out.disc_x);
    if (reach > 0) sort_discs(list.discs, x, y);
    for (const std::uint32_t i : list.discs) {
      const Disc& disc = shapes.discs[i];
      add(disc, disc.radius * disc.radius, from(0, i, x, y) - around);
    }
    if (reach > 0 && list.discs.size() > most_in_turn)
      while ((count(out.disc_x) - first) % most_lanes != 0) add({x, y, 0}, -1, infinity);
    out.cells_[std::size_t{row} * out.columns_ + column] = {
        first, count(out.disc_x) - first, count(out.edges), count(list.edges), count(out.polygons),
        count(list.polygons)};
    for (const std::uint32_t i : list.edges) out.edges.push_back(shapes.edges[i]);
    out.polygons.insert(out.polygons.end(), list.polygons.begin(), list.polygons.end());
    full = full || out.disc_x.size() + out.edges.size() > limit;
  }

  // The square of 2^level cells a side from (column, row) on, of which levels[level + 1] holds a superset.
  void build(std::size_t level, std::uint32_t column, std::uint32_t row) {
    if (full || column >= out.columns_ || row >= out.rows_) return;
    const std::uint32_t side = 1u << level;
    const double half = 0.5 * side * out.size_;
    filter(levels[level + 1], levels[level], out.x0_ + column * out.size_ + half, out.y0_ + row * out.size_ + half,
           half * 1.4142135623730952);
    if (level == 0) return emit(levels[0], column, row);
    for (std::uint32_t k = 0; k < 4; ++k) build(level - 1, column + (k & 1) * (side / 2), row + (k >> 1) * (side / 2));
  }

  void run() {
    const double width = shapes.x1 - shapes.x0, height = shapes.y1 - shapes.y0;
    const double most = reach > 0 ? 16384 : 65536;
    const double wanted = std::min(std::max(8.0 * static_cast<double>(shapes.size()), 1024.0), most);
    const double size = std::max(std::sqrt(width * height / wanted), std::max(width, height) / 4096);
    out.size_ = size * (1 + 1e-9);
    out.per_metre_ = 1 / out.size_;
    out.x0_ = shapes.x0, out.y0_ = shapes.y0;
    out.columns_ = static_cast<std::uint32_t>(std::ceil(width / out.size_));
    out.rows_ = static_cast<std::uint32_t>(std::ceil(height / out.size_));
    out.x1_ = out.x0_ + out.columns_ * out.size_, out.y1_ = out.y0_ + out.rows_ * out.size_;
    out.cells_.assign(std::size_t{out.columns_} * out.rows_, {});
    std::size_t top = 0;
    while ((1u << top) < std::max(out.columns_, out.rows_)) ++top;
    levels.resize(top + 2);
    const auto all = [](std::vector<std::uint32_t>& to, std::size_t n) {
      for (std::size_t i = 0; i < n; ++i) to.push_back(static_cast<std::uint32_t>(i));
    };
    all(levels[top + 1].discs, shapes.discs.size());
    all(levels[top + 1].edges, shapes.edges.size());
    all(levels[top + 1].polygons, shapes.polygons.size());
    build(top, 0, 0);
    if (full) out = CellLists();
  }
};

CellLists CellLists::within(const Shapes& shapes, double reach, std::size_t limit) {
  CellLists lists;
  if (shapes.size() > 0) Builder{shapes, lists, reach, limit, false, {}, {}, {}}.run();
  return lists;
}

CellLists CellLists::nearest(const Shapes& shapes) {
  CellLists lists;
  if (shapes.size() > 0) Builder{shapes, lists, -1, std::size_t{1} << 26, false, {}, {}, {}}.run();
  return lists;
}

}  // namespace arena
