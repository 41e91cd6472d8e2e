// Rays and clearances: the fast structures against testing every shape, bit by bit.
#include <gtest/gtest.h>

#include "oracle.hpp"

namespace arena {
namespace {

TEST(Geometry, FastAnswersAreThoseOfTestingEveryShape) {
  std::size_t hits = 0, inner = 0;
  for (std::uint64_t key = 0; key < 600; ++key) {
    Draw draw{wend::Random(wend::stream(key, "scene")), key % 2 == 0, key % 3 == 0 ? 60.0 : 20.0};
    const auto scene = random_scene(draw);
    const StaticMap map(scene);
    for (int k = 0; k < 150; ++k) {
      const Ray ray = draw.ray(k % 4 == 0);
      for (const double reach : {4.0, 8.0, 1000.0, infinity}) {
        const double fast = std::min(map.cast(ray, reach), reach), slow = cast_all(*scene, ray, reach);
        ASSERT_EQ(fast, slow) << "scene " << key << " ray " << k << " reach " << reach << " from " << ray.x << " "
                              << ray.y << " towards " << ray.dx << " " << ray.dy;
        hits += slow < reach && slow > 0;
      }
      const double fast = map.clearance(ray.x, ray.y), slow = clearance_everything(*scene, ray.x, ray.y);
      ASSERT_EQ(fast, slow) << "scene " << key << " point " << ray.x << " " << ray.y;
      inner += slow < 0;
    }
  }
  EXPECT_GT(hits, 100000u);
  EXPECT_GT(inner, 5000u);
}

}  // namespace
}  // namespace arena
