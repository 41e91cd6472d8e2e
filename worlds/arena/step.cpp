// The arena's course within a period: motion, collisions, arrivals.
#include "world.hpp"

namespace arena {
namespace {

constexpr double margin = 1e-9;    // m, for rounding, where a test is skipped
constexpr int most_samples = 16;   // of a dt in which a body moves farther than its radius
constexpr double most_turn = 0.2;  // rad between two samples of such a dt

}  // namespace

// A few copies at a time, so that what they are made of stays near.
void World::step(wend::Rows copies, wend::Matrix<const double> actions, std::span<wend_outcome> outcomes) {
  const std::size_t some = std::max<std::size_t>(block / robots_, 1);
  for (std::size_t k = 0; k < copies.size(); k += some) {
    const std::size_t first = k * robots_;
    step_some(copies.subspan(k, std::min(some, copies.size() - k)), actions.data() + first * actions.width(),
              &outcomes[first]);
  }
}

void World::step_some(wend::Rows copies, const double* actions, wend_outcome* outcomes) {
  const std::size_t width = kinematics_.columns().width();
  const double* action = actions;
  for (const std::uint32_t c : copies)
    for (std::uint32_t r = 0; r < robots_; ++r, action += width) {
      Robot& robot = robots(c)[r];
      robot.acting = robot.ended == 0;
      if (robot.acting) decide(robot, {action, width});
    }
  for (std::uint32_t s = 0; s < options_.substeps && tick(copies);) ++s;
  for (const std::uint32_t c : copies)
    for (std::uint32_t r = 0; r < robots_; ++r, ++outcomes) {
      const Robot& robot = robots(c)[r];
      if (!robot.acting) continue;
      const std::uint32_t flags = robot.ended;
      *outcomes = {options_.step, flags, 0};
      if (flags & WEND_ARRIVED) outcomes->reward += options_.arrive;
      if (flags & WEND_COLLIDED) outcomes->reward += options_.collide;
    }
}

void World::decide(Robot& robot, std::span<const double> action) const {
  const Noise& noise = kinematics_.noise();
  if (noise.speed > 0 || noise.turn_rate > 0) {
    wend::Random random(robot.noise, 2 * robot.decisions);
    const double a = random.normal(), b = random.normal();
    robot.command = kinematics_.command(action, a, b);
  } else {
    robot.command = kinematics_.command(action);
  }
  ++robot.decisions;
  if (robot.command.turn != 0) {
    robot.motion.heading = wend::math::wrap_angle(robot.motion.heading + robot.command.turn);
    robot.turned += std::fabs(robot.command.turn);
  }
}

// One dt of the copies that are not over; false where there is none.
bool World::tick(wend::Rows copies) {
  Robot* moving[block];
  std::size_t n = 0;
  bool any = false;
  for (const std::uint32_t c : copies) {
    Robot* robot = robots(c);
    if (std::all_of(robot, robot + robots_, [](const Robot& r) { return r.ended != 0; })) continue;
    Copy& copy = copies_[c];
    any = true;
    ++copy.ticks;
    if (!copy.movers.empty()) move_movers(copy);
    if (copy.place->moving_goals) move_goals(copy, robot);
    for (std::uint32_t r = 0; r < robots_; ++r, ++robot) {
      robot->collided = false;
      robot->old_x = robot->motion.x, robot->old_y = robot->motion.y;
      if (robot->ended) continue;
      robot->ticks = copy.ticks;
      moving[n++] = robot;
      if (n == block) move({moving, n}), n = 0;
    }
  }
  move({moving, n});
  for (const std::uint32_t c : copies) {
    const Copy& copy = copies_[c];
    Robot* all = robots(c);
    for (std::uint32_t r = 0; r < robots_ && !copy.movers.empty(); ++r)
      if (!all[r].ended) meet_movers(copy, all[r]);
    if (robots_ > 1) meet_robots(all);
    for (std::uint32_t r = 0; r < robots_; ++r)
      if (!all[r].ended) finish(copy, all[r]);
  }
  return any;
}

void World::move_movers(Copy& copy) const {
  const double now = static_cast<double>(copy.ticks) * options_.dt;
  const bool listed = copy.listed.load(std::memory_order_relaxed);
  for (std::size_t m = 0; m < copy.movers.size(); ++m) {
    Moving& mover = copy.movers[m];
    const Track::State at = copy.place->movers[m].at(now + mover.phase);
    mover.old_x = mover.x, mover.old_y = mover.y;
    mover.x = at.x, mover.y = at.y, mover.vx = at.vx, mover.vy = at.vy;
    if (listed) copy.shapes[copy.first_mover + m].vx = at.vx, copy.shapes[copy.first_mover + m].vy = at.vy;
  }
}

void World::move_goals(Copy& copy, Robot* robots) const {
  const double now = static_cast<double>(copy.ticks) * options_.dt;
  for (std::size_t r = 0; r < std::min<std::size_t>(robots_, copy.place->goals.size()); ++r) {
    const Track& track = copy.place->goals[r];
    if (!track.moves()) continue;
    const Track::State at = track.at(now);
    robots[r].goal_x = at.x, robots[r].goal_y = at.y;
  }
}

// Robots' motion among what stands still.  As long as nothing can be nearer than the nearest so far, nothing is
// measured: a way of length l brings the centre no nearer than l.
void World::move(std::span<Robot* const> moving) const {
  Arcs arcs;
  arcs.n = static_cast<std::uint32_t>(moving.size());
  for (std::uint32_t k = 0; k < arcs.n; ++k) {
    const Robot& robot = *moving[k];
    const Twist twist = kinematics_.twist(robot.command, robot.motion);
    arcs.x.at[k] = robot.motion.x, arcs.y.at[k] = robot.motion.y, arcs.heading.at[k] = robot.motion.heading;
    arcs.speed.at[k] = twist.speed, arcs.turn_rate.at[k] = twist.turn_rate;
  }
  kinematics_.move(arcs, options_.dt);
  const double reach = options_.radius + options_.stop_distance;
  for (std::uint32_t k = 0; k < arcs.n; ++k) {
    Robot& robot = *moving[k];
    const Twist twist{arcs.speed.at[k], arcs.turn_rate.at[k]};
    const double length = kinematics_.way(twist, options_.dt);
    robot.path += std::fabs(twist.speed) * options_.dt;
    robot.turned += std::fabs(twist.turn_rate) * options_.dt;
    const wend_motion from = robot.motion;
    robot.motion = {arcs.x.at[k], arcs.y.at[k], arcs.heading.at[k], twist.speed, twist.turn_rate};
    if (length > 0) robot.at_least = robot.at_least - length - margin;
    if (robot.at_least > (length > 0 ? std::max(robot.nearest + options_.radius, reach) : reach)) continue;
    settle(*maps_[static_cast<std::size_t>(&robot - rows_.data())], robot, from, twist, length);
  }
}

// Measures where a robot is now, and where its way was long, on its way.
void World::settle(const StaticMap& map, Robot& robot, const wend_motion& from, Twist twist, double length) const {
  const double reach = options_.radius + options_.stop_distance;
  if (length > options_.radius && robot.at_least <= reach) {
    sweep(map, robot, from, twist, length);
  } else {
    robot.at_least =
        std::min(map.clearance(robot.motion.x, robot.motion.y), map.clearance_wall(robot.motion.x, robot.motion.y));
  }
  robot.nearest = std::min(robot.nearest, robot.at_least - options_.radius);
  robot.collided = robot.collided || robot.at_least <= reach;
}

// A dt in which the body moves farther than its radius: discs along the way, no more than a radius apart; where that
// takes too many, the centre's way between them may cross nothing.
void World::sweep(const StaticMap& map, Robot& robot, const wend_motion& from, Twist twist, double length) const {
  const double wanted = std::max(options_.radius > 0 ? length / options_.radius : 1.0,
                                 std::fabs(twist.turn_rate) * options_.dt / most_turn);
  const int samples = static_cast<int>(std::min(std::ceil(wanted), static_cast<double>(most_samples)));
  const wend_motion to = robot.motion;
  wend_motion last = from;
  for (int k = 1; k <= samples; ++k) {
    wend_motion next = to;
    if (k < samples) {
      next = from;
      kinematics_.move(next, twist, options_.dt * k / samples);
    }
    const double dx = next.x - last.x, dy = next.y - last.y, way = std::sqrt(dx * dx + dy * dy);
    if (way > options_.radius && way > 0) {
      const Ray ray{last.x, last.y, dx / way, dy / way};
      const double hit = std::min(map.cast(ray, way), map.cast_wall(ray));
      if (hit < way) {
        robot.collided = true;
        next.x = last.x + hit * ray.dx, next.y = last.y + hit * ray.dy;
      }
    }
    robot.motion = last = next;
    robot.at_least = std::min(map.clearance(next.x, next.y), map.clearance_wall(next.x, next.y));
    if (robot.collided || robot.at_least <= options_.radius + options_.stop_distance) {
      robot.collided = true;
      robot.path -= std::fabs(twist.speed) * options_.dt * (samples - k) / samples;
      return;
    }
  }
}

// The clearance to a disc that may have moved too; where the two have moved farther than they are wide, on all the way.
void World::meet(Robot& robot, double old_x, double old_y, double x, double y, double radius) const {
  const double px = robot.motion.x - x, py = robot.motion.y - y;
  double centres = std::sqrt(px * px + py * py);
  const double ox = robot.old_x - old_x, oy = robot.old_y - old_y;
  const double dx = px - ox, dy = py - oy, wide = options_.radius + radius;
  if (dx * dx + dy * dy > wide * wide) centres = std::min(centres, from_segment(0, 0, ox, oy, px, py));
  const double clearance = centres - wide;
  robot.nearest = std::min(robot.nearest, clearance);
  robot.collided = robot.collided || clearance <= options_.stop_distance;
}

void World::meet_movers(const Copy& copy, Robot& robot) const {
  for (const Moving& mover : copy.movers) meet(robot, mover.old_x, mover.old_y, mover.x, mover.y, mover.radius);
}

// Robots that ended stay where they are, as surfaces for the others.
void World::meet_robots(Robot* robots) const {
  for (std::uint32_t r = 0; r < robots_; ++r) {
    if (robots[r].ended) continue;
    for (std::uint32_t other = 0; other < robots_; ++other) {
      const Robot& o = robots[other];
      if (other != r) meet(robots[r], o.old_x, o.old_y, o.motion.x, o.motion.y, options_.radius);
    }
  }
}

void World::finish(const Copy& copy, Robot& robot) const {
  const double dx = robot.motion.x - robot.goal_x, dy = robot.motion.y - robot.goal_y;
  if (robot.collided) {
    robot.ended = WEND_TERMINATED | WEND_COLLIDED;
  } else if (dx * dx + dy * dy <= robot.goal_radius * robot.goal_radius) {
    robot.ended = WEND_TERMINATED | WEND_ARRIVED;
  } else if (copy.ticks >= options_.limit) {
    robot.ended = WEND_TRUNCATED;
  }
  if (robot.ended & WEND_TERMINATED) robot.motion.speed = robot.motion.turn_rate = 0;
}

}  // namespace arena
