// Covering, GA, subsumption, deletion and compaction of the canonical operators; and the multiplexer.
#include "canonical.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "multiplexer.hpp"

using xcs::Numbers;
using xcs::Population;
using xcs::RuleSet;

namespace {

std::uint32_t add(Population& population, const std::string& condition, std::uint32_t action, const Numbers& numbers) {
  std::vector<std::uint64_t> care, value;
  EXPECT_TRUE(xcs::parse_condition(condition, population.bits(), care, value));
  return population.add(care.data(), value.data(), action, numbers);
}

std::map<std::string, double> contents(const Population& population) {
  std::map<std::string, double> all;
  for (std::uint32_t rule = 0; rule < population.size(); ++rule)
    all[population.condition(rule) + ":" + std::to_string(population.action(rule))] = population.numerosity(rule);
  return all;
}

xcs::Parameters parameters_with(double limit, double theta_mna = 2) {
  xcs::Parameters parameters;
  parameters.limit = limit, parameters.theta_mna = theta_mna;
  return parameters;
}

constexpr Numbers accurate{500, 1, 0.5, 100, 10, 0, 1, 0}, wrong{500, 400, 0.01, 100, 10, 0, 1, 0},
    young{500, 0, 0.01, 3, 10, 0, 1, 0};

}  // namespace

TEST(Covering, MakesMatchingRulesUntilThereAreEnoughActions) {
  xcs::Canonical operators(parameters_with(1000, 3), 8, false);
  Population population(8, 5);
  wend::Random random(1);
  for (int k = 0; k < 200; ++k) {
    const std::uint64_t state = random.word() & 0xff;
    RuleSet match;
    population.match(&state, match);
    operators.cover(population, &state, match, random);
    std::set<std::uint32_t> actions;
    for (const std::uint32_t rule : match) {
      EXPECT_TRUE(population.matches(rule, &state));
      actions.insert(population.action(rule));
    }
    EXPECT_GE(actions.size(), 3u);
    if (k == 0) {
      EXPECT_EQ(population.size(), 3u);
    }
  }
  EXPECT_EQ(population.prediction[0], 10);
  EXPECT_EQ(population.fitness[0], 0.01);
}

TEST(Covering, LeavesBitsFreeWithItsProbability) {
  Population population(64, 1);
  xcs::Parameters parameters = parameters_with(1e6, 1);
  wend::Random random(2);
  double free = 0;
  for (int k = 0; k < 2000; ++k) {
    const std::uint64_t state = random.word();
    free +=
        64 - static_cast<double>(population.specified(xcs::cover_action(population, &state, 0, 1, parameters, random)));
  }
  EXPECT_NEAR(free / 64 / 2000, 0.33, 0.005);
}

TEST(ActionSetSubsumption, TheMostGeneralAccurateRuleTakesTheSpecialOnesIn) {
  Population population(3, 2);
  add(population, "11#", 1, accurate);
  add(population, "110", 1, young);
  add(population, "1##", 1, accurate);
  add(population, "###", 1, wrong);
  Numbers three = wrong;
  three.numerosity = 3;
  add(population, "#10", 1, wrong);
  add(population, "1#0", 1, three);
  RuleSet acted{0, 1, 2, 3, 4, 5};
  population.track(&acted);
  xcs::subsume_action_set(population, acted, {});
  EXPECT_EQ(contents(population), (std::map<std::string, double>{{"1##:1", 6}, {"###:1", 1}, {"#10:1", 1}}));
  EXPECT_EQ(population.micro(), 8);
  std::set<std::uint32_t> left(acted.begin(), acted.end());
  EXPECT_EQ(left, (std::set<std::uint32_t>{0, 1, 2}));
}

TEST(Deletion, StopsAtTheLimitAndTakesCopiesOneByOne) {
  Population population(2, 2);
  Numbers many = accurate;
  many.numerosity = 50;
  add(population, "00", 0, many);
  add(population, "11", 1, many);
  wend::Random random(3);
  delete_to_limit(population, parameters_with(60), random);
  EXPECT_EQ(population.micro(), 60);
  EXPECT_EQ(population.size(), 2u);
  EXPECT_GT(population.numerosity(0), 15);
  EXPECT_GT(population.numerosity(1), 15);
  delete_to_limit(population, parameters_with(1), random);
  EXPECT_EQ(population.micro(), 1);
  EXPECT_EQ(population.size(), 1u);
}

TEST(Breeding, WaitsUntilTheSetHasRestedLongEnough) {
  xcs::Parameters parameters = parameters_with(100);
  parameters.theta_ga = 5, parameters.mu = 1, parameters.subsume_offspring = false,
  parameters.subsume_action_set = false;
  xcs::Canonical operators(parameters, 4, false);
  Population population(4, 2);
  add(population, "####", 1, accurate);
  RuleSet acted{0};
  population.track(&acted);
  wend::Random random(4);
  const std::uint64_t state = 0b1011;
  xcs::Experience experience;
  experience.state = &state, experience.action = 1;
  for (int k = 0; k < 5; ++k) operators.discover(population, experience, acted, random);
  EXPECT_EQ(population.size(), 1u);
  operators.discover(population, experience, acted, random);
  EXPECT_EQ(population.generations, 1);
  // All bits and the action mutate, within the niche.
  EXPECT_EQ(contents(population), (std::map<std::string, double>{{"####:1", 1}, {"1101:0", 2}}));
  EXPECT_EQ(population.fitness[1], 0.5 * 0.1);
  EXPECT_EQ(population.experience[1], 0);
  EXPECT_EQ(population.stamp[1], 6);
  experience.explored = false;
  for (int k = 0; k < 20; ++k) operators.discover(population, experience, acted, random);
  EXPECT_EQ(population.generations, 1) << "an exploiting step breeds nothing";
}

TEST(Breeding, ParentsTakeTheirSpecialOffspringIn) {
  xcs::Parameters parameters = parameters_with(100);
  parameters.theta_ga = 0, parameters.mu = 0.5;
  xcs::Canonical operators(parameters, 6, false);
  Population population(6, 1);
  add(population, "######", 0, accurate);
  RuleSet acted{0};
  population.track(&acted);
  wend::Random random(6);
  const std::uint64_t state = 0;
  xcs::Experience experience;
  experience.state = &state;
  for (int k = 0; k < 20; ++k) operators.discover(population, experience, acted, random);
  EXPECT_EQ(contents(population), (std::map<std::string, double>{{"######:0", 41}}));
}

TEST(Genetics, EachPlaceMutatesWithProbabilityMuAndStaysInTheNiche) {
  xcs::Parameters parameters;
  parameters.mu = 0.1;
  constexpr std::size_t bits = 70;
  const xcs::Genetics genetics(parameters, bits);
  Population population(bits, 4);
  std::string half;
  for (std::size_t j = 0; j < bits; ++j) half += j % 2 ? '#' : '1';
  add(population, half, 2, {});
  const std::uint64_t state[2] = {~std::uint64_t{0}, ~std::uint64_t{0}};
  wend::Random random(7);
  std::vector<int> changed(bits + 1);
  constexpr int n = 20000;
  for (int k = 0; k < n; ++k) {
    xcs::Offspring child;
    child.copy(population, 0);
    genetics.mutate(child, state, 4, random);
    for (std::size_t j = 0; j < bits; ++j) {
      const bool care = child.care[j / 64] >> (j % 64) & 1, value = child.value[j / 64] >> (j % 64) & 1;
      ASSERT_EQ(care, value) << "a specified bit is the state's, a free one 0";
      changed[j] += care != (half[j] == '1');
    }
    changed[bits] += child.action != 2;
    ASSERT_LT(child.action, 4u);
  }
  for (std::size_t j = 0; j <= bits; ++j) EXPECT_NEAR(changed[j] / double(n), 0.1, 0.01) << j;
}

TEST(Genetics, WithoutAStateABitBecomesOneOfTheOtherTwo) {
  xcs::Parameters parameters;
  parameters.mu = 1;
  const xcs::Genetics genetics(parameters, 3);
  Population population(3, 1);
  add(population, "01#", 0, {});
  wend::Random random(8);
  std::map<std::string, int> seen;
  for (int k = 0; k < 8000; ++k) {
    xcs::Offspring child;
    child.copy(population, 0);
    genetics.mutate(child, nullptr, 1, random);
    Population one(3, 1);
    one.add(child.care.data(), child.value.data(), 0, child.numbers);
    ++seen[one.condition(0)];
  }
  EXPECT_EQ(seen.size(), 8u);
  for (const auto& [condition, times] : seen) {
    EXPECT_TRUE(condition[0] != '0' && condition[1] != '1' && condition[2] != '#') << condition;
    EXPECT_NEAR(times, 1000, 130) << condition;
  }
}

TEST(Genetics, CrossoverExchangesOneStretchAndMeansTheNumbers) {
  constexpr std::size_t bits = 130;
  xcs::Parameters parameters;
  const xcs::Genetics genetics(parameters, bits);
  Population population(bits, 1);
  add(population, std::string(bits, '1'), 0, {100, 4, 0.2});
  add(population, std::string(bits, '#'), 0, {300, 8, 0.4});
  wend::Random random(9);
  std::vector<int> exchanged(bits);
  for (int k = 0; k < 3000; ++k) {
    xcs::Offspring a, b;
    a.copy(population, 0);
    b.copy(population, 1);
    genetics.cross(a, b, random);
    int borders = 0;
    bool before = false;
    for (std::size_t j = 0; j < bits; ++j) {
      const bool mine = a.care[j / 64] >> (j % 64) & 1, other = b.care[j / 64] >> (j % 64) & 1;
      ASSERT_NE(mine, other);
      borders += mine == before;
      exchanged[j] += !mine;
      before = !mine;
    }
    ASSERT_LE(borders, 2) << "one stretch";
    EXPECT_EQ(a.numbers.prediction, 200);
    EXPECT_EQ(b.numbers.error, 6);
    EXPECT_DOUBLE_EQ(b.numbers.fitness, 0.3);
  }
  EXPECT_GT(exchanged[65], 3000 * 0.45) << "the middle changes places in half of all crossovers";
  EXPECT_LT(exchanged[0], 3000 * 0.05);
}

TEST(Compaction, NoActionLosesItsLastRuleInAState) {
  wend::Random random(10);
  for (int k = 0; k < 200; ++k) {
    Population population(4, 2);
    for (int r = 0; r < 25; ++r) {
      std::string condition(4, '#');
      for (char& c : condition)
        if (random.chance(0.5)) c = random.chance(0.5) ? '1' : '0';
      const Numbers* kinds[] = {&accurate, &wrong, &young};
      if (!contents(population).contains(condition + ":0")) add(population, condition, 0, *kinds[random.below(3)]);
    }
    Population before(population);
    xcs::compact(population, {});
    EXPECT_EQ(population.micro(), before.micro());
    for (std::uint64_t state = 0; state < 16; ++state) {
      RuleSet had, has;
      before.match(&state, had);
      population.match(&state, has);
      EXPECT_EQ(had.empty(), has.empty());
      EXPECT_LE(has.size(), had.size());
    }
  }
}

TEST(Compaction, YoungRulesGoToAnyExperiencedOneAndOldOnesOnlyToAnAccurateOne) {
  Population population(2, 2);
  add(population, "##", 0, wrong);
  add(population, "0#", 0, accurate);
  add(population, "00", 0, wrong);
  add(population, "1#", 0, young);
  add(population, "11", 1, young);
  xcs::compact(population, {});
  EXPECT_EQ(contents(population), (std::map<std::string, double>{{"##:0", 2}, {"0#:0", 2}, {"11:1", 1}}));
}

// Learns a multiplexer and returns how many of the last 1000 exploiting trials are right.
int learn(std::size_t address, double limit, int trials, std::uint64_t seed, Population& population) {
  const xcs::testing::Multiplexer world{address};
  xcs::Canonical operators(parameters_with(limit), world.bits(), false);
  RuleSet match, acted;
  xcs::Predictions predictions;
  population.track(&acted);
  wend::Random random(seed);
  int right = 0;
  for (int t = 0; t < trials; ++t) {
    xcs::testing::explore(world, operators, population, match, acted, random);
    const std::uint64_t state = world.draw(random);
    population.match(&state, match);
    operators.predict(population, match, predictions);
    right += t >= trials - 1000 && xcs::best_action(predictions.array) == world.answer(state);
  }
  population.untrack(&acted);
  return right;
}

TEST(Multiplexer, SixBitsAreLearnedInTheMostGeneralRules) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Population population(6, 2);
    EXPECT_GE(learn(2, 400, 6000, seed, population), 998);
    EXPECT_LE(population.size(), 60u);
    std::size_t general = 0;
    for (std::uint32_t rule = 0; rule < population.size(); ++rule)
      general += population.specified(rule) == 3 && (population.care(rule)[0] & 3) == 3 &&
                 xcs::may_subsume(population, rule, {});
    EXPECT_GE(general, 14u) << "of 16: both bits of the address, its data bit, and either answer";
  }
}

TEST(Multiplexer, ElevenBitsAreLearned) {
  Population population(11, 2);
  EXPECT_GE(learn(3, 800, 15000, 1, population), 995);
  EXPECT_LE(population.size(), 140u);
}

TEST(Multiplexer, EveryKernelLearnsTheSameRules) {
  std::map<std::string, double> first;
  for (const xcs::Kernel kernel : {xcs::Kernel::kScalar, xcs::Kernel::kAvx2, xcs::Kernel::kAvx512}) {
    if (!xcs::has_kernel(kernel)) continue;
    Population population(11, 2);
    population.use(kernel);
    learn(3, 800, 3000, 5, population);
    if (first.empty()) first = contents(population);
    EXPECT_EQ(contents(population), first);
  }
}
