// The parameters of wend.lssvm_q, checked against each other and the action space.
#pragma once
#include <wend/config.hpp>

#include "cooperation.hpp"
#include "critic.hpp"
#include "features.hpp"

namespace lssvm {

struct Settings {
  CriticSettings critic;
  Switching switching;
  double advice_c, advice, coldest, hottest, annealing, theta;
  std::uint64_t window, advice_window, retrain_every;
  std::uint32_t sweeps, final_sweeps;
  bool reject_collisions;
  Forget forget;
};

Settings read_settings(const wend::Config& config, const Features& features);

}  // namespace lssvm
