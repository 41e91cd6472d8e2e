#include "parameters.hpp"

namespace xcs {
Parameters read_parameters(const wend::Params& params, std::size_t bits, std::uint32_t actions) {
  Parameters p;
  p.limit = params.number("N");
  p.p_hash = params.number("P_hash");
  // One arm may serve worlds of different sizes: the entry with the most bits that the condition has wins.
  double most = -1;
  std::string limit = "N";  // where it stands
  for (std::size_t i = 0; i < params.size("by_bits"); ++i) {
    const std::string entry = wend::Params::element("by_bits", i);
    const double from = params.number(entry + "/bits");
    if (from > static_cast<double>(bits) || from <= most) continue;
    most = from;
    if (params.has(entry + "/N")) p.limit = params.number(limit = entry + "/N");
    p.p_hash = params.number_or(entry + "/P_hash", p.p_hash);
  }
  p.beta = params.number("beta");
  p.alpha = params.number_or("alpha", p.alpha);
  p.epsilon_0 = params.number_or("epsilon_0", p.epsilon_0);
  p.nu = params.number_or("nu", p.nu);
  p.gamma = params.number("gamma");
  p.theta_ga = params.number_or("theta_GA", p.theta_ga);
  p.chi = params.number("chi");
  p.mu = params.number("mu");
  p.theta_del = params.number_or("theta_del", p.theta_del);
  p.delta = params.number_or("delta", p.delta);
  p.theta_sub = params.number_or("theta_sub", p.theta_sub);
  p.theta_mna = params.number_or("theta_mna", p.theta_mna);
  p.prediction_i = params.number("prediction_I");
  p.error_i = params.number_or("error_I", p.error_i);
  p.fitness_i = params.number_or("fitness_I", p.fitness_i);
  p.fitness_reduction = params.number_or("fitness_reduction", p.fitness_reduction);
  p.tournament = params.number_or("tournament", p.tournament);
  p.uniform_crossover = params.text("crossover") == "uniform";
  p.subsume_offspring = params.number_or("subsume_offspring", p.subsume_offspring) != 0;
  p.subsume_action_set = params.number_or("subsume_action_set", p.subsume_action_set) != 0;
  p.gradient = params.number_or("gradient", p.gradient) != 0;

  if (p.theta_mna == 0) p.theta_mna = actions;
  if (p.theta_mna > actions)
    throw wend::parameter_error("theta_mna", "expected at most the " + std::to_string(actions) +
                                                 " actions that there are, found " + wend::number_text(p.theta_mna) +
                                                 "; 0 stands for all of them");
  if (p.limit < actions)
    throw wend::parameter_error(limit, "expected room for a rule of each of the " + std::to_string(actions) +
                                           " actions, found a population of " + wend::number_text(p.limit));
  return p;
}

}  // namespace xcs
