// The paper's operators (sections 2.1.3 and 3.2) on the rule store of wend.xcs:
//
//   selection   the strong survive; a rule that was punished gets an offspring whose condition is the present string,
//               with nothing left out, and whose action is another one
//   crossover   is covering: [M] lacks an action -> a rule for it; the weakest rule makes room
//   mutation    is merging, every K steps: two strong rules of one action whose conditions differ in one specified bit
//               and whose predictions differ by no more than a tolerance become one rule with '#' there
//
// Fitness (12)-(14): f = fit1 fit2; fit1 is 1 while the last clearance after the rule's action was above the safety
// distance; fit2 is the rule's accuracy (XCS) or its strength (LCS).
#pragma once
#include <functional>
#include <memory>
#include <wend/config.hpp>
#include <wend/reading.hpp>

#include "discovery.hpp"
#include "parameters.hpp"

namespace xcs {

// Marks of rules, beside kSeeded.
inline constexpr std::uint8_t kUnsafe = 2;  // fit1 = 0 when the rule acted last
inline constexpr std::uint8_t kMerged = 4;  // came from merging

struct PaperOptions {
  bool strength = false;       // fit2 is the prediction itself, and all rules of [M] have the same say; else accuracy
  double safety_distance = 0;  // m: R of (12)
  std::uint64_t merge_every = 0;  // K, learned steps; 0: never
  double merge_tolerance = 0;     // largest |P1 - P2|
  double merge_experience = 0;    // least experience of both
  double initial_rules = 0;       // random rules that a new rule base starts with
  double specialise = 0;          // probability that a punished rule with '#' also gets an offspring of its own action
  double beta_least = 0;   // the learning rate falls with experience down to this; at least `beta`: it is constant
  double inherited = 0;    // experience of a covering rule, with what the nearest rules predict; 0: neither
  double seeded_beta = 0;  // learning rate of a seeded rule until it has `seeded_experience`; 0: as any other
  double seeded_experience = 0;
};

class PaperOperators : public Discovery {
 public:
  // `clearance`: the distance columns after the action that (12) takes the least of.
  PaperOperators(const Parameters& parameters, const PaperOptions& options, wend::Reading clearance);

  void cover(Population&, const std::uint64_t* state, RuleSet& match, wend::Random&) override;
  void predict(const Population&, const RuleSet& match, Predictions& out) const override;
  void update(Population&, const Experience&, const RuleSet& acted) override;
  void discover(Population&, const Experience&, RuleSet& acted, wend::Random&) override;
  void save(wend::Writer& writer) const override { writer.put(steps_); }
  void load(wend::Reader& reader) override { steps_ = reader.get<std::uint64_t>(); }

 private:
  bool safe(const Experience& experience) const;
  double rate(const Population&, std::uint32_t rule) const;
  void fill(Population&, wend::Random&) const;
  void inherit(const Population&, const std::uint64_t* state);
  void make_room(Population&, const std::uint64_t* state) const;
  void breed_punished(Population&, const Experience&, RuleSet& acted, wend::Random&);
  void add_exact(Population&, const std::uint64_t* state, std::uint32_t action, double prediction);

  Parameters parameters_;
  PaperOptions options_;
  wend::Reading clearance_;
  std::uint64_t steps_ = 0;  // learned ones: the timer of merging
  RuleSet match_;            // scratch, as are all below
  Predictions predictions_;
  std::vector<std::uint8_t> lacking_;
  std::vector<double> inherited_, weights_;  // by action, as is the next
  std::vector<int> distances_;
  mutable std::vector<std::uint8_t> safe_;
};

// Merges pairs until none is left; returns how many rules it took out.
std::size_t merge(Population& population, const PaperOptions& options);

// A factory of operators, one object for each rule base.
std::function<std::unique_ptr<Discovery>()> paper_operators(const wend::Config& config, const Parameters& parameters);

}  // namespace xcs
