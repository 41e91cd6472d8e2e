#include "paint.hpp"

#include <cmath>
#include <core/base/error.hpp>
#include <variant>

namespace wend::render {
namespace {

using core::Place;

struct Painter {
  Canvas& canvas;
  Fonts& fonts;
  double scale;

  Place scaled(Place p) const { return {p.x * scale, p.y * scale}; }
  core::Box scaled(const core::Box& b) const { return {b.x * scale, b.y * scale, b.width * scale, b.height * scale}; }
  core::Pen scaled(core::Pen pen) const {
    pen.width *= scale;
    for (double& length : pen.dash) length *= scale;
    return pen;
  }
  template <class Shape>
  void outline(const Polygon& points, bool closed, const Shape& shape) const {
    if (shape.fill) canvas.fill(points, *shape.fill);
    if (shape.pen) canvas.draw(points, closed, scaled(*shape.pen));
  }

  void operator()(const core::Path& path) const {
    Polygon points;
    points.reserve(path.points.size());
    for (const Place p : path.points) points.push_back(scaled(p));
    outline(points, path.closed, path);
  }
  void operator()(const core::Circle& shape) const {
    outline(circle(scaled(shape.centre), shape.radius * scale), true, shape);
  }
  void operator()(const core::Rectangle& rectangle) const {
    const core::Box b = scaled(rectangle.box);
    outline({{b.x, b.y}, {b.right(), b.y}, {b.right(), b.bottom()}, {b.x, b.bottom()}}, true, rectangle);
  }
  void operator()(core::Text text) const {
    text.at = scaled(text.at);
    text.size *= scale;
    text.halo *= scale;
    fonts.draw(canvas, text);
  }
  void operator()(core::Cells cells) const {
    cells.box = scaled(cells.box);
    canvas.fill_cells(cells);
  }
};

}  // namespace

Canvas paint(const core::Figure& figure, double scale, Fonts& fonts) {
  const double width = std::ceil(figure.width * scale), height = std::ceil(figure.height * scale);
  if (!(width >= 1 && height >= 1 && width <= largest_side && height <= largest_side && width * height <= most_pixels))
    throw core::Error(core::Exit::data, "figure: expected at most 20000 pixels a side and 100000000 in all, found " +
                                            std::to_string(static_cast<long long>(width)) + " x " +
                                            std::to_string(static_cast<long long>(height)));
  Canvas canvas(static_cast<int>(width), static_cast<int>(height));
  const Painter painter{canvas, fonts, scale};
  for (const core::Item& item : figure.items) {
    if (item.clip >= 0)
      canvas.clip(painter.scaled(figure.clips[static_cast<std::size_t>(item.clip)]));
    else
      canvas.unclip();
    std::visit(painter, item.what);
  }
  return canvas;
}

}  // namespace wend::render
