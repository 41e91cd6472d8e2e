// Runs one cell: the episodes of an arm, frozen, in one variant of a world.
#pragma once
#include <core/experiment/unit.hpp>
#include <core/run/instance.hpp>

#include <string>

namespace wend::core {

struct WorkOptions {
  Libraries* libraries = nullptr;
  const Listener* listener = nullptr;
  std::uint32_t batch = 16;    // episodes that run side by side; never changes a result
  std::string scratch;         // folder for traces and states
};

// `state`: the bytes of the state file to test, empty where nothing is learned; `state_name` is for messages.
CellResult run_cell(const Cell& cell, const std::string& state, const std::string& state_name, const WorkOptions& options);

// Only creates what the cell needs; throws as run_cell would.
void check_cell(const Cell& cell, const WorkOptions& options);

}  // namespace wend::core
