#include "population.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace xcs {
namespace {

constexpr std::size_t pair_words = 2 * Planes::block_words;

template <class T>
void fill_gap(std::vector<T>& all, std::uint32_t gap) {  // the last takes the place
  all[gap] = all.back();
  all.pop_back();
}

}  // namespace

Population::Population(std::size_t bits, std::uint32_t actions)
    : bits_(bits), words_((bits + 63) / 64), actions_(actions), kernel_(best_kernel()), planes_(bits) {}

Population::Population(const Population& other) : Population(other.bits_, other.actions_) {
  *this = other;
}

Population& Population::operator=(const Population& other) {
  prediction = other.prediction, error = other.error, fitness = other.fitness, experience = other.experience;
  set_size = other.set_size, stamp = other.stamp, marks = other.marks, time = other.time,
  generations = other.generations;
  bits_ = other.bits_, words_ = other.words_, actions_ = other.actions_, kernel_ = other.kernel_, micro_ = other.micro_;
  care_ = other.care_, value_ = other.value_, action_ = other.action_, numerosity_ = other.numerosity_;
  planes_ = other.planes_, mask_ = other.mask_;
  ++version_;
  for (RuleSet* set : tracked_) set->clear();
  return *this;
}

Numbers Population::numbers(std::uint32_t rule) const {
  return {prediction[rule], error[rule], fitness[rule],     experience[rule],
          set_size[rule],   stamp[rule], numerosity_[rule], marks[rule]};
}

bool Population::matches(std::uint32_t rule, const std::uint64_t* state) const noexcept {
  const std::uint64_t *c = care(rule), *v = value(rule);
  std::uint64_t broken = 0;
  for (std::size_t w = 0; w < words_; ++w) broken |= (v[w] ^ state[w]) & c[w];
  return broken == 0;
}

bool Population::more_general(std::uint32_t general, const std::uint64_t* special_care,
                              const std::uint64_t* special_value) const noexcept {
  const std::uint64_t *c = care(general), *v = value(general);
  std::uint64_t fails = 0, wider = 0;
  for (std::size_t w = 0; w < words_; ++w) {
    fails |= (c[w] & ~special_care[w]) | ((v[w] ^ special_value[w]) & c[w]);
    wider |= special_care[w] & ~c[w];
  }
  return fails == 0 && wider != 0;
}

std::size_t Population::specified(std::uint32_t rule) const noexcept {
  std::size_t n = 0;
  for (std::size_t w = 0; w < words_; ++w) n += static_cast<std::size_t>(std::popcount(care(rule)[w]));
  return n;
}

std::string Population::condition(std::uint32_t rule) const {
  std::string text(bits_, '#');
  for (std::size_t j = 0; j < bits_; ++j)
    if (care(rule)[j / 64] >> (j % 64) & 1) text[j] = value(rule)[j / 64] >> (j % 64) & 1 ? '1' : '0';
  return text;
}

std::uint32_t Population::add(const std::uint64_t* care, const std::uint64_t* value, std::uint32_t action,
                              const Numbers& numbers) {
  const auto rule = static_cast<std::uint32_t>(size());
  if (rule == planes_.blocks() * Planes::block_rules) {
    planes_.words.resize(planes_.words.size() + bits_ * pair_words);
    mask_.resize(planes_.blocks() * Planes::block_words);
  }
  for (std::size_t w = 0; w < words_; ++w) {
    care_.push_back(care[w]);
    value_.push_back(value[w] & care[w]);
  }
  action_.push_back(action);
  numerosity_.push_back(numbers.numerosity);
  micro_ += numbers.numerosity;
  prediction.push_back(numbers.prediction);
  error.push_back(numbers.error);
  fitness.push_back(numbers.fitness);
  experience.push_back(numbers.experience);
  set_size.push_back(numbers.set_size);
  stamp.push_back(numbers.stamp);
  marks.push_back(numbers.marks);
  write_planes(rule, care_.data() + rule * words_, value_.data() + rule * words_);
  return rule;
}

void Population::remove(std::uint32_t rule) {
  const auto last = static_cast<std::uint32_t>(size() - 1);
  micro_ -= numerosity_[rule];
  if (rule != last) set_condition(rule, care(last), value(last));
  clear_planes(last);
  care_.resize(last * words_);
  value_.resize(last * words_);
  fill_gap(action_, rule);
  fill_gap(numerosity_, rule);
  for (auto* numbers : {&prediction, &error, &fitness, &experience, &set_size, &stamp}) fill_gap(*numbers, rule);
  fill_gap(marks, rule);
  for (RuleSet* set : tracked_) {
    std::erase(*set, rule);
    std::replace(set->begin(), set->end(), last, rule);
  }
}

void Population::set_numerosity(std::uint32_t rule, double numerosity) {
  micro_ += numerosity - numerosity_[rule];
  numerosity_[rule] = numerosity;
}

void Population::set_condition(std::uint32_t rule, const std::uint64_t* care, const std::uint64_t* value) {
  for (std::size_t w = 0; w < words_; ++w) {
    care_[rule * words_ + w] = care[w];
    value_[rule * words_ + w] = value[w] & care[w];
  }
  write_planes(rule, care_.data() + rule * words_, value_.data() + rule * words_);
}

void Population::clear() {
  for (auto* numbers : {&prediction, &error, &fitness, &experience, &set_size, &stamp, &numerosity_}) numbers->clear();
  marks.clear(), care_.clear(), value_.clear(), action_.clear(), planes_.words.clear(), mask_.clear();
  micro_ = 0, ++version_;
  for (RuleSet* set : tracked_) set->clear();
}

void Population::match(const std::uint64_t* state, RuleSet& out) const {
  const std::size_t blocks = (size() + Planes::block_rules - 1) / Planes::block_rules;
  match_planes(kernel_, planes_, blocks, state, mask_.data());
  collect(out);
}

std::uint32_t Population::find(const std::uint64_t* care, const std::uint64_t* value, std::uint32_t action) const {
  const std::size_t blocks = (size() + Planes::block_rules - 1) / Planes::block_rules;
  find_planes(kernel_, planes_, blocks, care, value, mask_.data());
  for (std::size_t w = 0; w < (size() + 63) / 64; ++w)
    for (std::uint64_t left = mask_[w]; left != 0; left &= left - 1) {
      const auto rule = static_cast<std::uint32_t>(64 * w + static_cast<std::size_t>(std::countr_zero(left)));
      if (action_[rule] == action) return rule;
    }
  return none;
}

void Population::nearest(const std::uint64_t* state, RuleSet& out) const {
  out.clear();
  std::size_t fewest = bits_ + 1;
  for (std::uint32_t rule = 0; rule < size(); ++rule) {
    std::size_t broken = 0;
    for (std::size_t w = 0; w < words_; ++w)
      broken += static_cast<std::size_t>(std::popcount((value(rule)[w] ^ state[w]) & care(rule)[w]));
    if (broken < fewest) out.clear();
    fewest = std::min(fewest, broken);
    if (broken == fewest) out.push_back(rule);
  }
}

// The planes of one rule hold two bits for each bit of the condition.
void Population::write_planes(std::uint32_t rule, const std::uint64_t* care, const std::uint64_t* value) {
  ++version_;
  std::uint64_t* plane =
      planes_.words.data() + rule / Planes::block_rules * bits_ * pair_words + rule % Planes::block_rules / 64;
  const std::uint64_t bit = std::uint64_t{1} << (rule % 64);
  for (std::size_t j = 0; j < bits_; ++j, plane += pair_words) {
    const bool free = !(care[j / 64] >> (j % 64) & 1), one = value[j / 64] >> (j % 64) & 1;
    plane[0] = (plane[0] & ~bit) | (free || !one ? bit : 0);
    plane[Planes::block_words] = (plane[Planes::block_words] & ~bit) | (free || one ? bit : 0);
  }
}

void Population::clear_planes(std::uint32_t rule) {
  ++version_;
  std::uint64_t* plane =
      planes_.words.data() + rule / Planes::block_rules * bits_ * pair_words + rule % Planes::block_rules / 64;
  const std::uint64_t bit = std::uint64_t{1} << (rule % 64);
  for (std::size_t j = 0; j < bits_; ++j, plane += pair_words) {
    plane[0] &= ~bit;
    plane[Planes::block_words] &= ~bit;
  }
}

void Population::collect(RuleSet& out) const {
  out.clear();
  for (std::size_t w = 0; w < (size() + 63) / 64; ++w)
    for (std::uint64_t left = mask_[w]; left != 0; left &= left - 1)
      out.push_back(static_cast<std::uint32_t>(64 * w + static_cast<std::size_t>(std::countr_zero(left))));
}

void advocates(const Population& population, const RuleSet& match, std::uint32_t action, RuleSet& out) {
  out.clear();
  for (const std::uint32_t rule : match)
    if (population.action(rule) == action) out.push_back(rule);
}

bool parse_condition(std::string_view text, std::size_t bits, std::vector<std::uint64_t>& care,
                     std::vector<std::uint64_t>& value) {
  if (text.size() != bits) return false;
  care.assign((bits + 63) / 64, 0);
  value.assign((bits + 63) / 64, 0);
  for (std::size_t j = 0; j < bits; ++j) {
    if (text[j] != '0' && text[j] != '1' && text[j] != '#') return false;
    if (text[j] != '#') care[j / 64] |= std::uint64_t{1} << (j % 64);
    if (text[j] == '1') value[j / 64] |= std::uint64_t{1} << (j % 64);
  }
  return true;
}

}  // namespace xcs
