// wend.potential_field, wend.potential_field_true -- O. Khatib, "Real-time obstacle avoidance for manipulators and
// mobile robots", The International Journal of Robotics Research 5(1), 1986.
//
//   symbol    here         meaning
//   F_x*      attraction   k_a (goal - p); beyond d* of constant size (conic), where d_star is given
//   F_(O,p)   repulsion    eta (1/rho - 1/rho_0) / rho^2 away from the obstacle's nearest point, where rho < rho_0
//   rho       rho          distance from the body's rim to the obstacle, m
//   rho_0     rho_0        distance of influence, m
//
// The robot steers to the heading of the sum.  The one component reads rho from its range columns (every beam is a
// point obstacle), the other from the true map (every shape's nearest point; privileged).
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>
#include <wend/plugin.hpp>
#include <wend/reading.hpp>
#include <wend/steer.hpp>

#include "field.hpp"
#include "nearest.hpp"

namespace potential_field {
namespace {

// What one row felt last.
struct Felt {
  Force attraction, repulsion;
  double nearest_rho = wend::math::detail::not_a_number, nearest_bearing = 0;  // NaN: nothing within rho_0

  void push(const Field& field, double bearing, double rho) {
    if (!(rho < field.rho_0)) return;
    repulsion += field.repulsion(bearing, rho);
    if (!(nearest_rho <= rho)) nearest_rho = rho, nearest_bearing = bearing;
  }
  Force total() const noexcept { return {attraction.x + repulsion.x, attraction.y + repulsion.y}; }
};

// What both components share: the goal, steering by the force, telemetry.
class Base {
 public:
  explicit Base(const wend::Config& config)
      : field_{config.params.number("k_a"), config.params.number("eta"), config.params.number("rho_0"),
               config.params.number("d_star")},
        felt_(config.rows()),
        distance_(config.observation, config.params.text("goal") + ".distance", "goal"),
        bearing_(config.observation, config.params.text("goal") + ".bearing", "goal"),
        steer_(config),
        speed_(config.params.number_or("speed", steer_.top_speed())) {
    if (!steer_.discrete() && !std::isfinite(speed_))
      throw wend::parameter_error(
          "speed", "expected a speed, since neither the body nor the action space bounds it; found none");
    columns_.box("force_x", "1").box("force_y", "1").box("force_angle", "rad", -wend::math::pi, wend::math::pi);
    columns_.box("attraction", "1", 0).box("repulsion", "1", 0);
  }

  void begin(wend::Rows rows, wend::Episodes) {
    for (const std::uint32_t row : rows) felt_[row] = {};
  }

  const wend::Columns* telemetry(std::uint32_t when) const { return when == WEND_PER_STEP ? &columns_ : nullptr; }
  void read(std::uint32_t, wend::Rows rows, wend::Matrix<double> out) const {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Felt& felt = felt_[rows[i]];
      const Force total = felt.total();
      const double values[] = {total.x, total.y, total.angle(), felt.attraction.magnitude(),
                               felt.repulsion.magnitude()};
      std::copy(std::begin(values), std::end(values), out[i].begin());
    }
  }
  void explain(std::uint32_t row, wend::Writer& writer) const {
    const Felt& felt = felt_[row];
    const auto degrees = [](double angle) { return angle / wend::math::degree; };
    char text[240];
    int n = std::snprintf(text, sizeof text, "attraction %.3g at %+.0f deg, ", felt.attraction.magnitude(),
                          degrees(felt.attraction.angle()));
    n += std::isnan(felt.nearest_rho)
             ? std::snprintf(text + n, sizeof text - n, "nothing within %.3g m", field_.rho_0)
             : std::snprintf(text + n, sizeof text - n, "repulsion %.3g at %+.0f deg (nearest: %.3g m at %+.0f deg)",
                             felt.repulsion.magnitude(), degrees(felt.repulsion.angle()), felt.nearest_rho,
                             degrees(felt.nearest_bearing));
    n += std::snprintf(text + n, sizeof text - n, "; steers to %+.0f deg", degrees(felt.total().angle()));
    writer.text({text, static_cast<std::size_t>(n)});
  }

 protected:
  Felt& attracted(std::uint32_t row, std::span<const double> observation) {
    Felt& felt = felt_[row] = {};
    felt.attraction = field_.attraction(bearing_(observation), distance_(observation));
    return felt;
  }
  void steer(const Felt& felt, std::span<double> action) const { steer_.towards(felt.total().angle(), speed_, action); }

  Field field_;
  std::vector<Felt> felt_;  // of each row

 private:
  wend::Reading distance_, bearing_;  // of the goal
  wend::Steer steer_;
  double speed_;  // m/s
  wend::Columns columns_;
};

class FromSensor : public Base {
 public:
  explicit FromSensor(const wend::Config& config)
      : Base(config), ranges_(config.observation, config.params.texts("observe"), "observe") {}

  void act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Felt& felt = attracted(rows[i], observations[i]);
      for (std::size_t k = 0; k < ranges_.size(); ++k) {
        const double rho = ranges_(observations[i], k);
        if (rho < ranges_.column(k).high) felt.push(field_, ranges_.bearing(k), rho);  // the reach itself is no echo
      }
      steer(felt, actions[i]);
    }
  }

 private:
  wend::Reading ranges_;  // m, from the rim
};

class FromMap : public Base {
 public:
  explicit FromMap(const wend::Config& config)
      : Base(config),
        world_(config.use("world")),
        robots_(config.robots()),
        poses_(config.rows()),
        bodies_(config.rows()),
        goals_(config.rows()),
        team_(config.robots()),
        team_bodies_(config.robots()),
        team_goals_(config.robots()) {
    if (!world_) throw wend::unsupported("the potential field of true distances needs a world with " WEND_GEOMETRY2D);
  }

  void act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) {
    world_.poses(rows, std::span(poses_).first(rows.size()));
    world_.bodies(rows, std::span(bodies_).first(rows.size()), std::span(goals_).first(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Felt& felt = attracted(rows[i], observations[i]);
      const wend_disc& body = bodies_[i];
      const auto push = [&](double dx, double dy, double distance) {
        if (distance > 0)
          felt.push(field_, wend::math::wrap_angle(wend::math::atan2(dy, dx) - poses_[i].heading),
                    distance - body.radius);
      };
      const std::uint32_t copy = rows[i] / robots_;
      for (const Near& near : obstacles_.around(body.x, body.y, field_.rho_0 + body.radius, world_.shapes(copy)))
        push(near.dx, near.dy, near.distance);
      if (robots_ > 1) each_other(rows[i], body, push);
      steer(felt, actions[i]);
    }
  }

 private:
  template <class Push>
  void each_other(std::uint32_t row, const wend_disc& body, Push&& push) {
    const std::uint32_t first = row - row % robots_;
    for (std::uint32_t robot = 0; robot < robots_; ++robot) team_[robot] = first + robot;
    world_.bodies(team_, team_bodies_, team_goals_);
    for (std::uint32_t robot = 0; robot < robots_; ++robot) {
      const double dx = team_bodies_[robot].x - body.x, dy = team_bodies_[robot].y - body.y;
      if (team_[robot] != row) push(dx, dy, wend::math::hypot(dx, dy) - team_bodies_[robot].radius);
    }
  }

  wend::GeometryRef world_;
  std::uint32_t robots_;
  Obstacles obstacles_;
  std::vector<wend_pose> poses_;
  std::vector<wend_disc> bodies_, goals_;
  std::vector<std::uint32_t> team_;
  std::vector<wend_disc> team_bodies_, team_goals_;
};

}  // namespace
}  // namespace potential_field

WEND_PLUGIN(wend::component<potential_field::FromSensor>("wend.potential_field"),
            wend::component<potential_field::FromMap>("wend.potential_field_true"))
