#include "goal_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rolling_window {
namespace {

constexpr float blocked = std::numeric_limits<float>::infinity();
constexpr int columns_to[8] = {1, 1, 0, -1, -1, -1, 0, 1}, rows_to[8] = {0, 1, 1, 1, 0, -1, -1, -1};
constexpr std::uint8_t at_goal = 8;
constexpr float diagonal = 1.41421356f;

}  // namespace

void GoalDistance::begin(const GridMemory& memory, const Passage& passage, Point goal, double goal_radius, Point robot,
                         double slack) {
  memory_ = &memory;
  passage_ = passage;
  slack_ = slack;
  expanded_ = 0;
  heap_.clear();
  if (nodes_.size() < memory.size()) nodes_.resize(memory.size());
  if (++generation_ == 0) {
    for (Node& node : nodes_) node.generation = 0;
    generation_ = 1;
  }
  const std::size_t target = memory.contains(robot.x, robot.y) ? memory.cell_at(robot.x, robot.y) : 0;
  target_column_ = static_cast<long>(target % memory.columns());
  target_row_ = static_cast<long>(target / memory.columns());
  if (!memory.contains(goal.x, goal.y)) return;
  const double cell = memory.cell();
  const auto span = static_cast<long>(goal_radius / cell) + 1;
  for (long dr = -span; dr <= span; ++dr) {
    for (long dc = -span; dc <= span; ++dc) {
      const double x = goal.x + static_cast<double>(dc) * cell, y = goal.y + static_cast<double>(dr) * cell;
      if (!memory.contains(x, y)) continue;
      const std::size_t i = memory.cell_at(x, y);
      const Point p = memory.centre(i);
      const double distance = std::sqrt((p.x - goal.x) * (p.x - goal.x) + (p.y - goal.y) * (p.y - goal.y));
      if (distance > std::max(goal_radius, 0.75 * cell)) continue;
      open(static_cast<std::uint32_t>(i), static_cast<float>(0.1 * distance), at_goal);
    }
  }
}

void GoalDistance::refresh(std::uint32_t cell) {
  Node& node = nodes_[cell];
  if (node.generation != generation_) node = {generation_, blocked, -1, at_goal, 0};
}

float GoalDistance::factor(std::uint32_t cell) {
  refresh(cell);
  Node& node = nodes_[cell];
  if (node.factor < 0) {
    const Point p = memory_->centre(cell);
    const double factor = passage_.factor(memory_->clearance(cell), p.x, p.y, slack_);
    node.factor = factor >= Passage::infinite ? blocked : static_cast<float>(factor);
  }
  return node.factor;
}

// Octile distance to the robot's cell; 0.999 keeps float rounding from making it inconsistent.
float GoalDistance::heuristic(std::uint32_t cell) const noexcept {
  const auto columns = static_cast<long>(memory_->columns());
  const auto dc = static_cast<float>(std::labs(static_cast<long>(cell) % columns - target_column_));
  const auto dr = static_cast<float>(std::labs(static_cast<long>(cell) / columns - target_row_));
  const float least = std::min(dc, dr), most = std::max(dc, dr);
  return 0.999f * static_cast<float>(memory_->cell()) * (most + (diagonal - 1) * least);
}

void GoalDistance::open(std::uint32_t cell, float g, std::uint8_t direction) {
  if (factor(cell) == blocked) return;
  Node& node = nodes_[cell];
  if (node.closed || !(g < node.g)) return;
  node.g = g, node.direction = direction;
  heap_.push_back({g + heuristic(cell), cell});
  std::push_heap(heap_.begin(), heap_.end(),
                 [](const Entry& a, const Entry& b) { return a.f != b.f ? a.f > b.f : a.cell > b.cell; });
}

void GoalDistance::expand(std::uint32_t cell) {
  ++expanded_;
  const auto columns = static_cast<long>(memory_->columns()), rows = static_cast<long>(memory_->rows());
  const long column = static_cast<long>(cell) % columns, row = static_cast<long>(cell) / columns;
  const float g = nodes_[cell].g, own = nodes_[cell].factor;
  const auto side = static_cast<float>(memory_->cell());
  const auto passable = [&](long c, long r) {
    return c >= 0 && r >= 0 && c < columns && r < rows &&
           factor(static_cast<std::uint32_t>(r * columns + c)) != blocked;
  };
  for (int k = 0; k < 8; ++k) {
    const long c = column + columns_to[k], r = row + rows_to[k];
    if (!passable(c, r)) continue;
    const bool slanted = k % 2 == 1;
    if (slanted && (!passable(c, row) || !passable(column, r))) continue;
    const auto to = static_cast<std::uint32_t>(r * columns + c);
    const float step = side * (slanted ? diagonal : 1) * 0.5f * (own + factor(to));
    open(to, g + step, static_cast<std::uint8_t>((k + 4) % 8));
  }
}

double GoalDistance::cost(std::size_t cell) {
  const auto wanted = static_cast<std::uint32_t>(cell);
  const auto later = [](const Entry& a, const Entry& b) { return a.f != b.f ? a.f > b.f : a.cell > b.cell; };
  if (factor(wanted) == blocked) return Passage::infinite;
  while (!nodes_[wanted].closed && !heap_.empty()) {
    const std::uint32_t next = heap_.front().cell;
    std::pop_heap(heap_.begin(), heap_.end(), later);
    heap_.pop_back();
    if (nodes_[next].closed) continue;
    nodes_[next].closed = 1;
    expand(next);
  }
  return nodes_[wanted].closed ? static_cast<double>(nodes_[wanted].g) : Passage::infinite;
}

bool GoalDistance::path(Point from, std::vector<Point>& out) {
  out.clear();
  if (!memory_->contains(from.x, from.y)) return false;
  std::size_t cell = memory_->cell_at(from.x, from.y);
  if (cost(cell) >= Passage::infinite) return false;
  while (true) {
    out.push_back(memory_->centre(cell));
    const std::uint8_t direction = nodes_[cell].direction;
    if (direction == at_goal) return true;
    cell = static_cast<std::size_t>(static_cast<long>(cell) + columns_to[direction] +
                                    rows_to[direction] * static_cast<long>(memory_->columns()));
  }
}

}  // namespace rolling_window
