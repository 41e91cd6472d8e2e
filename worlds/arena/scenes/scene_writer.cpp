// Writes a scene in its own format: an element a line, numbers so that they are read back to the same bits.
#include <nlohmann/json.hpp>
#include <utility>

#include "scene_file.hpp"

namespace arena {
namespace {

using Json = nlohmann::json;

std::string line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json points(const std::vector<Point>& all) {
  Json json = Json::array();
  for (const Point& p : all) json.push_back({p.x, p.y});
  return json;
}

Json mover_json(const Mover& mover) {
  if (mover.waypoints.empty())
    return {{"radius", mover.radius}, {"x", mover.x}, {"y", mover.y}, {"vx", mover.vx}, {"vy", mover.vy}};
  return {{"radius", mover.radius},
          {"waypoints", points(mover.waypoints)},
          {"speed", mover.speed},
          {"random_phase", mover.random_phase}};
}

Json start_json(const Start& start) {
  Json json = {{"x", start.x}, {"y", start.y}};
  if (!start.random_heading) json["heading"] = start.heading;
  return json;
}

Json goal_json(const Goal& goal) {
  Json json = {{"x", goal.x}, {"y", goal.y}, {"radius", goal.radius}};
  if (!goal.waypoints.empty()) {
    json["waypoints"] = points(goal.waypoints);
    json["speed"] = goal.speed;
  }
  return json;
}

template <class T, class Write>
void list(std::string& out, const char* key, const std::vector<T>& all, Write&& write) {
  if (all.empty()) return;
  out += ",\n  \"" + std::string(key) + "\": [";
  for (std::size_t i = 0; i < all.size(); ++i) out += (i == 0 ? "\n    " : ",\n    ") + line(write(all[i]));
  out += "\n  ]";
}

std::string grid_text(const Grid& grid) {
  std::string out = ",\n  \"grid\": {\"x\": " + line(grid.x) + ", \"y\": " + line(grid.y) +
                    ", \"cell\": " + line(grid.cell) + ", \"rows\": [";
  for (std::uint32_t row = grid.rows; row-- > 0;) {
    out += row + 1 == grid.rows ? "\n    \"" : ",\n    \"";
    for (std::uint32_t column = 0; column < grid.columns; ++column) out += grid.at(column, row) ? '@' : '.';
    out += '"';
  }
  return out + "\n  ]}";
}

}  // namespace

std::string format_scene(const Scene& scene) {
  std::string out = "{\n  \"wend_scene\": 1,\n  \"name\": " + line(scene.name) + ",\n  \"bounds\": " +
                    line({{"x", scene.x}, {"y", scene.y}, {"width", scene.width}, {"height", scene.height}}) +
                    ",\n  \"walled\": " + line(scene.walled);
  if (scene.optimal_length >= 0) out += ",\n  \"optimal_length\": " + line(scene.optimal_length);
  list(out, "discs", scene.discs, [](const Disc& d) { return Json{d.x, d.y, d.radius}; });
  list(out, "segments", scene.segments, [](const Segment& s) { return Json{s.x0, s.y0, s.x1, s.y1}; });
  list(out, "polygons", scene.polygons, [](const Polygon& p) { return points(p.points); });
  if (scene.grid.columns > 0) out += grid_text(scene.grid);
  list(out, "movers", scene.movers, mover_json);
  list(out, "starts", scene.starts, start_json);
  list(out, "goals", scene.goals, goal_json);
  return out + "\n}\n";
}

}  // namespace arena
