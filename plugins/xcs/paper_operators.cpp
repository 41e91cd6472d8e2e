// The paper's operators: see paper_operators.hpp.  Numerosity stays 1: merging leaves no copies behind.
#include "paper_operators.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "canonical.hpp"

namespace xcs {
namespace {

PaperOptions read_options(const wend::Params& params) {
  PaperOptions options;
  options.strength = params.text("fitness") == "strength";
  options.safety_distance = params.number("safety_distance");
  options.merge_every = params.count("merge_every");
  options.merge_tolerance = params.number("merge_tolerance");
  options.merge_experience = params.number("merge_experience");
  options.initial_rules = params.number("initial_rules");
  options.specialise = params.number("specialise");
  options.beta_least = params.number("beta_least");
  options.inherited = params.number("inherited");
  options.seeded_beta = params.number("seeded_beta");
  options.seeded_experience = params.number("seeded_experience");
  return options;
}

}  // namespace

PaperOperators::PaperOperators(const Parameters& parameters, const PaperOptions& options, wend::Reading clearance)
    : parameters_(parameters), options_(options), clearance_(std::move(clearance)) {}

// (12) The least clearance to anything after the action, beyond R or not.
bool PaperOperators::safe(const Experience& experience) const {
  if (experience.flags & WEND_COLLIDED) return false;
  for (std::size_t i = 0; i < clearance_.size(); ++i)
    if (clearance_(experience.next_observation, i) <= options_.safety_distance) return false;
  return true;
}

// The initial classifiers are random ones (2.1.1).
void PaperOperators::fill(Population& population, wend::Random& random) const {
  const auto wanted = static_cast<std::size_t>(std::min(options_.initial_rules, parameters_.limit));
  std::vector<std::uint64_t> state(population.words());
  while (population.size() < wanted) {
    std::fill(state.begin(), state.end(), 0);
    for (std::size_t j = 0; j < population.bits(); ++j) state[j / 64] |= (random.word() & 1) << (j % 64);
    cover_action(population, state.data(), static_cast<std::uint32_t>(random.below(population.actions())), 1,
                 parameters_, random);
  }
}

// Covering: as long as [M] has fewer actions than theta_mna, a rule for one that it lacks.
void PaperOperators::cover(Population& population, const std::uint64_t* state, RuleSet& match, wend::Random& random) {
  if (population.size() == 0 && options_.initial_rules > 0) {
    fill(population, random);
    population.match(state, match);
  }
  lacking_.assign(population.actions(), 1);
  double present = 0;
  for (const std::uint32_t rule : match) present += std::exchange(lacking_[population.action(rule)], 0);
  if (present >= parameters_.theta_mna) return;
  if (options_.inherited > 0) inherit(population, state);
  for (; present < parameters_.theta_mna; ++present) {
    std::uint64_t skip = random.below(population.actions() - static_cast<std::uint64_t>(present));
    std::uint32_t action = 0;
    while (!lacking_[action] || skip-- > 0) ++action;
    lacking_[action] = 0;
    make_room(population, state);
    const std::uint32_t rule =
        cover_action(population, state, action, static_cast<double>(match.size()) + 1, parameters_, random);
    if (options_.inherited == 0 || std::isnan(inherited_[action])) continue;
    population.prediction[rule] = inherited_[action];
    population.experience[rule] = options_.inherited;
  }
  population.match(state, match);
}

// What the rules nearest to a state predict, by action, weighted with their experience; NaN where none has any of its
// own.  A condition is as far away as it has bits that the state breaks.
void PaperOperators::inherit(const Population& population, const std::uint64_t* state) {
  inherited_.assign(population.actions(), 0);
  weights_.assign(population.actions(), 0);
  distances_.assign(population.actions(), std::numeric_limits<int>::max());
  for (std::uint32_t rule = 0; rule < population.size(); ++rule) {
    const double experience = population.experience[rule];
    if (experience <= options_.inherited) continue;
    int broken = 0;
    for (std::size_t w = 0; w < population.words(); ++w)
      broken += std::popcount((population.value(rule)[w] ^ state[w]) & population.care(rule)[w]);
    const std::uint32_t a = population.action(rule);
    if (broken > distances_[a]) continue;
    if (broken < distances_[a]) inherited_[a] = weights_[a] = 0, distances_[a] = broken;
    inherited_[a] += experience * population.prediction[rule];
    weights_[a] += experience;
  }
  for (std::size_t a = 0; a < weights_.size(); ++a)
    inherited_[a] = weights_[a] > 0 ? inherited_[a] / weights_[a] : std::numeric_limits<double>::quiet_NaN();
}

// Evicts the weakest rules, but none that matches the present state.
void PaperOperators::make_room(Population& population, const std::uint64_t* state) const {
  while (population.micro() + 1 > parameters_.limit) {
    std::uint32_t weakest = Population::none;
    for (std::uint32_t rule = 0; rule < population.size(); ++rule)
      if ((weakest == Population::none || population.fitness[rule] < population.fitness[weakest]) &&
          !population.matches(rule, state))
        weakest = rule;
    if (weakest == Population::none) return;
    population.remove(weakest);
  }
}

// (1) with the integrated fitness (14) as the weight; where all of an action's rules are unsafe, with fit2 alone.  A
// strength is no weight: then every rule has the same say.
void PaperOperators::predict(const Population& population, const RuleSet& match, Predictions& out) const {
  const std::size_t n = population.actions();
  out.array.assign(n, std::numeric_limits<double>::quiet_NaN());
  out.weighted.assign(n, 0);
  out.fitness.assign(n, 0);
  safe_.assign(n, 0);
  for (const std::uint32_t rule : match)
    if (!(population.marks[rule] & kUnsafe)) safe_[population.action(rule)] = 1;
  for (const std::uint32_t rule : match) {
    const std::uint32_t a = population.action(rule);
    if (safe_[a] && (population.marks[rule] & kUnsafe)) continue;
    const double weight = options_.strength ? population.numerosity(rule) : population.fitness[rule];
    out.weighted[a] += weight * population.prediction[rule];
    out.fitness[a] += weight;
    out.array[a] = population.prediction[rule];
  }
  for (std::size_t a = 0; a < n; ++a)
    if (out.fitness[a] > 0) out.array[a] = out.weighted[a] / out.fitness[a];
}

// The mean of what was seen at first; then as slow as beta; with beta_least slower still as experience grows.
double PaperOperators::rate(const Population& population, std::uint32_t rule) const {
  const double experience = population.experience[rule];
  if ((population.marks[rule] & kSeeded) && options_.seeded_beta > 0 && experience < options_.seeded_experience)
    return options_.seeded_beta;
  const double first = 1 / parameters_.beta;
  if (experience < first) return 1 / experience;
  if (options_.beta_least >= parameters_.beta) return parameters_.beta;
  return std::max(options_.beta_least, parameters_.beta * std::sqrt(first / experience));
}

// (3)-(7), and the mark of (12).
void PaperOperators::update(Population& population, const Experience& experience, const RuleSet& acted) {
  const bool harmless = safe(experience);
  double accurate = 0;
  for (const std::uint32_t rule : acted) {
    ++population.experience[rule];
    const double beta = rate(population, rule), step = experience.target - population.prediction[rule];
    population.error[rule] += beta * (std::fabs(step) - population.error[rule]);
    population.prediction[rule] += beta * step;
    population.set_size[rule] += beta * (static_cast<double>(acted.size()) - population.set_size[rule]);
    accurate += accuracy(population.error[rule], parameters_) * population.numerosity(rule);
    const int others = population.marks[rule] & ~kUnsafe;
    population.marks[rule] = static_cast<std::uint8_t>(harmless ? others : others | kUnsafe);
  }
  for (const std::uint32_t rule : acted) {
    const double own = accuracy(population.error[rule], parameters_) * population.numerosity(rule);
    double& fitness = population.fitness[rule];
    fitness = options_.strength ? population.prediction[rule] : fitness + parameters_.beta * (own / accurate - fitness);
  }
}

void PaperOperators::discover(Population& population, const Experience& experience, RuleSet& acted,
                              wend::Random& random) {
  if (!experience.explored) return;
  population.time += 1;
  if (!safe(experience)) breed_punished(population, experience, acted, random);
  if (options_.merge_every == 0 || ++steps_ % options_.merge_every != 0) return;
  population.generations += 1;
  merge(population, options_);
}

// Offspring of a rule that was punished: the present string and another action, expected to bring what [M] says of
// it.  A rule that is too general may also be split: the string with its own action, and what it brought.
void PaperOperators::breed_punished(Population& population, const Experience& experience, RuleSet& acted,
                                    wend::Random& random) {
  bool general = false;
  for (const std::uint32_t rule : acted) general = general || population.specified(rule) < population.bits();
  if (general && random.chance(options_.specialise))
    add_exact(population, experience.state, experience.action, experience.target);
  if (population.actions() < 2) return;
  auto other = static_cast<std::uint32_t>(random.below(population.actions() - 1));
  if (other >= experience.action) ++other;
  population.match(experience.state, match_);
  predict(population, match_, predictions_);
  const double expected = predictions_.array[other];
  add_exact(population, experience.state, other, std::isnan(expected) ? parameters_.prediction_i : expected);
}

// The rule for exactly this string and action, where there is none yet.
void PaperOperators::add_exact(Population& population, const std::uint64_t* state, std::uint32_t action,
                               double prediction) {
  std::vector<std::uint64_t> care(population.words(), ~std::uint64_t{0});
  if (population.bits() % 64 != 0) care.back() = (std::uint64_t{1} << (population.bits() % 64)) - 1;
  if (population.find(care.data(), state, action) != Population::none) return;
  make_room(population, state);
  Numbers numbers;
  numbers.prediction = prediction, numbers.error = parameters_.error_i;
  numbers.fitness = options_.strength ? prediction : parameters_.fitness_i;
  numbers.set_size = 1, numbers.stamp = population.time;
  population.add(care.data(), state, action, numbers);
}

std::function<std::unique_ptr<Discovery>()> paper_operators(const wend::Config& config, const Parameters& parameters) {
  const PaperOptions options = read_options(config.params);
  const std::vector<std::string> columns = config.params.texts("clearance");
  wend::Reading clearance;
  if (!columns.empty()) clearance = wend::Reading(config.observation, columns, "clearance");
  return [=] { return std::make_unique<PaperOperators>(parameters, options, clearance); };
}

}  // namespace xcs
