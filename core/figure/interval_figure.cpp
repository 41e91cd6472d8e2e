#include <algorithm>
#include <core/figure/chart.hpp>
#include <core/figure/interval_figure.hpp>
#include <core/figure/text_metrics.hpp>

namespace wend::core {
namespace {

constexpr double margin = 22, title_height = 32, row = 25, plot_width = 170, value_width = 50, panel_gap = 22,
                 size = 12.5;
constexpr double panel_title = 26, axis_height = 48;
constexpr std::size_t panels_per_line = 4;
constexpr const char* privileged_text = " (privileged)";

// A rate is never rounded to a certainty that was not measured.
std::string value_text(double value, bool share) {
  if (!std::isfinite(value)) return "–";
  if (share)
    return grouped(value * 100, (value < 1 && value > 0.9995) || (value > 0 && value < 0.0005) ? 2 : 1, true) + " %";
  const double magnitude = std::fabs(value);
  return grouped(value, magnitude >= 1000 ? 0 : magnitude >= 10 ? 1 : 3, true);
}

Axis axis_of(const IntervalPanel& panel, bool share, double from, double to) {
  if (share) return Axis::fixed(0, 100, from, to, 4);
  double low = 1e300, high = -1e300;
  for (const Estimate& i : panel.values)
    for (const double v : {i.value, i.low, i.high})
      if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  if (low > high) return Axis::fixed(0, 1, from, to, 3);
  return Axis::linear(low > 0 ? 0 : low, high, from, to, 3);
}

void add_row(std::vector<Item>& items, const Estimate& i, const IntervalArm& arm, const Axis& axis, double unit,
             double y) {
  const Colour colour = arm.style.colour;
  if (std::isfinite(i.low) && std::isfinite(i.high)) {
    const double low = axis.pixel(i.low * unit), high = axis.pixel(i.high * unit);
    items.push_back({Path{{{low, y}, {high, y}}, false, {}, Pen{colour, 2.6, Cap::butt, {}}}, -1});
    for (const double x : {low, high})
      items.push_back({Path{{{x, y - 4.5}, {x, y + 4.5}}, false, {}, Pen{colour, 1.6, Cap::butt, {}}}, -1});
  }
  if (std::isfinite(i.value))
    items.push_back({Circle{{axis.pixel(i.value * unit), y}, 4.2, colour, Pen{ink::white, 1.1, Cap::butt, {}}}, -1});
}

double name_width(const IntervalArm& arm) {
  return text_width(arm.label, size) + (arm.privileged ? text_width(privileged_text, size) : 0);
}

// Ends at `at`.
void add_name(std::vector<Item>& items, const IntervalArm& arm, Place at, double room) {
  const double tail = arm.privileged ? text_width(privileged_text, size) : 0;
  items.push_back(
      {label({at.x - tail, at.y}, fit_text(arm.label, size, room - tail), size, ink::text, Anchor::end), -1});
  if (arm.privileged) items.push_back({label(at, privileged_text, size, ink::faint_text, Anchor::end), -1});
}

void add_panel(Figure& figure, const std::vector<IntervalArm>& arms, const IntervalPanel& panel, const Box& plot,
               const std::string& x_title, bool share) {
  const Axis axis = axis_of(panel, share, plot.x + 7, plot.right() - 7);
  figure.items.push_back({Rectangle{plot, ink::ground, {}}, -1});
  add_x_axis(figure.items, plot, axis, x_title, true);
  figure.items.push_back({Rectangle{plot, {}, Pen{ink::frame, 1, Cap::butt, {}}}, -1});
  figure.items.push_back({label({plot.x, plot.y - 8}, fit_text(panel.title, size, plot_width + value_width, true), size,
                                ink::text, Anchor::start, true),
                          -1});
  for (std::size_t a = 0; a < arms.size() && a < panel.values.size(); ++a) {
    const double y = plot.y + 5 + row * (static_cast<double>(a) + 0.5);
    add_row(figure.items, panel.values[a], arms[a], axis, share ? 100 : 1, y);
    figure.items.push_back({label({plot.right() + 7, y + 4}, value_text(panel.values[a].value, share), 11.5), -1});
  }
}

}  // namespace

Figure interval_figure(const std::vector<IntervalArm>& arms, const std::vector<IntervalPanel>& panels,
                       const IntervalOptions& options) {
  Figure figure;
  figure.title = options.title;
  double names = 60;
  for (const IntervalArm& arm : arms) names = std::max(names, std::min(name_width(arm), 300.0));
  const double left = margin + names + 16, top = margin + title_height,
               panel_width = plot_width + value_width + panel_gap;
  const double height = row * static_cast<double>(arms.size()) + 10, line_height = panel_title + height + axis_height;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const std::size_t line = p / panels_per_line, column = p % panels_per_line;
    const Box plot{left + static_cast<double>(column) * panel_width,
                   top + static_cast<double>(line) * line_height + panel_title, plot_width, height};
    const bool lowest = p + panels_per_line >= panels.size();
    add_panel(figure, arms, panels[p], plot, lowest ? options.x_title : "", options.share);
    for (std::size_t a = 0; column == 0 && a < arms.size(); ++a)
      add_name(figure.items, arms[a], {left - 12, plot.y + 5 + row * (static_cast<double>(a) + 0.5) + 4.3}, names);
  }
  const std::size_t across = std::clamp<std::size_t>(panels.size(), 1, panels_per_line);
  const std::size_t down = std::max<std::size_t>(1, (panels.size() + panels_per_line - 1) / panels_per_line);
  figure.width = std::max(left + static_cast<double>(across) * panel_width - panel_gap + margin, 420.0);
  figure.height = top + static_cast<double>(down) * line_height;
  if (!options.note.empty()) {
    figure.height += 18;
    figure.items.push_back(
        {label({margin, figure.height}, fit_text(options.note, 11, figure.width - 2 * margin), 11, ink::faint_text),
         -1});
  }
  figure.height += margin * 0.6;
  figure.items.push_back({label({margin, margin + 13}, fit_text(options.title, 15.5, figure.width - 2 * margin, true),
                                15.5, ink::text, Anchor::start, true),
                          -1});
  return figure;
}

}  // namespace wend::core
