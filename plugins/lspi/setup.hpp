// What the parameters and the columns make of an LSPI: number of actions, basis, mirror.
#pragma once
#include <memory>
#include <wend/config.hpp>
#include <wend/reading.hpp>

#include "basis.hpp"
#include "samples.hpp"

namespace lspi {

std::uint32_t count_actions(const wend::Space& action);

std::unique_ptr<Basis> make_basis(const wend::Params& params, const wend::Reading& state, std::uint32_t actions);

// Each column's partner is the column at the opposite bearing; a mirror twice over changes nothing.
Memory::Mirror find_mirror(const wend::Params& params, const wend::Reading& state, std::uint32_t actions);

}  // namespace lspi
