// Dijkstra's distances on the free cells, by buckets one cell wide (Denardo & Fox 1979): no step is shorter than a
// bucket, so all distances of a bucket are final when its turn comes and their order within it does not matter.
#include "optimal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace arena {
namespace {

constexpr double diagonal = 1.41421356237309504880;
constexpr double infinite = std::numeric_limits<double>::infinity();

double distance(Point a, Point b) noexcept {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}

// Calls visit(cell, leg) for the cells by which a way may leave or enter a point: its own, and those that a legal step
// leads to from there.  leg: cells from the point to that cell's centre.
template <class Visit>
void legs(const FreeSpace& space, Point p, Visit&& visit) {
  const std::ptrdiff_t own = space.index(p), stride = space.stride();
  if (own < 0) return;
  const auto free = [&](std::ptrdiff_t i) { return space.free(static_cast<std::size_t>(i)); };
  const bool fits = free(own);
  if (!fits && space.exact()) return;
  for (const std::ptrdiff_t dy : {-stride, std::ptrdiff_t{0}, stride}) {
    for (const std::ptrdiff_t dx : {-1, 0, 1}) {
      if (!free(own + dx + dy) || (fits && !(free(own + dx) && free(own + dy)))) continue;
      const auto cell = static_cast<std::size_t>(own + dx + dy);
      visit(cell, distance(p, space.centre(cell)) / space.cell());
    }
  }
}

class Buckets {
 public:
  explicit Buckets(std::vector<double>& steps) : steps_(steps) {}

  void relax(std::size_t cell, double steps) {
    if (!(steps < steps_[cell])) return;
    steps_[cell] = steps;
    at(steps).push_back(static_cast<std::uint32_t>(cell));
    ++waiting_;
  }

  // Settles every cell that can be reached.
  void run(const FreeSpace& space) {
    std::vector<std::uint8_t> open(space.cells(), space.cells() + space.size());
    for (double turn = 0; waiting_ > 0; ++turn) {
      std::vector<std::uint32_t>& bucket = at(turn);
      waiting_ -= bucket.size();
      for (const std::uint32_t cell : bucket) {
        if (!std::exchange(open[cell], std::uint8_t{0})) continue;
        expand(space.cells() + cell, space.stride(), cell);
      }
      bucket.clear();
    }
  }

 private:
  // A step is shorter than two cells and a leg than three: four buckets in turn are enough.
  std::vector<std::uint32_t>& at(double steps) { return buckets_[static_cast<std::uint64_t>(steps) % 4]; }

  void expand(const std::uint8_t* free, std::ptrdiff_t up, std::size_t cell) {
    const double straight = steps_[cell] + 1, aslant = steps_[cell] + diagonal;
    const auto to = [&](std::ptrdiff_t step, double steps) {
      relax(static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) + step), steps);
    };
    const bool left = free[-1], right = free[1], below = free[-up], above = free[up];
    if (left) to(-1, straight);
    if (right) to(1, straight);
    if (below) to(-up, straight);
    if (above) to(up, straight);
    if (left && below && free[-up - 1]) to(-up - 1, aslant);
    if (right && below && free[-up + 1]) to(-up + 1, aslant);
    if (left && above && free[up - 1]) to(up - 1, aslant);
    if (right && above && free[up + 1]) to(up + 1, aslant);
  }

  std::vector<double>& steps_;
  std::array<std::vector<std::uint32_t>, 4> buckets_;
  std::size_t waiting_ = 0;
};

}  // namespace

DistanceField::DistanceField(std::shared_ptr<const FreeSpace> space, Point goal, double goal_radius)
    : space_(std::move(space)), goal_(goal), goal_radius_(goal_radius), steps_(space_->size(), infinite) {
  Buckets buckets(steps_);
  if (goal_radius_ > 0) {
    // The rim may be reached from the cells within it and, by a straight leg, from those just outside.
    for (std::size_t i = 0; i < space_->size(); ++i) {
      if (!space_->free(i)) continue;
      const double leg = std::max(0.0, distance(space_->centre(i), goal_) - goal_radius_) / space_->cell();
      if (leg <= 1) buckets.relax(i, leg);
    }
  }
  legs(*space_, goal_,
       [&](std::size_t cell, double leg) { buckets.relax(cell, std::max(0.0, leg - goal_radius_ / space_->cell())); });
  buckets.run(*space_);
}

double DistanceField::length(Point start) const noexcept {
  const std::ptrdiff_t own = space_->index(start);
  const double straight = std::max(0.0, distance(start, goal_) - goal_radius_);
  if (own >= 0 && space_->free(static_cast<std::size_t>(own)) && (straight == 0 || own == space_->index(goal_)))
    return straight;
  double best = infinite;
  legs(*space_, start, [&](std::size_t cell, double leg) { best = std::min(best, leg + steps_[cell]); });
  return best < infinite ? best * space_->cell() : -1;
}

double optimal_length(const Scene& scene, Point start, Point goal, OptimalOptions options) {
  const auto space =
      std::make_shared<const FreeSpace>(scene, options.cell, options.body_radius, std::vector<Point>{start, goal});
  return DistanceField(space, goal, options.goal_radius).length(start);
}

double suitable_cell(const Scene& scene, double body_radius) noexcept {
  if (scene.grid.columns > 0) return scene.grid.cell;
  return body_radius > 0 ? body_radius / 3 : std::max(scene.width, scene.height) / 200;
}

}  // namespace arena
