// wend.progress -- reward of a robot on its way to a goal through narrow rooms, after Li et al., "Path obstacle
// avoidance planning of an ALV in narrow environments, based on XCS and LS-SVM": a reward for the goal, a graded
// penalty for what comes near, and progress towards the goal, which the paper leaves open.
//
//   symbol  here               meaning
//   d_g     goal distance      m, before and after the action
//   d       least reading      m, after the action
//   R       safe_distance      m
//
//   arrived                    + goal
//   collided                   - collision
//   otherwise                  - near (1 - d / R)  where d < R
//   always                     + progress (d_g - d_g') - step - cost of the action
#include <algorithm>
#include <limits>
#include <string>
#include <vector>
#include <wend/plugin.hpp>
#include <wend/reading.hpp>

namespace progress {
namespace {

class Progress {
 public:
  explicit Progress(const wend::Config& config)
      : distances_(config.observation, config.params.texts("observe"), "observe"),
        goal_distance_(config.observation, config.params.text("goal") + ".distance", "goal"),
        goal_(config.params.number("goal_reward")),
        collision_(config.params.number("collision")),
        near_(config.params.number("near")),
        safe_distance_(config.params.number("safe_distance")),
        progress_(config.params.number("progress")),
        step_(config.params.number("step")),
        action_costs_(config.params.numbers("action_costs")) {
    if (near_ > collision_)
      throw wend::parameter_error("near", "expected at most collision = " + wend::number_text(collision_) +
                                              ", so that a collision is never the lesser evil, found " +
                                              wend::number_text(near_));
    const bool table = config.action.width() == 1 && config.action[0].count > 0;
    if (!action_costs_.empty() && !table)
      throw wend::parameter_error(
          "action_costs", "expected none for continuous actions, found " + std::to_string(action_costs_.size()));
    if (!action_costs_.empty() && config.action[0].count != action_costs_.size())
      throw wend::parameter_error("action_costs", "expected one cost for each discrete action, " +
                                                      std::to_string(config.action[0].count) + ", found " +
                                                      std::to_string(action_costs_.size()));
  }

  void score(const wend::Batch& batch, std::span<wend_outcome> outcomes) const {
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const double covered = goal_distance_(batch.observations[i]) - goal_distance_(batch.next_observations[i]);
      double reward = progress_ * covered - step_ - cost_of(batch.actions[i][0]);
      const std::uint32_t flags = batch.outcomes[i].flags;
      if (flags & WEND_COLLIDED)
        reward -= collision_;
      else
        reward -= near_ * lack(batch.next_observations[i]);
      if (flags & WEND_ARRIVED) reward += goal_;
      outcomes[i].reward = reward;
    }
  }

 private:
  // 0 where nothing is within the safe distance, 1 on contact.
  double lack(std::span<const double> observation) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < distances_.size(); ++k) least = std::min(least, distances_(observation, k));
    return least < safe_distance_ ? 1 - std::max(least, 0.0) / safe_distance_ : 0;
  }
  double cost_of(double action) const noexcept {
    return action_costs_.empty() ? 0 : action_costs_[static_cast<std::size_t>(action)];
  }

  wend::Reading distances_, goal_distance_;
  double goal_, collision_, near_;
  double safe_distance_;  // m
  double progress_;       // per m
  double step_;           // per decision
  std::vector<double> action_costs_;
};

}  // namespace
}  // namespace progress

WEND_PLUGIN(wend::component<progress::Progress>("wend.progress"))
