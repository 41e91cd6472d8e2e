#include <algorithm>
#include <cctype>
#include <core/base/error.hpp>
#include <core/figure/axis.hpp>
#include <core/figure/curve_figure.hpp>
#include <core/figure/figure_source.hpp>
#include <core/figure/figures.hpp>
#include <core/figure/interval_figure.hpp>
#include <core/figure/map_figure.hpp>
#include <core/figure/step_series.hpp>
#include <core/figure/trials_figure.hpp>
#include <limits>
#include <map>
#include <tuple>

namespace wend::core {
namespace {

constexpr std::size_t most_grid_panels = 60;

class Names {
 public:
  // The first free one of name, name-2, name-3, ...
  std::string fresh(const std::string& text) {
    const std::string name = file_name(text);
    std::string candidate = name;
    for (int i = 2; !taken_.insert(candidate).second; ++i) candidate = name + "-" + std::to_string(i);
    return candidate;
  }

 private:
  std::set<std::string> taken_;
};

std::string joined(std::initializer_list<std::string> parts) {
  std::string text;
  for (const std::string& part : parts)
    if (!part.empty()) text += (text.empty() ? "" : " · ") + part;
  return text;
}

// The place among `all` of the i-th of `n` that are spread evenly, both ends included.
std::size_t spread(std::size_t i, std::size_t n, std::size_t all) { return n < 2 ? 0 : i * (all - 1) / (n - 1); }

class Gallery {
 public:
  explicit Gallery(const FigureSource& source) : source_(source) {}

  std::vector<NamedFigure> take() { return std::move(figures_); }

  void add_maps() {
    std::vector<MapPanel> first;
    for (const std::string& world : source_.worlds()) {
      const auto maps = maps_of(world);
      const std::size_t wanted = std::min<std::size_t>(source_.variants(), maps.size());
      std::size_t place = 0, drawn = 0;
      for (const auto& [key, shown] : maps) {  // spread over all of them: neighbours are often alike
        const auto& [variant, point] = key;
        if (drawn == wanted || place++ != spread(drawn, wanted, maps.size())) continue;
        ++drawn;
        const std::string where = point_text(point), map = "map " + std::to_string(variant);
        add("map_" + world + "_" + std::to_string(variant) + (where.empty() ? "" : "_" + where),
            map_figure(arms_of(shown), joined({source_.title(), world, map, where})));
        if (drawn == 1) first.push_back({world, arms_of(shown)});
      }
    }
    if (first.size() > most_grid_panels) first.resize(most_grid_panels);
    if (first.size() > 1) add("maps", map_grid(first, joined({source_.title(), "the first map of each world"})));
  }

  // One map before, during and after training.
  void add_learning() {
    for (const std::string& world : source_.worlds()) {
      std::map<std::pair<std::size_t, std::string>, std::vector<Recorded>> trainings;  // by arm and point
      for (const Recorded& one : source_.recorded())
        if (one.world == world && !one.unit.empty()) trainings[{source_.style_of(one.arm), one.point}].push_back(one);
      for (auto& [key, snapshots] : trainings) {
        const std::vector<Recorded> shown = first_of_each_amount(snapshots);
        if (shown.size() < 2) continue;
        std::vector<MapPanel> panels;
        for (const Recorded& one : shown)
          panels.push_back({grouped(one.amount) + " " + quantity(one.unit).text, {arm_of(one)}});
        const std::string& arm = shown[0].arm;
        const std::string where = point_text(key.second);
        add("learning_" + world + "_" + arm + (where.empty() ? "" : "_" + where),
            map_grid(panels, joined({source_.title(), world, arm + " while it learns", where})));
      }
    }
  }

  // The trials of the first recorded seed's training, all on its first map.
  void add_trials() {
    std::map<std::tuple<std::string, std::size_t, std::string>, std::vector<Recorded>> trainings;
    for (const Recorded& one : source_.trials()) trainings[{one.world, source_.style_of(one.arm), one.point}].push_back(one);
    for (const auto& [key, list] : trainings) {
      const auto& [world, style, point] = key;
      std::vector<const Trace*> shown;
      for (const Recorded& one : list)
        if (one.seed == list[0].seed && one.variant == list[0].variant) shown.push_back(one.trace);
      const std::string where = point_text(point);
      add("trials_" + world + "_" + list[0].arm + (where.empty() ? "" : "_" + where),
          trials_figure(shown, joined({source_.title(), world, list[0].arm + " while it learns", where})));
    }
  }

  // Values of single steps: tests, one line an arm; and trainings, trial after trial, a picture each.
  void add_steps(const std::string& metric) {
    std::map<std::pair<std::string, std::string>, std::map<std::size_t, Recorded>> tests;  // world, point: by style
    std::map<std::tuple<std::string, std::size_t, std::string>, std::vector<Recorded>> trainings;
    for (const Recorded& one : source_.episodes()) {
      const std::size_t style = source_.style_of(one.arm);
      if (one.training) {
        trainings[{one.world, style, one.point}].push_back(one);
      } else {
        const auto [held, added] = tests[{one.world, one.point}].emplace(style, one);
        if (!added && one.amount > held->second.amount && one.seed == held->second.seed && one.variant == held->second.variant && one.episode == held->second.episode)
          held->second = one;
      }
    }
    for (const auto& [key, arms] : tests) {
      std::vector<CurveSeries> curves;
      for (const auto& [style, one] : arms) add_step_curve(curves, one, {one.trace}, metric);
      add_step_figure("steps_" + metric + "_" + key.first, key.first, "", key.second, metric, curves);
    }
    for (const auto& [key, list] : trainings) {
      std::vector<const Trace*> trials;
      for (const Recorded& one : list)
        if (one.seed == list[0].seed) trials.push_back(one.trace);
      std::vector<CurveSeries> curves;
      add_step_curve(curves, list[0], trials, metric);
      const auto& [world, style, point] = key;
      add_step_figure("trial_steps_" + metric + "_" + world + "_" + list[0].arm, world, list[0].arm + " while it learns", point, metric, curves);
    }
  }

  void add_curves() {
    using Key = std::tuple<std::size_t, std::string, std::string>;  // world, metric, x
    std::map<Key, std::vector<CurveSeries>> groups;
    if (!source_.summary().contains("curves")) return;
    for (const Json& row : source_.summary()["curves"]) {
      const std::string world = text_of(row, "world");
      const auto place = std::find(source_.worlds().begin(), source_.worlds().end(), world) - source_.worlds().begin();
      if (!source_.wants(world) || !source_.wants_curve(text_of(row, "metric"))) continue;
      CurveSeries curve = series_of(row);
      if (!curve.points.empty()) groups[{place, text_of(row, "metric"), text_of(row, "x")}].push_back(std::move(curve));
    }
    for (const auto& [key, curves] : groups) {
      const auto& [place, metric, x] = key;
      const std::string& world = source_.worlds()[place];
      CurveOptions options;
      options.title = joined({source_.title(), world, quantity(metric).text});
      options.x_title = quantity(x).title();
      options.y_title = quantity(metric).title();
      options.log_x = source_.log_x(x);
      options.share = is_share(metric, curves);
      if (has_band(curves)) options.note = "Shaded: 95 % interval.";
      add("curve_" + metric + "_" + world, curve_figure(curves, options));
    }
  }

  void add_estimates(const std::string& metric, const std::string& name, bool share) {
    std::map<std::size_t, IntervalArm> arms;  // by line
    std::vector<std::map<std::size_t, Estimate>> worlds;
    std::vector<IntervalPanel> panels;
    for (const std::string& world : source_.worlds()) {
      std::map<std::size_t, Estimate> values;
      for (const Json* row : source_.final_results(world)) {
        const Estimate estimate = estimate_of(*row, metric, share);
        if (!std::isfinite(estimate.value)) continue;
        const std::string arm = text_of(*row, "arm"), point = row->contains("point") ? (*row)["point"].dump() : "{}";
        const std::size_t line = source_.line_of(arm, point);
        values[line] = estimate;
        arms[line] = {source_.label(arm, point), line_style(line), source_.privileged(arm)};
      }
      if (values.empty()) continue;
      worlds.push_back(std::move(values));
      panels.push_back({world, {}});
    }
    if (panels.empty()) return;
    std::vector<IntervalArm> rows;
    for (const auto& [line, arm] : arms) {
      rows.push_back(arm);
      for (std::size_t i = 0; i < panels.size(); ++i)
        panels[i].values.push_back(worlds[i].count(line) != 0 ? worlds[i][line] : Estimate{});
    }
    const Quantity what = share ? Quantity{"success rate", "%"} : quantity(metric);
    IntervalOptions options{joined({source_.title(), what.text}), what.title(), "Bars: 95 % interval.", share};
    add(name, interval_figure(rows, panels, options));
  }

 private:
  using MapKey = std::pair<std::uint64_t, std::string>;  // variant, point

  void add(const std::string& name, Figure figure) { figures_.push_back({names_.fresh(name), std::move(figure)}); }

  void add_step_curve(std::vector<CurveSeries>& curves, const Recorded& one, const std::vector<const Trace*>& episodes,
                      const std::string& metric) const {
    CurveSeries curve{one.arm, line_style(source_.style_of(one.arm)), step_series(episodes, metric), source_.privileged(one.arm)};
    curve.style.width = 1.3;
    if (!curve.points.empty()) curves.push_back(std::move(curve));
  }

  void add_step_figure(const std::string& name, const std::string& world, const std::string& what, const std::string& point,
                       const std::string& metric, const std::vector<CurveSeries>& curves) {
    if (curves.empty()) return;
    const std::string where = point_text(point);
    CurveOptions options;
    options.title = joined({source_.title(), world, what, where});
    options.x_title = "time (s)";
    options.y_title = quantity(metric).title();
    add(name + (where.empty() ? "" : "_" + where), curve_figure(curves, options));
  }

  MapArm arm_of(const Recorded& one) const {
    return {one.arm, one.trace, source_.style_of(one.arm), one.privileged || source_.privileged(one.arm), {}};
  }

  std::vector<MapArm> arms_of(const std::vector<Recorded>& list) const {
    std::vector<MapArm> arms;
    for (const Recorded& one : list) arms.push_back(arm_of(one));
    std::stable_sort(arms.begin(), arms.end(), [](const MapArm& a, const MapArm& b) { return a.style < b.style; });
    return arms;
  }

  // Of each variant and point the first seed's first episode, every arm at its last snapshot.
  std::map<MapKey, std::vector<Recorded>> maps_of(const std::string& world) const {
    std::map<MapKey, std::vector<Recorded>> maps;
    for (const Recorded& one : source_.recorded())
      if (one.world == world) maps[{one.variant, one.point}].push_back(one);
    for (auto& [key, list] : maps) {
      const auto first = [](const Recorded& a) { return std::pair{a.seed, a.episode}; };
      const auto least =
          std::min_element(list.begin(), list.end(), [&](auto& a, auto& b) { return first(a) < first(b); });
      const auto wanted = first(*least);
      std::map<std::string, Recorded> last;
      for (const Recorded& one : list) {
        if (first(one) != wanted) continue;
        const auto [held, added] = last.emplace(one.arm, one);
        if (!added && one.amount > held->second.amount) held->second = one;
      }
      list.clear();
      for (auto& [arm, one] : last) list.push_back(one);
    }
    return maps;
  }

  static std::vector<Recorded> first_of_each_amount(std::vector<Recorded> list) {
    const auto rank = [](const Recorded& a) { return std::tuple{a.variant, a.seed, a.episode}; };
    const auto least =
        rank(*std::min_element(list.begin(), list.end(), [&](auto& a, auto& b) { return rank(a) < rank(b); }));
    list.erase(std::remove_if(list.begin(), list.end(), [&](const Recorded& a) { return rank(a) != least; }),
               list.end());
    std::stable_sort(list.begin(), list.end(), [](auto& a, auto& b) { return a.amount < b.amount; });
    const auto same = [](const Recorded& a, const Recorded& b) { return a.amount == b.amount; };
    list.erase(std::unique(list.begin(), list.end(), same), list.end());
    return list;
  }

  CurveSeries series_of(const Json& row) const {
    CurveSeries curve;
    const std::string arm = text_of(row, "arm"), point = row.contains("point") ? row["point"].dump() : "{}";
    curve.label = source_.label(arm, point);
    curve.style = line_style(source_.line_of(arm, point));
    curve.privileged = source_.privileged(arm);
    if (const double robot = number_of(row, "robot"); robot >= 0) {  // the arm's colour, another dash
      curve.label += ", robot " + std::to_string(static_cast<int>(robot) + 1);
      curve.style.dash = line_style(static_cast<std::size_t>(robot)).dash;
    }
    if (!row.contains("points") || !row["points"].is_array()) return curve;
    const auto value = [](const Json& point, std::size_t i) {
      return i < point.size() && point[i].is_number() ? point[i].get<double>() : std::nan("");
    };
    for (const Json& p : row["points"])
      if (p.is_array()) curve.points.push_back({value(p, 0), value(p, 1), value(p, 2), value(p, 3)});
    return curve;
  }

  static bool is_share(const std::string& metric, const std::vector<CurveSeries>& curves) {
    bool share = metric == "success" || metric == "collision" || metric == "timeout" || metric == "spl";
    double highest = 0;
    for (const CurveSeries& curve : curves)
      for (const CurvePoint& p : curve.points) {
        if (p.mean < 0 || p.mean > 1) return false;
        highest = std::max(highest, p.mean);
      }
    return share || highest > 0.5;
  }

  static bool has_band(const std::vector<CurveSeries>& curves) {
    for (const CurveSeries& curve : curves)
      for (const CurvePoint& p : curve.points)
        if (p.high > p.low) return true;
    return false;
  }

  static Estimate estimate_of(const Json& row, const std::string& metric, bool share) {
    const Json* found = nullptr;
    if (share && row.contains(metric)) found = &row[metric];
    if (!share && row.contains("metrics") && row["metrics"].is_object() && row["metrics"].contains(metric))
      found = &row["metrics"][metric];
    if (found == nullptr || !found->is_object()) return {};
    const double middle = number_of(*found, share ? "rate" : "iqm");
    return {std::isfinite(middle) ? middle : number_of(*found, "mean"), number_of(*found, "low"),
            number_of(*found, "high")};
  }

  const FigureSource& source_;
  Names names_;
  std::vector<NamedFigure> figures_;
};

}  // namespace

std::string file_name(const std::string& text) {
  std::string name;
  for (const char c : text) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == '.';
    name += plain && static_cast<unsigned char>(c) < 0x80 ? c : '_';
  }
  if (name.empty() || name[0] == '.') name.insert(0, "_");
  return name.substr(0, 150);
}

std::vector<NamedFigure> figures_of(const Json& summary, const std::vector<Trace>& traces, const Json& options) {
  try {
    const FigureSource source(summary, traces, options);
    Gallery gallery(source);
    gallery.add_maps();
    gallery.add_learning();
    gallery.add_trials();
    gallery.add_curves();
    gallery.add_estimates("success", "success", true);
    for (const std::string& metric : source.steps()) gallery.add_steps(metric);
    for (const std::string& metric : source.metrics()) gallery.add_estimates(metric, "metric_" + metric, false);
    return gallery.take();
  } catch (const Json::exception& e) {
    throw Error(Exit::data, std::string("summary.json has not the expected form: ") + e.what());
  }
}

}  // namespace wend::core
