// The closed form against a simulation in small steps.
#include "../arc.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <wend/math.hpp>
#include <wend/random.hpp>

namespace {

// Way until the distance to the point falls to `radius`, by marching; -1 within `most`.
double marched(double v, double w, dwa::Point p, double radius, double most) {
  const double step = 2e-4;
  for (double way = 0; way < most; way += step) {
    const double turn = w / std::fabs(v) * way, sign = v > 0 ? 1 : -1;
    const double x = turn == 0 ? sign * way : sign * way * std::sin(turn) / turn;
    const double y = turn == 0 ? 0 : sign * way * (1 - std::cos(turn)) / turn;
    if (std::hypot(p.x - x, p.y - y) < radius) return way;
  }
  return -1;
}

}  // namespace

TEST(FreeWay, AgreesWithMarchingAlongTheArc) {
  wend::Random random(1);
  int hits = 0;
  for (int i = 0; i < 900; ++i) {
    const double v = random.uniform(-2, 2), w = i % 10 == 0 ? 0 : random.uniform(-3, 3),
                 radius = random.uniform(0.1, 0.6);
    const dwa::Point p{random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2)};
    if (std::hypot(p.x, p.y) < radius * 1.01) continue;
    const double most = w == 0 ? 4 : std::min(4.0, 2 * wend::math::pi * std::fabs(v / w));
    const double way = dwa::free_way(v, w, p, radius), expected = marched(v, w, p, radius, most);
    if (expected < 0) {
      EXPECT_TRUE(way > most - 2e-4) << i;
      continue;
    }
    ++hits;
    // A grazing contact is found late by marching: the deeper the contact, the closer.
    EXPECT_NEAR(way, expected, 2e-2) << "v " << v << " w " << w << " p " << p.x << " " << p.y << " r " << radius;
  }
  EXPECT_GT(hits, 100);
}

TEST(FreeWay, KnownCases) {
  EXPECT_DOUBLE_EQ(dwa::free_way(1, 0, {5, 0}, 1), 4);
  EXPECT_DOUBLE_EQ(dwa::free_way(-1, 0, {-5, 0}, 1), 4);
  EXPECT_EQ(dwa::free_way(1, 0, {-5, 0}, 1), INFINITY) << "behind";
  EXPECT_EQ(dwa::free_way(1, 0, {5, 1}, 1), INFINITY) << "touching is not hitting";
  EXPECT_EQ(dwa::free_way(0, 1, {1.1, 0}, 1), INFINITY) << "a disc turns on the spot";
  // A quarter circle of radius 2 to the left ends at (2, 2); a point there is met earlier by the angle of the chord.
  const double half = 2 * std::asin(0.5 / 4);
  EXPECT_NEAR(dwa::free_way(2, 1, {2, 2}, 0.5), 2 * (wend::math::half_pi - half), 1e-12);
  EXPECT_NEAR(dwa::free_way(2, -1, {2, -2}, 0.5), 2 * (wend::math::half_pi - half), 1e-12);
}

TEST(FreeWay, NearlyStraightArcsMeetTheLine) {
  for (const double w : {1e-3, 1e-6, 1e-8, 1e-10, -1e-7})
    EXPECT_NEAR(dwa::free_way(1, w, {3, 0.2}, 0.5), 3 - std::sqrt(0.21), 2e-3) << w;
  EXPECT_NEAR(dwa::free_way(1, 1e-8, {3, 0.2}, 0.5), 3 - std::sqrt(0.21), 1e-6);
}

TEST(FreeWay, APointWithinTheDiscBlocksOnlyWhatApproachesIt) {
  const dwa::Point ahead{0.3, 0.05};
  EXPECT_LT(dwa::free_way(1, 0, ahead, 0.5), 1e-3);
  EXPECT_LT(dwa::free_way(1, 0.5, ahead, 0.5), 1e-3);
  EXPECT_GT(dwa::free_way(-1, 0, ahead, 0.5), 1);
  EXPECT_GT(dwa::free_way(1, 0, {-0.3, 0.05}, 0.5), 1);
  EXPECT_GT(dwa::free_way(1, 0.5, {-0.3, 0.05}, 0.5), 1);
  EXPECT_LT(dwa::free_way(1, 0, {0.50000001, 0}, 0.5), 1e-3) << "contact itself";
}
