// A trace is an NPZ file with the arrays of struct Trace; its static shapes are columns of equal length, their points
// and cells laid end to end.
#include <wend/abi.h>

#include <core/base/error.hpp>
#include <core/record/json_text.hpp>
#include <core/record/npz.hpp>
#include <core/record/trace.hpp>

namespace wend::core {
namespace {

constexpr std::int64_t format = 1;

std::uint64_t cell_count(const TraceShape& shape) {
  return std::uint64_t{shape.columns} * shape.rows;
}

// False of a world without geometry, whose traces have no poses and no goals.
bool placed(const Trace& trace) {
  return !trace.pose.empty() || !trace.goal.empty();
}

// What is wrong with the lengths of the arrays, or an empty string; so nobody who reads a Trace need check them again.
std::string defect(const Trace& trace) {
  const std::size_t states = trace.time.size(), steps = states - 1;
  if (states == 0) return "time: expected at least one value, found none";
  const std::size_t places = placed(trace) ? states * trace.robots * 3 : 0;
  const struct {
    const char* name;
    std::size_t found, expected;
  } lengths[] = {{"pose", trace.pose.size(), places},
                 {"goal", trace.goal.size(), places},
                 {"body_radius", trace.body_radius.size(), trace.robots},
                 {"action", trace.action.size(), steps * trace.robots * trace.action_width},
                 {"reward", trace.reward.size(), steps * trace.robots},
                 {"flags", trace.flags.size(), steps * trace.robots},
                 {"mover", trace.mover.size(), states * trace.movers * 3},
                 {"telemetry", trace.telemetry.size(), steps * trace.robots * trace.telemetry_names.size()}};
  for (const auto& array : lengths)
    if (array.found != array.expected)
      return std::string(array.name) + ": expected " + std::to_string(array.expected) + " values, found " +
             std::to_string(array.found);
  for (std::size_t i = 0; i < trace.shapes.size(); ++i) {
    const TraceShape& shape = trace.shapes[i];
    const std::string where = "shape " + std::to_string(i) + ": ";
    const bool grid = shape.form == WEND_SHAPE_GRID;
    if (shape.form > WEND_SHAPE_GRID) return where + "form " + std::to_string(shape.form) + ", expected 0..3";
    if (grid ? shape.xy.size() != 3 : shape.xy.size() % 2 != 0)
      return where + "expected " + (grid ? "3 values" : "pairs of values") + " in xy, found " +
             std::to_string(shape.xy.size());
    if (shape.cells.size() != (grid ? cell_count(shape) : 0))
      return where + "expected " + std::to_string(grid ? cell_count(shape) : 0) + " cells, found " +
             std::to_string(shape.cells.size());
  }
  return "";
}

void add_shapes(NpzWriter& file, const std::vector<TraceShape>& shapes) {
  std::vector<std::uint32_t> form, kind, values, columns, rows;
  std::vector<double> radius, xy;
  std::vector<std::uint8_t> cells;
  for (const TraceShape& shape : shapes) {
    form.push_back(shape.form);
    kind.push_back(shape.kind);
    values.push_back(static_cast<std::uint32_t>(shape.xy.size()));
    columns.push_back(shape.columns);
    rows.push_back(shape.rows);
    radius.push_back(shape.radius);
    xy.insert(xy.end(), shape.xy.begin(), shape.xy.end());
    cells.insert(cells.end(), shape.cells.begin(), shape.cells.end());
  }
  const Shape n{shapes.size()};
  file.add("shape_form", form, n);
  file.add("shape_kind", kind, n);
  file.add("shape_values", values, n);  // of shape_xy
  file.add("shape_columns", columns, n);
  file.add("shape_rows", rows, n);
  file.add("shape_radius", radius, n);
  file.add("shape_xy", xy, {xy.size()});
  file.add("shape_cells", cells, {cells.size()});
}

std::vector<TraceShape> read_shapes(const NpzReader& file) {
  const auto form = file.uint32("shape_form", 1), kind = file.uint32("shape_kind", 1);
  const auto values = file.uint32("shape_values", 1), columns = file.uint32("shape_columns", 1);
  const auto rows = file.uint32("shape_rows", 1);
  const auto radius = file.float64("shape_radius", 1), xy = file.float64("shape_xy", 1);
  const auto cells = file.uint8("shape_cells", 1);
  const std::size_t n = form.size();
  if (kind.size() != n || values.size() != n || columns.size() != n || rows.size() != n || radius.size() != n)
    file.fail("the columns of its shapes differ in length");
  std::vector<TraceShape> shapes(n);
  std::size_t point = 0, cell = 0;
  for (std::size_t i = 0; i < n; ++i) {
    TraceShape& shape = shapes[i];
    shape.form = form[i];
    shape.kind = kind[i];
    shape.columns = columns[i];
    shape.rows = rows[i];
    shape.radius = radius[i];
    const std::uint64_t wanted = shape.form == WEND_SHAPE_GRID ? cell_count(shape) : 0;
    if (values[i] > xy.size() - point || wanted > cells.size() - cell)
      file.fail("shape " + std::to_string(i) + " asks for more points or cells than there are");
    shape.xy.assign(xy.begin() + static_cast<std::ptrdiff_t>(point),
                    xy.begin() + static_cast<std::ptrdiff_t>(point + values[i]));
    shape.cells.assign(cells.begin() + static_cast<std::ptrdiff_t>(cell),
                       cells.begin() + static_cast<std::ptrdiff_t>(cell + wanted));
    point += values[i];
    cell += wanted;
  }
  return shapes;
}

std::uint32_t dimension(const NpzReader& file, const char* array, std::uint64_t found) {
  if (found > 0xffffffff) file.fail(std::string("array \"") + array + "\" is too wide");
  return static_cast<std::uint32_t>(found);
}

std::vector<std::string> read_names(const NpzReader& file) {
  const auto names = parse_recorded(file.text("telemetry_names"));
  std::vector<std::string> out;
  if (!names || !names->is_array()) file.fail("array \"telemetry_names\" is not a JSON list");
  for (const Json& name : *names) {
    if (!name.is_string()) file.fail("array \"telemetry_names\" is not a list of texts");
    out.push_back(name.get<std::string>());
  }
  return out;
}

}  // namespace

void write_trace(const std::string& path, const Trace& trace) {
  if (const std::string wrong = defect(trace); !wrong.empty())
    throw Error(Exit::data, "cannot write the trace " + path + ": " + wrong);
  const std::uint64_t states = trace.time.size(), steps = states - 1, robots = trace.robots;
  NpzWriter file;
  file.add("format", std::vector<std::int64_t>{format}, {1});
  file.add_text("about", trace.about.dump(-1, ' ', false, Json::error_handler_t::replace));
  file.add("time", trace.time, {states});
  file.add("pose", trace.pose, {placed(trace) ? states : 0, robots, 3});
  file.add("goal", trace.goal, {placed(trace) ? states : 0, robots, 3});
  file.add("body_radius", trace.body_radius, {robots});
  file.add("action", trace.action, {steps, robots, trace.action_width});
  file.add("reward", trace.reward, {steps, robots});
  file.add("flags", trace.flags, {steps, robots});
  file.add("mover", trace.mover, {states, trace.movers, 3});
  file.add_text("telemetry_names", Json(trace.telemetry_names).dump(-1, ' ', false, Json::error_handler_t::replace));
  file.add("telemetry", trace.telemetry, {steps, robots, trace.telemetry_names.size()});
  add_shapes(file, trace.shapes);
  file.write(path);
}

Trace read_trace(const std::string& path) {
  const NpzReader file(path);
  Trace trace;
  const auto version = file.int64("format", 1);
  if (version.size() != 1 || version[0] != format)
    throw Error(Exit::data, path + ": a trace of another format: expected " + std::to_string(format) + ", found " +
                                (version.empty() ? "none" : std::to_string(version[0])));
  const auto about = parse_recorded(file.text("about"));
  if (!about || !about->is_object()) file.fail("array \"about\" is not a JSON object");
  trace.about = *about;
  Shape shape;
  trace.time = file.float64("time", 1);
  trace.pose = file.float64("pose", 3);
  trace.goal = file.float64("goal", 3);
  trace.body_radius = file.float64("body_radius", 1, &shape);
  trace.robots = dimension(file, "body_radius", shape[0]);
  trace.action = file.float64("action", 3, &shape);
  trace.action_width = dimension(file, "action", shape[2]);
  trace.reward = file.float64("reward", 2);
  trace.flags = file.uint32("flags", 2);
  trace.mover = file.float64("mover", 3, &shape);
  trace.movers = dimension(file, "mover", shape[1]);
  trace.telemetry_names = read_names(file);
  trace.telemetry = file.float64("telemetry", 3);
  trace.shapes = read_shapes(file);
  if (const std::string wrong = defect(trace); !wrong.empty()) file.fail(wrong);
  return trace;
}

}  // namespace wend::core
