// Clutter in the manner of Perille, Xiao et al. 2020 (Benchmarking metric ground navigation): random cells, smoothed by
// a cellular automaton, kept where a robot can pass.  The rules below are not the paper's code: they were chosen so
// that the maps look and measure like the published ones (README, "The frame of the BARN maps").
//
// Frame of the BARN worlds: x = -4.5 ... 0 and y = 0 ... 9.6 m, walls at both ends of x and at y = 0, open beyond
// y = 9.6 m.  The robot starts in the middle of x at y = 3 m, before the clutter; the goal is 10 m ahead, beyond it.
#include <algorithm>
#include <wend/math.hpp>

#include "generators.hpp"
#include "placement.hpp"

namespace arena {
namespace {

// A cell with `birth` occupied neighbours of its eight fills; an occupied one stays with `survival`.
constexpr int birth = 5, survival = 2;

using Cells = std::vector<std::uint8_t>;  // row-major from the lower-left

Cells smooth(const Cells& old, std::size_t columns, std::size_t rows, std::size_t corridor) {
  Cells next = old;
  for (std::size_t row = corridor; row < rows; ++row) {
    for (std::size_t column = 1; column + 1 < columns; ++column) {
      int neighbours = 0;
      for (std::size_t r = row - 1; r <= std::min(row + 1, rows - 1); ++r)
        for (std::size_t c = column - 1; c <= column + 1; ++c)
          neighbours += (r != row || c != column) ? old[r * columns + c] : 0;
      const std::size_t i = row * columns + column;
      next[i] = neighbours >= birth || (old[i] != 0 && neighbours >= survival) ? 1 : 0;
    }
  }
  return next;
}

// The published maps show outlines rather than solid blobs: a cell between four occupied ones is left out.
Cells hollow(const Cells& full, std::size_t columns, std::size_t rows, std::size_t corridor) {
  Cells outline = full;
  for (std::size_t row = corridor; row + 1 < rows; ++row)
    for (std::size_t column = 1; column + 1 < columns; ++column) {
      const std::size_t i = row * columns + column;
      if (full[i - 1] && full[i + 1] && full[i - columns] && full[i + columns]) outline[i] = 0;
    }
  return outline;
}

Cells draw_cells(const Cellular& p, wend::Random& random) {
  const std::size_t columns = p.cells[0], rows = p.cells[1];
  Cells cells(columns * rows, 0);
  const double fill = random.uniform(p.fill[0], p.fill[1]);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const bool wall = row == 0 || column == 0 || column + 1 == columns;
      const bool clutter = row >= p.corridor && random.chance(fill);
      cells[row * columns + column] = wall || clutter ? 1 : 0;
    }
  }
  const std::uint64_t iterations = p.smoothing[0] + random.below(p.smoothing[1] - p.smoothing[0] + 1);
  for (std::uint64_t i = 0; i < iterations; ++i) cells = smooth(cells, columns, rows, p.corridor);
  return hollow(cells, columns, rows, p.corridor);
}

Scene lay_out(const Cellular& p, Cells cells) {
  Scene scene;
  scene.name = "cellular";
  scene.walled = false;
  Grid grid;
  grid.cell = p.cell;
  grid.columns = p.cells[0], grid.rows = p.cells[1];
  grid.x = -(grid.columns * p.cell), grid.y = 0;
  grid.occupied = std::move(cells);
  const double depth = grid.rows * p.cell, start = p.corridor * 20 / 34 * p.cell, goal = start + depth / 9.6 * 10;
  scene.starts = {{grid.x / 2, start, wend::math::half_pi, false}};
  scene.goals = {{grid.x / 2, goal, p.goal_radius, {}, 0}};
  scene.x = grid.x, scene.y = 0;
  scene.width = -grid.x, scene.height = goal + p.goal_radius;
  if (p.discs) {
    for (std::uint32_t row = 0; row < grid.rows; ++row)
      for (std::uint32_t column = 0; column < grid.columns; ++column)
        if (grid.at(column, row))
          scene.discs.push_back({grid.x + (column + 0.5) * p.cell, (row + 0.5) * p.cell, p.cell / 2});
  } else {
    scene.grid = std::move(grid);
  }
  return scene;
}

}  // namespace

Scene generate(const Cellular& p, std::uint64_t key) {
  if (p.corridor >= p.cells[1])
    refuse("corridor", "expected fewer cells than the map has along y, found as many or more");
  if (p.fill[0] > p.fill[1]) refuse("fill", "expected the least share first, found the larger one");
  if (p.smoothing[0] > p.smoothing[1])
    refuse("smoothing", "expected the fewest iterations first, found the larger number");
  for (int attempt = 0; attempt < most_tries; ++attempt) {
    wend::Random random(wend::stream(key, static_cast<std::uint64_t>(attempt)));
    Scene scene = lay_out(p, draw_cells(p, random));
    const Start& start = scene.starts[0];
    const Goal& goal = scene.goals[0];
    if (joined(scene, {start.x, start.y}, {goal.x, goal.y}, p.body + p.margin, p.cell / 5)) return scene;
  }
  refuse("fill", "expected a way from start to goal, found none in 1000 tries: choose less fill or a smaller body");
}

}  // namespace arena
