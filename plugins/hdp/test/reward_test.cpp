// Equations (14)-(21) against values worked out by hand.
#include "../navigation.hpp"
#include "harness.hpp"

using namespace hdp_test;

namespace {

constexpr double goal = WEND_GOAL, wall = WEND_WALL, disc = WEND_OBSTACLE;

double reward_of(Bench& bench, const std::vector<double>& next, std::uint32_t flags = 0) {
  return bench.score(next, {0}, next, {{0, flags, 0}})[0].reward;
}

class Reward : public Bench {
 public:
  Reward() : Bench(1) { set("theta", "clipped").set("beta", 0.75).set("crash", -1); }
};

}  // namespace

TEST(SeekAndAvoid, WeighsTheirSignsAndDistances) {
  Reward reward;
  ASSERT_TRUE(reward.create()) << reward.error();
  const std::vector<double> far(5, 10), none(5, 0);
  const double quarter = wend::math::pi / 4;
  EXPECT_NEAR(reward_of(reward, sees(far, none, quarter)), -0.5, 1e-15) << "nothing in range: |theta| alone";
  EXPECT_NEAR(reward_of(reward, sees({10, 4, 10, 10, 10}, {0, disc, 0, 0, 0}, quarter)), -0.125 - 0.75 * 0.6, 1e-15);
  EXPECT_NEAR(reward_of(reward, sees({10, 4, 10, 1, 10}, {0, disc, 0, wall, 0}, 0)), -0.75 * 0.9, 1e-15);
  EXPECT_NEAR(reward_of(reward, sees({2.5, 10, 10, 10, 10}, {goal, 0, 0, 0, 0}, 0)), 0.75 * 0.75, 1e-15);
  EXPECT_NEAR(reward_of(reward, sees({0, 0, 0, 0, 0}, {goal, goal, goal, goal, goal}, 0)), 0.75, 1e-15) << "arrived";
  EXPECT_EQ(reward_of(reward, sees(far, none, 0), crashed), -1);
}

TEST(SeekAndAvoid, DecidesBetweenGoalAndObstacle) {
  const auto both = sees({2, 10, 10, 5, 10}, {goal, 0, 0, disc, 0}, 0);
  for (const auto& [tie, expected] : {std::pair{"obstacle", -0.5}, {"goal", 0.8}, {"larger", 0.8}}) {
    Reward reward;
    reward.set("tie", tie);
    ASSERT_TRUE(reward.create());
    EXPECT_NEAR(reward_of(reward, both), 0.75 * expected, 1e-15) << tie;
  }
}

TEST(SeekAndAvoid, RefusesColumnsOfAnotherKind) {
  const auto refused = [](const char* path, const char* columns) {
    Reward reward;
    EXPECT_FALSE(reward.set(path, columns).create());
    return reward.parameter() + ": " + reward.error();
  };
  EXPECT_EQ(refused("range/0", "sonar.kind.*"), "range: column \"sonar.kind.0\": expected the unit m, found 1");
  EXPECT_EQ(refused("kinds/0", "sonar.range.*"), "kinds: column \"sonar.range.0\": expected the unit 1, found m");
  EXPECT_EQ(refused("goal", "sonar.range.0"), "goal: column \"sonar.range.0\": expected the unit rad, found m");
}

TEST(SeekAndAvoid, RefusesRangesWithoutKinds) {
  Reward reward;
  reward.set("range", {"sonar.range.0"});
  EXPECT_FALSE(reward.create());
  EXPECT_EQ(reward.parameter(), "kinds");
  EXPECT_EQ(reward.error(), "expected as many columns as in range, 1, found 5");
}

TEST(Navigation, DeviationAsPrintedJumps) {
  const double right = wend::math::half_pi;
  EXPECT_EQ(hdp::deviation(right, hdp::Theta::printed), 1);
  EXPECT_NEAR(hdp::deviation(right - 1e-9, hdp::Theta::printed), 0.5, 1e-9);
  EXPECT_NEAR(hdp::deviation(right - 1e-9, hdp::Theta::clipped), 1, 1e-9);
  EXPECT_EQ(hdp::deviation(-3, hdp::Theta::printed), -1);
  EXPECT_EQ(hdp::deviation(-right / 2, hdp::Theta::clipped), -0.5);
}

TEST(Navigation, AGoalToTheLeftIsANegativeDeviation) {
  Bench bench;
  std::vector<wend_value> values{
      {"goal", "goal.bearing", 0}, {"kinds/0", "sonar.kind.*", 0}, {"range/0", "sonar.range.*", 0}};
  const hdp::Navigation navigation(wend::Space(bench.Spaces::observation.table()), wend::Params(values),
                                   hdp::Theta::clipped);
  std::vector<double> x(navigation.size());
  navigation.look(sees({10, 2, 10, 10, 7}, {0, goal, 0, 0, wall}, wend::math::pi / 4), x);
  const std::vector<double> expected{0, 0.8, 0, 0, -0.3, -0.5};
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], expected[i], 1e-15) << i;
}
