#include <wend/abi.h>

#include <algorithm>
#include <cmath>
#include <core/figure/map_scene.hpp>
#include <core/figure/simplify.hpp>

namespace wend::core {
namespace {

constexpr double tolerance = 0.15;  // px
constexpr double marker = 5.5;      // px
constexpr double small_goal = 7;    // px

bool same(Place a, Place b) {
  return std::hypot(a.x - b.x, a.y - b.y) < 0.5;
}

}  // namespace

void MapScene::add_disc(double x, double y, double radius, std::optional<Colour> fill, const Pen& pen,
                        double least) const {
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(radius)) return;
  items_.push_back({Circle{view_(x, y), std::max(radius * view_.scale, least), fill, pen}, clip_});
}

void MapScene::add_number(Place at, std::uint32_t robot, Colour colour) const {
  Text text = label({at.x + 7, at.y - 6}, std::to_string(robot + 1), 11, colour, Anchor::start, true);
  text.halo = 1.6;
  items_.push_back({std::move(text), clip_});
}

// Rows 0 to count - 1 of a table of x, y, something; `column` counts triples.
std::vector<Place> MapScene::way_of(const std::vector<double>& values, std::size_t column, std::size_t columns,
                                    std::size_t count) const {
  std::vector<Place> way;
  for (std::size_t t = 0; t < count && (t * columns + column) * 3 + 2 < values.size(); ++t) {
    const double* at = &values[(t * columns + column) * 3];
    way.push_back(view_(at[0], at[1]));
  }
  return simplified(way, tolerance);
}

void MapScene::add_grid(const TraceShape& shape) const {
  const std::size_t columns = shape.columns, rows = shape.rows;
  if (shape.xy.size() < 3 || columns == 0 || shape.cells.size() < columns * rows) return;
  const double cell = shape.xy[2];
  const Place corner = view_(shape.xy[0], shape.xy[1] + cell * static_cast<double>(rows));
  Cells cells;
  cells.box = {corner.x, corner.y, cell * view_.scale * static_cast<double>(columns),
               cell * view_.scale * static_cast<double>(rows)};
  cells.columns = shape.columns;
  cells.rows = shape.rows;
  cells.fill = shape.kind == WEND_WALL ? ink::wall : ink::obstacle_edge;
  cells.cells.reserve(columns * rows);
  for (std::size_t row = rows; row-- > 0;)  // theirs from the bottom, ours from the top
    for (std::size_t column = 0; column < columns; ++column)
      cells.cells.push_back(shape.cells[row * columns + column] != 0);
  items_.push_back({std::move(cells), clip_});
}

void MapScene::add_shape(const TraceShape& shape) const {
  const bool wall = shape.kind == WEND_WALL;
  const Colour fill = wall ? ink::wall : ink::obstacle;
  const Pen edge{wall ? ink::wall : ink::obstacle_edge, 1, Cap::round, {}};
  if (shape.form == WEND_SHAPE_GRID) return add_grid(shape);
  if (shape.form == WEND_SHAPE_DISC && shape.xy.size() >= 2)
    return add_disc(shape.xy[0], shape.xy[1], shape.radius, fill, edge, 0.7);
  std::vector<Place> points;
  for (std::size_t i = 0; i + 1 < shape.xy.size(); i += 2) points.push_back(view_(shape.xy[i], shape.xy[i + 1]));
  if (shape.form == WEND_SHAPE_POLYGON) items_.push_back({Path{points, true, fill, edge}, clip_});
  const Pen line{wall ? ink::wall : ink::obstacle_edge, 2, Cap::round, {}};
  if (shape.form == WEND_SHAPE_SEGMENTS)
    for (std::size_t i = 0; i + 1 < points.size(); i += 2)
      items_.push_back({Path{{points[i], points[i + 1]}, false, {}, line}, clip_});
}

void MapScene::add_movers(const Trace& trace) const {
  const std::size_t count = trace.time.size();
  for (std::size_t m = 0; m < trace.movers; ++m)
    items_.push_back(
        {Path{way_of(trace.mover, m, trace.movers, count), false, {}, Pen{ink::mover_path, 1.3, Cap::round, {}}},
         clip_});
  for (std::size_t m = 0; m < trace.movers && 3 * m + 2 < trace.mover.size(); ++m) {
    const double* at = &trace.mover[3 * m];
    add_disc(at[0], at[1], at[2], ink::mover, Pen{ink::mover_edge, 1.2, Cap::butt, {}}, 1.5);
    add_disc(at[0], at[1], at[2] * 0.55, {}, Pen{ink::mover_edge, 0.9, Cap::butt, {}});
  }
}

void MapScene::add_goals(const Trace& trace) const {
  std::vector<Place> drawn;
  for (std::uint32_t robot = 0; robot < trace.robots && 3 * robot + 2 < trace.goal.size(); ++robot) {
    const std::vector<Place> way = way_of(trace.goal, robot, trace.robots, trace.time.size());
    if (way.size() > 1 && !std::all_of(way.begin(), way.end(), [&](Place p) { return same(p, way[0]); }))
      items_.push_back({Path{way, false, {}, Pen{ink::goal_edge, 1, Cap::butt, {4, 3}}}, clip_});
    const double* at = &trace.goal[3 * robot];
    const Place here = view_(at[0], at[1]);
    if (std::any_of(drawn.begin(), drawn.end(), [&](Place p) { return same(p, here); })) continue;
    drawn.push_back(here);
    add_disc(at[0], at[1], at[2], ink::goal, Pen{ink::goal_edge, 1.2, Cap::butt, {}}, 3);
    items_.push_back({Circle{here, 1.6, ink::goal_edge, {}}, clip_});
    if (trace.robots > 1) add_number(here, robot, ink::text);
  }
}

// Above the bodies that stand in it; where the goal is too small to be seen below a marker, four ticks point at it.
void MapScene::add_goal_rings(const Trace& trace) const {
  const Pen pen{ink::goal_edge, 1.2, Cap::butt, {}};
  for (std::uint32_t robot = 0; robot < trace.robots && 3 * robot + 2 < trace.goal.size(); ++robot) {
    const double* at = &trace.goal[3 * robot];
    add_disc(at[0], at[1], at[2], {}, pen, 3);
    const Place here = view_(at[0], at[1]);
    if (!(at[2] * view_.scale < small_goal) || !std::isfinite(here.x + here.y)) continue;
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
      items_.push_back(
          {Path{{{here.x + 9 * dx, here.y + 9 * dy}, {here.x + 14 * dx, here.y + 14 * dy}}, false, {}, pen}, clip_});
  }
}

void MapScene::add_way(const MapArm& arm, Layer layer) const {
  const Trace& trace = *arm.trace;
  const LineStyle style = arm.line();
  for (std::uint32_t robot = 0; robot < trace.robots; ++robot) {
    std::vector<Place> way = way_of(trace.pose, robot, trace.robots, outcome(trace, robot).steps + std::size_t{1});
    const Pen pen = layer == Layer::line ? style.pen() : Pen{rgb(0xffffff, 0.75), style.width + 2, Cap::butt, {}};
    items_.push_back({Path{std::move(way), false, {}, pen}, clip_});
  }
}

void MapScene::add_starts(const std::vector<MapArm>& arms) const {
  std::vector<Place> drawn;
  for (const MapArm& arm : arms)
    for (std::uint32_t robot = 0; robot < arm.trace->robots && 3 * robot + 2 < arm.trace->pose.size(); ++robot) {
      const double* pose = &arm.trace->pose[3 * robot];
      const Place here = view_(pose[0], pose[1]);
      if (!std::isfinite(pose[0] + pose[1] + pose[2])) continue;
      if (std::any_of(drawn.begin(), drawn.end(), [&](Place p) { return same(p, here); })) continue;
      drawn.push_back(here);
      const double radius = robot < arm.trace->body_radius.size() ? arm.trace->body_radius[robot] : 0;
      add_disc(pose[0], pose[1], radius, {}, Pen{ink::text, 1, Cap::butt, {2, 2}});
      add_start_marker(items_, here, pose[2], marker, ink::text, clip_);
      if (arm.trace->robots > 1) add_number(here, robot, ink::text);
    }
}

void MapScene::add_body(const MapArm& arm) const {
  const Trace& trace = *arm.trace;
  Colour fill = arm.line().colour;
  fill.alpha = 40;
  for (std::uint32_t robot = 0; robot < trace.robots && robot < trace.body_radius.size(); ++robot) {
    const Outcome end = outcome(trace, robot);
    const std::size_t at = (static_cast<std::size_t>(end.steps) * trace.robots + robot) * 3;
    if (at + 2 >= trace.pose.size()) continue;
    const double x = trace.pose[at], y = trace.pose[at + 1], radius = trace.body_radius[robot];
    add_disc(x, y, radius, fill, Pen{arm.line().colour, 1.1, Cap::butt, {}});
    if (end.ending != Ending::collided) continue;
    for (std::size_t m = 0; m < trace.movers; ++m) {  // the mover that it met, where they met
      const std::size_t place = (end.steps * std::size_t{trace.movers} + m) * 3;
      if (place + 2 >= trace.mover.size()) break;
      const double* mover = &trace.mover[place];
      if (std::hypot(mover[0] - x, mover[1] - y) < 1.1 * (radius + mover[2]))
        add_disc(mover[0], mover[1], mover[2], {}, Pen{arm.line().colour, 1.1, Cap::butt, {3, 2}});
    }
  }
}

void MapScene::add_ending(const MapArm& arm) const {
  const Trace& trace = *arm.trace;
  for (std::uint32_t robot = 0; robot < trace.robots; ++robot) {
    const Outcome end = outcome(trace, robot);
    const std::size_t at = (static_cast<std::size_t>(end.steps) * trace.robots + robot) * 3;
    if (at + 2 >= trace.pose.size() || !std::isfinite(trace.pose[at] + trace.pose[at + 1])) continue;
    const Place here = view_(trace.pose[at], trace.pose[at + 1]);
    add_end_marker(items_, end.ending, here, marker, arm.line().colour, clip_);
    if (trace.robots > 1) add_number(here, robot, arm.line().colour);
  }
}

}  // namespace wend::core
