// The Boolean multiplexer as a function of its inputs.
#pragma once
#include <cstdint>

namespace multiplexer {

// k address bits, the most significant first, then 2^k data bits; the answer is the data bit that the address names.
// An input is a number of size() bits whose most significant bit is bit 0 of the multiplexer.
class Function {
 public:
  explicit constexpr Function(std::uint32_t address_bits) noexcept : k_(address_bits) {}

  constexpr std::uint32_t size() const noexcept { return k_ + (1u << k_); }
  constexpr std::uint64_t inputs() const noexcept { return std::uint64_t{1} << size(); }
  constexpr std::uint32_t bit(std::uint64_t input, std::uint32_t i) const noexcept {
    return static_cast<std::uint32_t>(input >> (size() - 1 - i) & 1);
  }
  constexpr std::uint32_t answer(std::uint64_t input) const noexcept {
    const auto address = static_cast<std::uint32_t>(input >> (size() - k_));
    return bit(input, k_ + address);
  }

 private:
  std::uint32_t k_;
};

}  // namespace multiplexer
