// The maps against the literature's optima, and the geometry of a maze against a plain search.
#include "maze.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <wend/error.hpp>

#include "maps.hpp"

using grid_maze::code_of;
using grid_maze::Edge;
using grid_maze::Maze;
using grid_maze::named_map;

namespace {

// Bellman's equation, swept until nothing changes, on rows and columns with a torus written out by hand.
double mean_by_sweeps(const std::vector<std::string>& rows) {
  const int h = static_cast<int>(rows.size()), w = static_cast<int>(rows[0].size());
  const auto at = [&](int y, int x) { return rows[(y + h) % h][(x + w) % w]; };
  std::vector<std::vector<double>> v(h, std::vector<double>(w, 1e9));
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x) {
        double best = v[y][x];
        if (at(y, x) == 'F' || at(y, x) == 'G')
          best = 0;
        else if (at(y, x) == '.')
          for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) best = std::min(best, 1 + v[(y + dy + h) % h][(x + dx + w) % w]);
        changed = changed || best < v[y][x];
        v[y][x] = best;
      }
  }
  double sum = 0, n = 0;
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x)
      if (at(y, x) == '.') sum += v[y][x], ++n;
  return sum / n;
}

std::string message(const std::vector<std::string>& rows, Edge edge = Edge::wraps) {
  try {
    Maze maze(rows, edge);
  } catch (const wend::Error& error) {
    return error.parameter() + ": " + error.what();
  }
  return "no error";
}

}  // namespace

TEST(Maze, OptimaAreThoseOfTheLiterature) {
  struct Expected {
    const char* name;
    std::size_t empty;
    double sum;  // of the least steps over all empty cells
    double mean;
  };
  for (const auto& [name, empty, sum, mean] : {Expected{"woods1", 16, 27, 1.69},
                                               {"woods2", 288, 486, 1.69},
                                               {"maze4", 26, 91, 3.50},
                                               {"maze5", 36, 166, 4.61},
                                               {"maze6", 36, 187, 5.19}}) {
    const Maze maze(named_map(name), Edge::wraps);
    EXPECT_EQ(maze.empty_cells().size(), empty) << name;
    EXPECT_NEAR(maze.mean_steps_to_food(), sum / static_cast<double>(empty), 1e-12) << name;
    EXPECT_NEAR(maze.mean_steps_to_food(), mean, 0.005) << name;
    EXPECT_NEAR(maze.mean_steps_to_food(), mean_by_sweeps(named_map(name)), 1e-12) << name;
  }
}

TEST(Maze, NoTwoCellsOfDifferentDistanceLookAlike) {
  for (const char* name : {"woods1", "woods2", "maze4", "maze5", "maze6"}) {
    const Maze maze(named_map(name), Edge::wraps);
    std::set<std::pair<std::string, std::uint32_t>> seen;
    std::set<std::string> views;
    for (const std::uint32_t cell : maze.empty_cells()) {
      std::string view;
      for (std::uint32_t d = 0; d < 8; ++d) view += std::to_string(code_of(maze.sees(cell, d), 2));
      views.insert(view);
      seen.insert({view, maze.steps_to_food(cell)});
    }
    EXPECT_EQ(views.size(), seen.size()) << name << ": these mazes are Markov";
  }
}

TEST(Maze, Woods2IsEighteenWoods1Patterns) {
  const Maze woods2(named_map("woods2"), Edge::wraps), woods1(named_map("woods1"), Edge::wraps);
  for (const std::uint32_t cell : woods2.empty_cells()) {
    const std::uint32_t here = cell / 30 % 5 * 5 + cell % 30 % 5;
    EXPECT_EQ(woods2.steps_to_food(cell), woods1.steps_to_food(here));
    for (std::uint32_t d = 0; d < 8; ++d) EXPECT_EQ(code_of(woods2.sees(cell, d), 2), code_of(woods1.sees(here, d), 2));
  }
}

TEST(Maze, StepsGoClockwiseFromTheNorth) {
  const Maze maze({".....", ".....", ".....", "....F", "....."}, Edge::wraps);
  const std::uint32_t from = 2 * 5 + 1;
  const std::vector<std::uint32_t> expected = {6, 7, 12, 17, 16, 15, 10, 5};
  for (std::uint32_t d = 0; d < 8; ++d) EXPECT_EQ(maze.step(from, d), expected[d]) << d;
  EXPECT_EQ(maze.step(0, 7), 24u) << "the corner wraps";
  EXPECT_EQ(maze.step(4, 1), 20u);
  EXPECT_EQ(maze.step(24, 3), 0u);
}

TEST(Maze, RockAndTheEdgeHold) {
  const Maze maze({"...", ".OF", "..Q"}, Edge::rock);
  EXPECT_EQ(maze.step(0, 3), 0u) << "south-east is rock";
  EXPECT_EQ(maze.step(7, 2), 7u) << "Q is rock too";
  EXPECT_EQ(maze.step(0, 0), 0u);
  EXPECT_EQ(maze.sees(0, 0), 'O') << "beyond the edge is rock";
  EXPECT_EQ(maze.step(1, 3), 5u) << "diagonally past a corner";
  EXPECT_EQ(maze.steps_to_food(6), 2u);
  EXPECT_EQ(maze.steps_to_food(3), 2u);
}

TEST(Maze, CodesOfTheCells) {
  EXPECT_EQ(code_of('.', 3), 0b000u);
  EXPECT_EQ(code_of('O', 3), 0b010u);
  EXPECT_EQ(code_of('Q', 3), 0b011u);
  EXPECT_EQ(code_of('F', 3), 0b110u);
  EXPECT_EQ(code_of('G', 3), 0b111u);
  EXPECT_EQ(code_of('.', 2), 0b00u);
  EXPECT_EQ(code_of('O', 2), 0b01u);
  EXPECT_EQ(code_of('Q', 2), 0b01u);
  EXPECT_EQ(code_of('F', 2), 0b11u);
  EXPECT_EQ(code_of('G', 2), 0b11u);
}

TEST(Maze, BrokenMapsAreRefused) {
  EXPECT_EQ(message({}), "map: expected at least 3 x 3 cells, found 0 x 0");
  EXPECT_EQ(message({"..F.", "...."}), "map: expected at least 3 x 3 cells, found 4 x 2");
  EXPECT_EQ(message({"...", ".F", "..."}), "map/1: expected 3 cells, as in the first row; found 2");
  EXPECT_EQ(message({"...", "..F", ".#."}),
            "map/2: expected . or * (empty), O or Q (rock), F or G (food); found \"#\" in column 1");
  EXPECT_EQ(message({"...", "..F", ".\xc3\xa9"}),
            "map/2: expected . or * (empty), O or Q (rock), F or G (food); found another character in column 1");
  EXPECT_EQ(message({"...", ".O.", "..."}), "map: expected food, F or G, somewhere; found none");
  EXPECT_EQ(message({"FFF", "OOO", "GGG"}), "map: expected an empty cell to start in, found none");
  EXPECT_EQ(message({"...O.", "OOOO.", "..FO."}, Edge::rock),
            "map: expected food within reach of every empty cell; none is of row 0, column 0");
  EXPECT_EQ(message({"...O.", "OOOO.", "..FO."}, Edge::wraps), "no error") << "round the torus there is a way";
  EXPECT_EQ(message(std::vector<std::string>(3, std::string(1001, 'F'))),
            "map: expected at most 1000 x 1000 cells, found 1001 x 3");
}
