// The arena: parameters, metrics, and what a robot knows of its own body.
#include "world.hpp"

#include "scenes/scene_file.hpp"

namespace arena {
namespace {

enum Metric { time_s, path, nearest, optimal, spl, turning, over_optimal, score };

double goal_radius_or(const wend::Params& params, double otherwise) {
  for (const char* path : {"goal_radius", "generate/goal_radius"})
    if (const double given = params.number_or(path, -1); given > 0) return given;
  return otherwise;
}

}  // namespace

Options::Options(const wend::Config& config)
    : dt(config.params.number("dt")),
      substeps(static_cast<std::uint32_t>(config.params.count("substeps"))),
      radius(config.robot.number("body/radius")),
      stop_distance(config.robot.number_or("stop_distance", 0)),
      draw_clearance(config.params.number_or("draw/clearance", config.params.number_or("generate/clearance", 0))),
      draw_distance(config.params.number_or("draw/distance", config.params.number_or("generate/distance", 0))),
      goal_radius(goal_radius_or(config.params, radius > 0 ? radius : 1)),
      optimal(config.params.number_or("optimal", 1) != 0),
      optimal_cell(config.params.number_or("optimal_cell", 0)),
      optimal_speed(config.params.number_or("optimal_speed", 0)),
      arrive(config.params.number_or("reward/arrive", 1)),
      collide(config.params.number_or("reward/collide", -1)),
      step(config.params.number_or("reward/step", 0)) {
  // A limit that is a whole number of dt but for rounding is that number.
  const double ticks = config.params.number("time_limit") / dt;
  if (ticks > 1e12)
    throw wend::parameter_error("time_limit", "expected at most 1e12 steps of dt, found " + std::to_string(ticks));
  limit = static_cast<std::uint64_t>(std::max(std::ceil(ticks * (1 - 1e-12) - 1e-9), 1.0));
  if (optimal_speed > 0 && !optimal)
    throw wend::parameter_error("optimal_speed",
                                "expected 0 where optimal is false, found " + std::to_string(optimal_speed));
}

World::World(const wend::Config& config)
    : options_(config),
      robots_(config.robots()),
      kinematics_(config.robot, options_.dt, options_.period()),
      source_(read_source(config.params)),
      rows_(config.rows()),
      copies_(config.copies()),
      maps_(config.rows()) {
  places_.reserve(copies_.size() + 17);
  metrics_.box("time_s", "s", 0)
      .box("path_length_m", "m", 0)
      .box("min_clearance_m", "m")
      .box("optimal_length_m", "m", 0)
      .box("spl", "1", 0, 1)
      .box("heading_change_rate", "rad/s", 0);
  if (options_.optimal_speed > 0) metrics_.box("time_over_optimal", "1", 0).box("barn_score", "1", 0, 0.5);
}

wend_limits World::limits(std::uint32_t) const {
  wend_limits out{};
  out.radius = options_.radius, out.stop_distance = options_.stop_distance;
  kinematics_.limits(out);
  return out;
}

void World::predict(std::uint32_t, std::span<const wend_motion> from, wend::Matrix<const double> actions,
                    double seconds, std::span<wend_motion> to) const {
  for (std::size_t k = 0; k < from.size(); ++k) to[k] = kinematics_.predict(from[k], actions[k], seconds);
}

// The scene as it stands: things that move at their present place, robots' starts and goals where they are now.
void World::write_scene(std::uint32_t index, wend::Writer& writer) const {
  const Copy& copy = copies_[index];
  if (!copy.place) throw wend::Error(WEND_E_ARGUMENT, {}, "the copy has no scene before its first reset");
  Scene scene = copy.place->scene();
  const Robot* robots = &rows_[std::size_t{index} * robots_];
  for (std::uint32_t r = 0; r < robots_; ++r) {
    const Robot& robot = robots[r];
    if (r >= scene.starts.size()) scene.starts.push_back({robot.motion.x, robot.motion.y, robot.motion.heading, false});
    if (r >= scene.goals.size()) scene.goals.push_back({robot.goal_x, robot.goal_y, robot.goal_radius, {}, 0});
  }
  writer.text(format_scene(scene));
}

const wend::Columns* World::telemetry(std::uint32_t when) const noexcept {
  return when == WEND_PER_EPISODE ? &metrics_ : nullptr;
}

// Times and lengths of ways that did not arrive are no number, and its scores are 0.
void World::read(std::uint32_t, wend::Rows rows, wend::Matrix<double> out) const {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Robot& robot = rows_[rows[k]];
    const std::span<double> to = out[k];
    const bool arrived = (robot.ended & WEND_ARRIVED) != 0, known = robot.optimal >= 0;
    const double seconds = static_cast<double>(robot.ticks) * options_.dt;
    const double longer = std::max(robot.path, robot.optimal);
    to[time_s] = arrived ? seconds : none;
    to[path] = arrived ? robot.path : none;
    to[nearest] = robot.nearest;
    to[optimal] = robot.optimal;
    to[spl] = !known ? none : !arrived ? 0 : longer > 0 ? robot.optimal / longer : 1;
    to[turning] = seconds > 0 ? robot.turned / seconds : none;
    if (options_.optimal_speed <= 0) continue;
    const double best = robot.optimal / options_.optimal_speed;
    to[over_optimal] = arrived && known && best > 0 ? seconds / best : none;
    to[score] = !known ? none : !arrived ? 0 : best > 0 ? best / std::min(std::max(seconds, 2 * best), 8 * best) : 0.5;
  }
}

}  // namespace arena
