// Values of rules: the prediction array and the update of an action set, equations (1)-(7).
#pragma once
#include <vector>

#include "parameters.hpp"
#include "population.hpp"

namespace xcs {

struct Predictions {
  std::vector<double> array;              // PA(a); NaN where no rule of [M] advocates a
  std::vector<double> weighted, fitness;  // sum F p and sum F, by action
};

// (1) PA(a) = sum F p / sum F over the rules of [M] that advocate a.
void predict(const Population& population, const RuleSet& match, Predictions& out);

// The best action of a prediction array, the first of equals; array.size() where there is none.
std::uint32_t best_action(const std::vector<double>& array);

// (3)-(7) for the rules of [A].
void update(Population& population, const RuleSet& acted, double target, const Parameters& parameters);

// (5) kappa of an error.
double accuracy(double error, const Parameters& parameters);

}  // namespace xcs
