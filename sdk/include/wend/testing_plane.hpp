// wend/testing_plane.hpp -- a world for tests of sensors and policies: discs in an unbounded plane, robots that are put
// where the test wants them or driven.  Plain code and brute force: the numbers it gives can be checked by hand.
//
//   wend::testing::Plane plane;                       // one robot, radius 0.3, speed and turn_rate
//   plane->obstacles = {{5, 0, 1}};                   // x, y, radius
//   plane->motions[0] = {0, 0, 0};
//   bench.use("world", plane.ref());
#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <vector>
#include <wend/math.hpp>
#include <wend/testing.hpp>

namespace wend::testing {

class PlaneWorld {
 public:
  explicit PlaneWorld(const Config& config) : motions(config.rows()), goals(config.rows(), wend_disc{10, 0, 1}) {
    robots_ = config.robots();
    speed_and_turn_rate();
  }

  // ---- what a test sets
  std::vector<wend_disc> obstacles;  // in every copy
  std::vector<wend_disc> movers;     // likewise
  std::vector<wend_motion> motions;  // one a row
  std::vector<wend_disc> goals;      // one a row
  wend_limits body{0.3, 0, 0, 1, math::pi, math::detail::infinity, math::detail::infinity, 0};
  double dt = 0.1;                             // s between two decisions
  double time_limit = math::detail::infinity;  // s
  std::vector<wend_shape> extra_shapes;        // of one copy, beside the discs: for drawing and planning only

  // Actions: a speed and a turn rate within the limits ...
  void speed_and_turn_rate() {
    table_.clear();
    action_ = std::make_unique<Columns>();
    action_->box("speed", "m/s", body.speed_low, body.speed_high)
        .box("turn_rate", "rad/s", -body.turn_rate, body.turn_rate);
  }
  // ... or rows of a table of both.
  void action_table(std::vector<std::pair<double, double>> rows) {
    table_ = std::move(rows);
    action_ = std::make_unique<Columns>();
    action_->discrete("action", table_.size());
  }
  const Columns& actions() const { return *action_; }

  // ---- world
  double period() const { return dt; }
  const Columns& action(std::uint32_t) const { return *action_; }
  void reset(Rows, Episodes) { steps = 0; }
  void step(Rows copies, Matrix<const double> actions, std::span<wend_outcome> outcomes) {
    ++steps;
    std::size_t i = 0;
    for (const std::uint32_t copy : copies)
      for (std::uint32_t robot = 0; robot < robots_; ++robot, ++i) {
        const std::uint32_t row = copy * robots_ + robot;
        if (outcomes[i].flags & (WEND_TERMINATED | WEND_TRUNCATED)) continue;
        motions[row] = moved(motions[row], actions[i], dt);
        outcomes[i] = outcome(row);
      }
  }
  std::uint64_t steps = 0;

  // ---- body
  wend_limits limits(std::uint32_t) const { return body; }
  void predict(std::uint32_t, std::span<const wend_motion> from, Matrix<const double> actions, double seconds,
               std::span<wend_motion> to) const {
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = moved(from[i], actions[i], seconds);
  }

  // ---- geometry
  void poses(Rows rows, std::span<wend_pose> out) const {
    for (std::size_t i = 0; i < rows.size(); ++i)
      out[i] = {motions[rows[i]].x, motions[rows[i]].y, motions[rows[i]].heading};
  }
  void bodies(Rows rows, std::span<wend_disc> robot, std::span<wend_disc> goal) const {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      robot[i] = disc_of(rows[i]);
      goal[i] = goals[rows[i]];
    }
  }
  void cast(Rows rows, std::span<const wend_pose> rays, double reach, std::uint32_t kinds, double* distance,
            std::uint8_t* kind) const {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      distance[i] = reach;
      std::uint8_t seen = WEND_NOTHING;
      each(rows[i], kinds, [&](const wend_disc& disc, std::uint8_t of) {
        const double hit = along(rays[i], disc);
        if (hit < distance[i]) distance[i] = hit, seen = of;
      });
      if (kind) kind[i] = seen;
    }
  }
  void clearance(Rows rows, std::span<const double> xy, std::uint32_t kinds, std::span<double> out) const {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      out[i] = math::detail::infinity;
      each(rows[i], kinds, [&](const wend_disc& disc, std::uint8_t) {
        out[i] = std::min(out[i], math::hypot(disc.x - xy[2 * i], disc.y - xy[2 * i + 1]) - disc.radius);
      });
    }
  }
  std::span<const wend_shape> shapes(std::uint32_t) {
    shapes_ = extra_shapes;
    for (const auto* discs : {&obstacles, &movers})
      for (const wend_disc& disc : *discs)
        shapes_.push_back(
            {WEND_SHAPE_DISC, discs == &movers ? WEND_MOVER : WEND_OBSTACLE, 1, &disc.x, nullptr, disc.radius, 0, 0});
    return shapes_;
  }
  // m, from the rim to the nearest disc or robot.
  double clearance_of(std::uint32_t row) const {
    double least = math::detail::infinity;
    const double xy[2] = {motions[row].x, motions[row].y};
    clearance(Rows(&row, 1), xy, WEND_OBSTACLE | WEND_MOVER | WEND_ROBOT, std::span(&least, 1));
    return least - body.radius;
  }

 private:
  wend_disc disc_of(std::uint32_t row) const { return {motions[row].x, motions[row].y, body.radius}; }
  template <class See>
  void each(std::uint32_t row, std::uint32_t kinds, See&& see) const {
    if (kinds & WEND_OBSTACLE)
      for (const wend_disc& disc : obstacles) see(disc, WEND_OBSTACLE);
    if (kinds & WEND_MOVER)
      for (const wend_disc& disc : movers) see(disc, WEND_MOVER);
    const std::uint32_t first = row - row % robots_;
    if (kinds & WEND_ROBOT)
      for (std::uint32_t other = first; other < first + robots_; ++other)
        if (other != row) see(disc_of(other), WEND_ROBOT);
    if (kinds & WEND_GOAL) see(goals[row], WEND_GOAL);
  }
  // Distance along a ray to a disc: 0 inside, infinite where it misses.
  static double along(const wend_pose& ray, const wend_disc& disc) {
    const double x = disc.x - ray.x, y = disc.y - ray.y, outside = x * x + y * y - disc.radius * disc.radius;
    if (outside <= 0) return 0;
    const double ahead = x * math::cos(ray.heading) + y * math::sin(ray.heading), root = ahead * ahead - outside;
    return ahead > 0 && root >= 0 ? ahead - std::sqrt(root) : math::detail::infinity;
  }
  wend_motion moved(wend_motion m, std::span<const double> action, double seconds) const {
    const std::size_t k = table_.empty() ? 0 : static_cast<std::size_t>(action[0]);
    const double wanted_v = table_.empty() ? action[0] : table_[k].first,
                 wanted_w = table_.empty() ? action[1] : table_[k].second;
    const double dv = body.acceleration * seconds, dw = body.turn_acceleration * seconds;
    m.speed = std::clamp(std::clamp(wanted_v, body.speed_low, body.speed_high), m.speed - dv, m.speed + dv);
    m.turn_rate = std::clamp(std::clamp(wanted_w, -body.turn_rate, body.turn_rate), m.turn_rate - dw, m.turn_rate + dw);
    const double half = 0.5 * m.turn_rate * seconds;  // the chord of an arc points to the mid heading
    const double chord = m.speed * seconds * (half == 0 ? 1 : math::sin(half) / half);
    m.x += chord * math::cos(m.heading + half);
    m.y += chord * math::sin(m.heading + half);
    m.heading = math::wrap_angle(m.heading + 2 * half);
    return m;
  }
  wend_outcome outcome(std::uint32_t row) const {
    const wend_disc& goal = goals[row];
    if (clearance_of(row) <= body.stop_distance) return {-1, WEND_TERMINATED | WEND_COLLIDED, 0};
    if (math::hypot(goal.x - motions[row].x, goal.y - motions[row].y) <= goal.radius)
      return {1, WEND_TERMINATED | WEND_ARRIVED, 0};
    if (static_cast<double>(steps) * dt >= time_limit) return {0, WEND_TRUNCATED, 0};
    return {0, 0, 0};
  }

  std::uint32_t robots_ = 1;
  std::vector<std::pair<double, double>> table_;
  std::unique_ptr<Columns> action_;
  std::vector<wend_shape> shapes_;
};

// A plane with its bench; -> reaches the world.
class Plane {
 public:
  explicit Plane(std::uint32_t copies = 1, std::uint32_t robots = 1) : bench_(component<PlaneWorld>("test.plane")) {
    bench_.copies(copies).robots(robots);
    if (!bench_.create()) throw std::runtime_error(bench_.error());
  }
  PlaneWorld* operator->() { return &bench_.object<PlaneWorld>(); }
  wend_ref ref() const { return bench_.ref(); }

 private:
  Bench bench_;
};

}  // namespace wend::testing
