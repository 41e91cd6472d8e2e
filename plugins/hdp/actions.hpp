// What wend.hdp and wend.random_redraw read alike: the three actions, and when a policy counts as learned.
#pragma once
#include <cstdint>
#include <string>
#include <wend/config.hpp>

namespace hdp {

// The discrete actions for u > 0, u = 0 and u < 0.
inline void read_actions(const wend::Config& config, double (&actions)[3]) {
  const std::vector<double> numbers = config.params.numbers("actions");
  const std::uint64_t count = config.action.width() == 1 ? config.action[0].count : 0;
  if (count == 0)
    throw wend::unsupported("expected discrete actions (a table in the robot's definition), found continuous ones");
  for (std::size_t k = 0; k < 3; ++k) {
    actions[k] = numbers[k];
    if (!(actions[k] < static_cast<double>(count)))
      throw wend::parameter_error(wend::Params::element("actions", k),
                                  "expected an action 0.." + std::to_string(count - 1) + ", found " +
                                      std::to_string(static_cast<std::uint64_t>(actions[k])));
  }
}

// Learning that stops before the criterion could never meet it.
inline void check_criterion(std::uint64_t criterion, std::uint64_t stop_after) {
  if (stop_after != 0 && stop_after < criterion)
    throw wend::parameter_error("stop_after", "expected at least criterion = " + std::to_string(criterion) +
                                                  ", or 0 for never, found " + std::to_string(stop_after));
}

}  // namespace hdp
