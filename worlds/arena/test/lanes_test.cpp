// Blocks of rays and of bodies, by every instruction set that this CPU has: the bits of testing one ray against every
// shape, and of moving one body.
#include <gtest/gtest.h>

#include "../motion/kinematics.hpp"
#include "oracle.hpp"

namespace arena {
namespace {

// n rays, in groups from nearly the same place as a robot's are.
Rays random_block(Draw& draw, std::uint32_t n) {
  Rays rays;
  rays.n = n;
  for (std::uint32_t k = 0; k < n; ++k) {
    Ray ray = draw.ray(k % 4 == 0);
    if (k > 0 && !draw.random.chance(0.15)) ray.x = rays.x.at[k - 1], ray.y = rays.y.at[k - 1];
    if (k > 0 && draw.random.chance(0.3)) ray.x += draw.random.uniform(-0.3, 0.3);
    rays.x.at[k] = ray.x, rays.y.at[k] = ray.y, rays.dx.at[k] = ray.dx, rays.dy.at[k] = ray.dy;
  }
  for (std::uint32_t k = n; k < rays.padded(); ++k)
    rays.x.at[k] = rays.y.at[k] = rays.dx.at[k] = rays.dy.at[k] = rays.best.at[k] = rays.hit.at[k] = 0;
  return rays;
}

TEST(Lanes, BlocksOfRaysGiveTheBitsOfTestingEveryShape) {
  std::size_t hits = 0, tested = 0;
  for (std::uint64_t key = 0; key < 500; ++key) {
    Draw draw{wend::Random(wend::stream(key, "block")), key % 2 == 0, key % 3 == 0 ? 60.0 : 20.0};
    const auto scene = random_scene(draw);
    StaticMap map(scene);
    for (const double reach : {2.0, 5.0, 20.0}) map.prepare(reach);
    Rays rays = random_block(draw, 1 + static_cast<std::uint32_t>(draw.random.below(block)));
    for (const double reach : {1.5, 5.0, 15.0, 1000.0, infinity}) {
      std::vector<double> slow(rays.n);
      for (std::uint32_t k = 0; k < rays.n; ++k) {
        rays.best.at[k] = k % 3 == 0 ? 0.7 * reach : reach;
        slow[k] = cast_all(*scene, rays.at(k), rays.best.at[k]);
        hits += slow[k] > 0 && slow[k] < rays.best.at[k];
      }
      for (const Kernels& kernels : every_kernels()) {
        map.cast(kernels, rays, reach);
        for (std::uint32_t k = 0; k < rays.n; ++k, ++tested)
          ASSERT_EQ(std::min(rays.hit.at[k], rays.best.at[k]), slow[k])
              << "scene " << key << " ray " << k << " of " << rays.n << " reach " << reach << " kernels "
              << &kernels - every_kernels().data();
      }
    }
  }
  EXPECT_GT(hits, 20000u);
  EXPECT_GT(tested, 100000u);
}

TEST(Lanes, ManyCandidatesAreLeftOutOnlyWhereTheyAreTooFar) {
  auto scene = std::make_shared<Scene>();
  wend::Random random(3);
  scene->width = scene->height = 30;
  for (int k = 0; k < 1500; ++k)
    scene->discs.push_back({random.uniform(0, 30), random.uniform(0, 30), random.uniform(0.01, 0.2)});
  scene->segments = {{3, 3, 20, 18}};
  StaticMap map(scene);
  map.prepare(6);
  Draw draw{wend::Random(4), false, 30};
  std::size_t missed = 0;
  for (int round = 0; round < 30; ++round) {
    Rays rays = random_block(draw, block - 3);
    for (std::uint32_t k = 0; k < rays.n; ++k) rays.best.at[k] = 6;
    for (const Kernels& kernels : every_kernels()) {
      map.cast(kernels, rays, 6);
      for (std::uint32_t k = 0; k < rays.n; ++k) {
        ASSERT_EQ(rays.hit.at[k], cast_all(*scene, rays.at(k), 6));
        missed += rays.hit.at[k] == 6;
      }
    }
  }
  EXPECT_GT(missed, 10u);
}

TEST(Lanes, DirectionsWallsMovingDiscsAndKindsAreThoseOfOneRay) {
  wend::Random random(8);
  for (std::uint32_t n = 1; n <= block; n += random.chance(0.5) ? 1 : 6) {
    std::vector<wend_pose> poses(n);
    for (wend_pose& pose : poses) pose = {random.uniform(-1, 11), random.uniform(-1, 9), random.uniform(-8192, 8192)};
    if (n > 3) poses[3].heading = 0, poses[2].heading = wend::math::half_pi;
    double x[5], y[5], radius2[5];
    for (int k = 0; k < 5; ++k)
      x[k] = random.uniform(0, 10), y[k] = random.uniform(0, 8), radius2[k] = random.uniform(0, 2);
    const auto first = static_cast<std::uint32_t>(random.below(n));
    const std::uint32_t last = first + 1 + static_cast<std::uint32_t>(random.below(n - first));
    for (const Kernels& kernels : every_kernels()) {
      Rays rays;
      rays.n = n;
      ASSERT_TRUE(kernels.aim(rays, poses.data(), 7));
      kernels.meet_bounds(rays, {0, 0, 10, 8});
      kernels.keep_nearer(rays, WEND_WALL);
      std::copy(rays.best.at, rays.best.at + n, rays.hit.at);
      kernels.meet_discs(rays, first, last, {x, y, radius2, 5});
      kernels.keep_nearer(rays, WEND_MOVER);
      for (std::uint32_t k = 0; k < n; ++k) {
        Ray ray{poses[k].x, poses[k].y, 0, 0};
        wend::math::sincos(poses[k].heading, ray.dy, ray.dx);
        ASSERT_EQ(rays.dx.at[k], ray.dx);
        ASSERT_EQ(rays.dy.at[k], ray.dy);
        const double wall = std::min(hit_bounds(ray, 0, 0, 10, 8), 7.0);
        double best = wall;
        for (int i = 0; i < 5 && k >= first && k < last; ++i)
          best = std::min(best, hit_disc(ray, x[i], y[i], radius2[i]));
        ASSERT_EQ(rays.best.at[k], best);
        ASSERT_EQ(rays.kind.at[k], best < wall ? WEND_MOVER : wall < 7 ? WEND_WALL : WEND_NOTHING);
      }
    }
  }
  for (const double heading : {8192.5, -1e300, infinity, std::nan("")})
    for (const Kernels& kernels : every_kernels()) {
      std::vector<wend_pose> poses(11, wend_pose{1, 1, 1});
      poses[9].heading = heading;
      Rays rays;
      rays.n = 11;
      EXPECT_FALSE(kernels.aim(rays, poses.data(), 7)) << heading;
    }
}

TEST(Lanes, BlocksOfBodiesMoveAsOneDoes) {
  for (const double offset : {0.0, 0.4}) {
    const std::vector<wend_value> values{{"kinematics/half_track", nullptr, 0.2},
                                         {"kinematics/offset", nullptr, offset},
                                         {"kinematics/type", "differential", 0},
                                         {"kinematics/wheel_radius", nullptr, 0.1}};
    const Kinematics kinematics(wend::Params(values), 0.1, 0.1);
    wend::Random random(5);
    for (std::uint32_t n = 1; n <= block; n += 9) {
      Arcs arcs;
      arcs.n = n;
      std::vector<wend_motion> single(n);
      for (std::uint32_t k = 0; k < n; ++k) {
        const double turning = random.chance(0.2) ? 0 : random.chance(0.2) ? 1e-4 : random.uniform(-60, 60);
        single[k] = {random.uniform(0, 9), random.uniform(0, 9), random.uniform(-3.2, 3.1), 0, 0};
        arcs.x.at[k] = single[k].x, arcs.y.at[k] = single[k].y, arcs.heading.at[k] = single[k].heading;
        arcs.speed.at[k] = random.uniform(-2, 2), arcs.turn_rate.at[k] = turning;
        kinematics.move(single[k], {arcs.speed.at[k], turning}, 0.1);
      }
      const Arcs before = arcs;
      const auto same = [&](std::uint32_t k) {
        return arcs.x.at[k] == single[k].x && arcs.y.at[k] == single[k].y && arcs.heading.at[k] == single[k].heading;
      };
      kinematics.move(arcs, 0.1);
      for (std::uint32_t k = 0; k < n; ++k) ASSERT_TRUE(same(k)) << k;
      for (const Kernels& kernels : every_kernels()) {
        if (offset != 0) break;
        arcs = before;
        kernels.follow_arcs(arcs, 0.1);
        for (std::uint32_t k = 0; k < n; ++k) {
          arcs.heading.at[k] = wend::math::wrap_angle(arcs.heading.at[k]);
          ASSERT_TRUE(same(k)) << k;
        }
      }
    }
  }
}

}  // namespace
}  // namespace arena
