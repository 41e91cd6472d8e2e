// The Boolean multiplexer, in process: the first k bits, read as a number (the first one its highest bit), choose one
// of the 2^k bits that follow.
#pragma once
#include <cstdint>
#include <wend/random.hpp>

#include "../canonical.hpp"

namespace xcs::testing {

struct Multiplexer {
  std::size_t address;  // k
  std::size_t bits() const { return address + (std::size_t{1} << address); }
  std::uint64_t draw(wend::Random& random) const { return random.word() >> (64 - bits()); }
  std::uint32_t answer(std::uint64_t state) const {
    std::size_t chosen = 0;
    for (std::size_t k = 0; k < address; ++k) chosen = 2 * chosen + (state >> k & 1);
    return static_cast<std::uint32_t>(state >> (address + chosen) & 1);
  }
};

// One exploring trial, as Butz & Wilson's single-step problems are learned.
inline void explore(const Multiplexer& world, Canonical& operators, Population& population, RuleSet& match, RuleSet& acted,
                    wend::Random& random) {
  const std::uint64_t state = world.draw(random);
  population.match(&state, match);
  operators.cover(population, &state, match, random);
  Experience experience;
  experience.state = &state;
  experience.action = static_cast<std::uint32_t>(random.below(2));
  experience.target = experience.action == world.answer(state) ? 1000 : 0;
  advocates(population, match, experience.action, acted);
  operators.update(population, experience, acted);
  operators.discover(population, experience, acted, random);
}

}  // namespace xcs::testing
