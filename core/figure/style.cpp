#include <array>
#include <cmath>
#include <core/figure/style.hpp>
#include <cstdio>

namespace wend::core {
namespace {

constexpr double pi = 3.14159265358979323846;

// Okabe & Ito 2008 without yellow, which vanishes on white; violet (Tol) in its place.
constexpr std::array<std::uint32_t, 8> colours = {0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7,
                                                  0x000000, 0xE69F00, 0x56B4E9, 0x882255};

const std::array<std::vector<double>, 8> dash_patterns = {
    {{}, {9, 4}, {2.5, 2.5}, {10, 3, 2.5, 3}, {16, 4}, {5, 3}, {10, 3, 2.5, 3, 2.5, 3}, {16, 4, 5, 4}}};

void add(std::vector<Item>& items, const Path& path, int clip) {
  Item item;
  item.what.emplace<Path>(path);
  item.clip = clip;
  items.push_back(item);
}

Path ring(Place at, double radius, int corners, double first, double inner = 1) {
  Path path;
  path.closed = true;
  const int n = inner < 1 ? 2 * corners : corners;
  for (int i = 0; i < n; ++i) {
    const double angle = first + 2 * pi * i / n, r = inner < 1 && i % 2 == 1 ? inner * radius : radius;
    path.points.push_back({at.x + r * std::cos(angle), at.y - r * std::sin(angle)});
  }
  return path;
}

void add_seamed(std::vector<Item>& items, Path path, Colour colour, int clip) {
  path.fill = colour;
  path.pen = Pen{ink::white, 2.4, Cap::round, {}};
  add(items, path, clip);  // the seam straddles the edge; the shape is painted again above its inner half
  path.pen.reset();
  add(items, path, clip);
}

void add_cross(std::vector<Item>& items, Place at, double radius, Colour colour, int clip) {
  const double r = radius * 0.8;
  for (const Pen& pen : {Pen{ink::white, 5.6, Cap::round, {}}, Pen{colour, 3.2, Cap::round, {}}})
    for (const double s : {1.0, -1.0})
      add(items, Path{{{at.x - r, at.y - s * r}, {at.x + r, at.y + s * r}}, false, {}, pen}, clip);
}

}  // namespace

LineStyle line_style(std::size_t index) {
  const std::size_t round = index / colours.size();
  return {rgb(colours[index % colours.size()]), dash_patterns[(index + round) % dash_patterns.size()]};
}

const char* name(Ending ending) {
  switch (ending) {
    case Ending::arrived:
      return "arrived";
    case Ending::collided:
      return "collided";
    case Ending::timeout:
      return "timeout";
    case Ending::ended:
      return "ended";
    case Ending::unfinished:
      break;
  }
  return "unfinished";
}

void add_end_marker(std::vector<Item>& items, Ending ending, Place at, double radius, Colour colour, int clip) {
  switch (ending) {
    case Ending::arrived:
      return add_seamed(items, ring(at, radius * 1.25, 5, pi / 2, 0.45), colour, clip);
    case Ending::collided:
      return add_cross(items, at, radius, colour, clip);
    case Ending::timeout:
      return add_seamed(items, ring(at, radius * 1.1, 4, pi / 4), colour, clip);
    case Ending::ended:
      return add_seamed(items, ring(at, radius * 1.1, 4, 0), colour, clip);
    case Ending::unfinished:
      return add_seamed(items, ring(at, radius * 0.8, 24, 0), colour, clip);
  }
}

void add_start_marker(std::vector<Item>& items, Place at, double heading, double radius, Colour colour, int clip) {
  Path path;
  path.closed = true;
  for (const auto& [angle, far] : {std::pair{0.0, 1.25}, {2.5, 1.0}, {pi, 0.45}, {-2.5, 1.0}})
    path.points.push_back(
        {at.x + far * radius * std::cos(heading + angle), at.y - far * radius * std::sin(heading + angle)});
  add_seamed(items, std::move(path), colour, clip);
}

void add_line_sample(std::vector<Item>& items, const LineStyle& style, Place at, double length) {
  add(items, Path{{at, {at.x + length, at.y}}, false, {}, style.pen()}, -1);
}

Text label(Place at, std::string text, double size, Colour colour, Anchor anchor, bool bold) {
  Text item;
  item.at = at;
  item.text = std::move(text);
  item.size = size;
  item.colour = colour;
  item.anchor = anchor;
  item.bold = bold;
  return item;
}

std::string grouped(double value, int decimals, bool exactly) {
  char digits[64];
  std::snprintf(digits, sizeof digits, "%.*f", decimals, std::fabs(value));
  std::string text = digits;
  const std::size_t point = text.find('.');
  std::size_t whole = point == std::string::npos ? text.size() : point;
  if (whole > 15) {  // as long as that nobody reads it
    std::snprintf(digits, sizeof digits, "%.4g", value);
    return digits;
  }
  for (; whole > 3; whole -= 3) text.insert(whole - 3, 1, ',');
  if (!exactly && text.find('.') != std::string::npos) {
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
  }
  if (!(value < 0) || text == "0") return text;
  return std::string("−").append(text);
}

}  // namespace wend::core
