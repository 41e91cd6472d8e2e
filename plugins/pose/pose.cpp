// wend.pose -- the robot's pose in the world's frame, exact or by odometry, and its speed and turn rate.
//
//   x, y, heading   true, or believed: the sum of the measured motions since the start (wend/odometry.hpp)
//   speed           signed arc length since the last decision over the period; 0 at the first
//   turn_rate       turn since the last decision over the period; 0 at the first
#include <vector>
#include <wend/odometry.hpp>
#include <wend/period.hpp>
#include <wend/plugin.hpp>

namespace pose {
namespace {

class Pose {
 public:
  explicit Pose(const wend::Config& config)
      : drift_(config.params, "drift"),
        world_(config.use("world")),
        period_(wend::period_of(config.use("world"))),
        odometry_(config.rows()),
        truth_(config.rows()) {
    if (!world_) throw wend::unsupported("a pose sensor needs a world with " WEND_GEOMETRY2D);
    columns_.box("x", "m").box("y", "m").box("heading", "rad", -wend::math::pi, wend::math::pi);
    columns_.box("speed", "m/s").box("turn_rate", "rad/s");
  }

  const wend::Columns& columns() const noexcept { return columns_; }

  void begin(wend::Rows rows, wend::Episodes episodes) {
    for (std::size_t i = 0; i < rows.size(); ++i) odometry_[rows[i]].begin(episodes[i].seed, drift_);
  }

  void sense(wend::Rows rows, wend::Matrix<double> out) {
    world_.poses(rows, std::span(truth_).first(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const wend_motion& m = odometry_[rows[i]].update(truth_[i], period_);
      const double values[] = {m.x, m.y, m.heading, m.speed, m.turn_rate};
      std::copy(std::begin(values), std::end(values), out[i].begin());
    }
  }

 private:
  wend::Drift drift_;
  wend::GeometryRef world_;
  double period_;  // s
  std::vector<wend::Odometry> odometry_;
  std::vector<wend_pose> truth_;
  wend::Columns columns_;
};

}  // namespace
}  // namespace pose

WEND_PLUGIN(wend::component<pose::Pose>("wend.pose"))
