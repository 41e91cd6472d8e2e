// The equations of motion of a pole hinged on a cart, with friction.
#pragma once
#include <array>

namespace cart_pole {

struct Plant {
  double gravity, cart_mass, pole_mass, half_length, cart_friction, pole_friction;
};

// Angle of the pole from upright and its rate (rad, rad/s, to the right), position of the cart and its speed (m, m/s).
struct State {
  double theta = 0, theta_dot = 0, x = 0, x_dot = 0;
};

// Time derivatives of the state's elements, in its order, under the force on the cart (N).
std::array<double, 4> derivatives(const Plant& plant, const State& state, double force) noexcept;

// The state `dt` later, the force held: one step of Runge and Kutta's fourth order, or of Euler's method.
State advance_rk4(const Plant& plant, const State& state, double force, double dt) noexcept;
State advance_euler(const Plant& plant, const State& state, double force, double dt) noexcept;

}  // namespace cart_pole
