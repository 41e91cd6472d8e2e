// The world through its C tables.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <wend/testing.hpp>

#include "maps.hpp"
#include "maze.hpp"

using grid_maze::Edge;
using grid_maze::Maze;
using wend::testing::Bench;

namespace {

struct World : Bench {
  explicit World(const char* maze, std::uint32_t copies = 1) : Bench(*wend_plugin_1.components[0]) {
    set("maze", maze).set("edge", "wraps").set("bits", 0).set("payoff", 1000).set("time_limit", 500);
    set("test", "random").Bench::copies(copies);
  }
  // Copy c gets episode `index` + c.
  void reset(std::vector<std::uint32_t> copies, std::uint64_t seed, std::uint32_t mode, std::uint64_t index = 0) {
    std::vector<wend_episode> episodes;
    for (const std::uint32_t copy : copies) {
      const std::uint64_t number = index + copy;
      episodes.push_back({number, wend::stream(seed, number), 0, 0, mode});
    }
    ASSERT_EQ(table<wend_world>(WEND_WORLD)
                  ->reset(ref().self, copies.data(), static_cast<std::uint32_t>(copies.size()), episodes.data()),
              WEND_OK);
  }
  wend_status try_step(double action, wend_outcome& outcome) {
    const std::uint32_t copy = 0;
    return table<wend_world>(WEND_WORLD)->step(ref().self, &copy, 1, &action, &outcome);
  }
  wend_outcome step(double action) {
    wend_outcome outcome{};
    EXPECT_EQ(try_step(action, outcome), WEND_OK);
    return outcome;
  }
};

std::vector<double> view(const Maze& maze, std::uint32_t cell, std::uint32_t bits) {
  std::vector<double> all;
  for (std::uint32_t d = 0; d < 8; ++d)
    for (std::uint32_t b = bits; b-- > 0;) all.push_back(grid_maze::code_of(maze.sees(cell, d), bits) >> b & 1);
  return all;
}

constexpr std::uint32_t arrived = WEND_TERMINATED | WEND_ARRIVED;

}  // namespace

TEST(GridMaze, SeesEightNeighboursInTwoOrThreeBits) {
  for (const auto& [name, bits] : {std::pair{"woods1", 2u}, {"woods2", 3u}, {"maze4", 2u}, {"maze6", 2u}}) {
    World world(name);
    world.set("test", "enumerate");
    ASSERT_TRUE(world.create()) << world.error();
    const wend_space* space = world.table<wend_sensor>(WEND_SENSOR)->space(world.ref().self);
    ASSERT_EQ(space->width, 8 * bits);
    EXPECT_STREQ(space->columns[0].name, "bit.0");
    EXPECT_EQ(space->columns[0].count, 2u);
    EXPECT_EQ(world.table<wend_world>(WEND_WORLD)->action(world.ref().self, 0)->columns[0].count, 8u);
    const Maze maze(grid_maze::named_map(name), Edge::wraps);
    for (std::uint64_t k = 0; k < maze.empty_cells().size(); ++k) {
      world.reset({0}, 1, WEND_TEST, k);
      EXPECT_EQ(world.sense(), view(maze, maze.empty_cells()[k], bits)) << name << " " << k;
    }
  }
}

TEST(GridMaze, ASensorVectorByHand) {
  World world("custom");
  world.set("map", {"OFQ", "G.*", "O.."}).set("bits", 3).set("test", "enumerate");
  ASSERT_TRUE(world.create()) << world.error();
  world.reset({0}, 1, WEND_TEST, 0);  // the middle: N F, NE Q, E ., SE ., S ., SW O, W G, NW O
  EXPECT_EQ(world.sense(),
            (std::vector<double>{1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 1, 1, 0, 1, 0}));
  world.set("bits", 2);
  ASSERT_TRUE(world.create()) << world.error();
  world.reset({0}, 1, WEND_TEST, 0);
  EXPECT_EQ(world.sense(), (std::vector<double>{1, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 1}));
}

TEST(GridMaze, AShortestWalkIsToldAsSuch) {
  World world("maze5");
  world.set("test", "enumerate");
  ASSERT_TRUE(world.create()) << world.error();
  const Maze maze(grid_maze::named_map("maze5"), Edge::wraps);
  double sum = 0;
  for (std::uint64_t k = 0; k < maze.empty_cells().size(); ++k) {
    world.reset({0}, 1, WEND_TEST, k);
    std::uint32_t cell = maze.empty_cells()[k];
    for (std::uint32_t left = maze.steps_to_food(cell); left > 0; --left) {
      EXPECT_TRUE(std::isnan(world.telemetry(WEND_PER_EPISODE)[0])) << "not there yet";
      std::uint32_t d = 0;
      while (maze.steps_to_food(maze.step(cell, d)) != left - 1) ++d;
      cell = maze.step(cell, d);
      const wend_outcome outcome = world.step(d);
      EXPECT_EQ(outcome.reward, left == 1 ? 1000 : 0);
      EXPECT_EQ(outcome.flags, left == 1 ? arrived : 0u);
    }
    const auto told = world.telemetry(WEND_PER_EPISODE);
    EXPECT_EQ(told[0], maze.steps_to_food(maze.empty_cells()[k]));
    EXPECT_EQ(told[1], told[0]);
    EXPECT_EQ(told[2], 1);
    sum += told[0];
  }
  EXPECT_EQ(sum, 166);
}

TEST(GridMaze, RockCostsAStepAndTheLimitTruncates) {
  World world("custom");
  world.set("map", {"OOOOO", "O..FO", "OOOOO"}).set("test", "enumerate").set("time_limit", 4);
  ASSERT_TRUE(world.create()) << world.error();
  world.reset({0}, 1, WEND_TEST, 0);
  EXPECT_EQ(world.step(0).flags, 0u);  // into the rock to the north
  EXPECT_EQ(world.step(2).flags, 0u);
  EXPECT_EQ(world.step(2).flags, arrived);
  EXPECT_EQ(world.telemetry(WEND_PER_EPISODE), (std::vector<double>{3, 2, 1.5}));

  world.reset({0}, 1, WEND_TEST, 1);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(world.step(0).flags, 0u);
  const wend_outcome last = world.step(0);
  EXPECT_EQ(last.flags, std::uint32_t{WEND_TRUNCATED});
  EXPECT_EQ(last.reward, 0);
  EXPECT_EQ(world.telemetry(WEND_PER_EPISODE), (std::vector<double>{4, 1, 4})) << "a failure counts as its limit";
}

TEST(GridMaze, ExploringEpisodesTellNothing) {
  World world("custom");
  world.set("map", {"OOOO", "O.FO", "OOOO"});
  ASSERT_TRUE(world.create()) << world.error();
  for (const std::uint32_t mode : {WEND_TEST, WEND_TRAIN_GREEDY, WEND_TRAIN_EXPLORE}) {
    world.reset({0}, 4, mode);
    EXPECT_EQ(world.step(2).flags, arrived);
    const auto told = world.telemetry(WEND_PER_EPISODE);
    for (const double value : told) EXPECT_EQ(std::isnan(value), mode == WEND_TRAIN_EXPLORE);
  }
}

TEST(GridMaze, StartsAreUniformOverEmptyCells) {
  World world("woods1", 3200);
  ASSERT_TRUE(world.create()) << world.error();
  world.reset(world.all_rows(), 12, WEND_TRAIN_EXPLORE);
  std::map<std::vector<double>, int> count;  // Woods1 looks different from each cell
  for (const std::uint32_t row : world.all_rows()) ++count[world.sense({row})];
  ASSERT_EQ(count.size(), 16u);
  double chi_square = 0;
  for (const auto& [seen, n] : count) chi_square += (n - 200.0) * (n - 200.0) / 200;
  EXPECT_LT(chi_square, 37.7) << "0.1 % point of 15 degrees of freedom";
}

TEST(GridMaze, CopiesDoNotDependOnEachOther) {
  World many("woods2", 4), one("woods2");
  ASSERT_TRUE(many.create() && one.create());
  many.reset({0, 1, 2, 3}, 6, WEND_TRAIN_GREEDY);
  one.reset({0}, 6, WEND_TRAIN_GREEDY, 2);
  EXPECT_EQ(many.sense({2}), one.sense());
}

TEST(GridMaze, RefusesWhatItCannotUse) {
  World both("woods1");
  both.set("map", {"...", ".F.", "..."});
  EXPECT_FALSE(both.create());
  EXPECT_EQ(both.parameter(), "map");
  EXPECT_EQ(both.error(), "expected no rows beside maze \"woods1\", found 3; say maze \"custom\" to use them");

  World none("custom");
  EXPECT_FALSE(none.create());
  EXPECT_EQ(none.parameter(), "map");
  EXPECT_EQ(none.error(), "expected at least 3 x 3 cells, found 0 x 0");

  World two("woods1");
  two.robots(2);
  EXPECT_FALSE(two.create());
  EXPECT_EQ(two.error(), "expected one robot in a grid maze, found 2");

  World half("woods1");
  half.set("time_limit", 2.5);
  EXPECT_FALSE(half.create());
  EXPECT_EQ(half.parameter(), "time_limit");
  EXPECT_EQ(half.error(), "expected a whole number of steps, a second each, found 2.5");

  World world("woods1");
  ASSERT_TRUE(world.create()) << world.error();
  world.reset({0}, 1, WEND_TEST);
  wend_outcome outcome{};
  EXPECT_EQ(world.try_step(8, outcome), WEND_E_ARGUMENT);
  EXPECT_EQ(world.error(), "expected a direction 0..7, found 8.000000");
}
