// The display list as JSON: what core hands to wend-render through a pipe.
#include <cmath>
#include <core/base/error.hpp>
#include <core/figure/display.hpp>
#include <cstdio>
#include <initializer_list>
#include <string_view>

namespace wend::core {
namespace {

double rounded(double value) {
  return std::round(value * 100) / 100;
}

Json to_json(const Colour& colour) {
  char text[16];
  std::snprintf(text, sizeof text, "#%02x%02x%02x%02x", colour.red, colour.green, colour.blue, colour.alpha);
  return text;
}

Json to_json(const Pen& pen) {
  Json json = {{"colour", to_json(pen.colour)}, {"width", rounded(pen.width)}};
  if (pen.cap == Cap::round) json["cap"] = "round";
  for (const double length : pen.dash) json["dash"].push_back(rounded(length));
  return json;
}

Json to_json(const Box& box) {
  return {rounded(box.x), rounded(box.y), rounded(box.width), rounded(box.height)};
}

template <class Shape>
void add_look(Json& json, const Shape& shape) {
  if (shape.fill) json["fill"] = to_json(*shape.fill);
  if (shape.pen) json["pen"] = to_json(*shape.pen);
}

struct Writer {
  Json operator()(const Path& path) const {
    Json points = Json::array();
    for (const Place& p : path.points) {
      points.push_back(rounded(p.x));
      points.push_back(rounded(p.y));
    }
    Json json = {{"path", std::move(points)}};
    if (path.closed) json["closed"] = true;
    add_look(json, path);
    return json;
  }
  Json operator()(const Circle& circle) const {
    Json json = {{"circle", {rounded(circle.centre.x), rounded(circle.centre.y), rounded(circle.radius)}}};
    add_look(json, circle);
    return json;
  }
  Json operator()(const Rectangle& rectangle) const {
    Json json = {{"rectangle", to_json(rectangle.box)}};
    add_look(json, rectangle);
    return json;
  }
  Json operator()(const Text& text) const {
    static const char* const anchors[] = {"start", "middle", "end"};
    Json json = {{"text", text.text},
                 {"at", {rounded(text.at.x), rounded(text.at.y)}},
                 {"size", rounded(text.size)},
                 {"colour", to_json(text.colour)},
                 {"anchor", anchors[static_cast<int>(text.anchor)]}};
    if (text.bold) json["bold"] = true;
    if (text.turn != 0) json["turn"] = rounded(text.turn);
    if (text.halo != 0) json["halo"] = rounded(text.halo);
    return json;
  }
  Json operator()(const Cells& cells) const {
    Json runs = Json::array();  // blank, filled, blank, ...
    std::uint64_t run = 0;
    bool filled = false;
    for (const std::uint8_t cell : cells.cells) {
      if ((cell != 0) != filled) {
        runs.push_back(run);
        run = 0;
        filled = !filled;
      }
      ++run;
    }
    runs.push_back(run);
    return {{"cells", std::move(runs)},
            {"box", to_json(cells.box)},
            {"columns", cells.columns},
            {"rows", cells.rows},
            {"fill", to_json(cells.fill)}};
  }
};

// A JSON value and where it stands; every access checks.
class Reader {
 public:
  Reader(const Json& json, std::string at) : json_(json), at_(std::move(at)) {}

  [[noreturn]] void fail(const std::string& expected) const {
    std::string found = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (found.size() > 60) found = found.substr(0, 57) + "...";
    throw Error(Exit::data, "figure" + at_ + ": expected " + expected + ", found " + found);
  }
  void keys(std::initializer_list<std::string_view> allowed) const {
    if (!json_.is_object()) fail("an object");
    for (const auto& entry : json_.items()) {
      bool known = false;
      for (const std::string_view key : allowed) known = known || entry.key() == key;
      if (!known) throw Error(Exit::data, "figure" + at_ + ": unknown key \"" + entry.key() + "\"");
    }
  }
  bool has(const char* key) const { return json_.is_object() && json_.contains(key); }
  Reader get(const char* key) const {
    if (!has(key)) fail(std::string("an object with \"") + key + "\"");
    return {json_.at(key), at_ + "/" + key};
  }
  Reader get(std::size_t index) const { return {json_.at(index), at_ + "/" + std::to_string(index)}; }
  std::size_t list(std::size_t low, std::size_t high) const {
    if (!json_.is_array() || json_.size() < low || json_.size() > high)
      fail("a list of " + std::to_string(low) + " to " + std::to_string(high) + " entries");
    return json_.size();
  }
  double number(double low, double high) const {
    const double value = json_.is_number() ? json_.get<double>() : std::nan("");
    if (!(value >= low && value <= high)) {
      char range[80];
      std::snprintf(range, sizeof range, "a number in [%.9g, %.9g]", low, high);
      fail(range);
    }
    return value;
  }
  std::uint64_t whole(std::uint64_t high) const {
    if (!json_.is_number_integer() || json_ < 0 || json_.get<std::uint64_t>() > high)
      fail("a whole number in [0, " + std::to_string(high) + "]");
    return json_.get<std::uint64_t>();
  }
  bool flag() const {
    if (!json_.is_boolean()) fail("true or false");
    return json_.get<bool>();
  }
  const std::string& text(std::size_t longest) const {
    if (!json_.is_string() || json_.get_ref<const std::string&>().size() > longest)
      fail("text of at most " + std::to_string(longest) + " bytes");
    return json_.get_ref<const std::string&>();
  }
  double coordinate() const { return number(-FigureLimits::coordinate, FigureLimits::coordinate); }
  double length() const { return number(0, FigureLimits::coordinate); }

  Colour colour() const {
    const std::string& hex = text(9);
    if (hex.size() != 9 || hex[0] != '#' || hex.find_first_not_of("0123456789abcdef", 1) != std::string::npos)
      fail("a colour \"#rrggbbaa\"");
    const unsigned long value = std::stoul(hex.substr(1), nullptr, 16);
    return {static_cast<std::uint8_t>(value >> 24), static_cast<std::uint8_t>(value >> 16),
            static_cast<std::uint8_t>(value >> 8), static_cast<std::uint8_t>(value)};
  }
  Pen pen() const {
    keys({"colour", "width", "cap", "dash"});
    Pen pen{get("colour").colour(), get("width").length(), Cap::butt, {}};
    if (has("cap")) {
      if (get("cap").text(10) != "round") get("cap").fail("\"round\"");
      pen.cap = Cap::round;
    }
    if (!has("dash")) return pen;
    const Reader dash = get("dash");
    double sum = 0;
    for (std::size_t i = 0, n = dash.list(2, 16); i < n; ++i) sum += pen.dash.emplace_back(dash.get(i).length());
    if (sum < 0.5) dash.fail("lengths that sum to at least 0.5 px");
    return pen;
  }
  Box box() const {
    list(4, 4);
    return {get(std::size_t{0}).coordinate(), get(1).coordinate(), get(2).length(), get(3).length()};
  }
  Place place() const {
    list(2, 2);
    return {get(std::size_t{0}).coordinate(), get(1).coordinate()};
  }
  template <class Shape>
  void look(Shape& shape) const {
    if (has("fill")) shape.fill = get("fill").colour();
    if (has("pen")) shape.pen = get("pen").pen();
  }

 private:
  const Json& json_;
  std::string at_;
};

Path read_path(const Reader& json, std::size_t& points) {
  json.keys({"path", "closed", "fill", "pen", "clip"});
  const Reader list = json.get("path");
  const std::size_t n = list.list(2, 2 * points);
  if (n % 2 != 0) list.fail("an even number of coordinates");
  points -= n / 2;
  Path path;
  path.points.reserve(n / 2);
  for (std::size_t i = 0; i < n; i += 2)
    path.points.push_back({list.get(i).coordinate(), list.get(i + 1).coordinate()});
  path.closed = json.has("closed") && json.get("closed").flag();
  json.look(path);
  return path;
}

Circle read_circle(const Reader& json) {
  json.keys({"circle", "fill", "pen", "clip"});
  const Reader list = json.get("circle");
  list.list(3, 3);
  Circle circle;
  circle.centre = {list.get(std::size_t{0}).coordinate(), list.get(1).coordinate()};
  circle.radius = list.get(2).length();
  json.look(circle);
  return circle;
}

Rectangle read_rectangle(const Reader& json) {
  json.keys({"rectangle", "fill", "pen", "clip"});
  Rectangle rectangle;
  rectangle.box = json.get("rectangle").box();
  json.look(rectangle);
  return rectangle;
}

Text read_text(const Reader& json) {
  json.keys({"text", "at", "size", "colour", "anchor", "bold", "turn", "halo", "clip"});
  Text text;
  text.text = json.get("text").text(FigureLimits::text);
  text.at = json.get("at").place();
  text.size = json.get("size").number(1, 1000);
  text.colour = json.get("colour").colour();
  const std::string& anchor = json.get("anchor").text(10);
  if (anchor != "start" && anchor != "middle" && anchor != "end")
    json.get("anchor").fail("\"start\", \"middle\" or \"end\"");
  text.anchor = anchor == "start" ? Anchor::start : anchor == "middle" ? Anchor::middle : Anchor::end;
  text.bold = json.has("bold") && json.get("bold").flag();
  if (json.has("turn")) text.turn = json.get("turn").number(-360, 360);
  if (json.has("halo")) text.halo = json.get("halo").number(0, 100);
  return text;
}

Cells read_cells(const Reader& json, std::size_t& budget) {
  json.keys({"cells", "box", "columns", "rows", "fill", "clip"});
  Cells cells;
  cells.box = json.get("box").box();
  cells.columns = static_cast<std::uint32_t>(json.get("columns").whole(100'000));
  cells.rows = static_cast<std::uint32_t>(json.get("rows").whole(100'000));
  cells.fill = json.get("fill").colour();
  const std::size_t total = static_cast<std::size_t>(cells.columns) * cells.rows;
  if (total > budget) json.fail("at most " + std::to_string(FigureLimits::cells) + " cells in a figure");
  budget -= total;
  const Reader runs = json.get("cells");
  const std::size_t n = runs.list(0, total + 2);
  cells.cells.reserve(total);
  for (std::size_t i = 0; i < n; ++i)
    cells.cells.insert(cells.cells.end(), runs.get(i).whole(total - cells.cells.size()), i % 2);
  if (cells.cells.size() != total) runs.fail("runs that sum to " + std::to_string(total) + " cells");
  return cells;
}

}  // namespace

Json to_json(const Figure& figure) {
  Json clips = Json::array(), items = Json::array();
  for (const Box& clip : figure.clips) clips.push_back(to_json(clip));
  for (const Item& item : figure.items) {
    Json json = std::visit(Writer{}, item.what);
    if (item.clip >= 0) json["clip"] = item.clip;
    items.push_back(std::move(json));
  }
  return {{"width", rounded(figure.width)},
          {"height", rounded(figure.height)},
          {"title", figure.title},
          {"clips", std::move(clips)},
          {"items", std::move(items)}};
}

Figure figure_from_json(const Json& json) {
  const Reader reader(json, "");
  reader.keys({"width", "height", "title", "clips", "items"});
  Figure figure;
  figure.width = reader.get("width").number(1, FigureLimits::side);
  figure.height = reader.get("height").number(1, FigureLimits::side);
  figure.title = reader.get("title").text(FigureLimits::text);
  const Reader clips = reader.get("clips"), items = reader.get("items");
  for (std::size_t i = 0, n = clips.list(0, FigureLimits::items); i < n; ++i)
    figure.clips.push_back(clips.get(i).box());
  std::size_t points = FigureLimits::points, cells = FigureLimits::cells;
  for (std::size_t i = 0, n = items.list(0, FigureLimits::items); i < n; ++i) {
    const Reader entry = items.get(i);
    Item item;
    if (entry.has("path"))
      item.what = read_path(entry, points);
    else if (entry.has("circle"))
      item.what = read_circle(entry);
    else if (entry.has("rectangle"))
      item.what = read_rectangle(entry);
    else if (entry.has("text"))
      item.what = read_text(entry);
    else if (entry.has("cells"))
      item.what = read_cells(entry, cells);
    else
      entry.fail("an object with \"path\", \"circle\", \"rectangle\", \"text\" or \"cells\"");
    if (entry.has("clip")) {
      const Reader clip = entry.get("clip");
      if (figure.clips.empty()) clip.fail("no clip, for the figure has none");
      item.clip = static_cast<std::int32_t>(clip.whole(figure.clips.size() - 1));
    }
    figure.items.push_back(std::move(item));
  }
  return figure;
}

}  // namespace wend::core
