#include "features.hpp"

#include <algorithm>
#include <cmath>
#include <wend/math.hpp>

namespace lssvm {

Features::Features(const wend::Config& config)
    : state_(config.observation, config.params.texts("observe"), "observe"),
      power_(config.params.number("distance_power")),
      bearing_weight_(config.params.number("bearing_weight")),
      distance_weight_(config.params.number("distance_weight")),
      goal_reach_(config.params.number("goal_reach")) {
  for (std::size_t i = 0; i < state_.size(); ++i) {
    const wend_column& column = state_.column(i);
    if (!std::isfinite(column.low) || !std::isfinite(column.high) || column.low >= column.high)
      throw wend::parameter_error("observe", "column \"" + std::string(column.name) +
                                                 "\": expected a finite range to scale to [0, 1], found none; take " +
                                                 "another column");
  }
  const std::string goal = config.params.text("goal");
  if (!goal.empty())
    goal_ = Goal{{config.observation, goal + ".distance", "goal"}, {config.observation, goal + ".bearing", "goal"}};
}

void Features::read(std::span<const double> observation, std::span<double> out) const {
  std::size_t k = 0;
  for (std::size_t i = 0; i < state_.size(); ++i) {
    const wend_column& column = state_.column(i);
    const double share = (state_(observation, i) - column.low) / (column.high - column.low);
    out[k++] = power_ == 1 ? share : wend::math::pow(std::clamp(share, 0.0, 1.0), power_);
  }
  if (!goal_) return;
  double sine, cosine;
  wend::math::sincos(goal_->bearing(observation), sine, cosine);
  out[k++] = bearing_weight_ * cosine;
  out[k++] = bearing_weight_ * sine;
  out[k++] = distance_weight_ * goal_->distance(observation) / goal_reach_;
}

std::vector<double> Features::constants() const {
  std::vector<double> all{power_, bearing_weight_, distance_weight_, goal_reach_};
  for (std::size_t i = 0; i < state_.size(); ++i) all.insert(all.end(), {state_.column(i).low, state_.column(i).high});
  return all;
}

}  // namespace lssvm
