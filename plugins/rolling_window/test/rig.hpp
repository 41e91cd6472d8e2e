// A robot with window, sonars, goal and pose sensor in a plane of discs, driven by the component through its C tables.
#pragma once
#include <cmath>
#include <memory>
#include <string>
#include <vector>
#include <wend/odometry.hpp>
#include <wend/random.hpp>
#include <wend/testing_plane.hpp>

namespace rig {

using wend::Random;
using wend::testing::Bench;
using wend::testing::Plane;

struct Robot {
  wend_limits limits{3, 0, 0, 0.5, 0.25 / 3, wend::math::detail::infinity, wend::math::detail::infinity, 3};
  std::vector<std::pair<double, double>> table{{0.5, 0}, {0.25, 0.25 / 3}, {0.25, -0.25 / 3}};  // none: continuous
  double dt = 1, time_limit = 2000;
  double reach = 20, range_noise = 0, actuator_noise = 0;
  wend::Drift drift;
  bool sonars = true;
};

// The SIMROBOT of Liu et al., and the disc of the BARN protocol.
inline Robot simrobot() {
  return {};
}
inline Robot barn(bool hard) {
  Robot robot;
  robot.limits = {0.3, 0, 0, 2, wend::math::pi, wend::math::detail::infinity, wend::math::detail::infinity, 0};
  robot.table.clear();
  robot.dt = 0.1, robot.time_limit = 100, robot.reach = 5, robot.range_noise = 0.02, robot.actuator_noise = 0.05,
  robot.sonars = false;
  if (hard) {
    robot.limits.acceleration = 2, robot.dt = 0.2;
    robot.drift.scale = 0.01, robot.drift.bend = 0.005, robot.drift.distance = 0.01, robot.drift.heading = 0.01,
    robot.drift.turn = 0.02;
  }
  return robot;
}

struct Scene {
  std::vector<wend_disc> obstacles;
  wend_motion start{};
  wend_disc goal{};
};

struct Outcome {
  bool arrived = false, collided = false;
  double seconds = 0, length = 0;
  std::uint64_t steps = 0;
  wend_motion end{};
};

class Rig {
 public:
  explicit Rig(const Robot& robot) : robot_(robot), bench_(*wend_plugin_1.components[0]) {
    plane_->body = robot.limits;
    plane_->dt = robot.dt, plane_->time_limit = robot.time_limit;
    if (robot.table.empty())
      plane_->speed_and_turn_rate();
    else
      plane_->action_table(robot.table);
    for (int k = 0; k < 36; ++k)
      columns_.box("window.range." + std::to_string(k), "m", 0, robot.reach,
                   wend::math::wrap_angle(k * 10 * wend::math::degree));
    if (robot.sonars)
      for (int k = 0; k < 6; ++k)
        columns_.box("sonar.range." + std::to_string(k), "m", 0, robot.reach, (75 - 30 * k) * wend::math::degree);
    columns_.box("goal.distance", "m").box("goal.bearing", "rad").box("goal.radius", "m");
    columns_.box("pose.x", "m")
        .box("pose.y", "m")
        .box("pose.heading", "rad")
        .box("pose.speed", "m/s")
        .box("pose.turn_rate", "rad/s");
    bench_.set("window", {"window.range.*"}).set("sonar", {"sonar.range.*"}).set("goal", "goal").set("pose", "pose");
    bench_.set("radius", 8)
        .set("candidates", 72)
        .set("memory", "none")
        .set("memory_cells", 1000000)
        .set("range_noise", 0.02);
    bench_.set("planner", "auto")
        .set("replan", 3)
        .set("headings", 24)
        .set("expansions", 3000)
        .set("clearance_weight", 3);
    bench_.set("safety_filter", 1)
        .set("switch", "B")
        .set("corridor", "driven")
        .set("switch_distance", 8)
        .set("sample_with", "planner");
    bench_.observation(columns_).action(plane_->actions()).use("world", plane_.ref());
  }
  Bench& bench() { return bench_; }
  Plane& plane() { return plane_; }
  const wend::Columns& columns() const { return columns_; }

  void place(const Scene& scene, std::uint64_t seed) {
    plane_->obstacles = scene.obstacles;
    plane_->motions[0] = scene.start;
    plane_->goals[0] = scene.goal;
    noise_ = Random(wend::stream(seed, "rig"));
    odometry_.begin(seed, robot_.drift);
    wend_episode ignored{};
    plane_->reset({}, {&ignored, 0});
    bench_.begin(seed);
  }
  std::vector<double> observe() {
    const wend_motion& truth = plane_->motions[0];
    const wend_motion believed = odometry_.update({truth.x, truth.y, truth.heading}, robot_.dt);
    std::vector<double> row;
    gather(truth);
    for (int k = 0; k < 36; ++k) row.push_back(noisy(ray(truth, columns_[static_cast<std::size_t>(k)].at)));
    if (robot_.sonars)
      for (int k = 0; k < 6; ++k) {
        double least = robot_.reach;
        for (int r = -3; r <= 3; ++r)
          least =
              std::min(least, ray(truth, columns_[static_cast<std::size_t>(36 + k)].at + r * 5 * wend::math::degree));
        row.push_back(noisy(least));
      }
    const wend_disc& goal = plane_->goals[0];
    const double dx = goal.x - believed.x, dy = goal.y - believed.y;
    row.push_back(wend::math::hypot(dx, dy));
    row.push_back(wend::math::wrap_angle(wend::math::atan2(dy, dx) - believed.heading));
    row.push_back(goal.radius);
    row.insert(row.end(), {believed.x, believed.y, believed.heading, believed.speed, believed.turn_rate});
    return row;
  }
  wend_outcome step(std::vector<double> action) {
    if (robot_.table.empty())
      for (double& a : action) a *= 1 + robot_.actuator_noise * noise_.normal();
    wend_outcome outcome{};
    const std::uint32_t copy = 0;
    plane_->step({&copy, 1}, wend::Matrix<const double>(action.data(), 1, action.size()), {&outcome, 1});
    return outcome;
  }
  Outcome run(const Scene& scene, std::uint64_t seed) {
    place(scene, seed);
    Outcome result;
    for (;;) {
      const wend_motion before = plane_->motions[0];
      const wend_outcome outcome = step(bench_.act(observe()));
      const wend_motion& now = plane_->motions[0];
      result.length += wend::math::hypot(now.x - before.x, now.y - before.y);
      ++result.steps;
      if (trace) trace(now);
      if (outcome.flags == 0) continue;
      result.arrived = outcome.flags & WEND_ARRIVED, result.collided = outcome.flags & WEND_COLLIDED;
      result.seconds = static_cast<double>(result.steps) * robot_.dt;
      result.end = now;
      return result;
    }
  }
  void (*trace)(const wend_motion&) = nullptr;

 private:
  double noisy(double d) {
    return d >= robot_.reach ? d : std::clamp(d * (1 + robot_.range_noise * noise_.normal()), 0.0, robot_.reach);
  }
  void gather(const wend_motion& at) {
    near_.clear();
    for (const wend_disc& disc : plane_->obstacles) {
      const double dx = disc.x - at.x, dy = disc.y - at.y, most = robot_.reach + robot_.limits.radius + disc.radius;
      if (dx * dx + dy * dy <= most * most) near_.push_back({dx, dy, disc.radius});
    }
  }
  double ray(const wend_motion& at, double bearing) const {
    double s, c;
    wend::math::sincos(at.heading + bearing, s, c);
    const double body = robot_.limits.radius;
    double least = robot_.reach;
    for (const wend_disc& disc : near_) {
      const double x = disc.x - body * c, y = disc.y - body * s, along = x * c + y * s,
                   outside = x * x + y * y - disc.radius * disc.radius;
      if (outside <= 0) return 0;
      const double root = along * along - outside;
      if (along > 0 && root >= 0) least = std::min(least, along - std::sqrt(root));
    }
    return least;
  }

  Robot robot_;
  Plane plane_;
  Bench bench_;
  wend::Columns columns_;
  Random noise_{0};
  wend::Odometry odometry_;
  std::vector<wend_disc> near_;
};

// A wall of discs from one point to another.
inline void wall(std::vector<wend_disc>& discs, double x0, double y0, double x1, double y1, double radius = 1) {
  const double length = wend::math::hypot(x1 - x0, y1 - y0);
  const int n = std::max(1, static_cast<int>(std::ceil(length / radius)));
  for (int k = 0; k <= n; ++k) discs.push_back({x0 + (x1 - x0) * k / n, y0 + (y1 - y0) * k / n, radius});
}
inline void fence(Scene& scene, double width, double height) {
  wall(scene.obstacles, -1, -1, width + 1, -1), wall(scene.obstacles, width + 1, -1, width + 1, height + 1);
  wall(scene.obstacles, width + 1, height + 1, -1, height + 1), wall(scene.obstacles, -1, height + 1, -1, -1);
}

// A U of inner width and depth with walls 2 m thick, open towards the start, in a fenced square that it fits in.
inline Scene u_trap(double width, double depth, std::uint64_t seed) {
  Random random(seed);
  const auto vary = [&](double x) { return x * random.uniform(0.95, 1.05); };
  width = vary(width), depth = vary(depth);
  const double before = vary(20), behind = vary(15), total = before + depth + 2 + behind;
  const double u1 = total / 2 - behind, v = width / 2 + 2, corner = std::max(std::sqrt(u1 * u1 + v * v), total / 2);
  const double side = std::max(100.0, 2 * (corner + 10));
  const double angle = random.uniform(-wend::math::pi, wend::math::pi), c = wend::math::cos(angle),
               s = wend::math::sin(angle);
  Scene scene;
  const auto x = [&](double u, double w) { return side / 2 + u * c - w * s; };
  const auto y = [&](double u, double w) { return side / 2 + u * s + w * c; };
  const auto part = [&](double ua, double wa, double ub, double wb) {
    wall(scene.obstacles, x(ua, wa), y(ua, wa), x(ub, wb), y(ub, wb));
  };
  const double open = -total / 2 + before, back = open + depth, half = width / 2 + 1;
  part(open + 1, half, back + 1, half), part(open + 1, -half, back + 1, -half), part(back + 1, -half, back + 1, half);
  scene.start = {x(-total / 2, 0), y(-total / 2, 0), random.uniform(-wend::math::pi, wend::math::pi), 0, 0};
  scene.goal = {x(total / 2, 0), y(total / 2, 0), 3};
  fence(scene, side, side);
  return scene;
}

// Discs of radius 2..6 at least `gap` apart in a fenced 100 x 100; start and goal at least 50 m from each other.
inline Scene random_discs(double gap, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const auto clear = [&](double px, double py, double room) {
    for (const wend_disc& disc : scene.obstacles)
      if (wend::math::hypot(px - disc.x, py - disc.y) < disc.radius + room) return false;
    return px > room && py > room && px < 100 - room && py < 100 - room;
  };
  for (int attempt = 0; attempt < 300; ++attempt) {
    const double r = random.uniform(2, 6), px = random.uniform(8 + r, 92 - r), py = random.uniform(8 + r, 92 - r);
    if (clear(px, py, gap + r - 1e-9)) scene.obstacles.push_back({px, py, r});
  }
  const auto place = [&](double& px, double& py) {
    do px = random.uniform(0, 100), py = random.uniform(0, 100);
    while (!clear(px, py, 6));
  };
  place(scene.start.x, scene.start.y);
  do place(scene.goal.x, scene.goal.y);
  while (wend::math::hypot(scene.goal.x - scene.start.x, scene.goal.y - scene.start.y) < 50);
  scene.goal.radius = 3;
  scene.start.heading = random.uniform(-wend::math::pi, wend::math::pi);
  fence(scene, 100, 100);
  return scene;
}

}  // namespace rig
