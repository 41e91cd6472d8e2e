#include "learner.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "rule_text.hpp"
#include "sharing.hpp"

namespace xcs {

std::uint32_t count_actions(const wend::Space& action) {
  if (action.width() != 1 || action[0].count == 0)
    throw wend::unsupported("expected one column of discrete actions, found " + std::to_string(action.width()) +
                            (action.width() == 1 ? " that is not discrete" : "") + "; give the robot an action table");
  return static_cast<std::uint32_t>(action[0].count);
}

Learner::Learner(const wend::Config& config, const std::string& name)
    : host_(config.host()),
      name_(name),
      encoder_(config.observation, config.params, "encoding"),
      actions_(count_actions(config.action)),
      parameters_(read_parameters(config.params, encoder_.bits(), actions_)),
      rows_(config.rows(), Row(encoder_.words())),
      greedy_updates_(config.params.flag("greedy_updates")),
      nearest_(config.params.text("unmatched") == "nearest"),
      proportional_(config.params.text_or("selection", "random") == "proportional"),
      json_(config.params.text("explain") == "json"),
      published_(config.params.text("rule_base") == "published"),
      exploration_(config.params.number_or("exploration", 1)),
      exploration_least_(config.params.number_or("exploration_least", 1)),
      exploration_episodes_(config.params.number_or("exploration_episodes", 1)),
      robots_(config.robots()),
      publish_every_(config.params.count("publish_every")),
      series_every_(config.params.count("series_every")) {
  const bool shared = config.params.text("rule_base") == "shared";
  for (std::uint32_t k = 0; k < (shared ? 1 : config.robots()); ++k)
    bases_.push_back(std::make_unique<Base>(encoder_.bits(), actions_));
  if (config.params.has("rules")) seed_from(config.params.text("rules"));
  for (std::uint32_t row = 0; row < rows_.size(); ++row) base_of(row).population.track(&rows_[row].acted);
  step_told_.box("prediction", "1").box("matching_rules", "1", 0);
  update_told_.box("macro_classifiers", "1", 0).box("population", "1", 0).box("fitness", "1", 0).box("error", "1", 0);
  update_told_.box("specificity", "1", 0, 1);
}

// Every rule base starts with the rules of a file.
void Learner::seed_from(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw wend::parameter_error("rules", "expected a file of rules, found none that can be read at " + file);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  for (auto& base : bases_) read_rules(text, encoder_.signature(), "rules", base->population);
  if (bases_.front()->population.micro() > parameters_.limit)
    throw wend::parameter_error("rules",
                                "expected at most N = " + shortest(parameters_.limit) + " micro-classifiers, found " +
                                    shortest(bases_.front()->population.micro()) + ": raise N or take fewer rules");
}

void Learner::begin(wend::Rows rows, wend::Episodes episodes) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Row& row = rows_[rows[i]];
    row.random = wend::Random(wend::stream(episodes[i].seed, "xcs"));
    row.mode = episodes[i].mode;
    if (row.mode == WEND_TRAIN_EXPLORE && rows[i] % robots_ == 0) ++episodes_;
    row.decided = false;
    row.acted.clear();
  }
}

std::uint32_t Learner::action_of(std::span<const double> action) const {
  if (!(action[0] >= 0 && action[0] < actions_))
    throw wend::Error(WEND_E_ARGUMENT, {},
                      "an action: expected 0.." + std::to_string(actions_ - 1) + ", found " + shortest(action[0]));
  return static_cast<std::uint32_t>(action[0]);
}

double Learner::checked_reward(double reward) {
  if (!std::isfinite(reward))
    throw wend::Error(WEND_E_ARGUMENT, {}, "a reward: expected a finite number, found " + shortest(reward));
  return reward;
}

// Falls linearly from `exploration` to `exploration_least`.
double Learner::exploration() const {
  if (exploration_least_ >= exploration_) return exploration_;
  const double done = std::min(static_cast<double>(episodes_) / exploration_episodes_, 1.0);
  return exploration_ + done * (exploration_least_ - exploration_);
}

std::uint32_t Learner::choose(Row& row, const std::vector<double>& array) {
  if (row.mode == WEND_TRAIN_EXPLORE && row.random.chance(exploration()))
    return proportional_ ? draw_proportionally(row, array) : static_cast<std::uint32_t>(row.random.below(actions_));
  const std::uint32_t best = best_action(array);
  return best < actions_ ? best : static_cast<std::uint32_t>(row.random.below(actions_));
}

// With probability proportional to PA, counted from the least where that is negative.
std::uint32_t Learner::draw_proportionally(Row& row, const std::vector<double>& array) {
  double least = 0;
  for (const double value : array)
    if (value < least) least = value;
  std::vector<double> weights;
  for (const double value : array) weights.push_back(std::isnan(value) ? 0 : value - least);
  const std::size_t drawn = row.random.weighted(weights);
  return static_cast<std::uint32_t>(drawn < actions_ ? drawn : row.random.below(actions_));
}

void Learner::learned_one() {
  ++learned_;
  if (!published_ || publish_every_ == 0 || learned_ % publish_every_ != 0) return;
  std::vector<Population*> all;
  for (const auto& base : bases_) all.push_back(&base->population);
  publish(all, parameters_);
}

// One point of fitness against generation each `series_every` generations.
void Learner::tell_generation(const Population& population, double before) const {
  if (series_every_ == 0 || population.generations == before) return;
  const auto every = static_cast<double>(series_every_);
  if (std::floor(population.generations / every) == std::floor(before / every)) return;
  host_->series(host_, "generation", population.generations, "fitness", mean_fitness(population));
}

double mean_fitness(const Population& population) {
  double sum = 0;
  for (std::uint32_t rule = 0; rule < population.size(); ++rule)
    sum += population.numerosity(rule) * population.fitness[rule];
  return population.micro() > 0 ? sum / population.micro() : 0;
}

}  // namespace xcs
