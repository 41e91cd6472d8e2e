// States, telemetry and explanations of a learner.
#include <algorithm>
#include <cmath>
#include <limits>

#include "learner.hpp"
#include "rule_text.hpp"

namespace xcs {
namespace {

void save_population(const Population& population, wend::Writer& writer) {
  const std::size_t n = population.size();
  std::vector<std::uint64_t> conditions, actions;
  for (std::uint32_t rule = 0; rule < n; ++rule) {
    conditions.insert(conditions.end(), population.care(rule), population.care(rule) + population.words());
    conditions.insert(conditions.end(), population.value(rule), population.value(rule) + population.words());
    actions.push_back(population.action(rule));
  }
  writer.put(std::span<const std::uint64_t>(conditions));
  writer.put(std::span<const std::uint64_t>(actions));
  for (const auto* numbers : {&population.prediction, &population.error, &population.fitness, &population.experience,
                              &population.set_size, &population.stamp, &population.numerosities()})
    writer.put(std::span<const double>(*numbers));
  writer.put(std::span<const std::uint8_t>(population.marks));
  writer.put(population.time);
  writer.put(population.generations);
}

Population load_population(wend::Reader& reader, std::size_t bits, std::uint32_t actions) {
  Population population(bits, actions);
  const std::size_t words = population.words();
  const auto conditions = reader.get_all<std::uint64_t>(), chosen = reader.get_all<std::uint64_t>();
  const std::size_t n = chosen.size();
  std::vector<double> numbers[7];
  bool good = conditions.size() == 2 * words * n;
  for (auto& column : numbers) {
    column = reader.get_all<double>();
    good = good && column.size() == n &&
           std::all_of(column.begin(), column.end(), [](double x) { return std::isfinite(x); });
  }
  const auto marks = reader.get_all<std::uint8_t>();
  if (!good || marks.size() != n)
    throw wend::damaged_state("expected the numbers of " + std::to_string(n) + " rules, found others");
  const std::uint64_t beyond = bits % 64 ? ~std::uint64_t{0} << (bits % 64) : 0;
  for (std::size_t r = 0; r < n; ++r) {
    const std::uint64_t *care = conditions.data() + 2 * words * r, *value = care + words;
    const double copies = numbers[6][r];
    bool hidden = false;  // a value where the condition has '#'
    for (std::size_t w = 0; w < words; ++w) hidden = hidden || (value[w] & ~care[w]) != 0;
    if (chosen[r] >= actions || hidden || (care[words - 1] & beyond) != 0 || !(copies >= 1) ||
        copies != std::floor(copies))
      throw wend::damaged_state("rule " + std::to_string(r) + " is not one of this encoding and these actions");
    population.add(
        care, value, static_cast<std::uint32_t>(chosen[r]),
        {numbers[0][r], numbers[1][r], numbers[2][r], numbers[3][r], numbers[4][r], numbers[5][r], copies, marks[r]});
  }
  population.time = reader.get<double>();
  population.generations = reader.get<double>();
  if (!std::isfinite(population.time) || !std::isfinite(population.generations))
    throw wend::damaged_state("expected a finite time and number of generations, found others");
  return population;
}

}  // namespace

std::string Learner::signature() const {
  return name_ + " 1: " + std::to_string(actions_) + " actions, " + encoder_.signature();
}

void Learner::save(wend::Writer& writer) const {
  writer.put(signature());
  writer.put(learned_);
  writer.put(episodes_);
  writer.put(static_cast<std::uint64_t>(bases_.size()));
  for (const auto& base : bases_) {
    save_population(base->population, writer);
    if (base->discovery) base->discovery->save(writer);
  }
  save_more(writer);
}

// One rule base may be handed to several robots; several are never poured into one.
void Learner::load(wend::Reader& reader) {
  reader.expect(signature());
  const auto learned = reader.get<std::uint64_t>(), episodes = reader.get<std::uint64_t>(),
             n = reader.get<std::uint64_t>();
  if (n != bases_.size() && n != 1)
    throw wend::damaged_state("expected " + std::to_string(bases_.size()) + " rule bases, found " + std::to_string(n));
  std::vector<Population> read;
  std::vector<std::unique_ptr<Discovery>> operators;
  for (std::uint64_t k = 0; k < n; ++k) {
    read.push_back(load_population(reader, encoder_.bits(), actions_));
    if (read.back().micro() > parameters_.limit)
      throw wend::damaged_state("expected at most N = " + shortest(parameters_.limit) + " micro-classifiers, found " +
                                shortest(read.back().micro()) + ": raise N");
    operators.push_back(make_discovery());
    if (operators.back()) operators.back()->load(reader);
  }
  const std::function<void()> take_over = load_more(reader);
  reader.end();
  take_over();
  for (std::size_t k = 0; k < bases_.size(); ++k) {
    bases_[k]->population = read[n == 1 ? 0 : k];
    if (n == bases_.size()) bases_[k]->discovery = std::move(operators[k]);
  }
  learned_ = learned, episodes_ = episodes;
  for (Row& row : rows_) row.decided = false;
}

const wend::Columns* Learner::telemetry(std::uint32_t when) const {
  return when == WEND_PER_STEP ? &step_told_ : when == WEND_PER_UPDATE ? &update_told_ : nullptr;
}

void Learner::read(std::uint32_t when, wend::Rows rows, wend::Matrix<double> out) const {
  if (when == WEND_PER_STEP) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      out[i][0] = rows_[rows[i]].prediction;
      out[i][1] = rows_[rows[i]].matching;
    }
    return;
  }
  double macro = 0, micro = 0, fitness = 0, error = 0, specified = 0;
  for (const auto& base : bases_) {
    const Population& population = base->population;
    macro += static_cast<double>(population.size());
    micro += population.micro();
    fitness += mean_fitness(population) * population.micro();
    for (std::uint32_t rule = 0; rule < population.size(); ++rule) {
      error += population.error[rule] * population.numerosity(rule);
      specified += static_cast<double>(population.specified(rule)) * population.numerosity(rule);
    }
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto row = out[0];
  row[0] = macro;
  row[1] = micro;
  row[2] = micro > 0 ? fitness / micro : none;
  row[3] = micro > 0 ? error / micro : none;
  row[4] = micro > 0 ? specified / micro / static_cast<double>(encoder_.bits()) : none;
}

void Learner::explain(std::uint32_t index, wend::Writer& writer) const {
  const Row& row = rows_.at(index);
  const Base& base = base_of(index);
  if (json_) return writer.text(format_json(base.population, encoder_.signature()));
  std::string text;
  if (row.decided) {
    RuleSet match;
    base.population.match(row.state.data(), match);
    text += "// state ";
    for (std::size_t j = 0; j < encoder_.bits(); ++j) text += row.state[j / 64] >> (j % 64) & 1 ? '1' : '0';
    text += ": action " + std::to_string(row.action) + ", predicted " + shortest(row.prediction) + ", by " +
            std::to_string(match.size()) + " rules:\n";
    for (const std::uint32_t rule : match)
      text += "//   " + base.population.condition(rule) + " -> " + std::to_string(base.population.action(rule)) +
              "  p " + shortest(base.population.prediction[rule]) + " error " + shortest(base.population.error[rule]) +
              " F " + shortest(base.population.fitness[rule]) + " x " + shortest(base.population.numerosity(rule)) +
              "\n";
  }
  writer.text(format_rules(base.population, encoder_.signature()));
  writer.text(text);
}

}  // namespace xcs
