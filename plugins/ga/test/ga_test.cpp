// The policy through its C table, planning and driving in a plane of discs.
#include <gtest/gtest.h>

#include <cmath>
#include <wend/testing_plane.hpp>

using wend::testing::Bench;
using wend::testing::Plane;

namespace {

// A robot of 0.15 m that goes on by 0.15 m in a period, straight or in a curve, in a square of 10 m with a margin.
struct Rig {
  Plane plane;
  std::vector<double> square{0, 0, 10, 0, 10, 0, 10, 10, 10, 10, 0, 10, 0, 10, 0, 0};
  wend::Columns nothing;
  Bench bench{*wend_plugin_1.components[0]};

  explicit Rig(std::uint32_t copies = 1, std::uint32_t robots = 1) : plane(copies, robots) {
    plane->body = {0.15, 0, 0, 1, 16, wend::math::detail::infinity, wend::math::detail::infinity, 0};
    const double turn = 22.5 * wend::math::degree / plane->dt;
    plane->action_table({{1, -2 * turn}, {1, -turn}, {1, 0}, {1, turn}, {1, 2 * turn}});
    plane->dt = 0.15;
    plane->extra_shapes = {{WEND_SHAPE_SEGMENTS, WEND_WALL, 8, square.data(), nullptr, 0, 0, 0}};
    for (auto& goal : plane->goals) goal = {9, 5, 0.3};
    for (auto& motion : plane->motions) motion = {1, 5, 0, 0, 0};
    bench.observation(nothing).action(plane->actions()).use("world", plane.ref()).copies(copies).robots(robots);
    bench.set("way_points", 6).set("population", 50).set("tournament", 3).set("elites", 2);
    bench.set("crossover", 0.8).set("blend", 0.5).set("mutation", 0.2).set("sigma", {0.1, 0.005});
    bench.set("generations", 400).set("patience", 60).set("collision", 100).set("smoothness", 0.1);
    bench.set("margin", 0.05).set("cell", 0).set("replan", 0).set("see_robots", 1).set("look_ahead", 3);
  }

  std::vector<double> act(std::vector<std::uint32_t> rows) {
    std::vector<double> actions(rows.size());
    EXPECT_EQ(
        bench.table<wend_policy>(WEND_POLICY)
            ->act(bench.ref().self, rows.data(), static_cast<std::uint32_t>(rows.size()), nullptr, actions.data()),
        WEND_OK)
        << bench.error();
    return actions;
  }

  // All rows until each is over; returns their flags.  `moved` may change the world after each step.
  template <class Moved>
  std::vector<std::uint32_t> drive(std::uint64_t seed, double seconds, Moved&& moved) {
    plane->time_limit = seconds, plane->steps = 0;
    bench.begin(seed);
    std::vector<wend_outcome> outcomes(bench.rows());
    std::vector<std::uint32_t> copies;
    for (std::uint32_t copy = 0; copy < bench.rows() / robots(); ++copy) copies.push_back(copy);
    while (true) {
      std::vector<std::uint32_t> going;
      for (const std::uint32_t row : bench.all_rows())
        if (!(outcomes[row].flags & (WEND_TERMINATED | WEND_TRUNCATED))) going.push_back(row);
      if (going.empty()) break;
      const auto chosen = act(going);
      std::vector<double> actions(bench.rows());
      for (std::size_t i = 0; i < going.size(); ++i) actions[going[i]] = chosen[i];
      ways.push_back(chosen);
      plane->step(copies, wend::Matrix<const double>(actions.data(), actions.size(), 1), outcomes);
      moved();
    }
    std::vector<std::uint32_t> flags;
    for (const auto& outcome : outcomes) flags.push_back(outcome.flags);
    return flags;
  }
  std::vector<std::uint32_t> drive(std::uint64_t seed, double seconds = 60) {
    return drive(seed, seconds, [] {});
  }
  std::uint32_t robots() const { return robots_; }
  std::uint32_t robots_ = 1;
  std::vector<std::vector<double>> ways;  // actions of every step
};

constexpr std::uint32_t arrived = WEND_TERMINATED | WEND_ARRIVED, collided = WEND_TERMINATED | WEND_COLLIDED;

// Posts across the room at x = 5, with a gap of free width `gap` around y.
std::vector<wend_disc> fence(double y, double gap) {
  std::vector<wend_disc> posts;
  for (double at = 0; at <= 10; at += 0.1)
    if (std::fabs(at - y) > gap / 2 + 0.1) posts.push_back({5, at, 0.1});
  return posts;
}

}  // namespace

TEST(Ga, DrivesStraightWhereNothingIs) {
  Rig rig;
  ASSERT_TRUE(rig.bench.create()) << rig.bench.error();
  EXPECT_EQ(rig.drive(1), std::vector<std::uint32_t>{arrived});
  EXPECT_LE(rig.ways.size(), 54u) << "7.7 m by 0.15 m take 52 steps";
  const auto told = rig.bench.telemetry(WEND_PER_EPISODE);
  EXPECT_NEAR(told[0], 8, 0.1) << "fitness";
  EXPECT_NEAR(told[1], 8, 0.05) << "length";
  EXPECT_EQ(told[2], 0) << "in obstacles";
  EXPECT_GT(told[3], 60) << "generations";
  EXPECT_EQ(told[4], 1) << "plans";
}

TEST(Ga, PassesTheGap) {
  int passed = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Rig rig;
    rig.plane->obstacles = fence(8, 1.2);
    ASSERT_TRUE(rig.bench.create()) << rig.bench.error();
    passed += rig.drive(seed)[0] == arrived;
    EXPECT_LT(rig.bench.telemetry(WEND_PER_STEP)[0], 0.1) << "it keeps to its path";
  }
  EXPECT_GE(passed, 4);
}

TEST(Ga, TurnsRoundWhereItStandsAtAWall) {
  for (const double heading : {3.14, 2.0, -2.5}) {
    Rig rig;
    rig.plane->motions[0] = {1, 5, heading, 0, 0};
    rig.plane->obstacles = {{0.45, 5, 0.1}, {1, 5.55, 0.1}};  // 0.3 m from the rim, behind and to the left
    ASSERT_TRUE(rig.bench.create()) << rig.bench.error();
    EXPECT_EQ(rig.drive(2)[0], arrived) << heading;
  }
}

TEST(Ga, AnOpenLoopPlanRunsIntoWhatMovedButANewPlanDoesNot) {
  // A disc beside the way moves onto it and stays.
  for (const bool replans : {false, true}) {
    Rig rig;
    rig.plane->movers = {{5, 6.5, 0.5}};
    rig.bench.set("replan", replans ? 5 : 0);
    ASSERT_TRUE(rig.bench.create()) << rig.bench.error();
    const auto flags = rig.drive(3, 60, [&] { rig.plane->movers[0].y = std::max(5.0, rig.plane->movers[0].y - 0.1); });
    EXPECT_EQ(flags[0], replans ? arrived : collided);
    const auto told = rig.bench.telemetry(WEND_PER_EPISODE);
    if (replans)
      EXPECT_GE(told[4], 10);
    else
      EXPECT_EQ(told[4], 1);
    EXPECT_NEAR(told[1], 8, 0.1) << "the first plan goes straight";
  }
}

TEST(Ga, MoversAreObstaclesWhereTheyStandWhenItPlans) {
  Rig rig;
  rig.plane->movers = {{5, 5, 0.5}};
  ASSERT_TRUE(rig.bench.create()) << rig.bench.error();
  EXPECT_EQ(rig.drive(4)[0], arrived);
  const double around = rig.bench.telemetry(WEND_PER_EPISODE)[1], radius = 0.5 + 0.2;
  const double shortest = 2 * (std::sqrt(16 - radius * radius) + radius * std::asin(radius / 4));
  EXPECT_GT(around, shortest - 0.02);
  EXPECT_LT(around, shortest + 0.15);
}

TEST(Ga, RobotsPlanForThemselvesAndMaySeeEachOther) {
  for (const bool see : {false, true}) {
    Rig rig(1, 2);
    rig.robots_ = 2;
    rig.plane->motions = {{1, 5, 0, 0, 0}, {5, 5, 0, 0, 0}};  // the second stands in the way of the first
    rig.plane->goals = {{9, 5, 0.3}, {5, 9, 0.3}};
    rig.bench.set("see_robots", see ? 1 : 0);
    ASSERT_TRUE(rig.bench.create()) << rig.bench.error();
    rig.bench.begin(6);
    rig.act({0, 1});
    const auto told = rig.bench.telemetry(WEND_PER_EPISODE);
    EXPECT_NEAR(told[6], 4, 0.15) << "the second goes straight up";
    if (see)
      EXPECT_GT(told[1], 8.02);
    else
      EXPECT_NEAR(told[1], 8, 0.02);
  }
}

TEST(Ga, PlansOnceAnEpisodeAndTellsItsFitnessOfEveryGeneration) {
  Rig rig;
  rig.bench.set("replan", 10);
  ASSERT_TRUE(rig.bench.create()) << rig.bench.error();
  rig.drive(1);
  const auto generations = static_cast<std::size_t>(rig.bench.telemetry(WEND_PER_EPISODE)[3]);
  ASSERT_EQ(rig.bench.series.size(), generations + 1) << "of the first plan alone";
  for (std::size_t k = 0; k < rig.bench.series.size(); ++k) {
    EXPECT_EQ(rig.bench.series[k].first, "generation/best_fitness");
    EXPECT_EQ(rig.bench.series[k].second.first, static_cast<double>(k));
    if (k > 0) {
      EXPECT_LE(rig.bench.series[k].second.second, rig.bench.series[k - 1].second.second);
    }
  }
  EXPECT_EQ(rig.bench.series.back().second.second, rig.bench.telemetry(WEND_PER_EPISODE)[0]);
}

TEST(Ga, RowsDoNotDependOnTheirBatch) {
  const auto drive = [](Rig& rig) {
    rig.plane->obstacles = fence(7, 1.2);
    EXPECT_TRUE(rig.bench.create()) << rig.bench.error();
    rig.bench.begin(9);
  };
  Rig together(3), alone(3);
  drive(together);
  drive(alone);
  const auto all = together.act({0, 1, 2});
  for (const std::uint32_t row : {2u, 0u, 1u}) EXPECT_EQ(alone.act({row})[0], all[row]);
  EXPECT_EQ(alone.bench.telemetry(WEND_PER_EPISODE), together.bench.telemetry(WEND_PER_EPISODE));
  const auto told = together.bench.telemetry(WEND_PER_EPISODE);
  EXPECT_NE(told[0], told[5]) << "rows have seeds of their own";
}

TEST(Ga, AnEpisodeForgetsTheLast) {
  Rig rig, fresh;
  for (Rig* each : {&rig, &fresh}) {
    each->plane->obstacles = {{5, 5, 1}};
    ASSERT_TRUE(each->bench.create()) << each->bench.error();
  }
  rig.drive(1);
  rig.plane->motions[0] = fresh.plane->motions[0];
  rig.ways.clear();
  EXPECT_EQ(rig.drive(2), fresh.drive(2));
  EXPECT_EQ(rig.ways, fresh.ways);
}

TEST(Ga, FindsItsWayWithoutWalls) {
  Rig rig;
  rig.plane->extra_shapes.clear();
  rig.plane->obstacles = fence(-5, 0);  // from one end of the square to the other: it must go round an end
  ASSERT_TRUE(rig.bench.create()) << rig.bench.error();
  EXPECT_EQ(rig.drive(1)[0], arrived);
  EXPECT_GT(rig.bench.telemetry(WEND_PER_EPISODE)[1], 2 * std::hypot(4, 5));
}

TEST(Ga, ALongThinPlaneTakesNoMoreMemoryThanAnother) {
  Rig rig;
  rig.square = {0, 0, 1e12, 0, 1e12, 0, 1e12, 1e-6, 1e12, 1e-6, 0, 1e-6, 0, 1e-6, 0, 0};  // 10^12 columns at 1 m
  rig.plane->extra_shapes = {{WEND_SHAPE_SEGMENTS, WEND_WALL, 8, rig.square.data(), nullptr, 0, 0, 0}};
  ASSERT_TRUE(rig.bench.set("generations", 1).create()) << rig.bench.error();
  rig.bench.begin(1);
  EXPECT_EQ(rig.act({0}).size(), 1u);
}

TEST(Ga, Explains) {
  Rig rig;
  ASSERT_TRUE(rig.bench.create()) << rig.bench.error();
  rig.bench.begin(1);
  EXPECT_EQ(rig.bench.explain(), "no plan yet");
  rig.act({0});
  EXPECT_EQ(rig.bench.explain().rfind("plan 1: 8.0", 0), 0u) << rig.bench.explain();
}

TEST(Ga, RefusesContradictoryParameters) {
  const auto refused = [](const char* path, double value, const char* message) {
    Rig rig;
    rig.bench.set("population", 10).set(path, value);
    EXPECT_FALSE(rig.bench.create());
    EXPECT_EQ(rig.bench.error(), message);
    return rig.bench.parameter();
  };
  EXPECT_EQ(refused("tournament", 11, "expected at most the population, 10; found 11"), "tournament");
  EXPECT_EQ(refused("elites", 10, "expected fewer than the population, 10, so that there are children; found 10"),
            "elites");
  EXPECT_EQ(refused("sigma/1", 0.2, "expected [first, last] with last <= first, found a last above the first"),
            "sigma");
}

TEST(Ga, RefusesBodiesItCannotDrive) {
  Rig continuous;
  continuous.plane->speed_and_turn_rate();
  continuous.bench.action(continuous.plane->actions());
  EXPECT_FALSE(continuous.bench.create());
  EXPECT_EQ(continuous.bench.error(),
            "cannot follow a path with the actions speed, turn_rate: expected one discrete action");

  Rig still;
  still.plane->action_table({{0, 0}, {0, 1}});
  still.bench.action(still.plane->actions());
  EXPECT_FALSE(still.bench.create());
  EXPECT_EQ(still.bench.error(), "expected an action that leads somewhere from rest, found none");
}
