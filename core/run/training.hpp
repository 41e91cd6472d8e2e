// Runs one training: episodes in the training worlds until the budget is spent, with snapshots on the way.
#pragma once
#include <core/run/cell.hpp>

namespace wend::core {

// `initial`: the bytes of the state file the training starts from, or empty.
TrainingResult run_training(const Training& training, const std::string& initial, const std::string& initial_name,
                            const WorkOptions& options);

}  // namespace wend::core
