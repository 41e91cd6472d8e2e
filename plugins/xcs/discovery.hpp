// How rules come to be and go: the seam between the learner and the canonical or the paper's operators.
#pragma once
#include <cstdint>
#include <span>
#include <wend/bytes.hpp>
#include <wend/random.hpp>

#include "population.hpp"
#include "update.hpp"

namespace xcs {

// One transition, as the operators see it.
struct Experience {
  const std::uint64_t* state = nullptr;  // the encoded observation on which the action was taken
  std::uint32_t action = 0;
  double reward = 0, target = 0;  // R and P_target
  std::uint32_t flags = 0;        // WEND_TERMINATED, WEND_COLLIDED, ...
  std::span<const double> observation, next_observation;
  bool explored = true;  // false in TRAIN_GREEDY
};

// One object serves one population and keeps what belongs to it, such as a timer.  All chance comes from `random`.
class Discovery {
 public:
  virtual ~Discovery() = default;
  // Makes rules for a state until [M] is as the operators want it, and leaves the new [M] in `match`.
  virtual void cover(Population&, const std::uint64_t* state, RuleSet& match, wend::Random& random) = 0;
  // What rules predict for a state with this [M], by action.
  virtual void predict(const Population&, const RuleSet& match, Predictions& out) const = 0;
  // What was experienced changes the numbers of [A].
  virtual void update(Population&, const Experience&, const RuleSet& acted) = 0;
  // The numbers of [A] were just updated: subsume, breed, merge, evict.  `acted` is tracked by the population.
  virtual void discover(Population&, const Experience&, RuleSet& acted, wend::Random& random) = 0;
  // The training's budget is spent: bring the rule base into its final form.
  virtual void finish(Population&) {}
  // What it keeps besides the population (timers); never random numbers.
  virtual void save(wend::Writer&) const {}
  virtual void load(wend::Reader&) {}
};

}  // namespace xcs
