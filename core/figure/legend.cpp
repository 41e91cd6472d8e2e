#include <algorithm>
#include <core/figure/legend.hpp>
#include <core/figure/text_metrics.hpp>
#include <functional>

namespace wend::core {
namespace {

constexpr double sample = 44, gap = 8, size = 12.5, note_size = 11.5, row = 19, note_row = 16, between = 7;
constexpr const char* privileged_text = " (privileged)";

double label_width(const LegendLine& line) {
  return text_width(line.label, size) + (line.privileged ? text_width(privileged_text, size) : 0);
}

void add_label(std::vector<Item>& items, const LegendLine& line, Place at, double room) {
  const double tail = line.privileged ? text_width(privileged_text, size) : 0;
  const std::string text = fit_text(line.label, size, std::max(room - tail, 20.0));
  items.push_back({label(at, text, size), -1});
  if (line.privileged)
    items.push_back({label({at.x + text_width(text, size), at.y}, privileged_text, size, ink::faint_text), -1});
}

// Lays entries of known widths side by side, wrapping; calls `draw` with each one's corner.
double flow(const std::vector<double>& widths, Place at, double width, double height, double space,
            const std::function<void(std::size_t, Place)>& draw) {
  double x = at.x, y = at.y;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    if (x > at.x && x + widths[i] > at.x + width) {
      x = at.x;
      y += height;
    }
    draw(i, {x, y});
    x += widths[i] + space;
  }
  return widths.empty() ? 0 : y + height - at.y;
}

}  // namespace

double legend_width(const std::vector<LegendLine>& lines) {
  double width = 0;
  for (const LegendLine& line : lines)
    width = std::max({width, label_width(line), line.ending ? 16 + text_width(line.note, note_size) : 0});
  return sample + gap + width + 2;
}

double legend_height(const std::vector<LegendLine>& lines) {
  double height = 0;
  for (const LegendLine& line : lines) height += row + (line.ending ? note_row : 0) + between;
  return height;
}

void add_legend(std::vector<Item>& items, const std::vector<LegendLine>& lines, Place at, double width) {
  const double text = at.x + sample + gap, room = width - sample - gap;
  for (const LegendLine& line : lines) {
    add_line_sample(items, line.style, {at.x, at.y + row / 2}, sample);
    add_label(items, line, {text, at.y + row / 2 + 4.4}, room);
    at.y += row;
    if (line.ending) {
      add_end_marker(items, *line.ending, {text + 5, at.y + note_row / 2 - 0.5}, 4.4, line.style.colour);
      items.push_back({label({text + 16, at.y + note_row / 2 + 3.6}, fit_text(line.note, note_size, room - 16),
                             note_size, ink::faint_text),
                       -1});
      at.y += note_row;
    }
    at.y += between;
  }
}

double add_legend_row(std::vector<Item>* items, const std::vector<LegendLine>& lines, Place at, double width) {
  std::vector<double> widths;
  for (const LegendLine& line : lines)
    widths.push_back(std::min(
        width, sample + gap + std::max(label_width(line), line.ending ? 16 + text_width(line.note, note_size) : 0)));
  const bool notes =
      std::any_of(lines.begin(), lines.end(), [](const LegendLine& line) { return line.ending.has_value(); });
  return flow(widths, at, width, row + (notes ? note_row + between : 2), 26, [&](std::size_t i, Place corner) {
    if (items != nullptr) add_legend(*items, {lines[i]}, corner, widths[i] + 2);
  });
}

double add_map_key(std::vector<Item>* items, const std::vector<MapArm>& arms, const std::vector<Ending>& endings,
                   Place at, double width) {
  using Draw = std::function<void(std::vector<Item>&, Place)>;  // the sign, around this point
  std::vector<std::pair<std::string, Draw>> signs;
  signs.emplace_back("start", [](auto& out, Place p) { add_start_marker(out, p, 0, 5, ink::text); });
  signs.emplace_back("goal", [](auto& out, Place p) {
    out.push_back({Circle{p, 5.5, ink::goal, Pen{ink::goal_edge, 1.2, Cap::butt, {}}}, -1});
    out.push_back({Circle{p, 1.5, ink::goal_edge, {}}, -1});
  });
  if (std::any_of(arms.begin(), arms.end(), [](const MapArm& arm) { return arm.trace->movers > 0; }))
    signs.emplace_back("mover and its path", [](auto& out, Place p) {
      out.push_back(
          {Path{{{p.x - 8, p.y}, {p.x + 8.5, p.y}}, false, {}, Pen{ink::mover_path, 1.3, Cap::round, {}}}, -1});
      out.push_back({Circle{p, 5.5, ink::mover, Pen{ink::mover_edge, 1.2, Cap::butt, {}}}, -1});
      out.push_back({Circle{p, 3, {}, Pen{ink::mover_edge, 0.9, Cap::butt, {}}}, -1});
    });
  for (const Ending ending : endings)
    signs.emplace_back(name(ending),
                       [ending](auto& out, Place p) { add_end_marker(out, ending, p, 5, ink::faint_text); });
  std::vector<double> widths;
  for (const auto& [text, draw] : signs) widths.push_back(18 + text_width(text, note_size));
  return flow(widths, at, width, 19, 18, [&](std::size_t i, Place corner) {
    if (items == nullptr) return;
    signs[i].second(*items, {corner.x + 6, corner.y + 9.5});
    items->push_back({label({corner.x + 18, corner.y + 13.5}, signs[i].first, note_size, ink::faint_text), -1});
  });
}

}  // namespace wend::core
