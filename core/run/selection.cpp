#include <core/run/selection.hpp>

namespace wend::core {

void Selection::consider(const std::string& bytes, const Training& training, const WorkOptions& options) {
  double arrived = 0, reward = 0;
  std::uint64_t n = 0;
  for (std::size_t w = 0; w < training.selection_worlds.size(); ++w) {
    Cell cell;
    cell.driver = training.driver;
    cell.world = training.selection_worlds[w];
    cell.stream = training.selection_streams[w];
    cell.episodes = training.selection_episodes;
    for (cell.variant = 0; cell.variant < cell.world.variants; ++cell.variant) {
      for (const Episode& episode : run_cell(cell, bytes, "a snapshot", options).episodes)
        for (const RobotEpisode& robot : episode.robots) {
          arrived += robot.flags & WEND_ARRIVED ? 1 : 0;
          reward += robot.reward;
          ++n;
        }
    }
  }
  const double success = n ? arrived / static_cast<double>(n) : 0;
  const double mean_reward = n ? reward / static_cast<double>(n) : 0;
  if (success > success_ || (success == success_ && mean_reward > reward_)) {
    success_ = success;
    reward_ = mean_reward;
    best_ = bytes;
  }
}

}  // namespace wend::core
