#include "plant.hpp"

#include <wend/math.hpp>

namespace cart_pole {
namespace {

State moved(const State& s, const std::array<double, 4>& d, double t) noexcept {
  return {s.theta + t * d[0], s.theta_dot + t * d[1], s.x + t * d[2], s.x_dot + t * d[3]};
}

}  // namespace

// thdd = (g sin th + cos th (-F - m l thd^2 sin th + mu_c sgn xd) / (m_c + m) - mu_p thd / (m l))
//        / (l (4/3 - m cos^2 th / (m_c + m)))
// xdd  = (F + m l (thd^2 sin th - thdd cos th) - mu_c sgn xd) / (m_c + m)
std::array<double, 4> derivatives(const Plant& plant, const State& state, double force) noexcept {
  double sine, cosine;
  wend::math::sincos(state.theta, sine, cosine);
  const double mass = plant.cart_mass + plant.pole_mass, moment = plant.pole_mass * plant.half_length;
  const double friction = plant.cart_friction * ((state.x_dot > 0) - (state.x_dot < 0));
  const double swing = moment * state.theta_dot * state.theta_dot * sine;
  const double theta_ddot = (plant.gravity * sine + cosine * (-force - swing + friction) / mass -
                             plant.pole_friction * state.theta_dot / moment) /
                            (plant.half_length * (4.0 / 3 - plant.pole_mass * cosine * cosine / mass));
  const double x_ddot = (force + swing - moment * theta_ddot * cosine - friction) / mass;
  return {state.theta_dot, theta_ddot, state.x_dot, x_ddot};
}

State advance_rk4(const Plant& plant, const State& state, double force, double dt) noexcept {
  const auto k1 = derivatives(plant, state, force);
  const auto k2 = derivatives(plant, moved(state, k1, dt / 2), force);
  const auto k3 = derivatives(plant, moved(state, k2, dt / 2), force);
  const auto k4 = derivatives(plant, moved(state, k3, dt), force);
  std::array<double, 4> mean;
  for (std::size_t i = 0; i < 4; ++i) mean[i] = (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]) / 6;
  return moved(state, mean, dt);
}

State advance_euler(const Plant& plant, const State& state, double force, double dt) noexcept {
  return moved(state, derivatives(plant, state, force), dt);
}

}  // namespace cart_pole
