#include <algorithm>
#include <cmath>
#include <core/figure/map_figure.hpp>
#include <core/figure/text_metrics.hpp>

namespace wend::core {
namespace {

constexpr double margin = 22, title_size = 15.5, title_height = 32, bar_height = 34;

LegendLine legend_line(const MapArm& arm) {
  const Outcome end = outcome(*arm.trace);
  return {arm.line(), arm.label, arm.privileged, end.ending, verdict(*arm.trace) + " · " + effort(end)};
}

std::vector<Ending> endings_of(const std::vector<MapPanel>& panels) {
  std::vector<Ending> found;
  for (const Ending ending : {Ending::arrived, Ending::collided, Ending::timeout, Ending::ended, Ending::unfinished})
    for (const MapPanel& panel : panels)
      if (std::any_of(panel.arms.begin(), panel.arms.end(),
                      [&](const MapArm& arm) { return outcome(*arm.trace).ending == ending; })) {
        found.push_back(ending);
        break;
      }
  return found;
}

void add_title(Figure& figure, const std::string& title, double size = title_size) {
  figure.title = title;
  figure.items.push_back({label({margin, margin + 13}, fit_text(title, size, figure.width - 2 * margin, true), size,
                                ink::text, Anchor::start, true),
                          -1});
}

void place_beside(Figure& figure, const MapView& view, const std::vector<LegendLine>& lines,
                  const std::vector<MapArm>& arms, const std::vector<Ending>& endings) {
  const double column = std::clamp(legend_width(lines), 170.0, 360.0), x = view.page.right() + 24;
  double y = view.page.y;
  add_legend(figure.items, lines, {x, y}, column);
  y += legend_height(lines) + 10;
  y += add_map_key(&figure.items, arms, endings, {x, y}, column);
  figure.width = x + column + margin;
  figure.height = std::max(view.page.bottom() + bar_height, y) + margin * 0.6;
}

void place_below(Figure& figure, const MapView& view, const std::vector<LegendLine>& lines,
                 const std::vector<MapArm>& arms, const std::vector<Ending>& endings) {
  double y = view.page.bottom() + bar_height + 8;
  y += add_legend_row(&figure.items, lines, {margin, y}, view.page.width) + 4;
  y += add_map_key(&figure.items, arms, endings, {margin, y}, view.page.width);
  figure.width = view.page.right() + margin;
  figure.height = y + margin * 0.6;
}

Figure single_map(const std::vector<MapArm>& arms, const std::vector<LegendLine>& lines, const std::vector<Ending>& endings,
                  const std::string& title) {
  Figure figure;
  const MapView view = fit_map(map_bounds(arms), {margin, margin + title_height}, 640, 0.3, 4);
  add_map(figure, view, arms);
  add_scale_bar(figure, view, {view.page.x, view.page.bottom() + 20}, std::min(180.0, view.page.width * 0.45));
  if (view.page.width > 1.35 * view.page.height)
    place_below(figure, view, lines, arms, endings);
  else
    place_beside(figure, view, lines, arms, endings);
  add_title(figure, title);
  return figure;
}

}  // namespace

Figure map_figure(const std::vector<MapArm>& arms, const std::string& title) {
  std::vector<LegendLine> lines;
  for (const MapArm& arm : arms) lines.push_back(legend_line(arm));
  return single_map(arms, lines, {}, title);
}

Figure map_figure(const std::vector<MapArm>& arms, const std::vector<LegendLine>& legend, const std::string& title) {
  return single_map(arms, legend, endings_of({{"", arms}}), title);
}

namespace {

constexpr double panel_title = 24, panel_bar = 28, panel_gap = 26;

// How many panels each row takes, so that the whole is about 1.5 times as wide as high.
std::vector<std::size_t> rows_of(const std::vector<double>& widths, double height) {
  double total = 0;
  for (const double width : widths) total += width + panel_gap;
  std::vector<std::size_t> best;
  double best_misfit = 1e300;
  for (std::size_t rows = 1; rows <= widths.size(); ++rows) {
    std::vector<std::size_t> counts(1, 0);
    double used = 0, widest = 0;
    for (const double width : widths) {  // the k-th row ends where k / rows of the whole width is reached
      if (counts.back() > 0 &&
          used + width / 2 > total * static_cast<double>(counts.size()) / static_cast<double>(rows))
        counts.push_back(0);
      ++counts.back();
      used += width + panel_gap;
    }
    std::size_t first = 0;
    for (const std::size_t count : counts) {
      double row = 0;
      for (std::size_t i = first; i < first + count; ++i) row += widths[i] + panel_gap;
      widest = std::max(widest, row);
      first += count;
    }
    const double misfit = std::fabs(std::log(widest / (static_cast<double>(counts.size()) * height) / 1.5));
    if (misfit < best_misfit - 1e-9) best_misfit = misfit, best = counts;
  }
  return best;
}

// Arms by their first appearance, once each.
std::vector<MapArm> all_arms(const std::vector<MapPanel>& panels) {
  std::vector<MapArm> arms;
  for (const MapPanel& panel : panels)
    for (const MapArm& arm : panel.arms)
      if (std::none_of(arms.begin(), arms.end(), [&](const MapArm& other) { return other.label == arm.label; }))
        arms.push_back(arm);
  std::stable_sort(arms.begin(), arms.end(), [](const MapArm& a, const MapArm& b) { return a.style < b.style; });
  return arms;
}

// End markers and scale bar share a line below the map, unless there is no room for a bar that one can read.
bool is_crowded(double width, std::size_t arms) { return arms > 1 && width < 17 * static_cast<double>(arms) + 110; }

void add_panel(Figure& figure, const MapPanel& panel, const MapView& view, const std::vector<MapArm>& order) {
  const Box& page = view.page;
  figure.items.push_back({label({page.x, page.y - 8}, fit_text(panel.title, 12.5, page.width + panel_gap * 0.7, true),
                                12.5, ink::text, Anchor::start, true),
                          -1});
  add_map(figure, view, panel.arms);
  double bar_room = std::min(100.0, page.width * 0.35);
  double y = page.bottom() + 16;
  if (panel.arms.size() == 1 && order.size() == 1) {
    const Outcome end = outcome(*panel.arms[0].trace);
    add_end_marker(figure.items, end.ending, {page.x + 6, y - 4}, 4.4, panel.arms[0].line().colour);
    const std::string text = verdict(*panel.arms[0].trace) + " · " + effort(end);
    figure.items.push_back(
        {label({page.x + 17, y}, fit_text(text, 11.5, page.width + panel_gap * 0.5 - 17), 11.5), -1});
    y += 20;
  } else {
    double x = page.right() - 6 - 17 * static_cast<double>(order.size() - 1);
    const bool crowded = is_crowded(page.width, order.size());
    if (!crowded) bar_room = std::min(bar_room, x - 20 - page.x - 45);
    for (const MapArm& arm : order) {
      const auto here = std::find_if(panel.arms.begin(), panel.arms.end(),
                                     [&](const MapArm& other) { return other.label == arm.label; });
      if (here != panel.arms.end())
        add_end_marker(figure.items, outcome(*here->trace).ending, {x, y - 4}, 5, here->line().colour);
      x += 17;
    }
    if (crowded) y += 20;
  }
  add_scale_bar(figure, view, {page.x, y}, bar_room);
}

}  // namespace

Figure map_grid(const std::vector<MapPanel>& panels, const std::string& title) {
  Figure figure;
  const std::vector<MapArm> order = all_arms(panels);
  const double map_height = panels.size() <= 4 ? 320 : panels.size() <= 12 ? 260 : 190;
  std::vector<double> widths;
  for (const MapPanel& panel : panels)
    widths.push_back(fit_map_height(map_bounds(panel.arms), {}, map_height, 0.5, 3).page.width);
  const bool two_lines = order.size() == 1 || std::any_of(widths.begin(), widths.end(), [&](double width) {
                           return is_crowded(width, order.size());
                         });
  const double height = map_height + panel_title + panel_bar + (two_lines ? 20 : 0) + 12;
  double y = margin + title_height;
  std::size_t next = 0;
  for (const std::size_t count : rows_of(widths, height)) {
    double x = margin;
    for (std::size_t i = 0; i < count; ++i, ++next) {
      add_panel(figure, panels[next],
                fit_map_height(map_bounds(panels[next].arms), {x, y + panel_title}, map_height, 0.5, 3), order);
      x += widths[next] + panel_gap;
    }
    figure.width = std::max(figure.width, x - panel_gap + margin);
    y += height;
  }
  figure.width = std::max(figure.width, 320.0);
  std::vector<LegendLine> lines;
  for (const MapArm& arm : order) lines.push_back({arm.line(), arm.label, arm.privileged, {}, {}});
  const double room = figure.width - 2 * margin;
  y += add_legend_row(&figure.items, lines, {margin, y}, room) + 4;
  y += add_map_key(&figure.items, order, endings_of(panels), {margin, y}, room);
  figure.height = y + margin * 0.6;
  add_title(figure, title);
  return figure;
}

}  // namespace wend::core
