// The motion against conserved energy, the linearised closed form, and Lagrange's equations integrated otherwise.
#include "dynamics.hpp"

#include <gtest/gtest.h>

#include <cmath>

using pendulum::Constants;
using pendulum::Dynamics;
using pendulum::State;

namespace {

const Constants paper;

// From both of Lagrange's equations, with the cart's acceleration a as the second unknown:
//   (M + m) a + m l cos(theta) theta'' = u + m l sin(theta) theta'^2
//   m l cos(theta) a + 4/3 m l^2 theta'' = m g l sin(theta)
double by_lagrange(const State& s, double u) {
  const double m = paper.pendulum_mass, l = paper.length, c = m * l * std::cos(s.theta), d = m * l * std::sin(s.theta);
  const double a11 = paper.cart_mass + m, a22 = 4.0 / 3 * m * l * l;
  const double b1 = u + d * s.theta_dot * s.theta_dot, b2 = paper.gravity * d;
  return (a11 * b2 - c * b1) / (a11 * a22 - c * c);
}

// The explicit midpoint rule in very small steps.
State by_midpoints(State s, double u, double seconds, int steps) {
  const double h = seconds / steps;
  for (int i = 0; i < steps; ++i) {
    const State half{s.theta + h / 2 * s.theta_dot, s.theta_dot + h / 2 * by_lagrange(s, u)};
    s = {s.theta + h * half.theta_dot, s.theta_dot + h * by_lagrange(half, u)};
  }
  return s;
}

// Per unit of mass and length, where no force acts.
double energy(const State& s) {
  const double coupling = paper.pendulum_mass * paper.length / (paper.pendulum_mass + paper.cart_mass);
  const double inertia = 4 * paper.length / 3 - coupling * std::cos(s.theta) * std::cos(s.theta);
  return inertia * s.theta_dot * s.theta_dot / 2 + paper.gravity * std::cos(s.theta);
}

}  // namespace

TEST(Dynamics, AccelerationIsThatOfLagrangesEquations) {
  const Dynamics dynamics(paper);
  for (const double theta : {-1.5, -0.4, 0.0, 0.3, 1.2})
    for (const double rate : {-3.0, 0.0, 2.0})
      for (const double u : {-60.0, 0.0, 47.0})
        EXPECT_NEAR(dynamics.acceleration({theta, rate}, u), by_lagrange({theta, rate}, u), 1e-12);
}

TEST(Dynamics, APeriodAgreesWithAnotherIntegration) {
  const Dynamics dynamics(paper);
  for (const double theta : {-1.2, 0.0, 0.5})
    for (const double rate : {-2.0, 0.0, 4.0})
      for (const double u : {-55.0, 0.0, 42.0}) {
        const State other = by_midpoints({theta, rate}, u, 0.1, 20000);
        const State usual = dynamics.advance({theta, rate}, u, 0.1, 4);
        const State fine = dynamics.advance({theta, rate}, u, 0.1, 40);
        EXPECT_NEAR(usual.theta, other.theta, 1e-6) << theta << " " << rate << " " << u;
        EXPECT_NEAR(usual.theta_dot, other.theta_dot, 1e-5) << theta << " " << rate << " " << u;
        EXPECT_NEAR(fine.theta, other.theta, 2e-9) << theta << " " << rate << " " << u;
        EXPECT_NEAR(fine.theta_dot, other.theta_dot, 2e-8) << theta << " " << rate << " " << u;
      }
}

TEST(Dynamics, EnergyIsConservedWithoutAForce) {
  const Dynamics dynamics(paper);
  State state{0.3, -0.2};
  const double before = energy(state);
  double farthest = 0;
  for (int i = 0; i < 100; ++i) {  // it falls through and swings
    state = dynamics.advance(state, 0, 0.1, 40);
    EXPECT_NEAR(energy(state), before, 1e-7);
    farthest = std::fmax(farthest, std::fabs(state.theta));
  }
  EXPECT_GT(farthest, 3) << "it has not been below";
}

TEST(Dynamics, NearTheUprightItFallsExponentially) {
  // theta'' = lambda^2 theta: theta0 cosh(lambda t), where lambda^2 = g / (4 l / 3 - alpha m l).
  const double lambda = std::sqrt(9.8 / (4 * 0.5 / 3 - 0.1));
  const State state = Dynamics(paper).advance({1e-6, 0}, 0, 0.5, 100);
  EXPECT_NEAR(state.theta, 1e-6 * std::cosh(lambda * 0.5), 1e-13);
  EXPECT_NEAR(state.theta_dot, 1e-6 * lambda * std::sinh(lambda * 0.5), 1e-12);
}

TEST(Dynamics, MirrorImagesStayMirrorImages) {
  const Dynamics dynamics(paper);
  const State one = dynamics.advance({0.2, -1}, 47, 0.1, 4), other = dynamics.advance({-0.2, 1}, -47, 0.1, 4);
  EXPECT_EQ(one.theta, -other.theta);
  EXPECT_EQ(one.theta_dot, -other.theta_dot);
}
