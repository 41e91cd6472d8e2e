// Roulette over a whole population: weights that are computed side by side, and a draw from them.
#pragma once
#include <vector>

#include "parameters.hpp"
#include "population.hpp"

namespace xcs {

// Sums run in eight lanes (rule r in lane r % 8), so that a CPU may add them side by side and still get the same
// result.
class Wheel {
 public:
  // Butz & Wilson's deletion vote: as x num, times mean F / F of a copy where that is below delta x the mean and the
  // rule's experience above theta_del.
  void cast_votes(const Population& population, const Parameters& parameters);
  // Any weights >= 0, one a rule.
  void set(Kernel kernel, const std::vector<double>& weights);
  // A rule with probability proportional to its weight; Population::none where no weight is positive.
  std::uint32_t draw(wend::Random& random) const;

 private:
  Kernel kernel_ = Kernel::kScalar;
  std::vector<double> weights_;
  double sums_[8] = {};
};

}  // namespace xcs
