// The genetic algorithm on rooms whose best way is known.
#include "planner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <wend/math.hpp>

#include "rooms.hpp"

using ga::ClearanceGrid;
using ga::Fitness;
using ga::Plan;
using ga::Planner;
using ga::Point;
using ga::Problem;
using ga::Settings;

namespace {

Plan plan(const Problem& problem, std::uint64_t seed, const Settings& settings = {}, std::vector<Point> known = {}) {
  return Planner(settings).plan(problem, wend::Random(seed), known, nullptr);
}

bool same(const Plan& a, const Plan& b) {
  bool equal = a.path.size() == b.path.size() && a.generations == b.generations;
  for (std::size_t k = 0; equal && k < a.path.size(); ++k)
    equal = a.path[k].x == b.path[k].x && a.path[k].y == b.path[k].y;
  return equal;
}

}  // namespace

TEST(Planner, FitnessByHand) {
  const ClearanceGrid grid = ga::testing::room(10, {{4, 0, 5, 3}});
  Settings settings;
  settings.collision = 100, settings.smoothness = 0.5;
  Planner planner(settings);
  // East, north, west: 2 m, 3 m, 1 m; a left turn of 90 degrees twice, and one at the start, from heading south.
  const Problem free{{1, 1}, {2, 4}, -wend::math::half_pi, &grid, 0.2};
  const Fitness around = planner.judge(free, std::vector<Point>{{3, 1}, {3, 4}});
  EXPECT_NEAR(around.length, 6, 1e-12);
  EXPECT_NEAR(around.turning, 3 * wend::math::half_pi * wend::math::half_pi, 1e-12);
  EXPECT_EQ(around.collision, 0);
  EXPECT_NEAR(around.total, 6 + 0.5 * around.turning, 1e-12);
  // Straight through the block, inflated to 1.4 m; way-points on the line change nothing, nor do repeated ones.
  const Problem through{{1, 1}, {9, 1}, 0, &grid, 0.2};
  for (const auto& points : {std::vector<Point>{{2, 1}}, {{2, 1}, {2, 1}, {6, 1}}, {{1, 1}, {9, 1}}}) {
    const Fitness fitness = planner.judge(through, points);
    EXPECT_NEAR(fitness.length, 8, 1e-12);
    EXPECT_NEAR(fitness.turning, 0, 1e-24);
    EXPECT_NEAR(fitness.collision, 1.4, 0.01);
    EXPECT_NEAR(fitness.total, 8 + 100 * fitness.collision, 1e-9);
  }
}

TEST(Planner, InAnEmptyRoomTheBestWayIsStraight) {
  const ClearanceGrid grid = ga::testing::room(10, {});
  const Point start{1, 2}, goal{9, 8};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Plan found = plan({start, goal, wend::math::atan2(6, 8), &grid, 0.2}, seed);
    EXPECT_GE(found.fitness.total, 10 - 1e-9);
    EXPECT_LT(found.fitness.total, 10.1) << seed;
    EXPECT_EQ(found.fitness.collision, 0);
    ASSERT_EQ(found.path.size(), 8u);
    EXPECT_EQ(found.path.front().x, start.x);
    EXPECT_EQ(found.path.back().y, goal.y);
  }
}

TEST(Planner, FindsTheDoor) {
  // A door of 1.2 m far from the straight way: the best way bends at its inflated edges.
  const ClearanceGrid grid = ga::testing::room(10, {{0, 5, 7, 5.3}, {8.2, 5, 10, 5.3}});
  const double needed = 0.2;
  const double shortest = 2 * std::hypot(7 - 2, 5 - 1) + 0.3;  // touching the corners, for a point
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Plan best = plan({{2, 1}, {2, 9.3}, 0, &grid, needed}, seed);
    if (best.fitness.collision > 0.01) continue;
    ++found;
    EXPECT_GT(best.fitness.length, shortest);
    EXPECT_LT(best.fitness.length, shortest * 1.08) << seed;
  }
  EXPECT_GE(found, 8);
}

TEST(Planner, FitnessNeverGetsWorseAndTheSearchEnds) {
  const ClearanceGrid grid = ga::testing::room(10, {{3, 0, 4, 6}, {6, 4, 7, 10}});
  Settings settings;
  settings.generations = 120, settings.patience = 15;
  std::vector<double> told;
  const Plan best = Planner(settings).plan({{1, 1}, {9, 9}, 0, &grid, 0.2}, wend::Random(3), {},
                                           [&](std::size_t generation, double fitness) {
                                             EXPECT_EQ(generation, told.size());
                                             told.push_back(fitness);
                                           });
  ASSERT_EQ(told.size(), best.generations + 1);
  EXPECT_LE(best.generations, 120u);
  EXPECT_EQ(told.back(), best.fitness.total);
  for (std::size_t k = 1; k < told.size(); ++k) EXPECT_LE(told[k], told[k - 1]);
  if (best.generations < 120) {
    EXPECT_GT(told.back(), told[told.size() - 16] * (1 - 15 * 1e-4));
  }

  settings.generations = 7;
  EXPECT_EQ(plan({{1, 1}, {9, 9}, 0, &grid, 0.2}, 3, settings).generations, 7u);
  settings.generations = 400, settings.patience = 1, settings.mutation = 0, settings.crossover = 0;
  EXPECT_EQ(plan({{1, 1}, {9, 9}, 0, &grid, 0.2}, 3, settings).generations, 1u) << "copies never improve";
}

TEST(Planner, IsAFunctionOfItsSeed) {
  const ClearanceGrid grid = ga::testing::room(10, {{3, 0, 4, 6}});
  const Problem problem{{1, 1}, {9, 1}, 0, &grid, 0.2};
  EXPECT_TRUE(same(plan(problem, 4), plan(problem, 4)));
  EXPECT_FALSE(same(plan(problem, 4), plan(problem, 5)));
  Planner used{Settings{}};
  used.plan({{5, 5}, {1, 9}, 2, &grid, 0.3}, wend::Random(1), {}, nullptr);
  EXPECT_TRUE(same(used.plan(problem, wend::Random(4), {}, nullptr), plan(problem, 4))) << "nothing is left of a plan";
}

TEST(Planner, AKnownWayIsNeverLost) {
  const ClearanceGrid grid = ga::testing::room(10, {{0, 5, 7, 5.3}, {8.2, 5, 10, 5.3}});
  Settings settings;
  settings.generations = 0;
  const std::vector<Point> known{{7.6, 4}, {7.6, 4.5}, {7.6, 5}, {7.6, 5.5}, {7.6, 6}, {5, 8}};
  const Problem problem{{2, 1}, {2, 9.3}, 0, &grid, 0.2};
  const double fitness = Planner(settings).judge(problem, known).total;
  EXPECT_LE(plan(problem, 1, settings, known).fitness.total, fitness);
  EXPECT_GT(plan(problem, 1, settings).fitness.total, fitness) << "the first generation alone knows none so good";
}

TEST(Planner, WayPointsStayInTheArea) {
  const ClearanceGrid grid = ga::testing::room(4, {{0, 1.9, 3.2, 2.1}});
  Settings settings;
  settings.sigma_first = settings.sigma_last = 1, settings.blend = 3, settings.generations = 30;
  for (const Point& point : plan({{1, 1}, {1, 3}, 0, &grid, 0.2}, 2, settings).path) {
    EXPECT_GE(point.x, 0);
    EXPECT_LE(point.x, 4);
    EXPECT_GE(point.y, 0);
    EXPECT_LE(point.y, 4);
  }
}

TEST(Planner, TheRestOfAWay) {
  const std::vector<Point> path{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {7, 0}};
  const auto xs = [&](double from, Point here, std::size_t n) {
    std::vector<double> all;
    for (const Point& point : ga::rest_of(path, from, here, n)) all.push_back(point.x);
    return all;
  };
  EXPECT_EQ(xs(0, {0, 0}, 3), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(xs(1.5, {1.5, 0}, 3), (std::vector<double>{2, 3, 5}));
  EXPECT_EQ(xs(3.5, {3.5, 0}, 3), (std::vector<double>{5.25, 6.125, 6.5625}));
}
