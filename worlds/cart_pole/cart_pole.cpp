// wend.cart_pole: balancing a pole on a cart, as adaptive critics were first judged by.
//   J. Si, Y.-T. Wang: On-line learning control by association and reinforcement, IEEE Transactions on Neural Networks
//   12(2), 2001, 264-276.
//
//   symbol          here                    meaning
//   theta, x        State                   angle of the pole from upright, position of the cart
//   F               force                   action 0 is -force, action 1 is force, N
//   m_c, m, l       Plant                   masses, half the pole's length
//   mu_c, mu_p      Plant                   friction of the cart and of the pole
//   r               outcome                 -1 where the trial fails, else 0
#include <cmath>
#include <limits>
#include <string>
#include <vector>
#include <wend/plugin.hpp>

#include "plant.hpp"

namespace cart_pole {
namespace {

// Throws where the parameter is above the one that limits it.
void expect_within(const wend::Params& params, const char* parameter, const char* limit) {
  if (params.number(parameter) > params.number(limit))
    throw wend::parameter_error(parameter, std::string("expected at most ") + limit + " = " +
                                               wend::number_text(params.number(limit)) + ", found " +
                                               wend::number_text(params.number(parameter)));
}

bool finite(const State& state) noexcept {
  return std::isfinite(state.theta) && std::isfinite(state.theta_dot) && std::isfinite(state.x) &&
         std::isfinite(state.x_dot);
}

struct Copy {
  State state;
  std::uint64_t steps = 0, noise_key = 0;
  double reading_error = 0;  // of the angle, relative
  double largest_angle = 0;  // rad
};

class CartPole {
 public:
  explicit CartPole(const wend::Config& config)
      : plant_{config.params.number("gravity"),       config.params.number("cart_mass"),
               config.params.number("pole_mass"),     config.params.number("half_length"),
               config.params.number("cart_friction"), config.params.number("pole_friction")},
        force_(config.params.number("force")),
        dt_(config.params.number("dt")),
        angle_limit_(config.params.number("angle_limit_deg") * wend::math::degree),
        track_(config.params.number("track")),
        start_angle_(config.params.number("start_angle_deg") * wend::math::degree),
        start_position_(config.params.number("start_position")),
        sensor_uniform_(config.params.number("sensor_uniform")),
        sensor_deviation_(wend::math::sqrt(config.params.number("sensor_gaussian"))),
        actuator_uniform_(config.params.number("actuator_uniform")),
        goal_(config.params.count("steps")),
        euler_(config.params.text("integrator") == "euler"),
        copies_(config.rows()) {
    if (config.robots() != 1)
      throw wend::unsupported("expected one cart in a world, found " + std::to_string(config.robots()) + " robots");
    expect_within(config.params, "start_angle_deg", "angle_limit_deg");
    expect_within(config.params, "start_position", "track");
    push_.discrete("push", 2);
    seen_.box("theta", "rad").box("theta_dot", "rad/s").box("x", "m").box("x_dot", "m/s");
    told_.box("balanced_steps", "1", 0, static_cast<double>(goal_)).box("balanced_s", "s", 0);
    told_.box("largest_angle_deg", "deg", 0);
  }

  double period() const { return dt_; }
  const wend::Columns& action(std::uint32_t) const { return push_; }

  void reset(wend::Rows copies, wend::Episodes episodes) {
    for (std::size_t i = 0; i < copies.size(); ++i) {
      Copy& copy = copies_[copies[i]];
      wend::Random start(wend::stream(episodes[i].seed, "start"));
      copy = {};
      copy.state.theta = start_angle_ * start.uniform(-1, 1);
      copy.state.x = start_position_ * start.uniform(-1, 1);
      copy.noise_key = wend::stream(episodes[i].seed, "noise");
      draw_reading_error(copy);
    }
  }

  void step(wend::Rows copies, wend::Matrix<const double> actions, std::span<wend_outcome> outcomes) {
    for (std::size_t i = 0; i < copies.size(); ++i)
      outcomes[i] = step(copies_[copies[i]], actions[i][0] >= 0.5 ? force_ : -force_);
  }

  const wend::Columns& columns() const { return seen_; }
  void sense(wend::Rows rows, wend::Matrix<double> out) const {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Copy& copy = copies_[rows[i]];
      out[i][0] = copy.state.theta * (1 + copy.reading_error);
      out[i][1] = copy.state.theta_dot, out[i][2] = copy.state.x, out[i][3] = copy.state.x_dot;
    }
  }

  const wend::Columns* telemetry(std::uint32_t when) const { return when == WEND_PER_EPISODE ? &told_ : nullptr; }
  void read(std::uint32_t, wend::Rows rows, wend::Matrix<double> out) const {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Copy& copy = copies_[rows[i]];
      out[i][0] = static_cast<double>(copy.steps), out[i][1] = static_cast<double>(copy.steps) * dt_;
      out[i][2] = copy.largest_angle / wend::math::degree;
    }
  }

 private:
  wend_outcome step(Copy& copy, double force) {
    if (actuator_uniform_ > 0)  // positions 4 k are the forces', 4 k + 1 and 4 k + 2 the readings'
      force *= 1 + actuator_uniform_ * wend::Random(copy.noise_key, 4 * copy.steps).uniform(-1, 1);
    copy.state = euler_ ? advance_euler(plant_, copy.state, force, dt_) : advance_rk4(plant_, copy.state, force, dt_);
    ++copy.steps;
    draw_reading_error(copy);
    if (!finite(copy.state))
      throw wend::Error(WEND_E_PARAMETER, "dt",
                        "step " + std::to_string(copy.steps) +
                            ": the state is no longer finite; take a smaller dt, or less extreme masses and forces");
    const double angle = std::fabs(copy.state.theta);
    copy.largest_angle = std::max(copy.largest_angle, angle);
    if (!(angle <= angle_limit_ && std::fabs(copy.state.x) <= track_)) return {-1, WEND_TERMINATED | WEND_COLLIDED, 0};
    return {0, copy.steps == goal_ ? WEND_TERMINATED | WEND_ARRIVED : 0u, 0};
  }

  void draw_reading_error(Copy& copy) const {
    wend::Random random(copy.noise_key, 4 * copy.steps + 1);
    copy.reading_error = 0;
    if (sensor_uniform_ > 0) copy.reading_error += sensor_uniform_ * random.uniform(-1, 1);
    if (sensor_deviation_ > 0) copy.reading_error += sensor_deviation_ * random.normal();
  }

  Plant plant_;
  double force_, dt_, angle_limit_, track_, start_angle_, start_position_;
  double sensor_uniform_, sensor_deviation_, actuator_uniform_;
  std::uint64_t goal_;
  bool euler_;
  std::vector<Copy> copies_;
  wend::Columns push_, seen_, told_;
};

}  // namespace
}  // namespace cart_pole

WEND_PLUGIN(wend::component<cart_pole::CartPole>("wend.cart_pole"))
