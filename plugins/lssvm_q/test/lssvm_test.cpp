// The machine against the dense system it stands for, and on sinc and the two spirals.
#include "lssvm.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <wend/testing.hpp>

#include "dense.hpp"

using lssvm::Dual;
using lssvm::every_loops;
using lssvm::Expansion;
using lssvm::Loops;
using lssvm::Lssvm;
using lssvm::Points;

namespace {

constexpr double pi = 3.14159265358979323846;

Expansion expansion_of(const Points& points, double sigma, const std::vector<Dual>& duals) {
  Expansion expansion(points, sigma, duals.size());
  for (std::size_t k = 0; k < duals.size(); ++k) {
    for (std::size_t i = 0; i < points.rows(); ++i) expansion.set(k, i, duals[k].alpha[i]);
    expansion.set_bias(k, duals[k].b);
  }
  return expansion;
}

double sinc(double x) {
  return x == 0 ? 1 : std::sin(x) / x;
}

// Root mean square distance to sinc on [-10, 10] of a regression on n samples with noise of 0.1, the mean of 20 draws.
double sinc_error(std::size_t n) {
  double mean = 0;
  for (std::uint64_t draw = 0; draw < 20; ++draw) {
    wend::Random random(wend::stream(n, draw));
    std::vector<double> x(n), y(n);
    for (std::size_t i = 0; i < n; ++i) {
      x[i] = random.uniform(-10, 10);
      y[i] = sinc(x[i]) + random.normal(0, 0.1);
    }
    const Points points(x, 1);
    Expansion f = expansion_of(points, 1.5, Lssvm(points, 1.5, 10).fit(y, 1));
    double square = 0;
    for (int i = 0; i <= 400; ++i) {
      const double at = -10 + i * 0.05;
      double value;
      f.evaluate(&at, &value, 1);
      square += (value - sinc(at)) * (value - sinc(at)) / 401;
    }
    mean += std::sqrt(square) / 20;
  }
  return mean;
}

// Lang & Witbrock's two spirals: point `at` of 0..96 of the first one, its mirror image of the second.
void spiral(double at, double sign, double* out) {
  const double angle = at * pi / 16, radius = 6.5 * (104 - at) / 104;
  out[0] = sign * radius * std::sin(angle);
  out[1] = sign * radius * std::cos(angle);
}

int right_on_spirals(Expansion& f, double first, int count) {
  int right = 0;
  for (int i = 0; i < count; ++i)
    for (const double sign : {1.0, -1.0}) {
      double point[2], score[2];
      spiral(first + i, sign, point);
      f.evaluate(point, score, 2);
      right += (score[0] > score[1]) == (sign > 0);
    }
  return right;
}

}  // namespace

TEST(Lssvm, IsTheSolutionOfItsDenseSystem) {
  for (const std::size_t n : {1u, 2u, 7u, 8u, 9u, 64u, 127u, 128u, 129u, 150u, 265u}) {
    const std::size_t d = 3;
    const std::vector<double> x = dense::normals(n * d, n), y = dense::normals(n, n + 1000);
    const std::vector<double> expected = dense::lssvm(x, d, 0.8, 50, y);
    const Lssvm machine(Points(x, d), 0.8, 50);
    const Dual found = machine.fit(y, 1).front();
    EXPECT_NEAR(found.b, expected[0], 1e-10) << n;
    for (std::size_t i = 0; i < n; ++i) ASSERT_NEAR(found.alpha[i], expected[i + 1], 1e-9) << n << " " << i;
    EXPECT_LT(machine.residual(found, y), 1e-12);
  }
}

TEST(Lssvm, OneFactorServesManyTargets) {
  const std::size_t n = 150;
  const std::vector<double> x = dense::normals(n * 2, 1), y = dense::normals(n * 3, 2);
  const Lssvm machine(Points(x, 2), 0.5, 10);
  const std::vector<Dual> all = machine.fit(y, 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const Dual one = machine.fit(std::span(y).subspan(k * n, n), 1).front();
    EXPECT_EQ(all[k].alpha, one.alpha);
    EXPECT_EQ(all[k].b, one.b);
  }
}

TEST(Lssvm, GivesTheSameBitsOnEveryInstructionSet) {
  const std::size_t n = 300;
  const std::vector<double> x = dense::normals(n * 5, 1), y = dense::normals(n, 2);
  const Dual first = Lssvm(Points(x, 5), 1, 100, every_loops()[0]).fit(y, 1).front();
  for (const Loops& loops : every_loops()) {
    const Dual found = Lssvm(Points(x, 5), 1, 100, loops).fit(y, 1).front();
    EXPECT_EQ(found.alpha, first.alpha) << loops.name;
    EXPECT_EQ(found.b, first.b) << loops.name;
  }
}

TEST(Lssvm, ItsResidualIsThatOfTheWholeSystem) {
  const std::vector<double> x{0, 1}, y{3, 4};
  const Lssvm machine(Points(x, 1), 1, 1);
  EXPECT_NEAR(machine.residual({{0, 0}, 0}, y), 1, 1e-15);                       // |y| / |y|
  EXPECT_NEAR(machine.residual({{0, 0}, 3}, y), std::sqrt(0.0 + 1) / 5, 1e-15);  // misses y by (0, 1)
  const double k = std::exp(-0.5);
  EXPECT_NEAR(machine.residual({{1, 0}, 0}, y), std::sqrt(1 * 1 + (2 - 3) * (2 - 3) + (k - 4) * (k - 4)) / 5, 1e-15);
}

TEST(Lssvm, ResidualStaysSmallAtTwoThousandSamples) {
  const std::vector<double> x = dense::normals(2000 * 10, 1), y = dense::normals(2000, 2);
  const Lssvm machine(Points(x, 10), 2, 10);
  EXPECT_LT(machine.residual(machine.fit(y, 1).front(), y), 1e-9);
}

TEST(Lssvm, ItsConditionIsThatOfH) {
  for (const double c : {1.0, 100.0, 1e6}) {
    const std::vector<double> x = dense::normals(60 * 2, 5);
    const double exact = dense::condition(dense::system(x, 2, 0.7, c));
    const double found = Lssvm(Points(x, 2), 0.7, c).condition();
    EXPECT_LE(found, exact * (1 + 1e-6));
    EXPECT_GE(found, exact / 3);
  }
}

TEST(Lssvm, RefusesWhatIsNotPositiveDefinite) {
  const std::vector<double> x(50, 1.0);  // the same point fifty times
  EXPECT_EQ(wend::testing::error_of([&] { Lssvm(Points(x, 1), 1, 1e300); }),
            "the LS-SVM's system of 50 samples: expected a positive definite K + I/C, found none within rounding; "
            "lower C (advice_C of the classification)");
  EXPECT_EQ(wend::testing::error_of([&] { Lssvm(Points(x, 1), 1, 1e6); }), "");
}

TEST(Lssvm, LearnsSinc) {
  const double of_50 = sinc_error(50), of_200 = sinc_error(200);
  RecordProperty("rmse_50", std::to_string(of_50));
  RecordProperty("rmse_200", std::to_string(of_200));
  EXPECT_LE(of_50, 0.058 * 1.05);
  EXPECT_LE(of_200, 0.031 * 1.05);
  EXPECT_GT(of_200, 0.01);  // it cannot know better than the noise lets it
}

TEST(Lssvm, TellsTheTwoSpiralsApart) {
  std::vector<double> x, y;
  for (int i = 0; i < 97; ++i)
    for (const double sign : {1.0, -1.0}) {
      double point[2];
      spiral(i, sign, point);
      x.insert(x.end(), point, point + 2);
      y.push_back(sign);
    }
  std::vector<double> targets = y;
  for (const double sign : y) targets.push_back(-sign);
  const Points points(x, 2);
  Expansion f = expansion_of(points, 0.6, Lssvm(points, 0.6, 100).fit(targets, 2));
  EXPECT_EQ(right_on_spirals(f, 0, 97), 194);
  EXPECT_EQ(right_on_spirals(f, 0.5, 96), 192);
}
