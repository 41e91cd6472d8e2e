// The dynamic window: reach, admissibility, objective.
#include "../window.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <wend/math.hpp>

using dwa::Candidate;
using dwa::Motion;
using dwa::Settings;
using dwa::Situation;
using dwa::Window;

namespace {

Settings settings() {
  return {0.1, 0.3, 0, 2, 3, 2, 6, 0, 4, 0.8, 0.4, 0.2, 5, 7};
}
const std::vector<dwa::Point> nothing;

}  // namespace

TEST(Window, HoldsWhatOnePeriodCanReach) {
  Window window(settings());
  const auto all = window.search({{1, -2.8}, 5, 0, nothing});
  ASSERT_EQ(all.size(), 35u);
  EXPECT_DOUBLE_EQ(all.front().motion.v, 0.8);
  EXPECT_DOUBLE_EQ(all.back().motion.v, 1.2);
  EXPECT_DOUBLE_EQ(all.front().motion.w, -3) << "the body's limit";
  EXPECT_DOUBLE_EQ(all.back().motion.w, -2.2);
}

TEST(Window, WithoutLimitsOfAccelerationItHoldsEverything) {
  Settings s = settings();
  s.acceleration = s.turn_acceleration = wend::math::detail::infinity;
  Window window(s);
  const auto all = window.search({{0, 0}, 5, 0, nothing});
  EXPECT_EQ(all.front().motion.v, 0);
  EXPECT_EQ(all.back().motion.v, 2);
  EXPECT_EQ(all.front().motion.w, -3);
  EXPECT_EQ(all.back().motion.w, 3);
  for (const Candidate& candidate : all) EXPECT_TRUE(candidate.admissible && std::isfinite(candidate.value));
}

TEST(Window, AdmitsASpeedFromWhichItStopsInTime) {
  // From v: one period and v^2 / 2a of braking.  1.3 m are free: v = 2.09 would just do.
  const std::vector<dwa::Point> wall{{1.6, 0}};
  Window window(settings());
  const Situation situation{{1, 0}, 5, 0, wall};
  const double limit = -0.2 + std::sqrt(0.04 + 2 * 2 * 1.3);
  EXPECT_TRUE(window.judge(situation, {limit - 1e-6, 0}).admissible);
  EXPECT_FALSE(window.judge(situation, {limit + 1e-6, 0}).admissible);
  EXPECT_NEAR(window.judge(situation, {1, 0}).way, 1.3, 1e-12);
  EXPECT_EQ(window.judge(situation, {limit + 1e-6, 0}).value, 0);
}

TEST(Window, ABodyThatCannotTurnOnTheSpotMustDriveToTurn) {
  Settings s = settings();
  s.turn_radius = 1;
  Window window(s);
  const Situation situation{{1, 0}, 5, 0, nothing};
  EXPECT_TRUE(window.judge(situation, {1, 1}).admissible);
  EXPECT_FALSE(window.judge(situation, {0.9, 1}).admissible);
  EXPECT_FALSE(window.judge(situation, {0, 0.1}).admissible);
}

TEST(Window, TheObjectiveIsTheWeightedSum) {
  Window window(settings());
  const std::vector<dwa::Point> wall{{1.6, 0}};
  const Candidate straight = window.judge({{1, 0}, 5, 0.5, wall}, {1, 0});
  const double x = 5 * std::cos(0.5) - 0.1, y = 5 * std::sin(0.5);
  EXPECT_NEAR(straight.value, 0.8 * (1 - std::atan2(y, x) / wend::math::pi) + 0.4 * 1.3 / 4 + 0.2 * 0.5, 1e-12);
}

TEST(Window, ATurnOnTheSpotIsWorthTheWayThatItOpens) {
  Settings s = settings();
  s.period = 1, s.turn_acceleration = wend::math::detail::infinity;
  Window window(s);
  const std::vector<dwa::Point> wall{{1.3, 0}};
  const Situation situation{{0, 0}, 5, 0, wall};
  EXPECT_NEAR(window.judge(situation, {0, 0}).way, 1, 1e-12);
  EXPECT_EQ(window.judge(situation, {0, 1.5}).way, 4);
}

TEST(Window, SmoothingPrefersWhatHasAdmissibleNeighbours) {
  Settings s = settings();
  s.alpha = 0, s.gamma = 1, s.beta = 0;
  Window window(s);
  // A wall to the left of the straight way: turning left is not admissible, going straight is.
  std::vector<dwa::Point> wall;
  for (double x = 0; x < 3; x += 0.05) wall.push_back({x, 0.31});
  const auto all = window.search({{1, 0}, 5, 0, wall});
  const auto at = [&](int i, int j) { return all[static_cast<std::size_t>(7 * i + j)]; };
  ASSERT_TRUE(at(2, 3).admissible && at(2, 5).admissible == false && at(2, 1).admissible);
  EXPECT_LT(at(2, 3).value, at(2, 1).value) << "the same speed, nearer to the wall";
}
