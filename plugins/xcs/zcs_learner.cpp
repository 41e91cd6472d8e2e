#include "zcs_learner.hpp"

#include <algorithm>
#include <numeric>

namespace xcs {
namespace {

constexpr double least_strength = 1e-6;  // for roulettes

double sum_of(const Population& population, const RuleSet& set) {
  double sum = 0;
  for (const std::uint32_t rule : set) sum += population.prediction[rule];
  return sum;
}

}  // namespace

// Strength is kept as the prediction.  Every rule is one micro-classifier, as in the paper.
Zcs::Zcs(const wend::Config& config)
    : Learner(config, "wend.zcs"),
      tax_(config.params.number("tau")),
      covering_(config.params.number("phi")),
      breeding_(config.params.number("rho")),
      roulette_in_tests_(config.params.text("test_selection") == "roulette"),
      genetics_(parameters_, encoder_.bits()),
      earlier_(config.rows()) {
  for (std::uint32_t row = 0; row < earlier_.size(); ++row) base_of(row).population.track(&earlier_[row]);
}

void Zcs::begin(wend::Rows rows, wend::Episodes episodes) {
  Learner::begin(rows, episodes);
  for (const std::uint32_t row : rows) earlier_[row].clear();
}

void Zcs::act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    decide(rows[i], observations[i]);
    actions[i][0] = rows_[rows[i]].action;
  }
}

// The action of a rule of [M] drawn by strength; the action with the most strength where tests are greedy.
void Zcs::decide(std::uint32_t index, std::span<const double> observation) {
  Row& row = rows_[index];
  Population& population = base_of(index).population;
  encoder_.encode(observation, row.state.data());
  population.match(row.state.data(), match_);
  if (learns(row)) cover(population, row);
  if (match_.empty() && takes_nearest()) population.nearest(row.state.data(), match_);
  weights_.assign(actions_, 0);
  for (const std::uint32_t rule : match_) weights_[population.action(rule)] += population.prediction[rule];
  if (learns(row) || roulette_in_tests_) {
    const std::size_t drawn = row.random.weighted(weights_);
    row.action = static_cast<std::uint32_t>(drawn < actions_ ? drawn : row.random.below(actions_));
  } else {
    row.action = match_.empty() ? static_cast<std::uint32_t>(row.random.below(actions_)) : best_action(weights_);
  }
  row.prediction = weights_[row.action];
  row.matching = static_cast<double>(match_.size());
  advocates(population, match_, row.action, row.acted);
  row.decided = true;
  if (learns(row)) pay(population, row, earlier_[index]);
}

// The bucket: a share beta of [A]'s strength goes, discounted, to the [A] of the step before; the rest of [M] is taxed.
void Zcs::pay(Population& population, Row& row, RuleSet& earlier) {
  double bucket = 0;
  for (const std::uint32_t rule : row.acted) {
    const double share = parameters_.beta * population.prediction[rule];
    population.prediction[rule] -= share;
    bucket += share;
  }
  for (const std::uint32_t rule : earlier)
    population.prediction[rule] += parameters_.gamma * bucket / static_cast<double>(earlier.size());
  for (const std::uint32_t rule : match_)
    if (population.action(rule) != row.action) population.prediction[rule] *= 1 - tax_;
}

std::uint64_t Zcs::learn(const wend::Batch& batch) {
  std::uint64_t used = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const std::uint32_t index = batch.rows[i];
    Row& row = rows_[index];
    // A bucket brigade needs its own decisions: what somebody else decided can't be learned from.
    if (!learns(row) || !row.decided || action_of(batch.actions[i]) != row.action) continue;
    Population& population = base_of(index).population;
    const double reward = checked_reward(batch.outcomes[i].reward);
    for (const std::uint32_t rule : row.acted) {
      population.prediction[rule] += parameters_.beta * reward / static_cast<double>(row.acted.size());
      population.experience[rule] += 1;
    }
    earlier_[index] = row.acted;
    row.acted.clear();
    row.decided = false;
    if (batch.outcomes[i].flags & WEND_TERMINATED) earlier_[index].clear();
    population.time += 1;
    if (row.random.chance(breeding_)) {
      const double generation = population.generations;
      breed(population, row.random);
      tell_generation(population, generation);
    }
    learned_one();
    ++used;
  }
  return used;
}

// Covering: [M] has less than phi times the strength of a mean [M] of its size.
void Zcs::cover(Population& population, Row& row) {
  const double all = std::accumulate(population.prediction.begin(), population.prediction.end(), 0.0);
  const double mean = population.size() ? all / population.micro() : 0;
  if (!match_.empty() && sum_of(population, match_) >= covering_ * mean) return;
  Parameters initial = parameters_;
  if (population.size()) initial.prediction_i = mean;
  while (population.micro() >= parameters_.limit) evict(population, row.random);
  cover_action(population, row.state.data(), static_cast<std::uint32_t>(row.random.below(actions_)), 1, initial,
               row.random);
  population.match(row.state.data(), match_);
}

// A rule goes with probability proportional to the inverse of its strength.
void Zcs::evict(Population& population, wend::Random& random) {
  weights_.clear();
  for (const double strength : population.prediction) weights_.push_back(1 / std::max(strength, least_strength));
  wheel_.set(population.kernel(), weights_);
  population.remove(wheel_.draw(random));
}

// The GA of the whole population: two parents, drawn by strength, give half of theirs to two offspring.
void Zcs::breed(Population& population, wend::Random& random) {
  if (population.size() == 0) return;
  population.generations += 1;
  weights_.clear();
  for (const double strength : population.prediction) weights_.push_back(std::max(strength, least_strength));
  wheel_.set(population.kernel(), weights_);
  const std::uint32_t parents[2] = {wheel_.draw(random), wheel_.draw(random)};
  Offspring children[2];
  for (int k = 0; k < 2; ++k) {
    population.prediction[parents[k]] /= 2;
    children[k].copy(population, parents[k]);
  }
  if (random.chance(parameters_.chi)) genetics_.cross(children[0], children[1], random);
  for (Offspring& child : children) {
    genetics_.mutate(child, nullptr, actions_, random);
    while (population.micro() >= parameters_.limit) evict(population, random);
    population.add(child.care.data(), child.value.data(), child.action, child.numbers);
  }
}

}  // namespace xcs
