// The forces against Khatib's equations.
#include "../field.hpp"

#include <gtest/gtest.h>

#include <wend/math.hpp>

using potential_field::Field;
using potential_field::Force;

namespace {

constexpr Field field{2, 400, 8, 0};

}  // namespace

TEST(Field, AttractionGrowsWithTheDistance) {
  const Force force = field.attraction(wend::math::half_pi, 5);
  EXPECT_NEAR(force.x, 0, 1e-12);
  EXPECT_DOUBLE_EQ(force.y, 10);
}

TEST(Field, ConicAttractionSaturatesBeyondDStar) {
  const Field conic{2, 400, 8, 3};
  EXPECT_DOUBLE_EQ(conic.attraction(0, 2).x, 4);
  EXPECT_DOUBLE_EQ(conic.attraction(0, 3).x, 6);
  EXPECT_DOUBLE_EQ(conic.attraction(0, 300).x, 6);
}

TEST(Field, RepulsionIsTheNegativeGradientOfItsPotential) {
  const auto potential = [](double rho) { return 0.5 * 400 * (1 / rho - 1 / 8.0) * (1 / rho - 1 / 8.0); };
  for (const double rho : {0.5, 1.0, 3.0, 7.5}) {
    const double h = 1e-6, slope = (potential(rho + h) - potential(rho - h)) / (2 * h);
    EXPECT_NEAR(field.repulsion(0, rho).x, slope, 1e-6 * -slope) << rho;  // away from an obstacle ahead is backwards
  }
}

TEST(Field, RepulsionEndsAtRho0AndIsFiniteOnContact) {
  EXPECT_EQ(field.repulsion(1, 8).magnitude(), 0);
  EXPECT_EQ(field.repulsion(1, 9).magnitude(), 0);
  EXPECT_EQ(field.repulsion(1, 0).magnitude(), field.repulsion(1, 0.008).magnitude());
  EXPECT_LT(field.repulsion(1, -1).magnitude(), 1e12);
}

TEST(Force, OfNoSizePointsAhead) {
  EXPECT_EQ(Force{}.angle(), 0);
}
