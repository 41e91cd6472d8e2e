#include "settings.hpp"

#include "actions.hpp"

namespace hdp {
namespace {

// Everything as printed; what the paper does not say is Settings' own.
Settings paper() {
  return {};
}

Settings robust() {
  Settings s;
  s.td = true;
  s.critic_sees_sign = true;
  s.theta = Theta::clipped;
  s.l_a = 1e-4, s.l_c = 1e-3;
  s.weights = 0.3;
  s.noise = 0.6, s.noise_decay = 0.9, s.noise_floor = 0.02;
  s.success_noise = 0.5, s.success_l_a = 0.5, s.success_l_c = 0.7;
  s.reinitialise = Reinitialise::timeout;
  s.stop_after = 5;
  s.divergence_is_error = true;
  return s;
}

// Beyond both: what is to the right is seen as its mirror image to the left, and the critic can tell what the action is
// worth in which state.  Made for a reward whose crash is worse than what a step costs for ever.
Settings folded() {
  Settings s = robust();
  s.fold = s.critic_bias = s.critic_products = true;
  s.future_after_crash = false;
  s.weights = 0.1;
  s.U_c = 3, s.T_a = 0;  // above any J, so that the actor always drives J up
  s.success_l_a = 0.7, s.success_l_c = 0.85;
  s.reinitialise = Reinitialise::never;
  return s;
}

Reinitialise reinitialise_of(const std::string& name) {
  if (name == "timeout") return Reinitialise::timeout;
  if (name == "crash") return Reinitialise::crash;
  return name == "failure" ? Reinitialise::failure : Reinitialise::never;
}

}  // namespace

Settings settings_from(const wend::Params& params) {
  const std::string preset = params.text("preset");
  Settings s = preset == "paper" ? paper() : preset == "folded" ? folded() : robust();
  const auto is = [&](const char* name, const char* value, bool otherwise) {
    return params.has(name) ? params.text(name) == value : otherwise;
  };
  const auto take = [&](const char* name, double& value) { value = params.number_or(name, value); };
  if (params.has("theta")) s.theta = theta_of(params.text("theta"));
  if (params.has("reinitialise")) s.reinitialise = reinitialise_of(params.text("reinitialise"));
  s.td = is("critic_form", "td", s.td);
  s.critic_sees_sign = is("critic_action", "sign", s.critic_sees_sign);
  s.greedy_bootstrap = is("bootstrap", "greedy", s.greedy_bootstrap);
  s.future_after_crash = is("crash_future", "keep", s.future_after_crash);
  s.future_after_arrival = params.text("arrival_future") == "keep";
  s.divergence_is_error = is("on_divergence", "error", s.divergence_is_error);
  s.hidden = params.count("hidden");
  if (params.has("critic_bias")) s.critic_bias = params.flag("critic_bias");
  if (params.has("critic_products")) s.critic_products = params.flag("critic_products");
  if (params.has("fold")) s.fold = params.flag("fold");
  s.N_a = static_cast<std::uint32_t>(params.count("N_a"));
  s.N_c = static_cast<std::uint32_t>(params.count("N_c"));
  s.rate_every = params.count("rate_every");
  s.similar_trials = params.count("similar_trials");
  s.similar_steps = params.count("similar_steps");
  s.criterion = params.count("criterion");
  if (params.has("stop_after")) s.stop_after = params.count("stop_after");
  take("gain", s.gain), take("weights", s.weights), take("alpha", s.alpha), take("U_c", s.U_c);
  take("l_a", s.l_a), take("l_c", s.l_c), take("T_a", s.T_a), take("T_c", s.T_c);
  take("rate_drop", s.rate_drop), take("rate_floor", s.rate_floor);
  take("clip", s.clip), take("normalise", s.normalise);
  take("noise", s.noise), take("noise_decay", s.noise_decay), take("noise_floor", s.noise_floor);
  take("success_noise", s.success_noise), take("timeout_noise", s.timeout_noise);
  take("success_l_a", s.success_l_a), take("success_l_c", s.success_l_c);
  check_criterion(s.criterion, s.stop_after);
  if (s.noise_floor > s.noise)
    throw wend::parameter_error("noise_floor", "expected at most noise = " + wend::number_text(s.noise) + ", found " +
                                                   wend::number_text(s.noise_floor) + "; lower it too, or raise noise");
  return s;
}

}  // namespace hdp
