// Measures the arena beside Box2D: rays among the same discs and walls, and a whole step of the same robot.  With Box2D
// a step is six ray casts, the motion, and a query of what the body touches, since its kinematic bodies stop at
// nothing. Thread CPU time, without resets; the two take turns and the least of several turns counts.
//   bench_box2d [--json]
#include <box2d/box2d.h>

#include <cmath>
#include <cstring>

#include "course.hpp"

namespace {

using Rays = std::vector<wend_pose>;

constexpr double graze =
    1e-3;  // m; what just touches may be a hit to one and a miss to Box2D, whose numbers have 24 bits

class Nearest : public b2RayCastCallback {
 public:
  float fraction = 1;
  float ReportFixture(b2Fixture*, const b2Vec2&, const b2Vec2&, float found) override { return fraction = found; }
};

// Whether a disc touches what the query finds.
class Touches : public b2QueryCallback {
 public:
  explicit Touches(b2Vec2 centre) : centre_(centre) { body_.m_radius = bench::radius; }
  bool hit = false;
  bool ReportFixture(b2Fixture* fixture) override {
    const b2Transform here(centre_, b2Rot(0)), there = fixture->GetBody()->GetTransform();
    hit = hit || b2TestOverlap(&body_, 0, fixture->GetShape(), 0, here, there);
    return !hit;
  }

 private:
  b2Vec2 centre_;
  b2CircleShape body_;
};

class Box2d {
 public:
  explicit Box2d(int obstacles) : world_(b2Vec2(0, 0)) {
    const b2BodyDef nowhere;
    b2Body* fixed = world_.CreateBody(&nowhere);
    for (const arena::Disc& disc : bench::scene_of(obstacles).discs) {
      b2CircleShape circle;
      circle.m_p.Set(static_cast<float>(disc.x), static_cast<float>(disc.y));
      circle.m_radius = static_cast<float>(disc.radius);
      fixed->CreateFixture(&circle, 0);
    }
    const b2Vec2 corners[] = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    for (int k = 0; k < 4; ++k) {
      b2EdgeShape wall;
      wall.SetTwoSided(corners[k], corners[(k + 1) % 4]);
      fixed->CreateFixture(&wall, 0);
    }
  }
  double cast(const wend_pose& ray) const {
    const b2Vec2 from(static_cast<float>(ray.x), static_cast<float>(ray.y));
    const float reach = bench::reach, heading = static_cast<float>(ray.heading);
    Nearest nearest;
    world_.RayCast(&nearest, from, from + b2Vec2(reach * std::cos(heading), reach * std::sin(heading)));
    return nearest.fraction * bench::reach;
  }
  bool touches(double x, double y) const {
    const b2Vec2 centre(static_cast<float>(x), static_cast<float>(y)), half(bench::radius, bench::radius);
    Touches touches(centre);
    world_.QueryAABB(&touches, {centre - half, centre + half});
    return touches.hit;
  }

 private:
  b2World world_;
};

// What 64 robots sense in every 50th step of so many.
Rays rays_of(bench::Loop& loop, int steps) {
  Rays rays;
  for (int k = 0; k < steps; k += 50) {
    loop.measure(0);  // 50 steps
    rays.insert(rays.end(), loop.rays.begin(), loop.rays.end());
  }
  return rays;
}

// Seconds a ray.
double cast_all(const Box2d& box2d, const Rays& rays, std::vector<double>& ranges) {
  const double begin = wend::testing::thread_seconds();
  for (std::size_t k = 0; k < rays.size(); ++k) ranges[k] = box2d.cast(rays[k]);
  asm volatile("" : : "r"(ranges.data()) : "memory");
  return (wend::testing::thread_seconds() - begin) / static_cast<double>(rays.size());
}
double cast_all(bench::Loop& loop, const Rays& rays, std::vector<double>& ranges) {
  std::vector<std::uint8_t> kinds(loop.rays.size());
  const double begin = wend::testing::thread_seconds();
  for (std::size_t k = 0; k < rays.size(); k += loop.rays.size())
    loop.arena.geometry->cast(loop.arena.self, loop.rows.data(), &rays[k], static_cast<std::uint32_t>(loop.rays.size()),
                              bench::reach, WEND_WALL | WEND_OBSTACLE | WEND_MOVER | WEND_ROBOT, &ranges[k],
                              kinds.data());
  asm volatile("" : : "r"(ranges.data()) : "memory");
  return (wend::testing::thread_seconds() - begin) / static_cast<double>(rays.size());
}

// The robots of the course in Box2D.  One that touches something goes back to where it began, at no cost to Box2D.
struct Robots {
  const Box2d& box2d;
  std::vector<wend_pose> poses;
  std::vector<wend_pose> starts = poses;
  std::vector<double> sides = std::vector<double>(bench::copies, 6);

  void step() {
    for (std::size_t c = 0; c < poses.size(); ++c) {
      wend_pose& pose = poses[c];
      double ranges[bench::beams];
      for (std::uint32_t b = 0; b < bench::beams; ++b)
        ranges[b] = box2d.cast({pose.x, pose.y, pose.heading + bench::axes[b]});
      const auto [left, right] = bench::steer(ranges, sides[c]);
      const double speed = bench::wheel_radius * (left + right) / 2;
      const double turn = bench::wheel_radius * (right - left) / (2 * bench::half_track);
      pose.x += bench::dt * speed * std::cos(pose.heading);
      pose.y += bench::dt * speed * std::sin(pose.heading);
      pose.heading += bench::dt * turn;
      if (box2d.touches(pose.x, pose.y)) pose = starts[c];
    }
  }
  double measure(double seconds) {
    const double begin = wend::testing::thread_seconds();
    std::uint64_t steps = 0;
    do {
      for (int k = 0; k < 20; ++k) step();
      steps += 20 * poses.size();
    } while (wend::testing::thread_seconds() - begin < seconds);
    asm volatile("" : : "r"(poses.data()) : "memory");
    return (wend::testing::thread_seconds() - begin) / static_cast<double>(steps);
  }
};

}  // namespace

int main(int argc, char** argv) {
  const bool json = argc > 1 && std::strcmp(argv[1], "--json") == 0;
  std::vector<std::pair<std::string, double>> figures;
  for (const int n : {20, 200, 1000, 10000}) {
    const auto tell = [&](const char* key, double figure) { figures.emplace_back(key + std::to_string(n), figure); };
    bench::Arena arena(n);
    bench::Loop loop(arena);
    const Box2d box2d(n);
    const Rays rays = rays_of(loop, 2500);
    std::vector<double> ours(rays.size()), theirs(rays.size());
    double our_ray = 1, their_ray = 1, our_step = 1, their_step = 1;
    for (int turn = 0; turn < 7; ++turn) {
      their_ray = std::min(their_ray, cast_all(box2d, rays, theirs));
      for (int k = 0; k < 20; ++k) our_ray = std::min(our_ray, cast_all(loop, rays, ours));
    }
    std::size_t different = 0;
    for (std::size_t k = 0; k < rays.size(); ++k) different += std::fabs(ours[k] - theirs[k]) > graze;
    tell("raycast_vs_box2d_", their_ray / our_ray);
    tell("raycast_box2d_ns_", 1e9 * their_ray);
    tell("raycast_ns_", 1e9 * our_ray);
    tell("raycast_box2d_differs_", static_cast<double>(different) / static_cast<double>(rays.size()));
    if (n > 200) continue;
    Robots robots{box2d, loop.poses};
    for (int turn = 0; turn < 7; ++turn) {
      our_step = std::min(our_step, loop.measure(0.2));
      their_step = std::min(their_step, robots.measure(0.2));
    }
    tell("step_vs_box2d_", their_step / our_step);
    tell("step_box2d_per_s_", 1 / their_step);
  }
  bench::print(figures, json);
}
