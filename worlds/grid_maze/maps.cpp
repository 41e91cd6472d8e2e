#include "maps.hpp"

#include <wend/error.hpp>

namespace grid_maze {
namespace {

// Wilson 1994: this pattern, repeated without end, which is what a torus is.
constexpr std::string_view woods1 = R"(
.....
.OOF.
.OOO.
.OOO.
.....)";

// Wilson 1995: two kinds of rock and of food, dealt at random once.
constexpr std::string_view woods2 = R"(
..............................
.QQF..QQF..OQF..QQG..OQG..OQF.
.OOO..QOO..OQO..OOQ..QQO..QQQ.
.OOQ..OQQ..OQQ..QQO..OOO..QQO.
..............................
..............................
.QOF..QOG..QOF..OOF..OOG..QOG.
.QQO..QOO..OOO..OQO..QQO..QOO.
.QQQ..OOO..OQO..QOQ..QOQ..OQO.
..............................
..............................
.QOG..QOF..OOG..OQF..OOG..OOF.
.OOQ..OQQ..QQO..OQQ..QQO..OQO.
.QQO..OOO..OQO..OOQ..OQQ..QQQ.
..............................)";

// Lanzi 1997.
constexpr std::string_view maze4 = R"(
OOOOOOOO
O..O..FO
OO..O..O
OO.O..OO
O......O
OO.O...O
O....O.O
OOOOOOOO)";

// Lanzi 1999.
constexpr std::string_view maze5 = R"(
OOOOOOOOO
O......FO
O..O.OO.O
O.O.....O
O...OO..O
O.O.O..OO
O.O..O..O
O.....O.O
OOOOOOOOO)";

// Lanzi 1999: Maze5 with one rock moved, which leaves a single way in to the food.
constexpr std::string_view maze6 = R"(
OOOOOOOOO
O.....OFO
O..O.OO.O
O.O.....O
O...OO..O
O.O.O..OO
O.O.....O
O.....O.O
OOOOOOOOO)";

// The lines that follow the first, which is empty.
std::vector<std::string> rows_of(std::string_view text) {
  std::vector<std::string> rows;
  while (!text.empty()) {
    text.remove_prefix(1);
    rows.emplace_back(text.substr(0, text.find('\n')));
    text.remove_prefix(rows.back().size());
  }
  return rows;
}

}  // namespace

std::vector<std::string> named_map(std::string_view name) {
  if (name == "woods1") return rows_of(woods1);
  if (name == "woods2") return rows_of(woods2);
  if (name == "maze4") return rows_of(maze4);
  if (name == "maze5") return rows_of(maze5);
  if (name == "maze6") return rows_of(maze6);
  throw wend::parameter_error("maze", "no maze is called \"" + std::string(name) + "\"");
}

}  // namespace grid_maze
