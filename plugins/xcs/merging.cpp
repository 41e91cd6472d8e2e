// Merging, the paper's mutation operator: pairs of rules of one action that differ in one specified bit.
#include <algorithm>
#include <cmath>
#include <functional>
#include <unordered_map>
#include <vector>
#include <wend/random.hpp>

#include "paper_operators.hpp"

namespace xcs {
namespace {

// Rules by condition and action.  Looked up by hash and verified; nothing depends on the table's order.
class Index {
 public:
  explicit Index(const Population& population) : population_(population) {
    table_.reserve(2 * population.size());
    for (std::uint32_t rule = 0; rule < population.size(); ++rule)
      table_.emplace(hash(population.care(rule), population.value(rule), population.action(rule)), rule);
  }
  std::uint32_t find(const std::uint64_t* care, const std::uint64_t* value, std::uint32_t action) const {
    const auto at = table_.find(hash(care, value, action));
    if (at == table_.end()) return Population::none;
    const std::uint32_t rule = at->second;
    const std::size_t words = population_.words();
    const bool same = population_.action(rule) == action && std::equal(care, care + words, population_.care(rule)) &&
                      std::equal(value, value + words, population_.value(rule));
    return same ? rule : Population::none;
  }

 private:
  std::uint64_t hash(const std::uint64_t* care, const std::uint64_t* value, std::uint32_t action) const noexcept {
    std::uint64_t key = action + 1;
    for (std::size_t w = 0; w < population_.words(); ++w)
      for (const std::uint64_t word : {care[w], value[w]}) {
        key = (key ^ word) * 0x9E3779B97F4A7C15u;
        key ^= key >> 29;
      }
    return key;
  }
  const Population& population_;
  std::unordered_map<std::uint64_t, std::uint32_t> table_;
};

double mean_prediction(const Population& population) {
  double sum = 0;
  for (const double p : population.prediction) sum += p;
  return population.size() ? sum / static_cast<double>(population.size()) : 0;
}

// One sweep over all rules; each merges at most once in it.
std::size_t sweep(Population& population, const PaperOptions& options) {
  const Index index(population);
  const double least = mean_prediction(population);
  const auto strong = [&](std::uint32_t rule) {
    return population.prediction[rule] >= least && population.experience[rule] >= options.merge_experience &&
           !(population.marks[rule] & kUnsafe);
  };
  std::vector<char> taken(population.size(), 0);
  std::vector<std::uint32_t> gone;
  std::vector<std::uint64_t> value(population.words()), care(population.words());
  const auto rules = static_cast<std::uint32_t>(population.size());
  for (std::uint32_t rule = 0; rule < rules; ++rule) {
    if (taken[rule] || !strong(rule)) continue;
    for (std::size_t j = 0; j < population.bits() && !taken[rule]; ++j) {
      const std::uint64_t bit = std::uint64_t{1} << (j % 64);
      if (!(population.care(rule)[j / 64] & bit)) continue;
      care.assign(population.care(rule), population.care(rule) + population.words());
      value.assign(population.value(rule), population.value(rule) + population.words());
      value[j / 64] ^= bit;
      const std::uint32_t other = index.find(care.data(), value.data(), population.action(rule));
      if (other == Population::none || taken[other] || !strong(other) ||
          std::fabs(population.prediction[rule] - population.prediction[other]) > options.merge_tolerance)
        continue;
      care[j / 64] &= ~bit, value[j / 64] &= ~bit;
      if (index.find(care.data(), value.data(), population.action(rule)) != Population::none) continue;
      const std::uint32_t better = population.prediction[other] > population.prediction[rule] ? other : rule;
      population.prediction[rule] = population.prediction[better];
      population.error[rule] = std::max(population.error[rule], population.error[other]);
      population.fitness[rule] = std::max(population.fitness[rule], population.fitness[other]);
      population.experience[rule] = std::max(population.experience[rule], population.experience[other]);
      population.marks[rule] = static_cast<std::uint8_t>((population.marks[rule] & population.marks[other]) | kMerged);
      population.set_condition(rule, care.data(), value.data());
      taken[rule] = taken[other] = 1;
      gone.push_back(other);
    }
  }
  std::sort(gone.begin(), gone.end(), std::greater<>());  // the last first: no number below it changes
  for (const std::uint32_t rule : gone) population.remove(rule);
  return gone.size();
}

}  // namespace

std::size_t merge(Population& population, const PaperOptions& options) {
  std::size_t all = 0;
  for (std::size_t n = 1; n > 0; all += n) n = sweep(population, options);
  return all;
}

}  // namespace xcs
