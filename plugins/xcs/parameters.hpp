// What the algorithms are told: Butz & Wilson's learning parameters under the field's names.
#pragma once
#include <cstdint>
#include <string>
#include <wend/config.hpp>

namespace xcs {

struct Parameters {
  double limit = 400;                          // N: most micro-classifiers
  double beta = 0.2;                           // learning rate of p, epsilon, F, as
  double alpha = 0.1, epsilon_0 = 10, nu = 5;  // accuracy: alpha (epsilon / epsilon_0)^-nu beyond epsilon_0
  double gamma = 0.71;                         // discount
  double theta_ga = 25;                        // mean time between two GAs in a niche
  double chi = 0.8, mu = 0.04;                 // probability of crossover, of mutation a bit and of the action
  double theta_del = 20, delta = 0.1;  // experience from which a fitness below delta x the mean counts against a rule
  double theta_sub = 20;               // experience of a subsumer
  double p_hash = 0.33;                // probability of '#' in covering
  double theta_mna = 0;                // least number of actions in [M]; 0: all
  double prediction_i = 10, error_i = 0, fitness_i = 0.01;  // of a new rule
  double fitness_reduction = 0.1;                           // of an offspring
  double tournament = 0;           // share of [A] that contests a parent; 0: roulette by fitness
  bool uniform_crossover = false;  // else two-point
  bool subsume_offspring = true, subsume_action_set = true;
  bool gradient = false;  // Butz, Goldberg & Lanzi 2005: p's step x F / sum F
};

// Reads "N", "beta", ... and refuses values that contradict one another.  `bits` is the length of a condition.
Parameters read_parameters(const wend::Params& params, std::size_t bits, std::uint32_t actions);

}  // namespace xcs
