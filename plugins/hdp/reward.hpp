// wend.seek_and_avoid -- the continuous reinforcement of equations (19)-(21), of the state that a step led to.
#pragma once
#include <vector>
#include <wend/component.hpp>

#include "navigation.hpp"

namespace hdp {

inline constexpr double usual_beta = 0.75;  // (20)

class SeekAndAvoid {
 public:
  explicit SeekAndAvoid(const wend::Config& config)
      : navigation_(config.observation, config.params, theta_of(config.params.text("theta"))),
        tie_(tie_of(config.params.text("tie"))),
        beta_(config.params.number("beta")),
        crash_(config.params.number("crash")),
        x_(navigation_.size()) {}

  void score(const wend::Batch& batch, std::span<wend_outcome> outcomes) {
    for (std::size_t i = 0; i < batch.size(); ++i) {
      navigation_.look(batch.next_observations[i], x_);
      const bool crashed = (batch.outcomes[i].flags & WEND_COLLIDED) != 0;
      outcomes[i].reward = crashed ? crash_ : reinforcement(x_, tie_, beta_);
    }
  }

 private:
  Navigation navigation_;
  Tie tie_;
  double beta_, crash_;
  std::vector<double> x_;
};

}  // namespace hdp
