// wend.random and wend.goal_direct -- the two controls that need no paper.
//
//   random        a ~ uniform over the action space, from the row's episode seed
//   goal_direct   turn towards the goal's bearing, drive; obstacles are not looked at (wend/steer.hpp)
#include <cmath>
#include <string>
#include <vector>
#include <wend/plugin.hpp>
#include <wend/reading.hpp>
#include <wend/steer.hpp>

namespace basic {
namespace {

class RandomPolicy {
 public:
  explicit RandomPolicy(const wend::Config& config) : action_(config.action), draws_(config.rows(), wend::Random(0)) {
    for (const wend_column& column : action_.columns())
      if (column.count == 0 && !(std::isfinite(column.low) && std::isfinite(column.high)))
        throw wend::unsupported("cannot draw uniformly from the action \"" + std::string(column.name) +
                                "\": expected finite bounds, found none");
  }

  void begin(wend::Rows rows, wend::Episodes episodes) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      draws_[rows[i]] = wend::Random(wend::stream(episodes[i].seed, "wend.random"));
  }

  void act(wend::Rows rows, wend::Matrix<const double>, wend::Matrix<double> actions) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < action_.width(); ++j) {
        wend::Random& draw = draws_[rows[i]];
        const wend_column& column = action_[j];
        actions[i][j] =
            column.count > 0 ? static_cast<double>(draw.below(column.count)) : draw.uniform(column.low, column.high);
      }
  }

 private:
  wend::Space action_;
  std::vector<wend::Random> draws_;  // of each row
};

class GoalDirect {
 public:
  explicit GoalDirect(const wend::Config& config)
      : bearing_(config.observation, config.params.text("goal") + ".bearing", "goal"),
        steer_(config),
        speed_(config.params.number_or("speed", steer_.top_speed())) {
    if (!steer_.discrete() && !std::isfinite(speed_))
      throw wend::parameter_error(
          "speed", "expected a speed, since neither the body nor the action space bounds it; found none");
  }

  void act(wend::Rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) {
    for (std::size_t i = 0; i < observations.rows(); ++i) steer_.towards(bearing_(observations[i]), speed_, actions[i]);
  }

 private:
  wend::Reading bearing_;
  wend::Steer steer_;
  double speed_;  // m/s
};

}  // namespace
}  // namespace basic

WEND_PLUGIN(wend::component<basic::RandomPolicy>("wend.random"), wend::component<basic::GoalDirect>("wend.goal_direct"))
