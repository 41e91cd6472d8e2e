#include "settings.hpp"

#include <string>

namespace lssvm {
namespace {

constexpr std::uint64_t most_actions = 256;

std::uint32_t count_actions(const wend::Space& action) {
  if (action.width() != 1)
    throw wend::unsupported("expected one column of discrete actions, found " + std::to_string(action.width()) +
                            " columns; give the robot an action table");
  if (action[0].count == 0)
    throw wend::unsupported("expected discrete actions, found the continuous column \"" + std::string(action[0].name) +
                            "\"; give the robot an action table");
  if (action[0].count < 2 || action[0].count > most_actions)
    throw wend::unsupported("expected 2.." + std::to_string(most_actions) + " actions to choose from, found " +
                            std::to_string(action[0].count));
  return static_cast<std::uint32_t>(action[0].count);
}

Switching read_switch(const wend::Params& params) {
  Switching out;
  const std::string kind = params.text("switch/kind");
  if (kind == "window") {
    out.kind = Switching::Kind::window;
    out.threshold = params.number("switch/threshold");
    out.n = params.count("switch/n");
  } else if (kind == "per_state") {
    out.kind = Switching::Kind::per_state;
  } else {
    out.episodes = params.count("switch/episodes");
  }
  return out;
}

// What one parameter alone cannot tell.
void check(const Settings& s, const Features& features) {
  if (s.coldest > s.hottest)
    throw wend::parameter_error("temperature", "expected the lowest first, found " + wend::number_text(s.coldest) +
                                                   " before " + wend::number_text(s.hottest));
  if (s.retrain_every > s.window)
    throw wend::parameter_error("retrain_every", "expected at most window = " + std::to_string(s.window) +
                                                     ", or samples are forgotten before they are learned from, found " +
                                                     std::to_string(s.retrain_every));
  const bool advised = s.switching.kind != Switching::Kind::after_episodes || s.switching.episodes > 0;
  if (advised && !features.has_goal())
    throw wend::parameter_error("goal",
                                "expected a goal's sensor, for condition (9) of the advice needs its distance; found "
                                "none: name one, or set switch to after_episodes with 0 episodes");
}

}  // namespace

Settings read_settings(const wend::Config& config, const Features& features) {
  const wend::Params& params = config.params;
  Settings s{};
  s.critic.actions = count_actions(config.action);
  s.critic.features = features.size();
  s.critic.discount = params.number("gamma");
  s.critic.sigma = params.number("sigma");
  s.critic.c = params.number("C");
  s.critic.action_distance = params.number("action_distance");
  s.critic.ordinal = params.text("actions") == "ordinal";
  s.critic.caution = params.number("caution");
  s.switching = read_switch(params);
  s.advice_c = params.number("advice_C");
  s.advice = params.number("advice");
  s.coldest = params.number("temperature/0");
  s.hottest = params.number("temperature/1");
  s.annealing = params.number("annealing");
  s.theta = params.number("theta");
  s.window = params.count("window");
  s.advice_window = params.count("advice_window");
  s.retrain_every = params.count("retrain_every");
  s.sweeps = static_cast<std::uint32_t>(params.count("sweeps"));
  s.final_sweeps = static_cast<std::uint32_t>(params.count("final_sweeps"));
  s.reject_collisions = params.text("collisions") == "reject";
  s.forget = params.text("forget") == "redundant" ? Forget::redundant : Forget::oldest;
  check(s, features);
  return s;
}

}  // namespace lssvm
