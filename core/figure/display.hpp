// A display list: what a picture consists of, in pixels at scale 1, y down.  It becomes SVG here and PNG in
// wend-render.
#pragma once
#include <core/base/json.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace wend::core {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;

  bool operator==(const Colour&) const = default;
};

constexpr Colour rgb(std::uint32_t hex, double alpha = 1) {
  return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8), static_cast<std::uint8_t>(hex),
          static_cast<std::uint8_t>(alpha * 255 + 0.5)};
}

struct Place {
  double x = 0, y = 0;

  bool operator==(const Place&) const = default;
};

struct Box {
  double x = 0, y = 0, width = 0, height = 0;

  double right() const { return x + width; }
  double bottom() const { return y + height; }
  bool operator==(const Box&) const = default;
};

enum class Cap { butt, round };
enum class Anchor { start, middle, end };

// A line's look; joins are round.  `dash` alternates drawn and blank lengths, empty is solid.
struct Pen {
  Colour colour;
  double width = 1;
  Cap cap = Cap::butt;
  std::vector<double> dash;

  bool operator==(const Pen&) const = default;
};

struct Path {
  std::vector<Place> points;
  bool closed = false;
  std::optional<Colour> fill;  // even-odd
  std::optional<Pen> pen;

  bool operator==(const Path&) const = default;
};

struct Circle {
  Place centre;
  double radius = 0;
  std::optional<Colour> fill;
  std::optional<Pen> pen;

  bool operator==(const Circle&) const = default;
};

struct Rectangle {
  Box box;
  std::optional<Colour> fill;
  std::optional<Pen> pen;

  bool operator==(const Rectangle&) const = default;
};

// One line of UTF-8 whose base line starts, is centred or ends at `at`; `turn` in degrees, clockwise on the page.
struct Text {
  Place at;
  std::string text;
  double size = 12;
  Colour colour;
  Anchor anchor = Anchor::start;
  bool bold = false;
  double turn = 0;
  double halo = 0;  // width of a white seam around the glyphs, for text on a map

  bool operator==(const Text&) const = default;
};

// Cells of one colour: 1 is filled, row-major from the top.
struct Cells {
  Box box;
  std::uint32_t columns = 0, rows = 0;
  std::vector<std::uint8_t> cells;
  Colour fill;

  bool operator==(const Cells&) const = default;
};

struct Item {
  std::variant<Path, Circle, Rectangle, Text, Cells> what;
  std::int32_t clip = -1;  // index into Figure::clips, or -1

  bool operator==(const Item&) const = default;
};

struct Figure {
  double width = 0, height = 0;
  std::string title;  // for those who cannot see it
  std::vector<Box> clips;
  std::vector<Item> items;  // painted in this order on white

  bool operator==(const Figure&) const = default;
};

// No picture is larger, and no list longer, than this; from_json refuses it.
struct FigureLimits {
  static constexpr double side = 20000;      // px at scale 1
  static constexpr double coordinate = 1e6;  // px
  static constexpr std::size_t items = 1'000'000;
  static constexpr std::size_t points = 10'000'000;  // of one figure
  static constexpr std::size_t cells = 100'000'000;  // of one figure
  static constexpr std::size_t text = 10'000;        // bytes of one text
};

// Coordinates are rounded to 1/100 px, cells are written as run lengths.
Json to_json(const Figure& figure);

// Throws Error(Exit::data) with the JSON pointer, what was expected and what was found.
Figure figure_from_json(const Json& json);

}  // namespace wend::core
