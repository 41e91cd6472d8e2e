// Reads the parameters that say which scenes an arena has, and hands them out.
#include "source.hpp"

#include <algorithm>
#include <wend/error.hpp>
#include <wend/math.hpp>

#include "scene_file.hpp"
#include "text_file.hpp"

namespace arena {
namespace {

using wend::Params;

// A parameter of "generate", or what the struct holds where a caller without schema left it out.
struct Reader {
  const Params& params;
  std::string path(const char* key) const { return std::string("generate/") + key; }

  void operator()(const char* key, double& value) const { value = params.number_or(path(key), value); }
  void operator()(const char* key, std::uint32_t& value) const {
    value = static_cast<std::uint32_t>(params.number_or(path(key), value));
  }
  void operator()(const char* key, bool& value) const { value = params.number_or(path(key), value) != 0; }
  void operator()(const char* key, std::string& value) const { value = params.text_or(path(key), value); }
  template <class T>
  void operator()(const char* key, std::array<T, 2>& value) const {
    for (std::size_t i = 0; i < 2; ++i)
      value[i] = static_cast<T>(params.number_or(Params::element(path(key), i), static_cast<double>(value[i])));
  }
};

Generator read_generator(const Params& params) {
  const Reader read{params};
  const std::string kind = params.text("generate/kind");
  if (kind == "random_obstacles") {
    RandomObstacles g;
    read("size", g.size), read("count", g.count), read("density", g.density), read("radius", g.radius);
    read("gap", g.gap), read("wall_gap", g.wall_gap), read("body", g.body), read("goal_radius", g.goal_radius);
    read("placement", g.placement), read("distance", g.distance), read("clearance", g.clearance),
        read("blocked", g.blocked);
    return g;
  }
  if (kind == "u_trap") {
    UTrap g;
    read("width", g.width), read("depth", g.depth), read("thickness", g.thickness), read("size", g.size);
    read("before", g.before), read("behind", g.behind), read("jitter", g.jitter), read("turn", g.turn);
    read("body", g.body), read("goal_radius", g.goal_radius);
    return g;
  }
  if (kind == "rooms") {
    Rooms g;
    read("size", g.size), read("rooms", g.rooms), read("door", g.door), read("thickness", g.thickness);
    read("loops", g.loops), read("passages", g.passages), read("count", g.count), read("radius", g.radius);
    read("gap", g.gap), read("body", g.body), read("goal_radius", g.goal_radius);
    return g;
  }
  if (kind == "door_room") {
    DoorRoom g;
    read("size", g.size), read("door", g.door), read("door_offset", g.door_offset);
    read("passage", g.passage), read("goals", g.goals);
    read("patrols", g.patrols), read("patrol_radius", g.patrol_radius), read("patrol_speed", g.patrol_speed);
    read("patrol_beat", g.patrol_beat), read("goal_spread", g.goal_spread);
    read("body", g.body), read("goal_radius", g.goal_radius);
    return g;
  }
  if (kind == "cellular") {
    Cellular g;
    read("cells", g.cells), read("cell", g.cell), read("corridor", g.corridor), read("fill", g.fill);
    read("smoothing", g.smoothing), read("discs", g.discs), read("body", g.body), read("margin", g.margin);
    read("goal_radius", g.goal_radius);
    return g;
  }
  throw wend::parameter_error(
      "generate/kind", "expected random_obstacles, u_trap, rooms, door_room or cellular, found \"" + kind + "\"");
}

// Runs `read`, and adds the parameter to an error that came without.
template <class Read>
auto for_parameter(const std::string& parameter, Read&& read) {
  try {
    return read();
  } catch (const wend::Error& error) {
    if (!error.parameter().empty()) throw;
    throw wend::parameter_error(parameter, error.what());
  }
}

std::vector<std::string> texts(const Params& params, const char* key) {
  std::vector<std::string> all = params.texts(key);
  const std::string one = params.text_or(key, "");
  if (all.empty() && !one.empty()) all.push_back(one);
  return all;
}

MapOptions read_map_options(const Params& params) {
  MapOptions options;
  options.cell = params.number_or("cell", options.cell);
  options.x = params.number_or("origin/0", 0), options.y = params.number_or("origin/1", 0);
  options.rows_along_x = params.text_or("layout", "columns_along_x") == "rows_along_x";
  options.discs = params.text_or("cells_as", "squares") == "discs";
  options.walled = params.number_or("walled", 1) != 0;
  return options;
}

void read_files(SceneSource& source, const Params& params) {
  const std::vector<std::string> scenes = texts(params, "scene"), maps = texts(params, "map");
  for (std::size_t i = 0; i < scenes.size(); ++i)
    source.files.push_back(for_parameter(Params::element("scene", i), [&] {
      return std::make_shared<const Scene>(parse_scene(scenes[i], read_text(scenes[i])));
    }));
  for (std::size_t i = 0; i < maps.size(); ++i)
    source.files.push_back(for_parameter(Params::element("map", i), [&] {
      return std::make_shared<const Scene>(parse_movingai_map(maps[i], read_text(maps[i]), source.map));
    }));
}

void read_places(SceneSource& source, const Params& params) {
  source.goal_radius = params.number_or("goal_radius", -1);
  for (std::size_t i = 0, n = params.size("starts"); i < n; ++i) {
    const std::string at = Params::element("starts", i);
    Start start{params.number(at + "/x"), params.number(at + "/y"), 0, !params.has(at + "/heading_deg")};
    if (!start.random_heading) start.heading = params.number(at + "/heading_deg") * wend::math::degree;
    source.starts.push_back(start);
  }
  for (std::size_t i = 0, n = params.size("goals"); i < n; ++i) {
    const std::string at = Params::element("goals", i), way = at + "/waypoints";
    Goal goal;
    goal.x = params.number(at + "/x"), goal.y = params.number(at + "/y");
    goal.radius = params.number_or(at + "/radius", 0);
    goal.speed = params.number_or(at + "/speed", 0);
    for (std::size_t k = 0, points = params.size(way); k < points; ++k)
      goal.waypoints.push_back(
          {params.number(Params::element(way, k) + "/0"), params.number(Params::element(way, k) + "/1")});
    if (goal.waypoints.size() == 1) throw wend::parameter_error(way, "expected two way-points or more, found 1");
    source.goals.push_back(std::move(goal));
  }
}

void read_scenario(SceneSource& source, const Params& params) {
  const std::string name = params.text_or("scenario", "");
  if (name.empty()) return;
  source.record_by_episode = params.text_or("record", "episode") == "episode";
  const std::size_t maps = texts(params, "map").size();
  if (maps != 1)
    throw wend::parameter_error(
        "scenario", "expected its one map in \"map\", found " + (maps == 0 ? "none" : std::to_string(maps)));
  if (!source.starts.empty() || !source.goals.empty())
    throw wend::parameter_error("scenario", "expected no starts and goals beside its own, found some");
  source.records = for_parameter("scenario", [&] { return parse_movingai_scenario(name, read_text(name)); });

  const Scene& map = *source.files[0];
  const auto cells = [&](double length) { return static_cast<std::uint32_t>(length / source.map.cell + 0.5); };
  std::uint32_t width = cells(map.width), height = cells(map.height);
  if (source.map.rows_along_x) std::swap(width, height);
  for (const Record& record : source.records) {
    const std::string where = name + ": line " + std::to_string(record.line) + ": expected ";
    if (record.width != width || record.height != height)
      throw wend::parameter_error("scenario", where + "the map's " + std::to_string(width) + " x " +
                                                  std::to_string(height) + " cells, found " +
                                                  std::to_string(record.width) + " x " + std::to_string(record.height));
    const auto occupied = [&](std::uint32_t x, std::uint32_t y) {
      const Point p = cell_centre(source.map, height, x, y);
      return map.grid.at(static_cast<std::int64_t>((p.x - map.x) / source.map.cell),
                         static_cast<std::int64_t>((p.y - map.y) / source.map.cell));
    };
    if (occupied(record.start_x, record.start_y))
      throw wend::parameter_error("scenario", where + "a start in a free cell, found an occupied one");
    if (occupied(record.goal_x, record.goal_y))
      throw wend::parameter_error("scenario", where + "a goal in a free cell, found an occupied one");
  }
}

Goal with_radius(Goal goal, double radius, double otherwise) {
  if (radius > 0) goal.radius = radius;
  if (!(goal.radius > 0)) goal.radius = otherwise;
  return goal;
}

// Bounds that are no walls take in all starts and goals.
void open_up(Scene& scene) {
  double x1 = scene.x + scene.width, y1 = scene.y + scene.height;
  const auto include = [&](double x, double y, double r) {
    scene.x = std::min(scene.x, x - r), scene.y = std::min(scene.y, y - r);
    x1 = std::max(x1, x + r), y1 = std::max(y1, y + r);
  };
  for (const Start& start : scene.starts) include(start.x, start.y, 0);
  for (const Goal& goal : scene.goals) {
    include(goal.x, goal.y, goal.radius);
    for (const Point& p : goal.waypoints) include(p.x, p.y, goal.radius);
  }
  scene.width = x1 - scene.x, scene.height = y1 - scene.y;
}

// What the parameters and the record put in place of the file's.
void furnish(Scene& scene, const SceneSource& source, const Record* record) {
  const double half_cell = source.map.cell / 2;
  if (record) {
    const Point start = cell_centre(source.map, record->height, record->start_x, record->start_y);
    const Point goal = cell_centre(source.map, record->height, record->goal_x, record->goal_y);
    scene.starts = {{start.x, start.y, 0, true}};
    scene.goals = {{goal.x, goal.y, half_cell, {}, 0}};
    scene.optimal_length = record->optimal_length * source.map.cell;
  }
  if (!source.starts.empty()) scene.starts = source.starts;
  if (!source.goals.empty()) scene.goals = source.goals;
  if (!source.starts.empty() || !source.goals.empty()) scene.optimal_length = -1;
  for (Goal& goal : scene.goals) goal = with_radius(std::move(goal), source.goal_radius, half_cell);
  if (!scene.walled) open_up(scene);
}

void check_given(const Params& params) {
  std::vector<std::string> given;
  if (params.any_below("generate")) given.push_back("generate");
  for (const char* key : {"scene", "map"})
    if (!texts(params, key).empty()) given.push_back(key);
  if (given.size() == 1) return;
  const std::string found = given.empty() ? "none" : given.size() == 2 ? given[0] + " and " + given[1] : "all three";
  throw wend::parameter_error("generate", "expected one of generate, scene and map, found " + found);
}

}  // namespace

SceneSource read_source(const Params& params) {
  SceneSource source;
  check_given(params);
  source.map = read_map_options(params);
  read_places(source, params);
  if (params.any_below("generate")) source.generator = read_generator(params);
  read_files(source, params);
  read_scenario(source, params);
  return source;
}

ScenePtr make_scene(const SceneSource& source, std::uint64_t scene_key, std::uint32_t variant) {
  const bool changed =
      !source.starts.empty() || !source.goals.empty() || source.goal_radius > 0 || !source.records.empty();
  if (source.generator) {
    Scene scene = std::visit([&](const auto& kind) { return generate(kind, scene_key); }, *source.generator);
    if (changed) furnish(scene, source, nullptr);
    return std::make_shared<const Scene>(std::move(scene));
  }
  const ScenePtr& file = source.files[variant % source.files.size()];
  if (!changed) return file;
  Scene scene = *file;
  furnish(scene, source, source.records.empty() ? nullptr : &source.records[variant % source.records.size()]);
  return std::make_shared<const Scene>(std::move(scene));
}

}  // namespace arena
