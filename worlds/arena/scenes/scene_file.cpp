// The scene format: its reader, which takes nothing that it does not know, and its writer.
#include "scene_file.hpp"

#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>
#include <wend/error.hpp>
#include <wend/math.hpp>

#include "text_file.hpp"

namespace arena {
namespace {

using Json = nlohmann::json;

constexpr double far = 1e6;  // m, the largest coordinate or length
constexpr std::size_t most = 100000;

// A value of the file, with the pointer that leads to it.
class Node {
 public:
  Node(const std::string& file, std::string pointer, const Json& value)
      : file_(file), pointer_(std::move(pointer)), value_(value) {}

  [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
    throw wend::Error(file_ + ": " + (pointer_.empty() ? "the file" : pointer_) + ": expected " + expected +
                      ", found " + found);
  }
  [[noreturn]] void fail(const std::string& expected) const {
    std::string found = value_.dump(-1, ' ', true, Json::error_handler_t::replace);
    if (found.size() > 60) found = found.substr(0, 60) + "...";
    fail(expected, found);
  }

  bool has(const char* key) const { return value_.contains(key); }
  Node at(const char* key) const {
    const auto found = value_.find(key);
    if (found == value_.end()) fail("a \"" + std::string(key) + "\"", "none");
    return {file_, pointer_ + "/" + key, *found};
  }
  Node at(std::size_t i) const { return {file_, pointer_ + "/" + std::to_string(i), value_[i]}; }

  void object(std::initializer_list<const char*> keys) const {
    if (!value_.is_object()) fail("an object");
    std::string known;
    for (const char* key : keys) known += (known.empty() ? "" : ", ") + std::string(key);
    for (const auto& [key, unused] : value_.items()) {
      const bool unknown =
          std::none_of(keys.begin(), keys.end(), [&, &k = key](const char* name) { return k == name; });
      if (unknown) fail("only the keys " + known, in_quotes(key));
    }
  }
  std::size_t array(std::size_t least, std::size_t largest, const char* of) const {
    if (!value_.is_array()) fail("an array of " + std::string(of));
    const std::size_t n = value_.size();
    if (n < least || n > largest)
      fail((least == largest ? std::to_string(least) : std::to_string(least) + " to " + std::to_string(largest)) + " " +
               of,
           std::to_string(n));
    return n;
  }
  double number(double low, double high, const char* what) const {
    const double v = value_.is_number() ? value_.get<double>() : high + 1;
    if (!(v >= low && v <= high)) fail(what);
    return v;
  }
  double coordinate() const { return number(-far, far, "a coordinate in m, -1e6 to 1e6"); }
  double speed() const { return number(0, far, "a speed in m/s, 0 to 1e6"); }
  double length() const {
    const double v = number(0, far, "a length in m above 0, at most 1e6");
    if (v == 0) fail("a length in m above 0, at most 1e6");
    return v;
  }
  bool flag() const {
    if (!value_.is_boolean()) fail("true or false");
    return value_.get<bool>();
  }
  std::string text() const {
    if (!value_.is_string() || value_.get_ref<const std::string&>().size() > 10000)
      fail("a text of at most 10000 characters");
    return value_.get<std::string>();
  }
  std::vector<double> coordinates(std::size_t n, const char* of) const {
    array(n, n, of);
    std::vector<double> all;
    for (std::size_t i = 0; i < n; ++i) all.push_back(at(i).coordinate());
    return all;
  }
  Point point() const {
    const std::vector<double> xy = coordinates(2, "coordinates x, y");
    return {xy[0], xy[1]};
  }

 private:
  const std::string& file_;
  std::string pointer_;
  const Json& value_;
};

template <class Read>
void each(const Node& scene, const char* key, const char* of, Read&& read) {
  if (!scene.has(key)) return;
  const Node list = scene.at(key);
  const std::size_t n = list.array(0, most, of);
  for (std::size_t i = 0; i < n; ++i) read(list.at(i));
}

double cross(const Point& o, const Point& a, const Point& b) noexcept {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

// Whether two edges without a common end have a point in common.
bool edges_meet(const Point& a, const Point& b, const Point& c, const Point& d) noexcept {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x)) return false;
  if (std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) return false;
  const double p = cross(a, b, c), q = cross(a, b, d), r = cross(c, d, a), s = cross(c, d, b);
  return ((p >= 0 && q <= 0) || (p <= 0 && q >= 0)) && ((r >= 0 && s <= 0) || (r <= 0 && s >= 0));
}

Polygon read_polygon(const Node& node) {
  Polygon polygon;
  std::vector<Point>& points = polygon.points;
  const std::size_t n = node.array(3, 1000, "points");
  for (std::size_t i = 0; i < n; ++i) points.push_back(node.at(i).point());
  double area = 0;
  for (std::size_t i = 1; i + 1 < n; ++i) area += cross(points[0], points[i], points[i + 1]);
  if (area == 0) node.fail("a polygon with an area", "none");
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && edges_meet(points[i], points[i + 1], points[j], points[(j + 1) % n]))
        node.fail("edges that do not meet",
                  "that those from points " + std::to_string(i) + " and " + std::to_string(j) + " do");
  if (area < 0) std::reverse(points.begin(), points.end());
  return polygon;
}

Polygon read_rectangle(const Node& node) {
  node.array(4, 4, "numbers x, y, width, height");
  const double x = node.at(std::size_t{0}).coordinate(), y = node.at(1).coordinate();
  const double w = node.at(2).length(), h = node.at(3).length();
  return {{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}};
}

Grid read_grid(const Node& node) {
  node.object({"x", "y", "cell", "rows"});
  Grid grid;
  grid.x = node.at("x").coordinate(), grid.y = node.at("y").coordinate(), grid.cell = node.at("cell").length();
  const Node rows = node.at("rows");
  const std::size_t n = rows.array(1, 4096, "rows");
  const std::size_t width = rows.at(std::size_t{0}).text().size();
  if (width < 1 || width > 4096) rows.at(std::size_t{0}).fail("1 to 4096 characters", std::to_string(width));
  grid.columns = static_cast<std::uint32_t>(width), grid.rows = static_cast<std::uint32_t>(n);
  for (std::size_t i = n; i-- > 0;) {
    const std::string row = rows.at(i).text();
    if (row.size() != width)
      rows.at(i).fail("as many characters as the first row, " + std::to_string(width), std::to_string(row.size()));
    for (const char c : row) {
      if (c != '.' && c != '@') rows.at(i).fail("only . and @", in_quotes(std::string(1, c)));
      grid.occupied.push_back(c == '@' ? 1 : 0);
    }
  }
  return grid;
}

std::vector<Point> read_waypoints(const Node& node) {
  std::vector<Point> points;
  const std::size_t n = node.array(2, 1000, "way-points");
  for (std::size_t i = 0; i < n; ++i) {
    points.push_back(node.at(i).point());
    if (i > 0 && points[i].x == points[i - 1].x && points[i].y == points[i - 1].y)
      node.at(i).fail("a way-point away from the one before");
  }
  return points;
}

Mover read_mover(const Node& node) {
  Mover mover;
  if (node.has("waypoints")) {
    node.object({"radius", "waypoints", "speed", "random_phase"});
    mover.waypoints = read_waypoints(node.at("waypoints"));
    mover.speed = node.at("speed").speed();
    if (node.has("random_phase")) mover.random_phase = node.at("random_phase").flag();
    mover.x = mover.waypoints[0].x, mover.y = mover.waypoints[0].y;
  } else {
    node.object({"radius", "x", "y", "vx", "vy"});
    mover.x = node.at("x").coordinate(), mover.y = node.at("y").coordinate();
    mover.vx = node.at("vx").coordinate(), mover.vy = node.at("vy").coordinate();
  }
  mover.radius = node.at("radius").length();
  return mover;
}

Start read_start(const Node& node) {
  node.object({"x", "y", "heading", "heading_deg"});
  Start start{node.at("x").coordinate(), node.at("y").coordinate(), 0, true};
  if (node.has("heading") && node.has("heading_deg")) node.fail("heading (rad) or heading_deg", "both");
  if (node.has("heading")) start.heading = node.at("heading").number(-10, 10, "a heading in rad, -10 to 10");
  if (node.has("heading_deg"))
    start.heading = node.at("heading_deg").number(-360, 360, "a heading in degrees, -360 to 360") * wend::math::degree;
  start.random_heading = !node.has("heading") && !node.has("heading_deg");
  return start;
}

Goal read_goal(const Node& node) {
  node.object({"x", "y", "radius", "waypoints", "speed"});
  Goal goal;
  goal.x = node.at("x").coordinate(), goal.y = node.at("y").coordinate(), goal.radius = node.at("radius").length();
  if (node.has("waypoints")) goal.waypoints = read_waypoints(node.at("waypoints"));
  if (node.has("waypoints") || node.has("speed")) goal.speed = node.at("speed").speed();
  if (node.has("speed") && !node.has("waypoints")) node.fail("way-points beside a speed", "none");
  return goal;
}

// Where bounds are walls, nothing that moves is outside them.
void check_inside(const Scene& scene, const Node& node, const Point& p) {
  if (scene.walled && !(p.x > scene.x && p.x < scene.x + scene.width && p.y > scene.y && p.y < scene.y + scene.height))
    node.fail("a place within the bounds, which are walls");
}

Scene read_scene(const std::string& name, const Node& file) {
  file.object({"wend_scene", "name", "bounds", "walled", "discs", "segments", "polygons", "rectangles", "grid",
               "movers", "starts", "goals", "optimal_length"});
  file.at("wend_scene").number(1, 1, "version 1");
  Scene scene;
  scene.name = file.has("name") ? file.at("name").text() : stem_of(name);
  const Node bounds = file.at("bounds");
  bounds.object({"x", "y", "width", "height"});
  if (bounds.has("x")) scene.x = bounds.at("x").coordinate();
  if (bounds.has("y")) scene.y = bounds.at("y").coordinate();
  scene.width = bounds.at("width").length(), scene.height = bounds.at("height").length();
  if (file.has("walled")) scene.walled = file.at("walled").flag();
  each(file, "discs", "discs", [&](const Node& node) {
    node.array(3, 3, "numbers x, y, radius");
    scene.discs.push_back({node.at(std::size_t{0}).coordinate(), node.at(1).coordinate(), node.at(2).length()});
  });
  each(file, "segments", "segments", [&](const Node& node) {
    const std::vector<double> v = node.coordinates(4, "coordinates x0, y0, x1, y1");
    if (v[0] == v[2] && v[1] == v[3]) node.fail("two different ends");
    scene.segments.push_back({v[0], v[1], v[2], v[3]});
  });
  each(file, "polygons", "polygons", [&](const Node& node) { scene.polygons.push_back(read_polygon(node)); });
  each(file, "rectangles", "rectangles", [&](const Node& node) { scene.polygons.push_back(read_rectangle(node)); });
  if (file.has("grid")) scene.grid = read_grid(file.at("grid"));
  each(file, "movers", "movers", [&](const Node& node) {
    scene.movers.push_back(read_mover(node));
    check_inside(scene, node, {scene.movers.back().x, scene.movers.back().y});
    for (const Point& p : scene.movers.back().waypoints) check_inside(scene, node, p);
  });
  each(file, "starts", "starts", [&](const Node& node) {
    scene.starts.push_back(read_start(node));
    check_inside(scene, node, {scene.starts.back().x, scene.starts.back().y});
  });
  each(file, "goals", "goals", [&](const Node& node) {
    scene.goals.push_back(read_goal(node));
    check_inside(scene, node, {scene.goals.back().x, scene.goals.back().y});
  });
  if (file.has("optimal_length"))
    scene.optimal_length = file.at("optimal_length").number(0, 1e9, "a length in m, 0 or more");
  return scene;
}

}  // namespace

Scene parse_scene(const std::string& name, std::string_view text) {
  std::vector<std::set<std::string>> open;  // keys of the objects around the present one
  const auto once = [&](int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) open.emplace_back();
    if (event == Json::parse_event_t::object_end) open.pop_back();
    if (event == Json::parse_event_t::key && !open.back().insert(parsed.get<std::string>()).second)
      throw wend::Error(name + ": expected each key once in an object, found " + in_quotes(parsed.get<std::string>()) +
                        " twice");
    return true;
  };
  Json json;
  try {
    json = Json::parse(text, once);
  } catch (const Json::parse_error& error) {
    const std::string_view before = text.substr(0, std::max<std::size_t>(error.byte, 1) - 1);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t column =
        before.size() - (before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1) + 1;
    throw wend::Error(name + ": line " + std::to_string(line) + ", column " + std::to_string(column) +
                      ": expected JSON, found " +
                      (before.size() < text.size() ? in_quotes(text.substr(before.size(), 1)) : "the end of the file"));
  } catch (const Json::exception&) {
    throw wend::Error(name + ": expected numbers that a double can hold, found one beyond");
  }
  return read_scene(name, Node(name, "", json));
}

}  // namespace arena
