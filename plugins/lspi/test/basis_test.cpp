// Every basis against its definition, written out.
#include "basis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

std::vector<double> features(const lspi::Basis& basis, const std::vector<double>& state) {
  std::vector<double> all(basis.size());
  basis.evaluate(state, all);
  return all;
}

// The values of all monomials of total degree at most `degree` in x, by counting through the exponents.
std::vector<double> all_monomials(const std::vector<double>& x, int degree) {
  std::vector<double> all;
  std::vector<int> exponents(x.size(), 0);
  while (true) {
    int total = 0;
    double product = 1;
    for (std::size_t v = 0; v < x.size(); ++v) {
      total += exponents[v];
      product *= std::pow(x[v], exponents[v]);
    }
    if (total <= degree) all.push_back(product);
    std::size_t v = 0;
    while (v < x.size() && ++exponents[v] > degree) exponents[v++] = 0;
    if (v == x.size()) return all;
  }
}

}  // namespace

TEST(Powers, AreOfTheScaledVariables) {
  const auto basis = lspi::powers({{0, 20}, {-1, 3}}, 3);
  EXPECT_EQ(features(*basis, {0, 3}), (std::vector<double>{1, -1, 1, -1, 1, 1, 1}));
  EXPECT_EQ(features(*basis, {15, 1}), (std::vector<double>{1, 0.5, 0.25, 0.125, 0, 0, 0}));
}

TEST(Powers, OfSixDistancesAre25) {
  EXPECT_EQ(lspi::powers(std::vector<lspi::Range>(6, {0, 20}), 4)->size(), 25u);
}

TEST(Monomials, AreAllOfThemOnce) {
  const auto basis = lspi::monomials(std::vector<lspi::Range>(6, {-1, 1}), 4);
  ASSERT_EQ(basis->size(), 210u);
  const std::vector<double> x{0.9, -0.83, 0.71, -0.67, 0.59, 0.53};
  std::vector<double> found = features(*basis, x), expected = all_monomials(x, 4);
  std::sort(found.begin(), found.end());
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-14) << k;
}

TEST(Monomials, AreOfTheScaledVariables) {
  EXPECT_EQ(features(*lspi::monomials({{0, 4}, {0, 8}}, 2), {3, 6}),
            (std::vector<double>{1, 0.5, 0.5, 0.25, 0.25, 0.25}));
}

TEST(Monomials, OfDegreeOneAreTheVariables) {
  EXPECT_EQ(features(*lspi::monomials({{-1, 1}, {-1, 1}}, 1), {0.25, -0.5}), (std::vector<double>{1, 0.25, -0.5}));
}

TEST(Gaussians, StandOnTheGridOfAllCentres) {
  const auto basis = lspi::gaussians({{-1, 1}, {0, 2, 5}}, 0.7);
  ASSERT_EQ(basis->size(), 7u);
  const std::vector<double> found = features(*basis, {0.3, 1.5});
  EXPECT_EQ(found[0], 1);
  std::size_t k = 1;
  for (const double x : {-1.0, 1.0})
    for (const double y : {0.0, 2.0, 5.0}) {
      const double square = (0.3 - x) * (0.3 - x) + (1.5 - y) * (1.5 - y);
      EXPECT_NEAR(found[k++], std::exp(-square / (2 * 0.7 * 0.7)), 1e-15);
    }
}

TEST(Basis, TellsItselfFromOthers) {
  EXPECT_EQ(lspi::powers({{0, 20}}, 4)->name(), "powers 1 4");
  EXPECT_EQ(lspi::monomials({{0, 20}}, 4)->name(), "monomials 1 4");
  EXPECT_EQ(lspi::gaussians({{0, 1}}, 1)->name(), "gaussians 1 3");
  EXPECT_EQ(lspi::powers({{0, 20}}, 4)->constants(), (std::vector<double>{0, 20}));
  EXPECT_NE(lspi::gaussians({{0, 1}}, 1)->constants(), lspi::gaussians({{0, 1}}, 2)->constants());
  EXPECT_NE(lspi::gaussians({{0, 1}}, 1)->constants(), lspi::gaussians({{0, 3}}, 1)->constants());
}
