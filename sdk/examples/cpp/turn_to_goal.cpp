// A policy in C++: action 1 turns left, 2 right, 0 goes straight on.
#include <wend/plugin.hpp>

class TurnToGoal {
 public:
  explicit TurnToGoal(const wend::Config& config)
      : bearing_(config.observation.index("goal.bearing", "observe")), tolerance_(config.params.number("tolerance")) {
    if (config.action[0].count < 3) throw wend::unsupported("expected at least 3 discrete actions");
  }

  void act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double bearing = observations[i][bearing_];
      actions[i][0] = bearing > tolerance_ ? 1 : bearing < -tolerance_ ? 2 : 0;
    }
  }

 private:
  std::size_t bearing_;
  double tolerance_;
};

WEND_PLUGIN(wend::component<TurnToGoal>("example.turn_to_goal_cpp"))
