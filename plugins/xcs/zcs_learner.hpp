// ZCS: a zeroth-level classifier system (Wilson 1994).  A rule's strength is what it expects to be paid.
#pragma once
#include "canonical.hpp"
#include "genetics.hpp"
#include "learner.hpp"
#include "votes.hpp"

namespace xcs {

class Zcs : public Learner {
 public:
  explicit Zcs(const wend::Config& config);
  void begin(wend::Rows rows, wend::Episodes episodes);
  void act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions);
  std::uint64_t learn(const wend::Batch& batch);

 private:
  std::unique_ptr<Discovery> make_discovery() const override { return nullptr; }
  void decide(std::uint32_t index, std::span<const double> observation);
  void cover(Population& population, Row& row);
  void pay(Population& population, Row& row, RuleSet& earlier);
  void breed(Population& population, wend::Random& random);
  void evict(Population& population, wend::Random& random);

  double tax_, covering_, breeding_;  // tau, phi, rho
  bool roulette_in_tests_;
  Genetics genetics_;
  std::vector<RuleSet> earlier_;  // [A] of the step before, by row, tracked
  std::vector<double> weights_;   // scratch
  Wheel wheel_;
};

}  // namespace xcs
