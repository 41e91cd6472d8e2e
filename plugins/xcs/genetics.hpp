// Offspring of rules: copying, crossover, mutation.
#pragma once
#include <vector>

#include "parameters.hpp"
#include "population.hpp"

namespace xcs {

struct Offspring {
  std::vector<std::uint64_t> care, value;
  std::uint32_t action = 0;
  Numbers numbers;
  // One copy of a rule: its fitness a copy, numerosity 1, experience 0.
  void copy(const Population& population, std::uint32_t parent);
};

class Genetics {
 public:
  Genetics(const Parameters& parameters, std::size_t bits);
  // Conditions change a part; prediction, error and fitness become the means.
  void cross(Offspring& a, Offspring& b, wend::Random& random) const;
  // Each bit and the action with probability mu.  Within the niche of `state`: '#' becomes the state's bit, a specified
  // bit becomes '#'.  Without a state a bit becomes one of the other two.  The action becomes another one.
  void mutate(Offspring& child, const std::uint64_t* state, std::uint32_t actions, wend::Random& random) const;

 private:
  bool uniform_;
  std::size_t bits_;
  std::vector<double> unmutated_;  // (1 - mu)^k: the probability that k places in a row stay as they are
};

}  // namespace xcs
