// Reads the maps and scenarios of Sturtevant's benchmarks, and says of every deviation in which line it stands.
#include "movingai.hpp"

#include <cmath>
#include <wend/error.hpp>

#include "text_file.hpp"

namespace arena {
namespace {

constexpr std::uint32_t longest_side = 16384;

class Lines {
 public:
  Lines(const std::string& name, std::string_view text) : name_(name), lines_(lines_of(text)) {}

  bool more() const noexcept { return next_ < lines_.size(); }
  std::string_view peek() const noexcept { return more() ? lines_[next_] : std::string_view(); }
  std::string_view take() noexcept {
    const std::string_view line = peek();
    ++next_;
    return line;
  }
  std::size_t taken() const noexcept { return next_; }
  // Of the line taken last.
  [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
    throw wend::Error(name_ + ": line " + std::to_string(next_) + ": expected " + expected + ", found " + found);
  }
  [[noreturn]] void fail(const std::string& expected) const {
    fail(expected, next_ > lines_.size() ? "the end of the file" : in_quotes(lines_[next_ - 1]));
  }

 private:
  const std::string& name_;
  std::vector<std::string_view> lines_;
  std::size_t next_ = 0;
};

std::uint32_t read_side(Lines& lines, const char* key) {
  const std::vector<std::string_view> fields = fields_of(lines.take());
  const auto value = fields.size() == 2 && fields[0] == key ? whole_number(fields[1]) : std::nullopt;
  if (!value || *value < 1 || *value > longest_side)
    lines.fail("\"" + std::string(key) + "\" and a whole number from 1 to " + std::to_string(longest_side));
  return *value;
}

// Row by row from the top: 1 is occupied.
std::vector<std::uint8_t> read_cells(Lines& lines, std::uint32_t width, std::uint32_t height) {
  std::vector<std::uint8_t> cells;
  cells.reserve(std::size_t{width} * height);
  for (std::uint32_t row = 0; row < height; ++row) {
    if (!lines.more()) {
      lines.take();
      lines.fail("row " + std::to_string(row + 1) + " of " + std::to_string(height));
    }
    const std::string_view line = lines.take();
    if (line.size() != width)
      lines.fail("a row of " + std::to_string(width) + " characters", std::to_string(line.size()));
    for (std::size_t c = 0; c < line.size(); ++c) {
      const bool free = line[c] == '.' || line[c] == 'G' || line[c] == 'S';
      const bool occupied = line[c] == '@' || line[c] == 'O' || line[c] == 'T' || line[c] == 'W';
      if (!free && !occupied)
        lines.fail("one of . G S @ O T W in column " + std::to_string(c + 1), in_quotes(line.substr(c, 1)));
      cells.push_back(occupied ? 1 : 0);
    }
  }
  while (lines.more())
    if (!lines.take().empty()) lines.fail("nothing after row " + std::to_string(height));
  return cells;
}

void lay(Scene& scene, const std::vector<std::uint8_t>& cells, std::uint32_t width, std::uint32_t height,
         const MapOptions& options) {
  Grid grid;
  grid.x = options.x, grid.y = options.y, grid.cell = options.cell;
  grid.columns = options.rows_along_x ? height : width;
  grid.rows = options.rows_along_x ? width : height;
  grid.occupied.resize(cells.size());
  for (std::uint32_t row = 0; row < height; ++row) {
    for (std::uint32_t column = 0; column < width; ++column) {
      const std::size_t to = options.rows_along_x ? std::size_t{column} * grid.columns + row
                                                  : std::size_t{height - 1 - row} * grid.columns + column;
      grid.occupied[to] = cells[std::size_t{row} * width + column];
    }
  }
  scene.width = grid.columns * grid.cell;
  scene.height = grid.rows * grid.cell;
  if (!options.discs) {
    scene.grid = std::move(grid);
    return;
  }
  for (std::uint32_t row = 0; row < grid.rows; ++row)
    for (std::uint32_t column = 0; column < grid.columns; ++column)
      if (grid.at(column, row))
        scene.discs.push_back({grid.x + (column + 0.5) * grid.cell, grid.y + (row + 0.5) * grid.cell, grid.cell / 2});
}

}  // namespace

Scene parse_movingai_map(const std::string& name, std::string_view text, const MapOptions& options) {
  Lines lines(name, text);
  if (lines.peek().substr(0, 4) == "type") {
    const std::vector<std::string_view> fields = fields_of(lines.take());
    if (fields.size() != 2 || fields[0] != "type" || fields[1] != "octile") lines.fail("\"type octile\"");
  }
  const std::uint32_t height = read_side(lines, "height"), width = read_side(lines, "width");
  if (lines.take() != "map") lines.fail("\"map\"");
  Scene scene;
  scene.name = stem_of(name);
  scene.x = options.x, scene.y = options.y;
  scene.walled = options.walled;
  lay(scene, read_cells(lines, width, height), width, height, options);
  return scene;
}

std::vector<Record> parse_movingai_scenario(const std::string& name, std::string_view text) {
  Lines lines(name, text);
  const std::vector<std::string_view> head = fields_of(lines.take());
  if (head.size() != 2 || head[0] != "version" || (head[1] != "1" && head[1] != "1.0")) lines.fail("\"version 1\"");
  std::vector<Record> records;
  while (lines.more()) {
    const std::string_view line = lines.take();
    if (line.empty()) continue;
    const std::vector<std::string_view> fields = fields_of(line);
    if (fields.size() != 9)
      lines.fail("9 fields: bucket, map, width, height, start x, start y, goal x, goal y, optimal length",
                 std::to_string(fields.size()));
    Record record;
    record.line = static_cast<std::uint32_t>(lines.taken());
    record.map = fields[1];
    std::uint32_t* const numbers[] = {&record.width,   &record.height, &record.start_x,
                                      &record.start_y, &record.goal_x, &record.goal_y};
    for (std::size_t i = 0; i < 6; ++i) {
      const auto value = whole_number(fields[i + 2]);
      if (!value) lines.fail("a whole number in field " + std::to_string(i + 3), in_quotes(fields[i + 2]));
      *numbers[i] = *value;
    }
    const auto length = real_number(fields[8]);
    if (!length || !(*length >= 0)) lines.fail("a length of 0 or more in field 9", in_quotes(fields[8]));
    record.optimal_length = *length;
    if (record.start_x >= record.width || record.goal_x >= record.width || record.start_y >= record.height ||
        record.goal_y >= record.height)
      lines.fail("start and goal within " + std::to_string(record.width) + " x " + std::to_string(record.height) +
                 " cells");
    records.push_back(std::move(record));
  }
  if (records.empty()) {
    lines.take();
    lines.fail("at least one record");
  }
  return records;
}

Point cell_centre(const MapOptions& options, std::uint32_t height, std::uint32_t x, std::uint32_t y) noexcept {
  const double column = options.rows_along_x ? y : x, row = options.rows_along_x ? x : height - 1 - y;
  return {options.x + (column + 0.5) * options.cell, options.y + (row + 0.5) * options.cell};
}

}  // namespace arena
