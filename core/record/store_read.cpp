// The queries of a Store.
#include <algorithm>
#include <core/base/error.hpp>
#include <core/record/json_text.hpp>
#include <core/record/store_impl.hpp>
#include <limits>

namespace wend::core {
namespace {

const char* table(UnitKind kind) {
  return kind == UnitKind::training ? "trainings" : "cells";
}

// File names by number, as record_training and record_cell have written them.
std::map<std::uint64_t, std::string> numbered(const Json& json) {
  std::map<std::uint64_t, std::string> out;
  if (!json.is_object()) return out;
  for (const auto& [key, value] : json.items())
    if (value.is_string() && !key.empty() && key.size() < 20 && key.find_first_not_of("0123456789") == key.npos)
      out[std::stoull(key)] = value.get<std::string>();
  return out;
}

std::vector<Curve> curves_of(Statement& query, std::int64_t row) {
  std::vector<Curve> curves;
  query.bind(row);
  std::int64_t current = -1;
  while (query.step()) {
    if (query.integer(0) != current) {
      current = query.integer(0);
      Curve& curve = curves.emplace_back();
      curve.metric = query.text(1);
      if (!query.is_null(2)) curve.robot = static_cast<std::uint32_t>(query.integer(2));
      curve.x = query.text(3);
    }
    curves.back().points.emplace_back(query.real(4), query.real(5));
  }
  return curves;
}

}  // namespace

QueryStatements::QueryStatements(Database& db)
    : training(db,
               "SELECT row, hash, final_state, snapshots, samples, steps, episodes, train_s, traces FROM trainings "
               "WHERE id = ? AND status = 'ok' ORDER BY attempt DESC LIMIT 1"),
      curves(db, "SELECT curve, metric, robot, x_name, x, y FROM curves WHERE training = ? ORDER BY curve, point"),
      cell(db,
           "SELECT row, metrics, traces, decision_us FROM cells WHERE id = ? AND status = 'ok' "
           "ORDER BY attempt DESC LIMIT 1"),
      episodes(db,
               "SELECT episode, robot, flags, steps, reward, hash FROM episodes WHERE cell = ? "
               "ORDER BY episode, robot"),
      metrics(db, "SELECT episode, robot, name, value FROM metrics WHERE cell = ? ORDER BY episode, robot"),
      cell_curves(db, "SELECT curve, metric, robot, x_name, x, y FROM cell_curves WHERE cell = ? ORDER BY curve, point") {}

Json Store::Impl::parse(const std::string& text, const char* what) const {
  auto json = parse_recorded(text);
  if (!json) throw Error(Exit::data, db->path() + " is damaged: " + what + " is not JSON");
  return std::move(*json);
}

std::map<std::string, DoneUnit> Store::done(UnitKind kind) const {
  // Beside max(), SQLite takes the other columns from the row that has it.
  const std::string sql = std::string("SELECT id, build_id, MAX(attempt) FROM ") + table(kind) +
                          " JOIN provenance USING(session) WHERE status = 'ok' GROUP BY id";
  Statement query(*impl_->db, sql.c_str());
  std::map<std::string, DoneUnit> out;
  while (query.step()) out[query.text(0)] = {query.text(1), static_cast<std::uint32_t>(query.integer(2))};
  return out;
}

std::map<std::string, FailedUnit> Store::failed(UnitKind kind) const {
  const std::string sql = std::string("SELECT id, cause, message, MAX(attempt) FROM ") + table(kind) +
                          " GROUP BY id HAVING SUM(status = 'ok') = 0";
  Statement query(*impl_->db, sql.c_str());
  std::map<std::string, FailedUnit> out;
  while (query.step())
    out[query.text(0)] = {{query.text(1), query.text(2)}, static_cast<std::uint32_t>(query.integer(3))};
  return out;
}

std::optional<TrainingResult> Store::training(const std::string& id) const {
  Statement& query = impl_->query->training;
  query.bind(id);
  if (!query.step()) return {};
  const std::int64_t row = query.integer(0);
  TrainingResult result;
  result.hash = query.text(1);
  result.final_state = query.text(2);
  const std::string snapshots = query.text(3);
  result.samples = static_cast<std::uint64_t>(query.integer(4));
  result.steps = static_cast<std::uint64_t>(query.integer(5));
  result.episodes = static_cast<std::uint64_t>(query.integer(6));
  result.train_s = query.real(7);
  const std::string traces = query.text(8);
  query.run();
  result.snapshots = numbered(impl_->parse(snapshots, "a training's list of snapshots"));
  result.traces = numbered(impl_->parse(traces, "a training's list of traces"));
  result.curves = curves_of(impl_->query->curves, row);
  return result;
}

std::optional<CellResult> Store::cell(const std::string& id) const {
  Statement& query = impl_->query->cell;
  query.bind(id);
  if (!query.step()) return {};
  const std::int64_t row = query.integer(0);
  const std::string names = query.text(1), traces = query.text(2);
  CellResult result;
  result.decision_us = query.real(3);
  query.run();
  result.traces = numbered(impl_->parse(traces, "a cell's list of traces"));
  const Json metrics = impl_->parse(names, "a cell's list of metrics");
  for (const Json& name : metrics)
    if (name.is_string()) result.metrics.push_back(name.get<std::string>());

  result.curves = curves_of(impl_->query->cell_curves, row);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Statement& episodes = impl_->query->episodes;
  episodes.bind(row);
  while (episodes.step()) {
    const auto index = static_cast<std::uint64_t>(episodes.integer(0));
    if (result.episodes.empty() || result.episodes.back().index != index)
      result.episodes.push_back({index, episodes.text(5), {}});
    result.episodes.back().robots.push_back({static_cast<std::uint32_t>(episodes.integer(1)),
                                             static_cast<std::uint32_t>(episodes.integer(2)),
                                             static_cast<std::uint64_t>(episodes.integer(3)), episodes.real(4),
                                             std::vector<double>(result.metrics.size(), nan)});
  }

  // Both lists ascend in (episode, robot): walk them side by side.
  Statement& values = impl_->query->metrics;
  values.bind(row);
  std::size_t e = 0, r = 0;
  while (values.step()) {
    const auto index = static_cast<std::uint64_t>(values.integer(0));
    const auto robot = static_cast<std::uint32_t>(values.integer(1));
    while (e < result.episodes.size() &&
           (result.episodes[e].index < index ||
            (result.episodes[e].index == index && result.episodes[e].robots[r].robot < robot))) {
      if (++r == result.episodes[e].robots.size()) {
        ++e;
        r = 0;
      }
    }
    if (e == result.episodes.size()) break;
    if (result.episodes[e].index != index || result.episodes[e].robots[r].robot != robot) continue;
    const auto found = std::find(result.metrics.begin(), result.metrics.end(), values.text(2));
    if (found != result.metrics.end())
      result.episodes[e].robots[r].metrics[static_cast<std::size_t>(found - result.metrics.begin())] = values.real(3);
  }
  return result;
}

std::optional<Json> Store::description(const std::string& id) const {
  Statement query(*impl_->db,
                  "SELECT description FROM cells WHERE id = ?1 UNION ALL "
                  "SELECT description FROM trainings WHERE id = ?1 LIMIT 1");
  query.bind(id);
  if (!query.step()) return {};
  return impl_->parse(query.text(0), "a unit's description");
}

Json Store::build() const {
  Statement query(*impl_->db, "SELECT build FROM provenance ORDER BY session DESC LIMIT 1");
  if (!query.step()) return Json::object();
  return impl_->parse(query.text(0), "a build");
}

}  // namespace wend::core
