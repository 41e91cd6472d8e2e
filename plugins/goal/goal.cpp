// wend.goal -- where the goal is, seen from the robot.
//
//   distance   |g - p|, m, to the goal's centre
//   bearing    atan2(g_y - p_y, g_x - p_x) - heading, rad, in [-pi, pi); 0 where the distance is 0
//   radius     of the goal, m
// p and heading are true, or what odometry believes (wend/odometry.hpp).
#include <vector>
#include <wend/odometry.hpp>
#include <wend/period.hpp>
#include <wend/plugin.hpp>

namespace goal {
namespace {

class Goal {
 public:
  explicit Goal(const wend::Config& config)
      : drift_(config.params, "drift"),
        world_(config.use("world")),
        period_(wend::period_of(config.use("world"))),
        odometry_(config.rows()),
        truth_(config.rows()),
        bodies_(config.rows()),
        goals_(config.rows()) {
    if (!world_) throw wend::unsupported("a goal sensor needs a world with " WEND_GEOMETRY2D);
    columns_.box("distance", "m", 0).box("bearing", "rad", -wend::math::pi, wend::math::pi).box("radius", "m", 0);
  }

  const wend::Columns& columns() const noexcept { return columns_; }

  void begin(wend::Rows rows, wend::Episodes episodes) {
    for (std::size_t i = 0; i < rows.size(); ++i) odometry_[rows[i]].begin(episodes[i].seed, drift_);
  }

  void sense(wend::Rows rows, wend::Matrix<double> out) {
    world_.poses(rows, std::span(truth_).first(rows.size()));
    world_.bodies(rows, std::span(bodies_).first(rows.size()), std::span(goals_).first(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const wend_motion& believed = odometry_[rows[i]].update(truth_[i], period_);
      const double dx = goals_[i].x - believed.x, dy = goals_[i].y - believed.y;
      const double distance = wend::math::hypot(dx, dy);
      const double bearing = distance > 0 ? wend::math::wrap_angle(wend::math::atan2(dy, dx) - believed.heading) : 0;
      out[i][0] = distance, out[i][1] = bearing, out[i][2] = goals_[i].radius;
    }
  }

 private:
  wend::Drift drift_;
  wend::GeometryRef world_;
  double period_;  // s
  std::vector<wend::Odometry> odometry_;
  std::vector<wend_pose> truth_;
  std::vector<wend_disc> bodies_, goals_;
  wend::Columns columns_;
};

}  // namespace
}  // namespace goal

WEND_PLUGIN(wend::component<goal::Goal>("wend.goal"))
