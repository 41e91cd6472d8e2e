// All that can be set about learning, and the presets.
#pragma once
#include <cstdint>
#include <string>
#include <wend/config.hpp>

#include "navigation.hpp"

namespace hdp {

enum class Reinitialise { never, timeout, crash, failure };

struct Settings {
  // what is learned
  std::size_t hidden = 6;
  double gain = 1, weights = 1;
  bool critic_bias = false, critic_products = false;
  Theta theta = Theta::printed;
  // how
  bool td = false, critic_sees_sign = false, greedy_bootstrap = true;
  bool future_after_crash = true, future_after_arrival = true;
  double alpha = 0.95, U_c = 0;
  double l_a = 1e-5, l_c = 1e-4;
  std::uint32_t N_a = 100, N_c = 80;
  double T_a = 0.02, T_c = 0.05;
  double rate_drop = 0, rate_floor = 0.005;
  std::uint64_t rate_every = 5;
  double clip = 0, normalise = 0;
  bool fold = false;
  // from trial to trial
  double noise = 0, noise_decay = 1, noise_floor = 0, timeout_noise = 0;
  double success_noise = 1, success_l_a = 1, success_l_c = 1;
  Reinitialise reinitialise = Reinitialise::never;
  std::uint64_t similar_trials = 0, similar_steps = 5;
  std::uint64_t criterion = 3, stop_after = 3;
  bool divergence_is_error = false;
};

// The preset, and what is given beside it: a parameter whose schema has no default is there only if it was given.
Settings settings_from(const wend::Params& params);

}  // namespace hdp
