// wend.range -- distances along axes around the robot, as a ring of sonars or a laser scanner gives them.
//
//   reading of axis i   d_i = min over the cone's rays of the distance from the ray's start to the first surface
//   with noise          d_i (1 + noise n) + noise_m n',  n, n' standard normal, held within [0, reach];
//                       a beam that meets nothing reads `reach` without noise: there is no echo to err on
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>
#include <wend/plugin.hpp>

#include "beams.hpp"

namespace range {
namespace {

std::vector<double> axes_of(const wend::Params& params) {
  const std::vector<double> axes = params.numbers("axes_deg");
  if (!axes.empty() && params.has("beams"))
    throw wend::parameter_error("beams", "expected either axes_deg or beams, found both");
  if (!axes.empty()) return axes;
  return spread_deg(params.has("beams") ? static_cast<std::uint32_t>(params.count("beams")) : 36u,
                    params.number("field_deg"));
}

std::uint32_t kinds_of(const wend::Params& params) {
  std::uint32_t kinds = 0;
  for (const std::string& name : params.texts("sees"))
    kinds |= name == "walls"       ? WEND_WALL
             : name == "obstacles" ? WEND_OBSTACLE
             : name == "movers"    ? WEND_MOVER
             : name == "robots"    ? WEND_ROBOT
                                   : WEND_GOAL;
  return kinds;
}

class Range {
 public:
  explicit Range(const wend::Config& config)
      : beams_(axes_of(config.params), config.params.number("cone_deg"),
               static_cast<std::uint32_t>(config.params.count("rays_per_cone"))),
        fingerprint_(beams_.fingerprint()),
        reach_(config.params.number("reach")),
        noise_(config.params.number("noise")),
        noise_m_(config.params.number("noise_m")),
        sees_(kinds_of(config.params)),
        with_kinds_(config.params.flag("kinds")),
        robots_(config.robots()),
        world_(config.use("world")),
        errors_(config.rows(), wend::Random(0)) {
    const wend::BodyRef body(config.use("world"));
    if (!world_ || !body)
      throw wend::unsupported("a range sensor needs a world with " WEND_GEOMETRY2D " and " WEND_BODY);
    for (std::uint32_t robot = 0; robot < robots_; ++robot)
      start_.push_back(config.params.text("from") == "rim" ? body.limits(robot).radius : 0);
    for (std::size_t i = 0; i < beams_.axes(); ++i)
      columns_.box("range." + std::to_string(i), "m", 0, reach_, beams_.bearing(i));
    for (std::size_t i = 0; with_kinds_ && i < beams_.axes(); ++i)
      columns_.box("kind." + std::to_string(i), "1", 0, 16, beams_.bearing(i));

    const std::size_t rays = config.rows() * beams_.rays().size();
    poses_.resize(config.rows());
    rays_.resize(rays), ray_rows_.resize(rays), distances_.resize(rays), kinds_.resize(rays);
  }

  const wend::Columns& columns() const noexcept { return columns_; }

  void begin(wend::Rows rows, wend::Episodes episodes) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      errors_[rows[i]] = wend::Random(wend::stream(wend::stream(episodes[i].seed, "wend.range"), fingerprint_));
  }

  // All rays of all rows in one call of the world.
  void sense(wend::Rows rows, wend::Matrix<double> out) {
    world_.poses(rows, std::span(poses_).first(rows.size()));
    const std::size_t per_row = beams_.rays().size(), n = rows.size() * per_row;
    for (std::size_t i = 0; i < rows.size(); ++i) place(rows[i], poses_[i], i * per_row);
    world_.cast(wend::Rows(ray_rows_.data(), n), std::span(rays_).first(n), reach_, sees_, distances_.data(),
                kinds_.data());
    for (std::size_t i = 0; i < rows.size(); ++i) read(rows[i], i * per_row, out[i]);
  }

 private:
  // The rays of one row, from `first` on.
  void place(std::uint32_t row, const wend_pose& pose, std::size_t first) {
    double s, c;
    wend::math::sincos(pose.heading, s, c);
    const double start = start_[row % robots_];
    for (std::size_t k = 0; k < beams_.rays().size(); ++k) {
      const Ray& ray = beams_.rays()[k];
      rays_[first + k] = {pose.x + start * (c * ray.cos - s * ray.sin), pose.y + start * (s * ray.cos + c * ray.sin),
                          pose.heading + ray.bearing};
      ray_rows_[first + k] = row;
    }
  }

  void read(std::uint32_t row, std::size_t first, std::span<double> out) {
    const std::size_t per_axis = beams_.rays_per_axis();
    for (std::size_t axis = 0; axis < beams_.axes(); ++axis) {
      const std::size_t begin = first + axis * per_axis;
      std::size_t nearest = begin;
      for (std::size_t k = begin; k < begin + per_axis; ++k) {
        if (!(distances_[k] >= 0)) throw bad_cast(row, distances_[k]);
        if (distances_[k] < distances_[nearest]) nearest = k;
      }
      out[axis] = perturbed(row, distances_[nearest], kinds_[nearest]);
      if (with_kinds_) out[beams_.axes() + axis] = kinds_[nearest];
    }
  }

  // Draws the same numbers whatever is seen, so that a reading's error depends on the step and the axis alone.
  double perturbed(std::uint32_t row, double distance, std::uint8_t kind) {
    const double relative = noise_ > 0 ? noise_ * errors_[row].normal() : 0;
    const double absolute = noise_m_ > 0 ? noise_m_ * errors_[row].normal() : 0;
    if (kind == WEND_NOTHING) return std::min(distance, reach_);
    return std::clamp(distance * (1 + relative) + absolute, 0.0, reach_);
  }

  static wend::Error bad_cast(std::uint32_t row, double found) {
    return wend::Error("cast of row " + std::to_string(row) +
                       ": expected a distance of 0 m or more from the world, found " +
                       (std::isnan(found) ? "NaN" : std::to_string(found)));
  }

  Beams beams_;
  std::uint64_t fingerprint_;
  double reach_, noise_, noise_m_;
  std::uint32_t sees_;
  bool with_kinds_;
  std::uint32_t robots_;
  wend::GeometryRef world_;
  std::vector<wend::Random> errors_;  // of each row
  std::vector<double> start_;         // m from the centre, of each robot
  wend::Columns columns_;
  std::vector<wend_pose> poses_, rays_;
  std::vector<std::uint32_t> ray_rows_;
  std::vector<double> distances_;
  std::vector<std::uint8_t> kinds_;
};

}  // namespace
}  // namespace range

WEND_PLUGIN(wend::component<range::Range>("wend.range"))
