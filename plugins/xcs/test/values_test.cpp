// Predictions, updates and votes, against numbers worked out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "update.hpp"
#include "votes.hpp"

using xcs::Numbers;
using xcs::Population;

namespace {

struct Small {
  Population population{1, 2};
  std::uint32_t add(std::uint32_t action, const Numbers& numbers) {
    const std::uint64_t none = 0;
    return population.add(&none, &none, action, numbers);
  }
};

}  // namespace

TEST(Predictions, AreMeansWeightedByFitness) {
  Small small;
  small.add(0, {100, 0, 0.1});
  small.add(0, {200, 0, 0.3});
  small.add(1, {50, 0, 0});
  xcs::Predictions predictions;
  predict(small.population, {0, 1, 2}, predictions);
  EXPECT_DOUBLE_EQ(predictions.array[0], (100 * 0.1 + 200 * 0.3) / 0.4);
  EXPECT_EQ(predictions.array[1], 50) << "without any fitness a rule's own prediction stands";
  EXPECT_EQ(xcs::best_action(predictions.array), 0u);
  predict(small.population, {2}, predictions);
  EXPECT_TRUE(std::isnan(predictions.array[0]));
  EXPECT_EQ(xcs::best_action(predictions.array), 1u);
  predict(small.population, {}, predictions);
  EXPECT_EQ(xcs::best_action(predictions.array), 2u) << "none";
}

TEST(Predictions, TheFirstOfEqualsIsBest) {
  EXPECT_EQ(xcs::best_action({1, 3, 3}), 1u);
}

TEST(Update, TakesTheMeanUntilItIsAsSlowAsBeta) {
  Small small;
  const auto rule = small.add(0, {10, 0, 0.01, 0, 5});
  xcs::Parameters parameters;
  double prediction = 10, error = 0, size = 5, fitness = 0.01;
  int n = 0;
  for (const double target : {1000.0, 0.0, 1000.0, 1000.0, 0.0, 1000.0, 1000.0}) {
    update(small.population, {rule}, target, parameters);
    const double rate = std::max(0.2, 1.0 / ++n);
    error += rate * (std::fabs(target - prediction) - error);  // of the old prediction
    prediction += rate * (target - prediction);
    size += rate * (1 - size);
    fitness += 0.2 * (1 - fitness);  // alone in its set
    EXPECT_DOUBLE_EQ(small.population.prediction[rule], prediction);
    EXPECT_DOUBLE_EQ(small.population.error[rule], error);
    EXPECT_DOUBLE_EQ(small.population.set_size[rule], size);
    EXPECT_DOUBLE_EQ(small.population.fitness[rule], fitness);
    EXPECT_EQ(small.population.experience[rule], n);
  }
}

TEST(Update, SharesFitnessByAccuracyAndNumerosity) {
  Small small;
  xcs::Parameters parameters;
  small.add(0, {0, 5, 0.5, 1000, 1, 0, 2});   // accurate, twice
  small.add(0, {0, 20, 0.5, 1000, 1, 0, 1});  // 0.1 (10 / 16)^5 after the update
  update(small.population, {0, 1}, 0, parameters);
  const double second = 0.1 * std::pow(10.0 / 16, 5);
  EXPECT_EQ(small.population.error[0], 4);
  EXPECT_EQ(small.population.error[1], 16);
  EXPECT_NEAR(small.population.fitness[0], 0.5 + 0.2 * (2 / (2 + second) - 0.5), 1e-15);
  EXPECT_NEAR(small.population.fitness[1], 0.5 + 0.2 * (second / (2 + second) - 0.5), 1e-15);
  EXPECT_NEAR(small.population.set_size[0], 1 + 0.2 * 2, 1e-15);
}

TEST(Update, WithGradientDescentStepsByTheShareOfFitness) {
  Small small;
  xcs::Parameters parameters;
  parameters.gradient = true;
  small.add(0, {0, 0, 0.3, 1000, 1, 0, 1});
  small.add(0, {0, 0, 0.1, 1000, 1, 0, 1});
  update(small.population, {0, 1}, 100, parameters);
  EXPECT_DOUBLE_EQ(small.population.prediction[0], 0.2 * 0.75 * 100);
  EXPECT_DOUBLE_EQ(small.population.prediction[1], 0.2 * 0.25 * 100);
}

TEST(Accuracy, FallsAsAPowerBeyondItsThreshold) {
  xcs::Parameters parameters;
  EXPECT_EQ(xcs::accuracy(9.99, parameters), 1);
  EXPECT_DOUBLE_EQ(xcs::accuracy(10, parameters), 0.1);
  EXPECT_DOUBLE_EQ(xcs::accuracy(20, parameters), 0.1 / 32);
  parameters.nu = 2.5;
  EXPECT_NEAR(xcs::accuracy(20, parameters), 0.1 * std::pow(0.5, 2.5), 1e-16);
}

// as x num, and mean F / F a copy as often where an experienced rule is unfit.
TEST(Votes, AreDrawnInProportion) {
  Small small;
  small.add(0, {0, 0, 0.5, 100, 4, 0, 1});    // vote 4
  small.add(0, {0, 0, 0.004, 100, 2, 0, 2});  // 0.002 a copy < 0.1 of the mean: 4 x mean / 0.002
  small.add(0, {0, 0, 0.0, 10, 3, 0, 1});     // too young: 3
  const double mean = 0.504 / 4, votes[3] = {4, 4 * mean / 0.002, 3}, total = votes[0] + votes[1] + votes[2];
  for (const xcs::Kernel kernel : {xcs::Kernel::kScalar, xcs::best_kernel()}) {
    small.population.use(kernel);
    xcs::Wheel wheel;
    wheel.cast_votes(small.population, {});
    wend::Random random(3);
    constexpr int n = 100000;
    int drawn[3] = {};
    for (int k = 0; k < n; ++k) ++drawn[wheel.draw(random)];
    for (int r = 0; r < 3; ++r) EXPECT_NEAR(drawn[r] / double(n), votes[r] / total, 0.005) << r;
  }
}

TEST(Votes, AreTheSameWithEveryKernel) {
  wend::Random random(9);
  for (const int n : {1, 7, 8, 9, 100, 1003}) {
    Small small;
    for (int r = 0; r < n; ++r)
      small.add(0,
                {0, 0, random.uniform(), random.uniform(0, 40), random.uniform(1, 50), 0, double(1 + random.below(9))});
    std::vector<std::uint32_t> first;
    for (const xcs::Kernel kernel : {xcs::Kernel::kScalar, xcs::Kernel::kAvx2, xcs::Kernel::kAvx512}) {
      if (!xcs::has_kernel(kernel)) continue;
      small.population.use(kernel);
      xcs::Wheel wheel;
      wheel.cast_votes(small.population, {});
      wend::Random draws(4);
      std::vector<std::uint32_t> drawn;
      for (int k = 0; k < 2000; ++k) drawn.push_back(wheel.draw(draws));
      if (first.empty()) first = drawn;
      EXPECT_EQ(drawn, first) << n << " rules, kernel " << static_cast<int>(kernel);
    }
  }
}

TEST(Wheel, NeverDrawsWhatHasNoWeight) {
  xcs::Wheel wheel;
  wend::Random random(1);
  wheel.set(xcs::Kernel::kScalar, {0, 1, 0, 3});
  for (int k = 0; k < 1000; ++k) EXPECT_EQ(wheel.draw(random) % 2, 1u);
  wheel.set(xcs::Kernel::kScalar, {0, 0});
  EXPECT_EQ(wheel.draw(random), Population::none);
}
