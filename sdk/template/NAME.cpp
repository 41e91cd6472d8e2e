// my.@NAME@: drives towards the goal, and turns away from what is near.  Change act() into your own policy.
#include <wend/plugin.hpp>

class @CLASS@ {
 public:
  explicit @CLASS@(const wend::Config& config)
      : ranges_(config.observation.select(config.params.texts("observe"), "observe")),
        bearing_(config.observation.index("goal.bearing", "goal")),
        near_(config.params.number("near")),
        observation_(config.observation) {
    if (config.action[0].count < 3) throw wend::unsupported("expected the actions straight, left, right; found fewer than 3");
  }

  // One action row for each observation row.  Columns were picked by name, so any robot with such sensors will do.
  void act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto seen = observations[i];
      double left = near_, right = near_;  // m to the nearest obstacle on each side
      for (const std::size_t column : ranges_) {
        double& side = observation_[column].at >= 0 ? left : right;
        if (seen[column] < side) side = seen[column];
      }
      double turn = seen[bearing_];
      if (left < near_ || right < near_) turn = left < right ? -1 : 1;
      actions[i][0] = turn > 0.1 ? 1 : turn < -0.1 ? 2 : 0;
    }
  }

 private:
  std::vector<std::uint32_t> ranges_;
  std::size_t bearing_;
  double near_;  // m
  wend::Space observation_;
};

WEND_PLUGIN(wend::component<@CLASS@>("my.@NAME@"))
