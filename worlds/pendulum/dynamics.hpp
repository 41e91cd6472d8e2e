// The motion of a pendulum on a cart that is free to roll.
#pragma once

namespace pendulum {

struct Constants {
  double gravity = 9.8;                      // g, m/s^2
  double pendulum_mass = 2, cart_mass = 8;   // m, M, kg
  double length = 0.5;                       // l, m
};

struct State {
  double theta = 0, theta_dot = 0;  // rad from the upright, rad/s
};

class Dynamics {
 public:
  explicit Dynamics(const Constants& constants);

  // theta_dotdot under the force u, rad/s^2.
  double acceleration(const State& state, double force) const noexcept;

  // The state after `seconds` of a constant force, by `steps` steps of the classical Runge-Kutta method.
  State advance(State state, double force, double seconds, unsigned steps) const noexcept;

 private:
  double gravity_, alpha_, coupling_, inertia_;  // g, 1 / (m + M), alpha m l, 4 l / 3
};

}  // namespace pendulum
