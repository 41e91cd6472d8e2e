// Actor and critic, and one decision's learning: equations (3)-(13).
#pragma once
#include <vector>

#include "loops.hpp"
#include "settings.hpp"

namespace hdp {

// What happened between two decisions.  `action` is what the critic saw of the action at x.
struct Step {
  std::span<const double> x;     // X(t - 1)
  double action;                 // u(t - 1), or its sign
  double r;                      // r(t)
  std::span<const double> next;  // X(t)
  double noise;                  // that will be added to u(t)
  double J_before;               // J(t - 1) as it was remembered
  bool crashed, arrived;
  double l_a, l_c;
};

class Agent {
 public:
  Agent(std::size_t inputs, const Settings& settings);

  void draw(wend::Random& random) { actor.draw(random, settings_->weights), critic.draw(random, settings_->weights); }

  double u(std::span<const double> x) const noexcept { return actor_output(actor, x, settings_->gain); }
  double J(std::span<const double> x, double action) noexcept {
    set_input(x, action);
    return critic.sum(z_, settings_->gain);
  }
  double seen(double u) const noexcept {  // of an action by the critic
    return settings_->critic_sees_sign ? (u > 0) - (u < 0) : u;
  }

  // The critic's loop, then the actor's, then J(t) of the updated weights for the next decision.
  double learn(const Step& step);

  Network actor, critic;

 private:
  void set_input(std::span<const double> x, double action) noexcept;  // of the critic
  void learn_value(const Step& step);
  static void hold(Network& network, const Settings& settings) noexcept;

  const Settings* settings_;
  std::vector<double> z_, by_u_;
};

}  // namespace hdp
