// The Boolean multiplexer, in process: the first k bits, read as a number (the first one its highest bit), choose one
// of the 2^k bits that follow.
#pragma once
#include <cstdint>
#include <wend/random.hpp>

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

}  // namespace xcs::testing
