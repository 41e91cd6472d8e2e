// A population of macro-classifiers over packed ternary conditions: the one rule store of wend.xcs, wend.lcs and
// wend.zcs.
//
// Bit j of a condition lies in word j / 64 at position j % 64.  `care` has a 1 where the bit is specified, `value` says
// what it must be there and is 0 where it is '#'.  For matching the same conditions are kept transposed, by bit
// (match.hpp). Rules are numbered 0..size()-1 without gaps: removing one moves the last into its place, in the tracked
// sets too.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>
#include <wend/random.hpp>

#include "match.hpp"

namespace xcs {

using RuleSet = std::vector<std::uint32_t>;  // numbers of rules, each once

enum Mark : std::uint8_t { kSeeded = 1 };  // came from a rule file or a teacher, not from covering or the GA

// What a rule knows, but for its condition and action.
struct Numbers {
  double prediction = 0, error = 0, fitness = 0;  // p, epsilon, F; the fitness of all copies together
  double experience = 0;                          // how often it was updated
  double set_size = 0;                            // as: mean size of its action sets, in micro-classifiers
  double stamp = 0;                               // ts: when the GA last ran in one of its sets
  double numerosity = 1;                          // how many micro-classifiers it stands for
  std::uint8_t marks = 0;
};

class Population {
 public:
  Population(std::size_t bits, std::uint32_t actions);
  Population(const Population&);  // a copy tracks no sets
  Population& operator=(const Population&);

  std::size_t size() const noexcept { return action_.size(); }  // macro-classifiers
  double micro() const noexcept { return micro_; }              // micro-classifiers: the sum of numerosities
  std::size_t bits() const noexcept { return bits_; }
  std::size_t words() const noexcept { return words_; }  // 64-bit words of a condition or a state
  std::uint32_t actions() const noexcept { return actions_; }
  // Grows whenever a rule comes, goes or changes its condition or action: sets found earlier may be out of date then.
  std::uint64_t version() const noexcept { return version_; }

  // ---- one rule
  const std::uint64_t* care(std::uint32_t rule) const noexcept { return care_.data() + rule * words_; }
  const std::uint64_t* value(std::uint32_t rule) const noexcept { return value_.data() + rule * words_; }
  std::uint32_t action(std::uint32_t rule) const noexcept { return action_[rule]; }
  double numerosity(std::uint32_t rule) const noexcept { return numerosity_[rule]; }
  const std::vector<double>& numerosities() const noexcept { return numerosity_; }
  Numbers numbers(std::uint32_t rule) const;
  bool matches(std::uint32_t rule, const std::uint64_t* state) const noexcept;
  // True if `general` matches all that `special` does and more, by conditions alone.
  bool more_general(std::uint32_t general, const std::uint64_t* special_care,
                    const std::uint64_t* special_value) const noexcept;
  std::size_t specified(std::uint32_t rule) const noexcept;  // bits that are not '#'
  std::string condition(std::uint32_t rule) const;           // "01##1", bit 0 first

  // Numbers that have no invariant are written directly: p.prediction[rule] = ...
  std::vector<double> prediction, error, fitness, experience, set_size, stamp;
  std::vector<std::uint8_t> marks;

  // ---- changing it
  // `care` and `value` lie outside of the population.
  std::uint32_t add(const std::uint64_t* care, const std::uint64_t* value, std::uint32_t action,
                    const Numbers& numbers);
  void remove(std::uint32_t rule);                             // with all its copies
  void set_numerosity(std::uint32_t rule, double numerosity);  // at least 1
  void set_condition(std::uint32_t rule, const std::uint64_t* care, const std::uint64_t* value);
  void set_action(std::uint32_t rule, std::uint32_t action) { action_[rule] = action, ++version_; }
  void clear();
  // Sets of rule numbers that live on while rules are removed: a removed rule leaves them.  Each must outlive the
  // population, or be untracked.
  void track(RuleSet* set) { tracked_.push_back(set); }
  void untrack(RuleSet* set) { std::erase(tracked_, set); }

  // ---- finding rules
  // [M]: the rules that match the state, in ascending order.
  void match(const std::uint64_t* state, RuleSet& out) const;
  // The rule with this condition and action, or none.
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  std::uint32_t find(const std::uint64_t* care, const std::uint64_t* value, std::uint32_t action) const;
  // The rules whose conditions the state breaks in the fewest bits: all that match where any does.
  void nearest(const std::uint64_t* state, RuleSet& out) const;

  double time = 0;         // grows by one with every exploring update, for the stamps
  double generations = 0;  // how often rules were bred

  Kernel kernel() const noexcept { return kernel_; }
  void use(Kernel kernel) noexcept { kernel_ = kernel; }  // the best of this CPU unless told

 private:
  void write_planes(std::uint32_t rule, const std::uint64_t* care, const std::uint64_t* value);
  void clear_planes(std::uint32_t rule);
  void collect(RuleSet& out) const;

  std::size_t bits_, words_;
  std::uint32_t actions_;
  Kernel kernel_;
  double micro_ = 0;
  std::uint64_t version_ = 0;
  std::vector<std::uint64_t> care_, value_;  // n x words
  std::vector<std::uint32_t> action_;
  std::vector<double> numerosity_;
  Planes planes_;
  std::vector<RuleSet*> tracked_;
  mutable AlignedWords mask_;  // scratch: one bit a rule
};

// [A]: those of [M] that advocate the action.
void advocates(const Population& population, const RuleSet& match, std::uint32_t action, RuleSet& out);

// Reads "01##1" into words; false where the text is not `bits` characters of 0, 1 and #.
bool parse_condition(std::string_view text, std::size_t bits, std::vector<std::uint64_t>& care,
                     std::vector<std::uint64_t>& value);

}  // namespace xcs
