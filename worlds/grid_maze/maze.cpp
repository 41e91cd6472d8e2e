#include "maze.hpp"

#include <wend/config.hpp>

namespace grid_maze {
namespace {

constexpr int east_of[Maze::directions] = {0, 1, 1, 1, 0, -1, -1, -1};
constexpr int south_of[Maze::directions] = {-1, -1, 0, 1, 1, 1, 0, -1};

// A byte of a character beyond ASCII is no text by itself.
std::string shown(char content) {
  return content >= ' ' && content <= '~' ? "\"" + std::string(1, content) + "\"" : "another character";
}

wend::Error broken(const std::string& message) {
  return wend::parameter_error("map", message);
}

}  // namespace

Maze::Maze(const std::vector<std::string>& rows, Edge edge) {
  read(rows);
  join(edge);
  measure();
}

void Maze::read(const std::vector<std::string>& rows) {
  const std::size_t width = rows.empty() ? 0 : rows.front().size();
  if (rows.size() < 3 || width < 3)
    throw broken("expected at least 3 x 3 cells, found " + std::to_string(width) + " x " + std::to_string(rows.size()));
  if (width > 1000 || rows.size() > 1000)
    throw broken("expected at most 1000 x 1000 cells, found " + std::to_string(width) + " x " +
                 std::to_string(rows.size()));
  width_ = static_cast<std::uint32_t>(width), height_ = static_cast<std::uint32_t>(rows.size());
  bool any_food = false;
  for (std::size_t y = 0; y < rows.size(); ++y) {
    if (rows[y].size() != width)
      throw wend::parameter_error(
          wend::Params::element("map", y),
          "expected " + std::to_string(width) + " cells, as in the first row; found " + std::to_string(rows[y].size()));
    for (std::size_t x = 0; x < width; ++x) {
      const char content = rows[y][x] == '*' ? '.' : rows[y][x];
      if (std::string_view(".OQFG").find(content) == std::string_view::npos)
        throw wend::parameter_error(wend::Params::element("map", y),
                                    "expected . or * (empty), O or Q (rock), F or G (food); found " + shown(content) +
                                        " in column " + std::to_string(x));
      if (content == '.') empty_.push_back(static_cast<std::uint32_t>(cells_.size()));
      any_food = any_food || content == 'F' || content == 'G';
      cells_.push_back(content);
    }
  }
  if (!any_food) throw broken("expected food, F or G, somewhere; found none");
  if (empty_.empty()) throw broken("expected an empty cell to start in, found none");
}

void Maze::join(Edge edge) {
  const int width = static_cast<int>(width_), height = static_cast<int>(height_);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (std::uint32_t d = 0; d < directions; ++d) {
        const int to_x = x + east_of[d], to_y = y + south_of[d];
        const bool outside = to_x < 0 || to_x >= width || to_y < 0 || to_y >= height;
        neighbours_.push_back(
            outside && edge == Edge::rock
                ? never
                : static_cast<std::uint32_t>((to_y + height) % height * width + (to_x + width) % width));
      }
}

// Breadth-first from all food at once: steps are symmetric, as each direction has its opposite.
void Maze::measure() {
  steps_.assign(cells_.size(), never);
  std::vector<std::uint32_t> queue;
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell)
    if (food(cell)) steps_[cell] = 0, queue.push_back(cell);
  for (std::size_t head = 0; head < queue.size(); ++head)
    for (std::uint32_t d = 0; d < directions; ++d) {
      const std::uint32_t next = step(queue[head], d);
      if (steps_[next] != never) continue;
      steps_[next] = steps_[queue[head]] + 1;
      queue.push_back(next);
    }
  for (const std::uint32_t cell : empty_)
    if (steps_[cell] == never)
      throw broken("expected food within reach of every empty cell; none is of " + place(cell));
}

std::string Maze::place(std::uint32_t cell) const {
  return "row " + std::to_string(cell / width_) + ", column " + std::to_string(cell % width_);
}

double Maze::mean_steps_to_food() const noexcept {
  double sum = 0;
  for (const std::uint32_t cell : empty_) sum += steps_[cell];
  return sum / static_cast<double>(empty_.size());
}

}  // namespace grid_maze
