// wend.pendulum: keeps a pendulum upright by pushing the cart it stands on.
//   M. G. Lagoudakis, R. Parr: Least-Squares Policy Iteration, JMLR 4 (2003) 1107-1149, section 9.2, after
//   H. O. Wang, K. Tanaka, M. F. Griffin: An approach to fuzzy control of nonlinear systems, IEEE T. Fuzzy Systems 4
//   (1996) 14-23.
//
//   symbol           here             meaning
//   theta, theta'    State            angle from the upright, rad, and its rate, rad/s: the two columns
//   g, m, M, l       Constants        gravity, masses of pendulum and cart, length
//   alpha            Dynamics         1 / (m + M)
//   u                force            -50, 0 or +50 N (actions 0, 1, 2), plus uniform noise in [-10, 10] N a period
//
// Reward 0, and -1 for |theta| > pi/2, where the episode ends.
#include <cmath>
#include <string>
#include <wend/math.hpp>
#include <wend/plugin.hpp>

#include "dynamics.hpp"

namespace pendulum {
namespace {

Constants constants_of(const wend::Params& params) {
  return {params.number("gravity"), params.number("pendulum_mass"), params.number("cart_mass"),
          params.number("length")};
}

class Pendulum {
 public:
  explicit Pendulum(const wend::Config& config)
      : dynamics_(constants_of(config.params)),
        period_(config.params.number("period")),
        force_(config.params.number("force")),
        noise_(config.params.number("noise")),
        start_angle_(config.params.number("start_angle")),
        start_speed_(config.params.number("start_speed")),
        substeps_(static_cast<unsigned>(config.params.count("substeps"))),
        rods_(config.rows()) {
    if (config.robots() != 1)
      throw wend::unsupported("expected one robot with a pendulum, found " + std::to_string(config.robots()));
    // A limit that is a whole number of periods but for rounding is that number.
    const double periods = config.params.number("time_limit") / period_;
    limit_ = static_cast<std::uint64_t>(std::fmax(std::ceil(periods * (1 - 1e-12) - 1e-9), 1.0));
    action_.discrete("force", 3);
    seen_.box("theta", "rad", -wend::math::pi, wend::math::pi).box("theta_dot", "rad/s");
    told_.box("balanced_steps", "1", 0);
  }

  double period() const { return period_; }
  const wend::Columns& action(std::uint32_t) const { return action_; }

  void reset(wend::Rows copies, wend::Episodes episodes) {
    for (std::size_t i = 0; i < copies.size(); ++i) {
      Rod& rod = rods_[copies[i]];
      wend::Random start(wend::stream(episodes[i].seed, "start"));
      rod.state.theta = start.uniform(-start_angle_, start_angle_);
      rod.state.theta_dot = start.uniform(-start_speed_, start_speed_);
      rod.key = wend::stream(episodes[i].seed, "noise");
      rod.steps = rod.balanced = 0;
    }
  }

  void step(wend::Rows copies, wend::Matrix<const double> actions, std::span<wend_outcome> outcomes) {
    for (std::size_t i = 0; i < copies.size(); ++i) {
      Rod& rod = rods_[copies[i]];
      const double noise = wend::Random(rod.key, rod.steps).uniform(-noise_, noise_);
      const double force = force_ * (actions[i][0] - 1) + noise;
      rod.state = dynamics_.advance(rod.state, force, period_, substeps_);
      ++rod.steps;
      if (std::fabs(rod.state.theta) > wend::math::half_pi) {
        outcomes[i] = {-1, WEND_TERMINATED, 0};
        continue;
      }
      ++rod.balanced;
      outcomes[i] = {0, rod.steps == limit_ ? WEND_TRUNCATED | WEND_ARRIVED : 0u, 0};
    }
  }

  const wend::Columns& columns() const { return seen_; }
  void sense(wend::Rows rows, wend::Matrix<double> out) const {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      out[i][0] = wend::math::wrap_angle(rods_[rows[i]].state.theta);
      out[i][1] = rods_[rows[i]].state.theta_dot;
    }
  }

  const wend::Columns* telemetry(std::uint32_t when) const { return when == WEND_PER_EPISODE ? &told_ : nullptr; }
  void read(std::uint32_t, wend::Rows rows, wend::Matrix<double> out) const {
    for (std::size_t i = 0; i < rows.size(); ++i) out[i][0] = static_cast<double>(rods_[rows[i]].balanced);
  }

 private:
  struct Rod {
    State state;
    std::uint64_t key = 0, steps = 0, balanced = 0;
  };

  Dynamics dynamics_;
  double period_, force_, noise_, start_angle_, start_speed_;
  unsigned substeps_;
  std::uint64_t limit_;
  std::vector<Rod> rods_;
  wend::Columns action_, seen_, told_;
};

}  // namespace
}  // namespace pendulum

WEND_PLUGIN(wend::component<pendulum::Pendulum>("wend.pendulum"))
