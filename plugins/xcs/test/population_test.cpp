// The rule store against a list of plain strings.
#include "population.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using xcs::Kernel;
using xcs::Population;
using xcs::RuleSet;

namespace {

std::string random_condition(std::size_t bits, double free, wend::Random& random) {
  std::string text(bits, '#');
  for (char& c : text)
    if (!random.chance(free)) c = random.chance(0.5) ? '1' : '0';
  return text;
}

std::vector<std::uint64_t> packed(const std::string& state) {
  std::vector<std::uint64_t> care, value;
  EXPECT_TRUE(xcs::parse_condition(state, state.size(), care, value));
  return value;
}

std::uint32_t add(Population& population, const std::string& condition, std::uint32_t action,
                  const xcs::Numbers& numbers = {}) {
  std::vector<std::uint64_t> care, value;
  EXPECT_TRUE(xcs::parse_condition(condition, population.bits(), care, value)) << condition;
  return population.add(care.data(), value.data(), action, numbers);
}

bool fits(const std::string& condition, const std::string& state) {
  for (std::size_t j = 0; j < state.size(); ++j)
    if (condition[j] != '#' && condition[j] != state[j]) return false;
  return true;
}

std::vector<Kernel> kernels() {
  std::vector<Kernel> all;
  for (const Kernel kernel : {Kernel::kScalar, Kernel::kAvx2, Kernel::kAvx512})
    if (xcs::has_kernel(kernel)) all.push_back(kernel);
  return all;
}

}  // namespace

class Sizes : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Bits, Sizes, testing::Values(1, 2, 11, 63, 64, 65, 128, 200));

TEST_P(Sizes, EveryKernelMatchesWhatAWalkOverStringsMatches) {
  const std::size_t bits = GetParam();
  wend::Random random(bits);
  for (const std::size_t n : {0, 1, 63, 64, 511, 512, 513, 1100}) {
    Population population(bits, 3);
    std::vector<std::string> conditions;
    for (std::size_t r = 0; r < n; ++r) {
      conditions.push_back(random_condition(bits, 1 - 2.0 / static_cast<double>(bits), random));
      add(population, conditions.back(), static_cast<std::uint32_t>(r % 3));
    }
    for (int k = 0; k < 20; ++k) {
      const std::string state = random_condition(bits, 0, random);
      RuleSet expected;
      for (std::uint32_t r = 0; r < n; ++r)
        if (fits(conditions[r], state)) expected.push_back(r);
      for (const Kernel kernel : kernels()) {
        population.use(kernel);
        RuleSet found;
        population.match(packed(state).data(), found);
        EXPECT_EQ(found, expected) << n << " rules, kernel " << static_cast<int>(kernel);
      }
      for (std::uint32_t r = 0; r < n; ++r)
        EXPECT_EQ(population.matches(r, packed(state).data()), fits(conditions[r], state));
    }
  }
}

TEST_P(Sizes, EveryKernelFindsARuleByItsConditionAndAction) {
  const std::size_t bits = GetParam();
  wend::Random random(bits + 1000);
  Population population(bits, 2);
  std::set<std::pair<std::string, std::uint32_t>> known;
  for (int r = 0; r < 700; ++r) {
    const std::string condition = random_condition(bits, 0.5, random);
    const auto action = static_cast<std::uint32_t>(random.below(2));
    if (known.insert({condition, action}).second) add(population, condition, action);
  }
  for (int k = 0; k < 300; ++k) {
    const std::uint32_t rule = static_cast<std::uint32_t>(random.below(population.size()));
    std::string condition = population.condition(rule);
    if (k % 2) condition[random.below(bits)] = "01#"[random.below(3)];
    std::vector<std::uint64_t> care, value;
    ASSERT_TRUE(xcs::parse_condition(condition, bits, care, value));
    for (const std::uint32_t action : {0u, 1u})
      for (const Kernel kernel : kernels()) {
        population.use(kernel);
        const std::uint32_t found = population.find(care.data(), value.data(), action);
        ASSERT_EQ(found != Population::none, known.contains({condition, action})) << condition;
        if (found != Population::none) {
          EXPECT_EQ(population.condition(found), condition);
          EXPECT_EQ(population.action(found), action);
        }
      }
  }
}

// Adds, removes and rewrites at random; after each the store agrees with a list that does the same.
TEST(Population, AgreesWithAListWhateverIsDoneToIt) {
  constexpr std::size_t bits = 9;
  struct Plain {
    std::string condition;
    std::uint32_t action;
    double prediction, numerosity;
  };
  wend::Random random(5);
  Population population(bits, 4);
  std::vector<Plain> list;
  for (int k = 0; k < 3000; ++k) {
    const std::uint64_t what = list.empty() ? 0 : random.below(list.size() > 600 ? 2 : 5);
    const auto rule = static_cast<std::uint32_t>(random.below(std::max<std::size_t>(list.size(), 1)));
    const std::string condition = random_condition(bits, 0.4, random);
    std::vector<std::uint64_t> care, value;
    ASSERT_TRUE(xcs::parse_condition(condition, bits, care, value));
    if (what == 1) {
      population.remove(rule);
      list[rule] = list.back();
      list.pop_back();
    } else if (what == 2) {
      population.set_condition(rule, care.data(), value.data());
      list[rule].condition = condition;
    } else if (what == 3) {
      population.set_numerosity(rule, 7);
      list[rule].numerosity = 7;
    } else {
      xcs::Numbers numbers;
      numbers.prediction = k, numbers.numerosity = 1 + k % 3;
      add(population, condition, static_cast<std::uint32_t>(k % 4), numbers);
      list.push_back({condition, static_cast<std::uint32_t>(k % 4), double(k), double(1 + k % 3)});
    }
    ASSERT_EQ(population.size(), list.size());
    double micro = 0;
    const std::string state = random_condition(bits, 0, random);
    RuleSet expected, found;
    for (std::uint32_t r = 0; r < list.size(); ++r) {
      ASSERT_EQ(population.condition(r), list[r].condition);
      ASSERT_EQ(population.action(r), list[r].action);
      ASSERT_EQ(population.prediction[r], list[r].prediction);
      ASSERT_EQ(population.numerosity(r), list[r].numerosity);
      micro += list[r].numerosity;
      if (fits(list[r].condition, state)) expected.push_back(r);
    }
    EXPECT_EQ(population.micro(), micro);
    population.match(packed(state).data(), found);
    ASSERT_EQ(found, expected);
  }
}

TEST(Population, ARemovedRuleLeavesTheTrackedSetsAndTheLastTakesItsNumber) {
  Population population(2, 2);
  for (const char* condition : {"00", "01", "10", "11"}) add(population, condition, 0);
  RuleSet both{1, 3}, first{1}, last{3};
  for (RuleSet* set : {&both, &first, &last}) population.track(set);
  population.remove(1);
  EXPECT_EQ(both, RuleSet{1});
  EXPECT_EQ(population.condition(1), "11");
  EXPECT_TRUE(first.empty());
  EXPECT_EQ(last, RuleSet{1});
  population.untrack(&last);
  population.remove(1);
  EXPECT_TRUE(both.empty());
  EXPECT_EQ(last, RuleSet{1}) << "no longer tracked";
}

TEST(Population, MoreGeneralMeansThatItMatchesAllTheOtherDoesAndMore) {
  wend::Random random(11);
  constexpr std::size_t bits = 4;
  for (int k = 0; k < 2000; ++k) {
    Population population(bits, 1);
    const std::string a = random_condition(bits, 0.6, random), b = random_condition(bits, 0.4, random);
    add(population, a, 0);
    add(population, b, 0);
    bool all = true, more = false;
    for (int s = 0; s < 1 << bits; ++s) {
      std::string state(bits, '0');
      for (std::size_t j = 0; j < bits; ++j) state[j] = s >> j & 1 ? '1' : '0';
      all = all && (!fits(b, state) || fits(a, state));
      more = more || (fits(a, state) && !fits(b, state));
    }
    EXPECT_EQ(population.more_general(0, population.care(1), population.value(1)), all && more) << a << " " << b;
    EXPECT_EQ(population.specified(0), bits - static_cast<std::size_t>(std::count(a.begin(), a.end(), '#')));
  }
}

TEST(Population, NearestBreaksTheFewestBits) {
  Population population(3, 2);
  add(population, "000", 0);
  add(population, "0#0", 1);
  add(population, "110", 1);
  RuleSet found;
  population.nearest(packed("011").data(), found);
  EXPECT_EQ(found, RuleSet{1});
  population.nearest(packed("111").data(), found);
  EXPECT_EQ(found, RuleSet{2});
  population.nearest(packed("010").data(), found);
  EXPECT_EQ(found, RuleSet{1}) << "one that matches";
}

TEST(Population, ACopyHasTheSameRulesAndTracksNothing) {
  Population population(3, 2);
  add(population, "0#1", 1);
  RuleSet set{0};
  population.track(&set);
  Population copy(population);
  copy.remove(0);
  EXPECT_EQ(set, RuleSet{0});
  EXPECT_EQ(population.condition(0), "0#1");
  population = copy;
  EXPECT_TRUE(set.empty());
  EXPECT_EQ(population.size(), 0u);
}

TEST(Conditions, AreReadOnlyWhereEveryCharacterIsOne) {
  std::vector<std::uint64_t> care, value;
  EXPECT_TRUE(xcs::parse_condition("01#", 3, care, value));
  EXPECT_EQ(care[0], 0b011u);
  EXPECT_EQ(value[0], 0b010u);
  EXPECT_FALSE(xcs::parse_condition("01", 3, care, value));
  EXPECT_FALSE(xcs::parse_condition("01#1", 3, care, value));
  EXPECT_FALSE(xcs::parse_condition("01x", 3, care, value));
}
