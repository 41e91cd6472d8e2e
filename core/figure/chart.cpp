#include <algorithm>
#include <core/figure/chart.hpp>
#include <core/figure/style.hpp>
#include <core/figure/text_metrics.hpp>

namespace wend::core {
namespace {

constexpr double tick_size = 11.5, title_size = 12.5;

void add_line(std::vector<Item>& items, Place a, Place b, Colour colour, double width = 1) {
  items.push_back({Path{{a, b}, false, {}, Pen{colour, width, Cap::butt, {}}}, -1});
}

}  // namespace

void add_x_axis(std::vector<Item>& items, const Box& plot, const Axis& axis, const std::string& title, bool grid) {
  double free_from = -1e300;  // tick labels never touch
  for (const Tick& tick : axis.ticks()) {
    const double x = axis.pixel(tick.value), half = text_width(tick.label, tick_size) / 2;
    if (x < plot.x - 0.5 || x > plot.right() + 0.5) continue;
    if (grid) add_line(items, {x, plot.y}, {x, plot.bottom()}, ink::grid_line);
    add_line(items, {x, plot.bottom()}, {x, plot.bottom() + 4}, ink::frame);
    if (x - half < free_from) continue;
    items.push_back({label({x, plot.bottom() + 17}, tick.label, tick_size, ink::text, Anchor::middle), -1});
    free_from = x + half + 8;
  }
  if (axis.broken()) {  // zero has no place on a logarithmic axis: two strokes say so
    const double x = (axis.pixel(0) + axis.pixel(axis.ticks().size() > 1 ? axis.ticks()[1].value : 1)) / 2;
    for (const double side : {-2.5, 1.5})
      add_line(items, {x + side, plot.bottom() + 4}, {x + side + 3, plot.bottom() - 4}, ink::text);
  }
  if (!title.empty())
    items.push_back(
        {label({plot.x + plot.width / 2, plot.bottom() + 38}, title, title_size, ink::text, Anchor::middle), -1});
}

void add_y_axis(std::vector<Item>& items, const Box& plot, const Axis& axis, const std::string& title) {
  double widest = 0;
  for (const Tick& tick : axis.ticks()) {
    const double y = axis.pixel(tick.value);
    if (y < plot.y - 0.5 || y > plot.bottom() + 0.5) continue;
    widest = std::max(widest, text_width(tick.label, tick_size));
    add_line(items, {plot.x, y}, {plot.right(), y}, ink::grid_line);
    add_line(items, {plot.x - 4, y}, {plot.x, y}, ink::frame);
    items.push_back({label({plot.x - 8, y + 4}, tick.label, tick_size, ink::text, Anchor::end), -1});
  }
  if (title.empty()) return;
  Text text = label({plot.x - 18 - widest, plot.y + plot.height / 2}, title, title_size, ink::text, Anchor::middle);
  text.turn = -90;
  items.push_back({std::move(text), -1});
}

}  // namespace wend::core
