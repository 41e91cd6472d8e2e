#include <algorithm>
#include <core/figure/chart.hpp>
#include <core/figure/curve_figure.hpp>
#include <core/figure/legend.hpp>
#include <core/figure/simplify.hpp>
#include <core/figure/text_metrics.hpp>

namespace wend::core {
namespace {

constexpr double margin = 22, title_height = 32, plot_width = 560, plot_height = 340;
constexpr std::size_t most_dots = 25;  // a curve with more points is drawn without

struct Ranges {
  double x_low = 1e300, x_high = -1e300, x_positive = 1e300, y_low = 1e300, y_high = -1e300;
  bool empty() const { return x_low > x_high; }
};

bool drawn(const CurvePoint& p) {
  return std::isfinite(p.x) && std::isfinite(p.mean);
}

Ranges ranges(const std::vector<CurveSeries>& curves) {
  Ranges r;
  for (const CurveSeries& curve : curves)
    for (const CurvePoint& p : curve.points) {
      if (!drawn(p)) continue;
      r.x_low = std::min(r.x_low, p.x);
      r.x_high = std::max(r.x_high, p.x);
      if (p.x > 0) r.x_positive = std::min(r.x_positive, p.x);
      for (const double y : {p.mean, p.low, p.high})
        if (std::isfinite(y)) r.y_low = std::min(r.y_low, y), r.y_high = std::max(r.y_high, y);
    }
  return r;
}

Axis x_axis(const Ranges& r, bool log, const Box& plot) {
  const double from = plot.x + 10, to = plot.right() - 10;
  if (r.empty()) return Axis::fixed(0, 1, from, to);
  return log ? Axis::logarithmic(r.x_positive, r.x_high, r.x_low <= 0, from, to)
             : Axis::fixed(r.x_low, r.x_high, from, to, 7);
}

Axis y_axis(const Ranges& r, bool share, const Box& plot) {
  const double from = plot.bottom(), to = plot.y;
  if (share) return Axis::fixed(0, 1, from, to, 5);
  if (r.empty()) return Axis::fixed(0, 1, from, to);
  const double low = r.y_low > 0 && r.y_low < 0.5 * r.y_high ? 0 : r.y_low;  // zero belongs to it where it is near
  return Axis::linear(low, r.y_high, from, to, 6);
}

class Drawing {
 public:
  Drawing(Figure& figure, const Axis& x, const Axis& y, int clip) : items_(figure.items), x_(x), y_(y), clip_(clip) {}

  void band(const CurveSeries& curve) const {
    std::vector<Place> upper, lower;
    const auto flush = [&] {
      std::vector<Place> outline = simplified(upper, 0.1), back = simplified(lower, 0.1);
      outline.insert(outline.end(), back.rbegin(), back.rend());
      Colour fill = curve.style.colour;
      fill.alpha = 38;
      if (outline.size() > 2) items_.push_back({Path{std::move(outline), true, fill, {}}, clip_});
      upper.clear();
      lower.clear();
    };
    for (const CurvePoint& p : curve.points) {
      if (!drawn(p) || !std::isfinite(p.low) || !std::isfinite(p.high)) {
        flush();
        continue;
      }
      upper.push_back({x_.pixel(p.x), y_.pixel(p.high)});
      lower.push_back({x_.pixel(p.x), y_.pixel(p.low)});
    }
    flush();
  }

  void line(const CurveSeries& curve) const {
    std::vector<Place> line;
    const bool dots = curve.points.size() <= most_dots;
    const auto flush = [&] {
      if (line.size() > 1) items_.push_back({Path{simplified(line, 0.1), false, {}, curve.style.pen()}, clip_});
      if (dots || line.size() == 1)
        for (const Place p : line)
          items_.push_back({Circle{p, 3, curve.style.colour, Pen{ink::white, 0.9, Cap::butt, {}}}, -1});
      line.clear();
    };
    for (const CurvePoint& p : curve.points) {
      if (drawn(p))
        line.push_back({x_.pixel(p.x), y_.pixel(p.mean)});
      else
        flush();
    }
    flush();
  }

 private:
  std::vector<Item>& items_;
  const Axis &x_, &y_;
  int clip_;
};

}  // namespace

Figure curve_figure(const std::vector<CurveSeries>& curves, const CurveOptions& options) {
  Figure figure;
  figure.title = options.title;
  const Ranges r = ranges(curves);
  double labels = 0;
  const Axis measure = y_axis(r, options.share, {0, 0, plot_width, plot_height});
  for (const Tick& tick : measure.ticks()) labels = std::max(labels, text_width(tick.label, 11.5));
  const Box plot{margin + 26 + labels, margin + title_height, plot_width, plot_height};
  const Axis x = x_axis(r, options.log_x, plot), y = y_axis(r, options.share, plot);
  add_y_axis(figure.items, plot, y, options.y_title);
  add_x_axis(figure.items, plot, x, options.x_title, true);
  figure.clips.push_back({plot.x - 2, plot.y - 2, plot.width + 4, plot.height + 4});
  const Drawing drawing(figure, x, y, 0);
  for (const CurveSeries& curve : curves) drawing.band(curve);
  for (const CurveSeries& curve : curves) drawing.line(curve);
  figure.items.push_back({Rectangle{plot, {}, Pen{ink::frame, 1, Cap::butt, {}}}, -1});
  if (r.empty())
    figure.items.push_back(
        {label({plot.x + plot.width / 2, plot.y + plot.height / 2}, "no values", 13, ink::faint_text, Anchor::middle),
         -1});

  std::vector<LegendLine> lines;
  for (const CurveSeries& curve : curves) lines.push_back({curve.style, curve.label, curve.privileged, {}, {}});
  const double column = std::clamp(legend_width(lines), 140.0, 340.0), left = plot.right() + 22;
  add_legend(figure.items, lines, {left, plot.y}, column);
  figure.width = left + column + margin;
  figure.height = std::max(plot.bottom() + 50, plot.y + legend_height(lines));
  if (!options.note.empty()) {
    figure.items.push_back({label({plot.x, figure.height + 12}, options.note, 11, ink::faint_text), -1});
    figure.height += 14;
  }
  figure.height += margin * 0.6;
  figure.items.push_back({label({margin, margin + 13}, fit_text(options.title, 15.5, figure.width - 2 * margin, true),
                                15.5, ink::text, Anchor::start, true),
                          -1});
  return figure;
}

}  // namespace wend::core
