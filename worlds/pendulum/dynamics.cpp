#include "dynamics.hpp"

#include <wend/math.hpp>

namespace pendulum {

Dynamics::Dynamics(const Constants& c)
    : gravity_(c.gravity),
      alpha_(1 / (c.pendulum_mass + c.cart_mass)),
      coupling_(alpha_ * c.pendulum_mass * c.length),
      inertia_(4 * c.length / 3) {}

// sin(2 theta) / 2 = sin(theta) cos(theta).
double Dynamics::acceleration(const State& state, double force) const noexcept {
  double sine, cosine;
  wend::math::sincos(state.theta, sine, cosine);
  const double moment =
      gravity_ * sine - coupling_ * state.theta_dot * state.theta_dot * sine * cosine - alpha_ * cosine * force;
  return moment / (inertia_ - coupling_ * cosine * cosine);
}

State Dynamics::advance(State state, double force, double seconds, unsigned steps) const noexcept {
  const double h = seconds / steps;
  for (unsigned i = 0; i < steps; ++i) {
    const auto from = [&](const State& slope, double dt) {
      return State{state.theta + dt * slope.theta, state.theta_dot + dt * slope.theta_dot};
    };
    const auto slope = [&](const State& at) { return State{at.theta_dot, acceleration(at, force)}; };
    const State k1 = slope(state), k2 = slope(from(k1, h / 2)), k3 = slope(from(k2, h / 2)), k4 = slope(from(k3, h));
    state.theta += h / 6 * (k1.theta + 2 * k2.theta + 2 * k3.theta + k4.theta);
    state.theta_dot += h / 6 * (k1.theta_dot + 2 * k2.theta_dot + 2 * k3.theta_dot + k4.theta_dot);
  }
  return state;
}

}  // namespace pendulum
