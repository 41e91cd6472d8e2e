// The operators of Wilson 1995 and Butz & Wilson 2002: covering, GA in the action set, subsumption, deletion,
// compaction.
#pragma once
#include "discovery.hpp"
#include "genetics.hpp"
#include "parameters.hpp"
#include "votes.hpp"

namespace xcs {

class Canonical : public Discovery {
 public:
  // `compacts`: finish() reduces the rule base.
  Canonical(const Parameters& parameters, std::size_t bits, bool compacts);

  void cover(Population&, const std::uint64_t* state, RuleSet& match, wend::Random&) override;
  void predict(const Population&, const RuleSet& match, Predictions& out) const override;
  void update(Population&, const Experience&, const RuleSet& acted) override;
  void discover(Population&, const Experience&, RuleSet& acted, wend::Random&) override;
  void finish(Population&) override;

  // The GA on [A], whatever the time of its last run.
  void breed(Population&, const Experience&, const RuleSet& acted, wend::Random&);

 private:
  std::uint32_t select(const Population&, const RuleSet& acted, wend::Random&);
  void insert(Population&, const Offspring&, std::uint32_t mother, std::uint32_t father) const;

  Parameters parameters_;
  bool compacts_;
  Genetics genetics_;
  Offspring children_[2];
  Wheel wheel_;
};

// ---- building blocks, for other operators too

// A new rule that matches the state, each bit '#' with probability P_hash; `match_micro` is its first guess of as.
std::uint32_t cover_action(Population&, const std::uint64_t* state, std::uint32_t action, double match_micro,
                           const Parameters&, wend::Random&);

// True if the rule is accurate and experienced enough to take others in.
bool may_subsume(const Population&, std::uint32_t rule, const Parameters&);

// The most general of those in [A] takes the more special ones in.  `acted` is tracked by the population.
void subsume_action_set(Population&, RuleSet& acted, const Parameters&);

// Deletes micro-classifiers by roulette over their votes until at most N are left.
void delete_to_limit(Population&, const Parameters&, wend::Random&);
void delete_to_limit(Population&, const Parameters&, wend::Random&, Wheel& scratch);

// Takes rules out whose every state and action another rule of [P] covers too: one that is more general and
// experienced, and accurate unless the rule to go has too little experience.  So no action that had a rule in a state
// loses its last.
void compact(Population&, const Parameters&);

}  // namespace xcs
