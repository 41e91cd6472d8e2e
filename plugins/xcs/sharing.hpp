// `rule_base: published`: robots with rule bases of their own send their merged rules to a public one, from which the
// others take what they lack (the paper's section 3.3, step 6).
#pragma once
#include <span>

#include "parameters.hpp"
#include "population.hpp"

namespace xcs {

// Every population receives the others' experienced rules with a '#' whose condition and action it has not, as long as
// it has room; a rule that several offer comes from the most experienced one.
void publish(std::span<Population* const> populations, const Parameters& parameters);

}  // namespace xcs
