#include "grid_memory.hpp"

#include <algorithm>
#include <cmath>

namespace rolling_window {
namespace {

// A hit makes a cell occupied at once; it takes as many beams through it as its evidence to free it again.
constexpr int hit = 3, most_evidence = 9, least_evidence = -3;
constexpr double dot_rate = 0.3;  // of a cell's point towards a new hit in it

long whole(double x) noexcept {
  return static_cast<long>(std::floor(x));
}

}  // namespace

GridMemory::GridMemory(const Settings& settings)
    : settings_(settings), reach_cells_(whole(settings.influence / settings.cell) + 1) {}

void GridMemory::clear() noexcept {
  columns_ = rows_ = 0;
  first_column_ = first_row_ = 0;
  evidence_.clear(), nearest_.clear(), dots_.clear();
  ++version_, ++extent_version_;
}

long GridMemory::column_of(double x) const noexcept {
  return whole(x / settings_.cell);
}
long GridMemory::row_of(double y) const noexcept {
  return whole(y / settings_.cell);
}

bool GridMemory::contains(double x, double y) const noexcept {
  return columns_ > 0 && inside(column_of(x), row_of(y));
}
std::size_t GridMemory::cell_at(double x, double y) const noexcept {
  return index(column_of(x), row_of(y));
}

Point GridMemory::centre(std::size_t cell) const noexcept {
  return {(static_cast<double>(first_column_ + static_cast<long>(cell % columns_)) + 0.5) * settings_.cell,
          (static_cast<double>(first_row_ + static_cast<long>(cell / columns_)) + 0.5) * settings_.cell};
}

// ---- extent

void GridMemory::cover(double x0, double y0, double x1, double y1) {
  const long c0 = column_of(x0), r0 = row_of(y0), c1 = column_of(x1) + 1, r1 = row_of(y1) + 1;
  const bool empty = columns_ == 0;
  const long right = first_column_ + static_cast<long>(columns_), top = first_row_ + static_cast<long>(rows_);
  if (!empty && c0 >= first_column_ && r0 >= first_row_ && c1 <= right && r1 <= top) return;
  long a = empty ? c0 : std::min(c0, first_column_), b = empty ? r0 : std::min(r0, first_row_);
  long c = empty ? c1 : std::max(c1, right), d = empty ? r1 : std::max(r1, top);
  const auto most = static_cast<double>(settings_.most_cells);
  if (static_cast<double>(c - a) * static_cast<double>(d - b) > most) {
    // Too large: keep the box that was asked for in the middle of what is allowed.
    const auto side = static_cast<long>(std::sqrt(most));
    const long column = (c0 + c1) / 2, row = (r0 + r1) / 2;
    a = column - side / 2, c = a + side, b = row - side / 2, d = b + side;
  } else {
    // Grow by a quarter more on each side that grows, so that growing is rare.
    const long spare_x = (c - a) / 4, spare_y = (d - b) / 4;
    if (static_cast<double>(c - a + 2 * spare_x) * static_cast<double>(d - b + 2 * spare_y) <= most) {
      if (empty || a < first_column_) a -= spare_x;
      if (empty || c > right) c += spare_x;
      if (empty || b < first_row_) b -= spare_y;
      if (empty || d > top) d += spare_y;
    }
  }
  resize(a, b, c, d);
}

void GridMemory::resize(long column0, long row0, long column1, long row1) {
  old_evidence_.swap(evidence_), old_nearest_.swap(nearest_), old_dots_.swap(dots_);
  const long old_column = first_column_, old_row = first_row_;
  const std::size_t old_columns = columns_, old_rows = rows_;
  first_column_ = column0, first_row_ = row0;
  columns_ = static_cast<std::size_t>(column1 - column0), rows_ = static_cast<std::size_t>(row1 - row0);
  evidence_.assign(size(), 0), nearest_.assign(size(), Source{none, none}), dots_.assign(size(), Dot{0, 0});
  const long from = std::max(column0, old_column), to = std::min(column1, old_column + static_cast<long>(old_columns));
  bool dropped = from > old_column || to < old_column + static_cast<long>(old_columns);
  for (std::size_t r = 0; r < old_rows; ++r) {
    const long row = old_row + static_cast<long>(r);
    if (row < row0 || row >= row1 || from >= to) {
      dropped = true;
      continue;
    }
    const std::size_t source = r * old_columns + static_cast<std::size_t>(from - old_column), target = index(from, row);
    const auto n = static_cast<std::ptrdiff_t>(to - from);
    const auto copy = [&](const auto& old, auto& now) {
      const auto first = old.begin() + static_cast<std::ptrdiff_t>(source);
      std::copy(first, first + n, now.begin() + static_cast<std::ptrdiff_t>(target));
    };
    copy(old_evidence_, evidence_), copy(old_dots_, dots_);
    if (!dropped) copy(old_nearest_, nearest_);
  }
  // New cells near old surfaces, and all cells where a surface was dropped, look for their nearest again.
  if (dropped) std::fill(nearest_.begin(), nearest_.end(), Source{none, none});
  for (std::size_t i = 0; i < size(); ++i)
    if (occupied(i)) spread(i);
  ++version_, ++extent_version_;
}

// ---- one scan

void GridMemory::observe(const Percept& percept) {
  const Point at = percept.at();
  double reach = percept.body + settings_.influence;
  for (const Beam& beam : percept.window) reach = std::max(reach, percept.body + beam.range);
  reach += 2 * settings_.cell;
  cover(at.x - reach, at.y - reach, at.x + reach, at.y + reach);
  removed_.clear();
  for (const Beam& beam : percept.window) carve(percept, beam);
  for (const Beam& beam : percept.window)
    if (beam.hit) mark(percept, beam);
  orphans_.clear();
  for (const std::size_t cell : removed_)
    if (!occupied(cell)) collect_orphans(cell);
  if (!orphans_.empty()) adopt_orphans();
}

// What a beam went through is free, up to the surface's place less its uncertainty (Amanatides and Woo 1987).
void GridMemory::carve(const Percept& percept, const Beam& beam) {
  const double cell = settings_.cell, x = percept.motion.x + percept.body * beam.cosine,
               y = percept.motion.y + percept.body * beam.sine;
  const double length = beam.hit ? beam.range * (1 - 2 * settings_.range_noise) - 0.75 * cell : beam.range;
  if (length <= 0) return;
  long column = column_of(x), row = row_of(y);
  const long step_x = beam.cosine > 0 ? 1 : -1, step_y = beam.sine > 0 ? 1 : -1;
  const double far = 1e300;
  const double per_x = beam.cosine != 0 ? cell / std::fabs(beam.cosine) : far,
               per_y = beam.sine != 0 ? cell / std::fabs(beam.sine) : far;
  const auto until = [&](double p, long c, double direction) {
    return direction == 0
               ? far
               : ((direction > 0 ? static_cast<double>(c + 1) : static_cast<double>(c)) * cell - p) / direction;
  };
  double next_x = until(x, column, beam.cosine), next_y = until(y, row, beam.sine), gone = 0;
  while (gone <= length && inside(column, row)) {
    const std::size_t i = index(column, row);
    if (evidence_[i] > least_evidence && --evidence_[i] == 0) removed_.push_back(i);
    if (next_x < next_y) {
      gone = next_x, next_x += per_x, column += step_x;
    } else {
      gone = next_y, next_y += per_y, row += step_y;
    }
  }
}

void GridMemory::mark(const Percept& percept, const Beam& beam) {
  const double x = percept.motion.x + (percept.body + beam.range) * beam.cosine;
  const double y = percept.motion.y + (percept.body + beam.range) * beam.sine;
  const long column = column_of(x), row = row_of(y);
  if (!inside(column, row)) return;
  const std::size_t i = index(column, row);
  const auto dx = static_cast<float>(x - static_cast<double>(column) * settings_.cell);
  const auto dy = static_cast<float>(y - static_cast<double>(row) * settings_.cell);
  // A cell that this scan's beams have just freed was occupied before it: nothing has changed then.
  const bool was = occupied(i), known = was || std::find(removed_.begin(), removed_.end(), i) != removed_.end();
  evidence_[i] = static_cast<std::int8_t>(std::min(most_evidence, std::max<int>(evidence_[i], 0) + hit));
  if (known) {
    constexpr auto rate = static_cast<float>(dot_rate);
    dots_[i].x += rate * (dx - dots_[i].x), dots_[i].y += rate * (dy - dots_[i].y);
  } else {
    dots_[i] = {dx, dy};
    spread(i);
    ++version_;
  }
}

// ---- clearances

double GridMemory::squared_distance(double x, double y, std::size_t at) const noexcept {
  const double corner_x = static_cast<double>(first_column_ + static_cast<long>(at % columns_)) * settings_.cell;
  const double corner_y = static_cast<double>(first_row_ + static_cast<long>(at / columns_)) * settings_.cell;
  const double dx = corner_x + static_cast<double>(dots_[at].x) - x,
               dy = corner_y + static_cast<double>(dots_[at].y) - y;
  return dx * dx + dy * dy;
}

double GridMemory::clearance(double x, double y) const noexcept {
  const long column = column_of(x), row = row_of(y);
  if (columns_ == 0 || !inside(column, row)) return settings_.influence;
  const Source source = nearest_[index(column, row)];
  if (source.dx == none) return settings_.influence;
  return std::min(settings_.influence, std::sqrt(squared_distance(x, y, index(column + source.dx, row + source.dy))));
}

double GridMemory::clearance(std::size_t cell) const noexcept {
  const Source source = nearest_[cell];
  if (source.dx == none) return settings_.influence;
  const auto at = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) + source.dx +
                                           source.dy * static_cast<std::ptrdiff_t>(columns_));
  const Point p = centre(cell);
  return std::min(settings_.influence, std::sqrt(squared_distance(p.x, p.y, at)));
}

// Tells the cells around a newly occupied one about its point.
void GridMemory::spread(std::size_t from) {
  const long column = first_column_ + static_cast<long>(from % columns_),
             row = first_row_ + static_cast<long>(from / columns_);
  const long c0 = std::max(column - reach_cells_, first_column_),
             c1 = std::min(column + reach_cells_, first_column_ + static_cast<long>(columns_) - 1);
  const long r0 = std::max(row - reach_cells_, first_row_),
             r1 = std::min(row + reach_cells_, first_row_ + static_cast<long>(rows_) - 1);
  const double limit = settings_.influence + settings_.cell,
               point_x = (static_cast<double>(column)) * settings_.cell + static_cast<double>(dots_[from].x),
               point_y = static_cast<double>(row) * settings_.cell + static_cast<double>(dots_[from].y);
  for (long r = r0; r <= r1; ++r) {
    const double dy = (static_cast<double>(r) + 0.5) * settings_.cell - point_y;
    std::size_t i = index(c0, r);
    for (long c = c0; c <= c1; ++c, ++i) {
      const double dx = (static_cast<double>(c) + 0.5) * settings_.cell - point_x, squared = dx * dx + dy * dy;
      if (squared > limit * limit) continue;
      const Source now = nearest_[i];
      if (now.dx != none) {
        const Point p{(static_cast<double>(c) + 0.5) * settings_.cell, (static_cast<double>(r) + 0.5) * settings_.cell};
        if (squared_distance(p.x, p.y, index(c + now.dx, r + now.dy)) <= squared) continue;
      }
      nearest_[i] = {static_cast<std::int16_t>(column - c), static_cast<std::int16_t>(row - r)};
    }
  }
}

// The cells that lost their nearest point.
void GridMemory::collect_orphans(std::size_t removed) {
  ++version_;
  const long column = first_column_ + static_cast<long>(removed % columns_),
             row = first_row_ + static_cast<long>(removed / columns_);
  for (long r = row - reach_cells_; r <= row + reach_cells_; ++r) {
    for (long c = column - reach_cells_; c <= column + reach_cells_; ++c) {
      if (!inside(c, r)) continue;
      Source& source = nearest_[index(c, r)];
      if (source.dx != column - c || source.dy != row - r) continue;
      source = {none, none};
      orphans_.push_back(index(c, r));
    }
  }
}

// An orphan takes the best of what its neighbours have, until nobody finds a nearer one (the nearest points of
// neighbouring cells are the same or adjacent ones, as in Danielsson's distance transform).
void GridMemory::adopt_orphans() {
  const double limit = settings_.influence + settings_.cell;
  for (int sweep = 0; sweep < 16; ++sweep) {
    bool changed = false;
    const auto adopt = [&](std::size_t i) {
      const auto column = static_cast<long>(i % columns_), row = static_cast<long>(i / columns_);
      const Point p = centre(i);
      Source best = nearest_[i];
      double least = limit * limit;
      if (best.dx != none)
        least =
            squared_distance(p.x, p.y, i + static_cast<std::size_t>(best.dx + best.dy * static_cast<long>(columns_)));
      bool better = false;
      for (long dr = -1; dr <= 1; ++dr) {
        for (long dc = -1; dc <= 1; ++dc) {
          const long c = column + dc, r = row + dr;
          if (c < 0 || r < 0 || c >= static_cast<long>(columns_) || r >= static_cast<long>(rows_)) continue;
          const Source source = nearest_[static_cast<std::size_t>(r) * columns_ + static_cast<std::size_t>(c)];
          if (source.dx == none) continue;
          const auto at = static_cast<std::size_t>((r + source.dy) * static_cast<long>(columns_) + c + source.dx);
          const double squared = squared_distance(p.x, p.y, at);
          if (squared < least) {
            least = squared;
            best = {static_cast<std::int16_t>(source.dx + dc), static_cast<std::int16_t>(source.dy + dr)};
            better = true;
          }
        }
      }
      if (better) nearest_[i] = best, changed = true;
    };
    if (sweep % 2 == 0)
      for (const std::size_t i : orphans_) adopt(i);
    else
      for (std::size_t k = orphans_.size(); k-- > 0;) adopt(orphans_[k]);
    if (!changed) break;
  }
}

}  // namespace rolling_window
