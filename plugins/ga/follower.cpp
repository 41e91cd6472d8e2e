#include "follower.hpp"

#include <algorithm>
#include <cmath>
#include <wend/math.hpp>

namespace ga {
namespace {

constexpr std::size_t most_sequences = 1024;
constexpr double touching = 1e3;  // cost of a step into what the grid knows
constexpr double aligned = 0.5;   // worth of a heading along the path, against one the other way

}  // namespace

Follower::Follower(wend::BodyRef body, std::size_t actions, double period, std::size_t steps)
    : body_(body), actions_(actions), period_(period) {
  std::size_t sequences = actions;
  for (; depth_ < steps && sequences * actions <= most_sequences; ++depth_) sequences *= actions;
  std::vector<double> all(actions);
  for (std::size_t k = 0; k < actions; ++k) all[k] = static_cast<double>(k);
  std::vector<wend_motion> to(actions);
  body.predict(0, std::vector<wend_motion>(actions), all.data(), period, to);
  for (const wend_motion& motion : to) advance_ = std::max(advance_, wend::math::hypot(motion.x, motion.y));
  if (!(advance_ > 0)) throw wend::unsupported("expected an action that leads somewhere from rest, found none");
}

Follower::Choice Follower::choose(std::uint32_t robot, const wend_motion& now, const Track& track, double& way,
                                  const wend_disc& goal, const ClearanceGrid& grid, double needed) {
  const double ahead = way + 3 * advance_ * static_cast<double>(depth_);
  way = track.foot({now.x, now.y}, way, ahead).way;
  nodes_.assign(1, Node{now, 0, 0, false});
  Choice choice{0, now};
  std::vector<wend_motion> first;
  for (std::size_t level = 0; level < depth_; ++level) {
    extend(robot);
    for (std::size_t k = 0; k < next_.size(); ++k) {
      if (level == 0) next_[k].first = k;
      judge(next_[k], track, way, goal, grid, needed);
    }
    nodes_.swap(next_);
    if (level == 0) first = to_;
  }
  double least = std::numeric_limits<double>::infinity();
  for (const Node& node : nodes_) {
    const double cost = node.cost + left_over(node, track, way);
    if (cost < least) least = cost, choice.action = node.first;
  }
  choice.next = first[choice.action];
  return choice;
}

// Every action after every node.
void Follower::extend(std::uint32_t robot) {
  next_.clear(), from_.clear(), columns_.clear();
  for (const Node& node : nodes_)
    for (std::size_t k = 0; k < actions_; ++k) {
      next_.push_back(node);
      from_.push_back(node.motion);
      columns_.push_back(static_cast<double>(k));
    }
  to_.resize(from_.size());
  body_.predict(robot, from_, columns_.data(), period_, to_);
  for (std::size_t k = 0; k < next_.size(); ++k)
    if (!next_[k].arrived) next_[k].motion = to_[k];
}

// Distance from the path at each step, and time.
void Follower::judge(Node& node, const Track& track, double way, const wend_disc& goal, const ClearanceGrid& grid,
                     double needed) const {
  if (node.arrived) return;
  const wend_motion& at = node.motion;
  const Foot foot = track.foot({at.x, at.y}, way, way + 3 * advance_ * static_cast<double>(depth_));
  node.cost += foot.distance / advance_;
  if (grid.at(at.x, at.y) <= needed) node.cost += touching;
  node.arrived = wend::math::hypot(goal.x - at.x, goal.y - at.y) <= goal.radius;
}

// What a sequence leaves to be done: the rest of the way, and the turn to where the path goes on.
double Follower::left_over(const Node& node, const Track& track, double way) const {
  if (node.arrived) return 0;
  const wend_motion& at = node.motion;
  const double reach = advance_ * static_cast<double>(depth_);
  const double foot = track.foot({at.x, at.y}, way, way + 3 * reach).way;
  const Point then = track.at(foot + reach);
  const double turn = wend::math::wrap_angle(wend::math::atan2(then.y - at.y, then.x - at.x) - at.heading);
  return (track.length() - foot) / advance_ + aligned * std::fabs(turn) * (2 / wend::math::pi);
}

}  // namespace ga
