#include "canonical.hpp"

namespace xcs {

Canonical::Canonical(const Parameters& parameters, std::size_t bits, bool compacts)
    : parameters_(parameters), compacts_(compacts), genetics_(parameters, bits) {}

// COVERING: as long as [M] has fewer actions than theta_mna, a rule for one that it lacks.
void Canonical::cover(Population& population, const std::uint64_t* state, RuleSet& match, wend::Random& random) {
  std::vector<std::uint8_t> has;
  for (;;) {
    has.assign(population.actions(), 0);
    std::uint32_t present = 0;
    double micro = 0;
    for (const std::uint32_t rule : match) {
      micro += population.numerosity(rule);
      std::uint8_t& own = has[population.action(rule)];
      present += 1 - own;
      own = 1;
    }
    if (present >= parameters_.theta_mna) return;
    std::uint64_t skip = random.below(population.actions() - present);
    std::uint32_t action = 0;
    while (has[action] || skip-- > 0) ++action;
    cover_action(population, state, action, micro + 1, parameters_, random);
    delete_to_limit(population, parameters_, random, wheel_);
    population.match(state, match);
  }
}

void Canonical::predict(const Population& population, const RuleSet& match, Predictions& out) const {
  xcs::predict(population, match, out);
}

void Canonical::update(Population& population, const Experience& experience, const RuleSet& acted) {
  xcs::update(population, acted, experience.target, parameters_);
}

void Canonical::discover(Population& population, const Experience& experience, RuleSet& acted, wend::Random& random) {
  if (!experience.explored) return;
  population.time += 1;
  if (parameters_.subsume_action_set) subsume_action_set(population, acted, parameters_);
  double stamps = 0, micro = 0;
  for (const std::uint32_t rule : acted) {
    stamps += population.stamp[rule] * population.numerosity(rule);
    micro += population.numerosity(rule);
  }
  if (micro > 0 && population.time - stamps / micro > parameters_.theta_ga)
    breed(population, experience, acted, random);
}

void Canonical::finish(Population& population) {
  if (compacts_) compact(population, parameters_);
}

// RUN GA.
void Canonical::breed(Population& population, const Experience& experience, const RuleSet& acted,
                      wend::Random& random) {
  population.generations += 1;
  for (const std::uint32_t rule : acted) population.stamp[rule] = population.time;
  const std::uint32_t mother = select(population, acted, random), father = select(population, acted, random);
  children_[0].copy(population, mother);
  children_[1].copy(population, father);
  if (random.chance(parameters_.chi)) genetics_.cross(children_[0], children_[1], random);
  for (Offspring& child : children_) {
    child.numbers.fitness *= parameters_.fitness_reduction;
    genetics_.mutate(child, experience.state, population.actions(), random);
  }
  for (const Offspring& child : children_) insert(population, child, mother, father);
  delete_to_limit(population, parameters_, random, wheel_);
}

// SELECT OFFSPRING: by roulette over F, or the best F a copy among a random share of the set (Butz 2003).
std::uint32_t Canonical::select(const Population& population, const RuleSet& acted, wend::Random& random) {
  if (parameters_.tournament > 0) {
    std::uint32_t best = Population::none;
    for (const std::uint32_t rule : acted) {
      if (!random.chance(parameters_.tournament)) continue;
      if (best == Population::none || population.fitness[rule] * population.numerosity(best) >
                                          population.fitness[best] * population.numerosity(rule))
        best = rule;
    }
    return best != Population::none ? best : acted[random.below(acted.size())];
  }
  double total = 0;
  for (const std::uint32_t rule : acted) total += population.fitness[rule];
  double left = random.uniform() * total;
  for (const std::uint32_t rule : acted)
    if ((left -= population.fitness[rule]) < 0) return rule;
  return acted.back();
}

// DO GA SUBSUMPTION by a parent, else INSERT IN POPULATION.
void Canonical::insert(Population& population, const Offspring& child, std::uint32_t mother,
                       std::uint32_t father) const {
  if (parameters_.subsume_offspring)
    for (const std::uint32_t parent : {mother, father})
      if (population.action(parent) == child.action && may_subsume(population, parent, parameters_) &&
          population.more_general(parent, child.care.data(), child.value.data()))
        return population.set_numerosity(parent, population.numerosity(parent) + 1);
  const std::uint32_t same = population.find(child.care.data(), child.value.data(), child.action);
  if (same != Population::none) return population.set_numerosity(same, population.numerosity(same) + 1);
  population.add(child.care.data(), child.value.data(), child.action, child.numbers);
}

std::uint32_t cover_action(Population& population, const std::uint64_t* state, std::uint32_t action, double match_micro,
                           const Parameters& parameters, wend::Random& random) {
  std::vector<std::uint64_t> care(population.words());
  for (std::size_t j = 0; j < population.bits(); ++j)
    if (!random.chance(parameters.p_hash)) care[j / 64] |= std::uint64_t{1} << (j % 64);
  Numbers numbers;
  numbers.prediction = parameters.prediction_i, numbers.error = parameters.error_i,
  numbers.fitness = parameters.fitness_i;
  numbers.set_size = match_micro;
  numbers.stamp = population.time;
  return population.add(care.data(), state, action, numbers);
}

bool may_subsume(const Population& population, std::uint32_t rule, const Parameters& parameters) {
  return population.experience[rule] > parameters.theta_sub && population.error[rule] < parameters.epsilon_0;
}

void subsume_action_set(Population& population, RuleSet& acted, const Parameters& parameters) {
  std::uint32_t best = Population::none;
  std::size_t fewest = 0;
  for (const std::uint32_t rule : acted) {
    if (!may_subsume(population, rule, parameters)) continue;
    const std::size_t specified = population.specified(rule);
    if (best == Population::none || specified < fewest) best = rule, fewest = specified;
  }
  if (best == Population::none) return;
  for (std::size_t k = 0; k < acted.size();) {
    const std::uint32_t rule = acted[k];
    if (rule == best || !population.more_general(best, population.care(rule), population.value(rule))) {
      ++k;
      continue;
    }
    const auto last = static_cast<std::uint32_t>(population.size() - 1);
    population.set_numerosity(best, population.numerosity(best) + population.numerosity(rule));
    population.remove(rule);  // leaves `acted`, which is tracked, so acted[k] is the next
    if (best == last) best = rule;
  }
}

void delete_to_limit(Population& population, const Parameters& parameters, wend::Random& random) {
  Wheel wheel;
  delete_to_limit(population, parameters, random, wheel);
}

void delete_to_limit(Population& population, const Parameters& parameters, wend::Random& random, Wheel& wheel) {
  while (population.micro() > parameters.limit) {
    wheel.cast_votes(population, parameters);
    const std::uint32_t rule = wheel.draw(random);
    if (rule == Population::none) return;
    if (population.numerosity(rule) > 1)
      population.set_numerosity(rule, population.numerosity(rule) - 1);
    else
      population.remove(rule);
  }
}

void compact(Population& population, const Parameters& parameters) {
  for (std::uint32_t rule = 0; rule < population.size();) {
    const bool young = population.experience[rule] <= parameters.theta_sub;
    std::uint32_t heir = Population::none;
    for (std::uint32_t other = 0; other < population.size() && heir == Population::none; ++other)
      if (population.action(other) == population.action(rule) && population.experience[other] > parameters.theta_sub &&
          (young || population.error[other] < parameters.epsilon_0) &&
          population.more_general(other, population.care(rule), population.value(rule)))
        heir = other;
    if (heir == Population::none) {
      ++rule;
      continue;
    }
    population.set_numerosity(heir, population.numerosity(heir) + population.numerosity(rule));
    population.remove(rule);  // the last takes its number, and is looked at next
  }
}

}  // namespace xcs
