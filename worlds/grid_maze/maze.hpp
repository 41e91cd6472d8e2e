// A maze of cells: what it looks like from each, and how far the food is.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace grid_maze {

enum class Edge { wraps, rock };

// Directions 0..7: north, then clockwise.
class Maze {
 public:
  static constexpr std::uint32_t directions = 8;
  static constexpr std::uint32_t never = ~0u;

  // Rows from the north.  Throws wend::Error, naming the row in parameter "map", where the map is broken.
  Maze(const std::vector<std::string>& rows, Edge edge);

  std::uint32_t width() const noexcept { return width_; }
  std::uint32_t height() const noexcept { return height_; }
  // Cells are numbered in reading order.
  char at(std::uint32_t cell) const noexcept { return cells_[cell]; }
  const std::vector<std::uint32_t>& empty_cells() const noexcept { return empty_; }
  bool food(std::uint32_t cell) const noexcept { return cells_[cell] == 'F' || cells_[cell] == 'G'; }

  // Where a step in `direction` from `cell` leads: `cell` itself where rock or the edge is in the way.
  std::uint32_t step(std::uint32_t cell, std::uint32_t direction) const noexcept {
    const std::uint32_t next = neighbours_[cell * directions + direction];
    return next == never || cells_[next] == 'O' || cells_[next] == 'Q' ? cell : next;
  }
  // What an animat in `cell` sees there: '.', 'O', 'Q', 'F' or 'G'.
  char sees(std::uint32_t cell, std::uint32_t direction) const noexcept {
    const std::uint32_t next = neighbours_[cell * directions + direction];
    return next == never ? 'O' : cells_[next];
  }
  // Least number of steps to food; `never` from rock.
  std::uint32_t steps_to_food(std::uint32_t cell) const noexcept { return steps_[cell]; }
  // Their mean over all empty cells.
  double mean_steps_to_food() const noexcept;

 private:
  void read(const std::vector<std::string>& rows);
  void join(Edge edge);
  void measure();
  std::string place(std::uint32_t cell) const;

  std::uint32_t width_ = 0, height_ = 0;
  std::vector<char> cells_;
  std::vector<std::uint32_t> neighbours_, steps_, empty_;
};

// A cell's content in 2 or 3 bits, the first on top.  Wilson 1995: the first bit tells food, the second something
// solid, the third one kind from the other.
constexpr std::uint32_t code_of(char content, std::uint32_t bits) noexcept {
  const std::uint32_t code = content == 'O'   ? 0b010
                             : content == 'Q' ? 0b011
                             : content == 'F' ? 0b110
                             : content == 'G' ? 0b111
                                              : 0b000;
  return bits == 3 ? code : code >> 1;
}

}  // namespace grid_maze
