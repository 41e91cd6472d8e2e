// Maps and scenarios of Sturtevant's benchmarks (movingai.com): octile grids as text, and starts and goals on them.
//
// A map:       type octile (may be missing) / height H / width W / map / H rows of W characters: . and G and S are
//              free; @ O T W are occupied (swamp S is passable, as it is for the benchmarks' own oracle; water W is
//              not).
// A scenario:  version 1 / bucket map width height start-x start-y goal-x goal-y optimal-length, y counted from the
// top.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "../scene.hpp"

namespace arena {

struct MapOptions {
  double cell = 1;            // m
  double x = 0, y = 0;        // m, the lower-left corner
  bool rows_along_x = false;  // row r of the text lies at x = r and its column c at y = c, as in the BARN maps;
                              // else column c at x = c and the last row at the bottom
  bool discs = false;         // an occupied cell is a disc of half a cell instead of a square
  bool walled = true;         // the map's edge is a wall
};

struct Record {
  std::uint32_t line = 0;                                          // of the file
  std::string map;                                                 // as the file spells it
  std::uint32_t width = 0, height = 0;                             // cells
  std::uint32_t start_x = 0, start_y = 0, goal_x = 0, goal_y = 0;  // cells, y from the top
  double optimal_length = 0;                                       // cells
};

// Both throw wend::Error, without a parameter, whose text opens with `name` and the line.
Scene parse_movingai_map(const std::string& name, std::string_view text, const MapOptions&);
std::vector<Record> parse_movingai_scenario(const std::string& name, std::string_view text);

// The middle of the cell in column x and row y (from the top) of a map of that many cells.
Point cell_centre(const MapOptions&, std::uint32_t height, std::uint32_t x, std::uint32_t y) noexcept;

}  // namespace arena
