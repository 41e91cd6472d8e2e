#include <algorithm>
#include <cmath>
#include <core/base/error.hpp>
#include <core/figure/figure_source.hpp>

namespace wend::core {
namespace {

std::string canonical(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string point_of(const Json& row) {
  return row.contains("point") && row["point"].is_object() ? canonical(row["point"]) : "{}";
}

// {"samples": 2300}; a row without it comes after all that have it.
std::pair<std::string, double> at_of(const Json& row) {
  if (row.contains("at") && row["at"].is_object())
    for (const auto& entry : row["at"].items())
      if (entry.value().is_number()) return {entry.key(), entry.value().get<double>()};
  return {"", std::numeric_limits<double>::infinity()};
}

bool flag_of(const Json& json, const char* key) {
  return json.contains(key) && json[key].is_boolean() && json[key].get<bool>();
}

std::uint64_t count_of(const Json& json, const char* key) {
  return json.contains(key) && json[key].is_number_integer() && json[key] >= 0 ? json[key].get<std::uint64_t>() : 0;
}

std::vector<std::string> texts_of(const Json& json, const char* key) {
  std::vector<std::string> texts;
  if (json.is_object() && json.contains(key) && json[key].is_array())
    for (const Json& text : json[key])
      if (text.is_string()) texts.push_back(text.get<std::string>());
  return texts;
}

template <class T>
std::size_t place_of(const std::vector<T>& list, const T& value) {
  return static_cast<std::size_t>(std::find(list.begin(), list.end(), value) - list.begin());
}

template <class T>
void add_once(std::vector<T>& list, const T& value) {
  if (place_of(list, value) == list.size()) list.push_back(value);
}

bool has_map(const Trace& trace) {
  return trace.robots > 0 && trace.pose.size() >= 3 * std::size_t{trace.robots} && !trace.time.empty();
}

const Json& rows(const Json& summary, const char* key) {
  static const Json none = Json::array();
  if (!summary.is_object()) throw Error(Exit::data, "summary.json: expected an object");
  if (!summary.contains(key)) return none;
  if (!summary[key].is_array()) throw Error(Exit::data, std::string("summary.json: /") + key + ": expected a list");
  for (const Json& row : summary[key])
    for (const char* name : {"arm", "world"})
      if (!row.is_object() || !row.contains(name) || !row[name].is_string())
        throw Error(Exit::data, std::string("summary.json: /") + key + ": expected objects with \"arm\" and \"world\"");
  return summary[key];
}

}  // namespace

std::string text_of(const Json& json, const char* key) {
  return json.is_object() && json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : "";
}

double number_of(const Json& json, const char* key) {
  return json.is_object() && json.contains(key) && json[key].is_number() ? json[key].get<double>() : std::nan("");
}

std::string point_text(const std::string& point) {
  const Json json = Json::parse(point, nullptr, false);
  std::string text;
  if (json.is_object())
    for (const auto& entry : json.items()) {
      const std::string value = entry.value().is_string() ? entry.value().get<std::string>() : canonical(entry.value());
      text += (text.empty() ? "" : ", ") + entry.key().substr(entry.key().rfind('/') + 1) + " = " + value;
    }
  return text;
}

FigureSource::FigureSource(const Json& summary, const std::vector<Trace>& traces, const Json& options)
    : summary_(summary), title_(text_of(summary, "experiment")) {
  read_options(options);
  for (const char* key : {"results", "curves"})
    for (const Json& row : rows(summary, key))
      note(row["arm"], row["world"], point_of(row), flag_of(row, "privileged"));
  for (const Trace& trace : traces) {
    const auto [unit, amount] = at_of(trace.about);
    Recorded one{&trace,
                 text_of(trace.about, "arm"),
                 text_of(trace.about, "world"),
                 point_of(trace.about),
                 count_of(trace.about, "variant"),
                 count_of(trace.about, "seed"),
                 count_of(trace.about, "episode"),
                 flag_of(trace.about, "privileged"),
                 unit,
                 amount,
                 flag_of(trace.about, "training")};
    if (!wants(one.world)) continue;
    note(one.arm, one.world, one.point, one.privileged);
    if (has_map(trace)) (one.training ? trials_ : recorded_).push_back(one);
    episodes_.push_back(std::move(one));
  }
  if (only_worlds_)
    worlds_.erase(std::remove_if(worlds_.begin(), worlds_.end(), [&](const auto& w) { return !wants(w); }),
                  worlds_.end());
}

void FigureSource::read_options(const Json& options) {
  if (!options.is_object()) return;
  if (!text_of(options, "title").empty()) title_ = text_of(options, "title");
  if (options.contains("worlds")) {
    worlds_ = texts_of(options, "worlds");
    only_worlds_.emplace(worlds_.begin(), worlds_.end());
  }
  if (options.contains("variants")) variants_ = count_of(options, "variants");
  metrics_ = texts_of(options, "metrics");
  steps_ = texts_of(options, "steps");
  const std::vector<std::string> log = texts_of(options, "log_x");
  log_x_.insert(log.begin(), log.end());
  std::vector<std::string> curves = {"success", "collision", "spl"};  // of snapshots; others are drawn when asked for
  if (options.contains("curves")) curves = texts_of(options, "curves");
  curves_.insert(curves.begin(), curves.end());
}

void FigureSource::note(const std::string& arm, const std::string& world, const std::string& point, bool privileged) {
  add_once(arms_, arm);
  if (wants(world)) add_once(worlds_, world);
  add_once(lines_, {arm, point});
  points_.insert(point);
  if (privileged) privileged_.insert(arm);
}

bool FigureSource::wants(const std::string& world) const {
  return !only_worlds_ || only_worlds_->count(world) != 0;
}

std::size_t FigureSource::style_of(const std::string& arm) const {
  return place_of(arms_, arm);
}

std::size_t FigureSource::line_of(const std::string& arm, const std::string& point) const {
  return points_.size() < 2 ? style_of(arm) : place_of(lines_, {arm, point});
}

std::string FigureSource::label(const std::string& arm, const std::string& point) const {
  const std::string text = points_.size() < 2 ? "" : point_text(point);
  return text.empty() ? arm : arm + ", " + text;
}

std::vector<const Json*> FigureSource::final_results(const std::string& world) const {
  std::vector<const Json*> chosen;
  for (const Json& row : rows(summary_, "results")) {
    if (row["world"] != world) continue;
    const auto same = std::find_if(chosen.begin(), chosen.end(), [&](const Json* other) {
      return (*other)["arm"] == row["arm"] && point_of(*other) == point_of(row);
    });
    if (same == chosen.end())
      chosen.push_back(&row);
    else if (at_of(row).second > at_of(**same).second)
      *same = &row;
  }
  return chosen;
}

}  // namespace wend::core
