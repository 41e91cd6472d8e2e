#include "turn_radius_planner.hpp"

#include <algorithm>
#include <cmath>
#include <wend/math.hpp>

namespace rolling_window {
namespace {

// A way that bends is a little longer than a straight one of the same time, so that equal plans do not waver.
constexpr double bend_cost = 1.02;

struct Later {
  template <class Entry>
  bool operator()(const Entry& a, const Entry& b) const noexcept {
    return a.f != b.f ? a.f > b.f : a.node > b.node;
  }
};

// Into place: a motion's state as seen from a pose.
wend_motion placed(const wend_motion& state, double x, double y, double heading, double sine, double cosine) noexcept {
  return {x + state.x * cosine - state.y * sine, y + state.x * sine + state.y * cosine,
          wend::math::wrap_angle(heading + state.heading), state.speed, state.turn_rate};
}

}  // namespace

TurnRadiusPlanner::Best& TurnRadiusPlanner::slot(std::uint64_t key) {
  const std::size_t mask = table_.size() - 1;
  std::size_t i = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ull) >> 20) & mask;
  while (table_[i].generation == generation_ && table_[i].key != key) i = (i + 1) & mask;
  return table_[i];
}

std::uint64_t TurnRadiusPlanner::key(const GridMemory& memory, double x, double y, double heading) const {
  const auto n = static_cast<double>(settings_.headings);
  auto bin =
      static_cast<std::int64_t>(std::floor(heading / wend::math::two_pi * n + 0.5)) % static_cast<std::int64_t>(n);
  if (bin < 0) bin += static_cast<std::int64_t>(settings_.headings);
  return memory.cell_at(x, y) * settings_.headings + static_cast<std::uint64_t>(bin);
}

// The goal's distance of a place; that of a neighbouring cell where its own is too near to something.
double TurnRadiusPlanner::guide(GoalDistance& to_goal, const GridMemory& memory, double x, double y) {
  double best = to_goal.cost(x, y);
  if (best < Passage::infinite) return best;
  for (int k = 0; k < 9; ++k) {
    const double dx = (k % 3 - 1) * memory.cell(), dy = (k / 3 - 1) * memory.cell();
    best = std::min(best, to_goal.cost(x + dx, y + dy) + 2 * memory.cell());
  }
  return best;
}

void TurnRadiusPlanner::push(const Node& node, const GridMemory& memory) {
  Best& best = slot(key(memory, node.x, node.y, node.heading));
  if (best.generation == generation_) {
    Node& other = nodes_[static_cast<std::size_t>(best.node)];
    if (other.closed || other.g <= node.g) return;
  }
  const auto id = static_cast<std::int32_t>(nodes_.size());
  best = {key(memory, node.x, node.y, node.heading), generation_, id};
  nodes_.push_back(node);
  open_.push_back({node.g + node.h, id});
  std::push_heap(open_.begin(), open_.end(), Later());
}

void TurnRadiusPlanner::expand(std::int32_t from, const GridMemory& memory, const Passage& passage,
                               GoalDistance& to_goal) {
  const Node node = nodes_[static_cast<std::size_t>(from)];
  double sine, cosine;
  wend::math::sincos(node.heading, sine, cosine);
  for (std::size_t m = 0; m < motions_.all.size(); ++m) {
    const Motion& motion = motions_.all[m];
    double factor = 0;
    wend_motion end{};
    for (const wend_motion& state : motion.states) {
      end = placed(state, node.x, node.y, node.heading, sine, cosine);
      factor += passage.factor(memory.clearance(end.x, end.y), end.x, end.y);
      if (factor >= Passage::infinite) break;
    }
    if (factor >= Passage::infinite || !memory.contains(end.x, end.y)) continue;
    const double h = guide(to_goal, memory, end.x, end.y);
    if (h >= Passage::infinite) continue;
    const double bend = std::fabs(motion.states.back().heading) > 1e-9 ? bend_cost : 1;
    const double cost = motion.seconds * motions_.top_speed * bend * factor / static_cast<double>(motion.states.size());
    push({end.x, end.y, end.heading, node.g + cost, h, from, static_cast<std::int32_t>(m), false}, memory);
  }
}

TurnRadiusPlanner::Result TurnRadiusPlanner::plan(const GridMemory& memory, const Passage& passage,
                                                  GoalDistance& to_goal, const wend_motion& start, Point goal,
                                                  double goal_radius, std::vector<PlannedStep>& steps) {
  steps.clear();
  nodes_.clear();
  open_.clear();
  expanded_ = 0;
  std::size_t room = 1024;
  while (room < 4 * settings_.expansions * motions_.all.size()) room *= 2;
  if (table_.size() < room) table_.assign(room, Best{});
  if (++generation_ == 0) {
    std::fill(table_.begin(), table_.end(), Best{});
    generation_ = 1;
  }
  if (!memory.contains(start.x, start.y)) return Result::trapped;
  push({start.x, start.y, start.heading, 0, std::min(guide(to_goal, memory, start.x, start.y), 1e100), -1, -1, false},
       memory);
  std::int32_t longest = 0, nearest = 0;
  while (!open_.empty()) {
    const std::int32_t id = open_.front().node;
    std::pop_heap(open_.begin(), open_.end(), Later());
    open_.pop_back();
    Node& node = nodes_[static_cast<std::size_t>(id)];
    if (node.closed || slot(key(memory, node.x, node.y, node.heading)).node != id) continue;
    node.closed = true;
    const double dx = node.x - goal.x, dy = node.y - goal.y;
    if (node.g >= settings_.horizon || dx * dx + dy * dy <= goal_radius * goal_radius) {
      trace(id, steps);
      return Result::reached;
    }
    if (node.g > nodes_[static_cast<std::size_t>(longest)].g) longest = id;
    if (node.h < nodes_[static_cast<std::size_t>(nearest)].h) nearest = id;
    if (++expanded_ > settings_.expansions) {
      trace(nearest > 0 ? nearest : longest, steps);
      return Result::open;
    }
    expand(id, memory, passage, to_goal);
  }
  trace(longest, steps);
  return Result::trapped;
}

void TurnRadiusPlanner::trace(std::int32_t node, std::vector<PlannedStep>& steps) {
  chain_.clear();
  for (; nodes_[static_cast<std::size_t>(node)].parent >= 0; node = nodes_[static_cast<std::size_t>(node)].parent)
    chain_.push_back(node);
  for (std::size_t k = chain_.size(); k-- > 0;) {
    const Node& end = nodes_[static_cast<std::size_t>(chain_[k])];
    const Node& from = nodes_[static_cast<std::size_t>(end.parent)];
    double sine, cosine;
    wend::math::sincos(from.heading, sine, cosine);
    const auto m = static_cast<std::size_t>(end.motion);
    for (const wend_motion& state : motions_.all[m].states)
      steps.push_back({m, placed(state, from.x, from.y, from.heading, sine, cosine)});
  }
}

}  // namespace rolling_window
