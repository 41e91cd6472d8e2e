#include "agent.hpp"

#include <algorithm>

namespace hdp {

Agent::Agent(std::size_t inputs, const Settings& settings)
    : actor(inputs, settings.hidden),
      critic(inputs + 1 + (settings.critic_products ? inputs : 0) + settings.critic_bias, settings.hidden),
      settings_(&settings),
      z_(critic.inputs, 1),
      by_u_(critic.inputs, 0) {}

// x, the action, the products of both, 1; and what changes by one in the action.
void Agent::set_input(std::span<const double> x, double action) noexcept {
  std::copy(x.begin(), x.end(), z_.begin());
  z_[x.size()] = action, by_u_[x.size()] = 1;
  if (!settings_->critic_products) return;
  for (std::size_t i = 0; i < x.size(); ++i) {
    z_[x.size() + 1 + i] = action * x[i];
    by_u_[x.size() + 1 + i] = x[i];
  }
}

double Agent::learn(const Step& step) {
  const Settings& s = *settings_;
  learn_value(step);
  hold(critic, s);
  const ActorTask task{s.gain, s.U_c, step.l_a, s.T_a, s.N_a};
  set_input(step.next, 0);
  actor_loop(actor, critic, step.next, z_, by_u_, task);
  hold(actor, s);
  return J(step.next, seen(u(step.next)));
}

// paper: e_c = alpha J(t) - (J(t - 1) - r(t)), the gradient through J(t), which the critic moves.
// td:    e_c = J(t - 1) - (r(t) + alpha J(t)), the gradient through J(t - 1), against a target that is held.
void Agent::learn_value(const Step& step) {
  const Settings& s = *settings_;
  CriticTask task{s.gain, 1, step.r, step.l_c, s.T_c, s.N_c};
  const double u_next = u(step.next) + (s.greedy_bootstrap ? 0 : step.noise);
  const bool future = (!step.crashed || s.future_after_crash) && (!step.arrived || s.future_after_arrival);
  if (s.td) {
    if (future) task.target += s.alpha * J(step.next, seen(u_next));
    set_input(step.x, step.action);
    critic_loop(critic, z_, task);
  } else {
    task.slope = future ? s.alpha : 0;
    task.target = step.J_before - step.r;
    set_input(step.next, seen(u_next));
    critic_loop(critic, z_, task);
  }
}

void Agent::hold(Network& network, const Settings& settings) noexcept {
  for (std::vector<double>* layer : {&network.first, &network.second}) {
    double largest = 0;
    for (const double w : *layer) largest = std::max(largest, std::fabs(w));
    if (settings.normalise > 0 && largest > settings.normalise)
      for (double& w : *layer) w /= largest;
    if (settings.clip > 0 && largest > settings.clip)
      for (double& w : *layer) w = std::clamp(w, -settings.clip, settings.clip);
  }
}

}  // namespace hdp
