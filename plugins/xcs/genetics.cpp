#include "genetics.hpp"

#include <utility>

namespace xcs {
namespace {

// The bits of word w that lie before `end`.
std::uint64_t bits_before(std::size_t end, std::size_t w) {
  if (end <= 64 * w) return 0;
  return end >= 64 * (w + 1) ? ~std::uint64_t{0} : (std::uint64_t{1} << (end - 64 * w)) - 1;
}

}  // namespace

void Offspring::copy(const Population& population, std::uint32_t parent) {
  care.assign(population.care(parent), population.care(parent) + population.words());
  value.assign(population.value(parent), population.value(parent) + population.words());
  action = population.action(parent);
  numbers = population.numbers(parent);
  numbers.fitness /= numbers.numerosity;
  numbers.numerosity = 1;
  numbers.experience = 0;
  numbers.marks = 0;
}

Genetics::Genetics(const Parameters& parameters, std::size_t bits)
    : uniform_(parameters.uniform_crossover), bits_(bits) {
  unmutated_.assign(bits + 2, 1);  // the action mutates after the condition, as one more place
  for (std::size_t k = 1; k < unmutated_.size(); ++k) unmutated_[k] = unmutated_[k - 1] * (1 - parameters.mu);
}

// APPLY CROSSOVER: the bits x <= j < y change places, or each with probability 1/2.
void Genetics::cross(Offspring& a, Offspring& b, wend::Random& random) const {
  std::size_t x = 0, y = 0;
  if (!uniform_) {
    x = random.below(bits_ + 1), y = random.below(bits_ + 1);
    if (x > y) std::swap(x, y);
  }
  for (std::size_t w = 0; w < a.care.size(); ++w) {
    const std::uint64_t chosen = uniform_ ? random.word() : bits_before(y, w) & ~bits_before(x, w);
    const std::uint64_t care = (a.care[w] ^ b.care[w]) & chosen, value = (a.value[w] ^ b.value[w]) & chosen;
    a.care[w] ^= care, b.care[w] ^= care;
    a.value[w] ^= value, b.value[w] ^= value;
  }
  for (double Numbers::*number : {&Numbers::prediction, &Numbers::error, &Numbers::fitness})
    a.numbers.*number = b.numbers.*number = (a.numbers.*number + b.numbers.*number) / 2;
}

// APPLY MUTATION.  The distance to the next mutated place is drawn, not every place.
void Genetics::mutate(Offspring& child, const std::uint64_t* state, std::uint32_t actions, wend::Random& random) const {
  for (std::size_t j = 0; j <= bits_; ++j) {
    const double u = random.uniform();
    if (u < unmutated_[bits_ + 1 - j]) return;
    for (std::size_t k = 1; u < unmutated_[k]; ++k) ++j;
    if (j == bits_) {
      if (actions < 2) return;
      const auto other = static_cast<std::uint32_t>(random.below(actions - 1));
      child.action = other < child.action ? other : other + 1;
      return;
    }
    const std::uint64_t bit = std::uint64_t{1} << (j % 64);
    std::uint64_t &care = child.care[j / 64], &value = child.value[j / 64];
    if (state != nullptr) {
      care ^= bit;
      value = (value & ~bit) | (state[j / 64] & care & bit);
    } else if (!(care & bit)) {
      care |= bit;
      value |= random.chance(0.5) ? bit : 0;
    } else if (random.chance(0.5)) {
      value ^= bit;
    } else {
      care &= ~bit;
      value &= ~bit;
    }
  }
}

}  // namespace xcs
