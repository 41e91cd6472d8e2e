// The random policy: uniform, from the row's seed, in any batch.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <wend/testing.hpp>

using wend::testing::Bench;

namespace {

struct Policy : Bench {
  wend::Columns eyes, hands;
  explicit Policy(std::uint32_t n = 1) : Bench(*wend_plugin_1.components[0]) {
    eyes.box("goal.bearing", "rad");
    observation(eyes).action(hands).copies(n);
  }
};

}  // namespace

TEST(RandomPolicy, IsUniformOverATable) {
  Policy policy;
  policy.hands.discrete("action", 3);
  ASSERT_TRUE(policy.create());
  policy.begin(1);
  std::vector<int> counts(3);
  const int n = 30000;
  for (int i = 0; i < n; ++i) ++counts.at(static_cast<std::size_t>(policy.act({0})[0]));
  for (const int count : counts) EXPECT_NEAR(count, n / 3, 4 * std::sqrt(n * 2 / 9.0));
}

TEST(RandomPolicy, IsUniformOverABox) {
  Policy policy;
  policy.hands.box("speed", "m/s", -1, 3).box("turn_rate", "rad/s", -2, 2);
  ASSERT_TRUE(policy.create());
  policy.begin(1);
  double mean = 0, square = 0, product = 0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const auto action = policy.act({0});
    ASSERT_TRUE(action[0] >= -1 && action[0] <= 3 && action[1] >= -2 && action[1] <= 2);
    mean += action[0] / n, square += (action[0] - 1) * (action[0] - 1) / n, product += (action[0] - 1) * action[1] / n;
  }
  EXPECT_NEAR(mean, 1, 0.04);
  EXPECT_NEAR(square, 4.0 / 3, 0.04);
  EXPECT_NEAR(product, 0, 0.04);
}

TEST(RandomPolicy, DoesNotDependOnTheBatch) {
  Policy together(3), apart(3);
  together.hands.discrete("action", 1000), apart.hands.discrete("action", 1000);
  ASSERT_TRUE(together.create() && apart.create());
  together.begin(4), apart.begin(4);
  for (int step = 0; step < 4; ++step) {
    const auto all = together.act({0, 0, 0});
    for (const std::uint32_t row : {2u, 0u, 1u}) EXPECT_EQ(apart.act({row}, {0})[0], all[row]);
    EXPECT_NE(all[0], all[1]);
  }
}

TEST(RandomPolicy, RefusesAnActionWithoutBounds) {
  Policy policy;
  policy.hands.box("speed", "m/s", 0, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(policy.create());
  EXPECT_EQ(policy.status(), WEND_E_UNSUPPORTED);
  EXPECT_EQ(policy.error(), "cannot draw uniformly from the action \"speed\": expected finite bounds, found none");
}
