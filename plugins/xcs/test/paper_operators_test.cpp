// The paper's operators on small rule bases, by hand.
#include "paper_operators.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sharing.hpp"

namespace {

constexpr double tolerance = 1e-12;

struct Bench {
  xcs::Population population{4, 3};
  xcs::Parameters parameters;
  xcs::PaperOptions options;
  wend::Columns columns;
  wend::Random random{7};

  Bench() {
    columns.box("sonar.range.0", "m", 0, 3, 0);
    parameters.limit = 100, parameters.p_hash = 0, parameters.theta_mna = 3;
    options.merge_tolerance = 5, options.safety_distance = 0.1, options.beta_least = 1;
  }
  xcs::PaperOperators make() {
    return xcs::PaperOperators(parameters, options,
                               wend::Reading(wend::Space(columns.table()), std::string("sonar.range.0"), "clearance"));
  }
  std::uint32_t add(const char* condition, std::uint32_t action, double prediction, double experience = 50) {
    std::vector<std::uint64_t> care, value;
    EXPECT_TRUE(xcs::parse_condition(condition, 4, care, value));
    xcs::Numbers numbers;
    numbers.prediction = prediction, numbers.experience = experience, numbers.fitness = 0.5;
    return population.add(care.data(), value.data(), action, numbers);
  }
  std::uint32_t find(const char* condition, std::uint32_t action) {
    std::vector<std::uint64_t> care, value;
    EXPECT_TRUE(xcs::parse_condition(condition, 4, care, value));
    return population.find(care.data(), value.data(), action);
  }
  bool has(const char* condition, std::uint32_t action) { return find(condition, action) != xcs::Population::none; }

  // A transition from `state` (bit 0 lowest) after which the sonar reads `clearance`.
  void live(xcs::PaperOperators& operators, std::uint64_t state, std::uint32_t action, double target, double clearance,
            std::uint32_t flags = 0) {
    const double next[] = {clearance};
    xcs::Experience experience;
    experience.state = &state, experience.action = action, experience.target = target, experience.flags = flags;
    experience.next_observation = next;
    xcs::RuleSet match, acted;
    population.match(&state, match);
    xcs::advocates(population, match, action, acted);
    population.track(&acted);
    operators.update(population, experience, acted);
    operators.discover(population, experience, acted, random);
    population.untrack(&acted);
  }
};

}  // namespace

TEST(PaperOperators, CoveringMakesTheStringARuleForEachAction) {
  Bench bench;
  auto operators = bench.make();
  const std::uint64_t state = 0b0110;
  xcs::RuleSet match;
  operators.cover(bench.population, &state, match, bench.random);
  EXPECT_EQ(match.size(), 3u);
  for (std::uint32_t a = 0; a < 3; ++a) EXPECT_TRUE(bench.has("0110", a)) << a;
  operators.cover(bench.population, &state, match, bench.random);
  EXPECT_EQ(bench.population.size(), 3u) << "nothing is lacking any more";
}

TEST(PaperOperators, CoveringEvictsTheWeakestRuleThatDoesNotMatch) {
  Bench bench;
  bench.parameters.limit = 3, bench.parameters.theta_mna = 1;
  auto operators = bench.make();
  bench.population.fitness[bench.add("0000", 0, 5)] = 0.3;
  bench.population.fitness[bench.add("0001", 0, 5)] = 0.1;
  bench.population.fitness[bench.add("0011", 0, 5)] = 0.2;
  const std::uint64_t state = 0b1111;
  xcs::RuleSet match;
  operators.cover(bench.population, &state, match, bench.random);
  EXPECT_EQ(bench.population.size(), 3u);
  EXPECT_FALSE(bench.has("0001", 0));
  EXPECT_EQ(match.size(), 1u);
}

TEST(PaperOperators, BeginsWithRandomRulesWhereAskedTo) {
  Bench bench;
  bench.options.initial_rules = 20, bench.parameters.p_hash = 0.5;
  auto operators = bench.make();
  const std::uint64_t state = 0;
  xcs::RuleSet match;
  operators.cover(bench.population, &state, match, bench.random);
  EXPECT_GE(bench.population.size(), 20u);
  EXPECT_LE(bench.population.size(), 23u);
}

TEST(PaperOperators, APunishedRuleGetsAnOffspringForTheStringWithAnotherAction) {
  Bench bench;
  auto operators = bench.make();
  bench.add("0###", 1, 100);
  bench.live(operators, 0b0010, 1, -300, 1, WEND_COLLIDED | WEND_TERMINATED);
  EXPECT_EQ(bench.population.size(), 2u);
  EXPECT_TRUE(bench.has("0100", 0) || bench.has("0100", 2)) << "the condition is the string, the action another one";
}

TEST(PaperOperators, ARuleThatIsTooGeneralIsSplitWhereAskedTo) {
  Bench bench;
  bench.options.specialise = 1;
  auto operators = bench.make();
  bench.add("0###", 1, 100);
  bench.live(operators, 0b0010, 1, -300, 1, WEND_COLLIDED | WEND_TERMINATED);
  const std::uint32_t split = bench.find("0100", 1);
  ASSERT_NE(split, xcs::Population::none);
  EXPECT_EQ(bench.population.prediction[split], -300) << "what it brought";
}

// (12)-(14).
TEST(PaperOperators, TheLeastClearanceAfterTheActionDecidesAboutSafety) {
  Bench bench;
  auto operators = bench.make();
  const std::uint32_t rule = bench.add("0100", 1, 10);
  bench.live(operators, 0b0010, 1, 10, 0.1);
  EXPECT_TRUE(bench.population.marks[rule] & xcs::kUnsafe) << "at R it is unsafe";
  EXPECT_EQ(bench.population.size(), 2u) << "and punished";
  bench.live(operators, 0b0010, 1, 10, 0.11);
  EXPECT_FALSE(bench.population.marks[rule] & xcs::kUnsafe);
}

TEST(PaperOperators, UnsafeRulesHaveNoSayBesideSafeOnes) {
  Bench bench;
  auto operators = bench.make();
  const std::uint32_t safe = bench.add("01##", 1, 10), unsafe = bench.add("0#0#", 1, 50);
  bench.population.marks[unsafe] = xcs::kUnsafe;
  const std::uint64_t state = 0b0010;
  xcs::RuleSet match;
  xcs::Predictions predictions;
  bench.population.match(&state, match);
  operators.predict(bench.population, match, predictions);
  EXPECT_DOUBLE_EQ(predictions.array[1], 10);
  EXPECT_TRUE(std::isnan(predictions.array[0]));
  bench.population.marks[safe] = xcs::kUnsafe;
  operators.predict(bench.population, match, predictions);
  EXPECT_DOUBLE_EQ(predictions.array[1], 30) << "where all are unsafe, fit2 alone weighs";
}

TEST(PaperOperators, StrengthIsThePredictionAndNoWeight) {
  Bench bench;
  bench.options.strength = true;
  bench.parameters.beta = 0.5;
  auto operators = bench.make();
  const std::uint32_t rule = bench.add("0100", 1, 10);
  bench.live(operators, 0b0010, 1, 20, 1);
  EXPECT_DOUBLE_EQ(bench.population.prediction[rule], 15);
  EXPECT_DOUBLE_EQ(bench.population.fitness[rule], 15);
}

TEST(PaperOperators, TheLearningRateFallsWithExperienceDownToItsLeast) {
  Bench bench;
  bench.parameters.beta = 0.2, bench.options.beta_least = 0.05;
  auto operators = bench.make();
  const std::uint32_t rule = bench.add("0100", 1, 0, 19);  // becomes 20: 0.2 sqrt(5 / 20) = 0.1
  bench.live(operators, 0b0010, 1, 100, 1);
  EXPECT_NEAR(bench.population.prediction[rule], 10, tolerance);
  bench.population.experience[rule] = 1e6, bench.population.prediction[rule] = 0;
  bench.live(operators, 0b0010, 1, 100, 1);
  EXPECT_NEAR(bench.population.prediction[rule], 5, tolerance);
}

TEST(PaperOperators, SeededRulesLearnSlowlyAtFirst) {
  Bench bench;
  bench.options.seeded_beta = 0.01, bench.options.seeded_experience = 30;
  auto operators = bench.make();
  const std::uint32_t rule = bench.add("0100", 1, 0, 20);
  bench.population.marks[rule] = xcs::kSeeded;
  bench.live(operators, 0b0010, 1, 100, 1);
  EXPECT_NEAR(bench.population.prediction[rule], 1, tolerance);
  bench.population.experience[rule] = 29, bench.population.prediction[rule] = 0;
  bench.live(operators, 0b0010, 1, 100, 1);
  EXPECT_NEAR(bench.population.prediction[rule], 20, tolerance) << "then as fast as any other";
}

TEST(Merging, JoinsRulesThatDifferInOneBitAndKeepsTheLargerWeight) {
  Bench bench;
  bench.add("0100", 1, 50), bench.add("0110", 1, 53), bench.add("1111", 1, 0);
  EXPECT_EQ(xcs::merge(bench.population, bench.options), 1u);
  ASSERT_EQ(bench.population.size(), 2u);
  const std::uint32_t merged = bench.find("01#0", 1);
  ASSERT_NE(merged, xcs::Population::none);
  EXPECT_EQ(bench.population.prediction[merged], 53);
  EXPECT_TRUE(bench.population.marks[merged] & xcs::kMerged);
}

TEST(Merging, GoesOnUntilNoPairIsLeft) {
  Bench bench;
  for (const char* condition : {"0000", "0001", "0010", "0011"}) bench.add(condition, 2, 50);
  bench.add("1111", 0, 0);
  EXPECT_EQ(xcs::merge(bench.population, bench.options), 3u);
  EXPECT_TRUE(bench.has("00##", 2));
}

TEST(Merging, LeavesRulesApartThatMustNotMerge) {
  Bench bench;
  bench.options.merge_experience = 20;
  bench.add("0100", 1, 50), bench.add("0110", 1, 56);      // predictions too far apart
  bench.add("1000", 1, 50), bench.add("1010", 2, 50);      // different actions
  bench.add("0000", 0, 50), bench.add("0011", 0, 50);      // two bits
  bench.add("1100", 0, 50), bench.add("110#", 0, 50);      // specified in one only
  bench.add("1101", 2, 50), bench.add("1111", 2, 50, 19);  // too little experience
  bench.add("0111", 2, -90), bench.add("0101", 2, -90);    // weak
  const std::size_t n = bench.population.size();
  EXPECT_EQ(xcs::merge(bench.population, bench.options), 0u);
  EXPECT_EQ(bench.population.size(), n);
}

TEST(Merging, HappensEveryKSteps) {
  Bench bench;
  bench.options.merge_every = 2;
  auto operators = bench.make();
  bench.add("0000", 1, 50), bench.add("0010", 1, 50), bench.add("1100", 0, -10);
  bench.live(operators, 0b0011, 0, -10, 1);
  EXPECT_EQ(bench.population.size(), 3u);
  bench.live(operators, 0b0011, 0, -10, 1);
  EXPECT_EQ(bench.population.size(), 2u);
  EXPECT_EQ(bench.population.generations, 1);
}

TEST(Publishing, GivesTheOthersExperiencedMergedRulesOnce) {
  Bench a, b, c;
  a.add("01##", 1, 50, 100), a.add("0111", 1, 50, 100), a.add("1###", 2, 50, 3);
  b.add("01##", 1, -7, 30);
  c.add("#1##", 0, 9, 200);
  xcs::Population* const all[] = {&a.population, &b.population, &c.population};
  xcs::publish(all, a.parameters);
  EXPECT_EQ(a.population.size(), 4u) << "all of its own and c's";
  EXPECT_TRUE(a.has("#1##", 0));
  EXPECT_EQ(b.population.prediction[b.find("01##", 1)], -7) << "what a robot has it keeps";
  EXPECT_TRUE(c.has("01##", 1));
  EXPECT_EQ(c.population.prediction[c.find("01##", 1)], 50) << "of two offers the more experienced one";
  EXPECT_FALSE(b.has("0111", 1)) << "a rule without # is no merged one";
  EXPECT_FALSE(b.has("1###", 2)) << "and this one has too little experience";
}

TEST(Publishing, StopsAtTheLimit) {
  Bench a, b;
  a.add("01##", 1, 50, 100), a.add("0#1#", 1, 50, 100);
  b.add("0000", 0, 1);
  b.parameters.limit = 2;
  xcs::Population* const all[] = {&a.population, &b.population};
  xcs::publish(all, b.parameters);
  EXPECT_EQ(b.population.size(), 2u);
}
