#include <algorithm>
#include <core/base/sha256.hpp>
#include <core/stats/curves.hpp>
#include <core/stats/rows.hpp>
#include <core/stats/summary.hpp>
#include <deque>
#include <limits>
#include <set>
#include <tuple>

namespace wend::core {
namespace {

// Groups in the order in which their keys first came.
template <class Key, class Group>
class Ordered {
 public:
  template <class... Arguments>
  Group& at(const Key& key, Arguments&&... arguments) {
    const auto [found, added] = index_.emplace(key, groups_.size());
    if (added) groups_.emplace_back(std::forward<Arguments>(arguments)...);
    return groups_[found->second];
  }
  std::deque<Group>& groups() { return groups_; }

 private:
  std::map<Key, std::size_t> index_;
  std::deque<Group> groups_;
};

using RowKey = std::tuple<std::string, std::string, std::string, std::string, std::uint64_t>;
using Rows = Ordered<RowKey, Row>;

RowKey key_of(const Cell& cell) {
  return {cell.driver.arm, cell.world.id, cell.point.dump(), cell.at ? cell.at->unit : "",
          cell.at ? cell.at->amount : 0};
}

std::uint64_t seed_of(const Training& training) {
  return training.streams.empty() ? 0 : training.streams[0].seed;
}

// ------------------------------------------------------------------------------------------------------------- curves

struct CurveGroup {
  Json head;  // all but the points
  std::vector<Points> seeds;
};

Json head(const std::string& arm, const std::string& world, const Json& point, const std::string& metric,
          const std::string& x) {
  return {{"arm", arm}, {"world", world}, {"point", point}, {"robot", nullptr}, {"metric", metric}, {"x", x}};
}

using CurveGroups = Ordered<std::string, CurveGroup>;

void add(CurveGroups& groups, Json about, const Curve& curve) {
  if (curve.robot) about["robot"] = *curve.robot;
  CurveGroup& group = groups.at(about.dump(-1, ' ', false, Json::error_handler_t::replace));
  group.head = std::move(about);
  group.seeds.push_back(curve.points);
}

void move_into(Json& curves, CurveGroups& groups) {
  for (CurveGroup& group : groups.groups()) {
    Json points = aggregate(group.seeds);
    if (points.empty()) continue;
    group.head["points"] = std::move(points);
    curves.push_back(std::move(group.head));
  }
}

// The worlds in which its arm tests a training, else the one in which it trains.
std::vector<std::string> worlds_of(const Training& training,
                                   const std::map<std::string, std::vector<std::string>>& tested) {
  const auto found = tested.find(training.id + training.driver.arm);
  if (found != tested.end()) return found->second;
  if (training.worlds.empty()) return {};
  return {training.worlds[0].id};
}

using TrainingResults = std::map<std::string, TrainingResult>;

void add_training_curves(Json& curves, const std::vector<Training>& trainings, const std::vector<Cell>& cells,
                         const TrainingResults& results) {
  std::map<std::string, std::vector<std::string>> tested;
  for (const Cell& cell : cells) {
    auto& worlds = tested[cell.training + cell.driver.arm];
    if (std::find(worlds.begin(), worlds.end(), cell.world.id) == worlds.end()) worlds.push_back(cell.world.id);
  }
  CurveGroups groups;
  for (const Training& training : trainings) {
    const auto result = results.find(training.id);
    if (result == results.end()) continue;
    for (const std::string& world : worlds_of(training, tested)) {
      for (const Curve& curve : result->second.curves) {
        add(groups, head(training.driver.arm, world, training.point, curve.metric, curve.x), curve);
      }
    }
  }
  move_into(curves, groups);
}

// "success" and "collision", then every metric that a snapshot's row has, but for times of this machine.
std::vector<std::string> curve_names(const std::map<std::uint64_t, std::size_t>& group, const Json& results) {
  std::set<std::string> metrics;
  for (const auto& [amount, i] : group)
    if (results[i].contains("metrics"))
      for (const auto& metric : results[i]["metrics"].items()) metrics.insert(metric.key());
  metrics.erase("train_s");
  metrics.erase("decision_us");
  std::vector<std::string> names = {"success", "collision"};
  names.insert(names.end(), metrics.begin(), metrics.end());
  return names;
}

// Success, collision and the metrics of snapshots against the budget's unit.
void add_snapshot_curves(Json& curves, std::deque<Row>& rows, const Json& results) {
  Ordered<std::string, std::map<std::uint64_t, std::size_t>> groups;  // amount -> row
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Cell& cell = rows[i].first();
    if (!cell.at || rows[i].is_empty()) continue;
    groups.at(head(cell.driver.arm, cell.world.id, cell.point, "", cell.at->unit).dump())[cell.at->amount] = i;
  }
  for (const auto& group : groups.groups()) {
    const Cell& cell = rows[group.begin()->second].first();
    for (const std::string& metric : curve_names(group, results)) {
      Json points = Json::array();
      for (const auto& [amount, i] : group) {
        if (results[i].contains(metric)) {
          const Json& rate = results[i][metric];
          points.push_back({amount, rate["rate"], rate["low"], rate["high"]});
        } else if (const auto found = rows[i].mean_of(metric)) {
          points.push_back({amount, found->mean, found->interval.low, found->interval.high});
        }
      }
      if (points.empty()) continue;
      Json curve = head(cell.driver.arm, cell.world.id, cell.point, metric, cell.at->unit);
      curve["points"] = std::move(points);
      curves.push_back(std::move(curve));
    }
  }
}

// --------------------------------------------------------------------------------------------------------------- rows

struct Counts {
  std::uint64_t done = 0, failed = 0;
};

// Of each arm, world and point the state that is tested last: the final one, which may be that of a snapshot.
class LastStates {
 public:
  explicit LastStates(const std::vector<Cell>& cells) {
    for (const Cell& cell : cells) {
      std::uint64_t& last = amounts_.try_emplace(where(cell), 0).first->second;
      last = std::max(last, amount(cell));
    }
  }
  bool has(const Cell& cell) const { return amounts_.at(where(cell)) == amount(cell); }

 private:
  using Where = std::tuple<std::string, std::string, std::string>;
  static Where where(const Cell& cell) { return {cell.driver.arm, cell.world.id, cell.point.dump()}; }
  static std::uint64_t amount(const Cell& cell) {
    return cell.at ? cell.at->amount : std::numeric_limits<std::uint64_t>::max();
  }
  std::map<Where, std::uint64_t> amounts_;
};

// Reads the results of all cells into their rows, and a line for each episode into `chain`.
Counts gather(Rows& rows, const std::vector<Cell>& cells, const Store& store, std::vector<std::string>& chain, CurveGroups& series) {
  const auto failures = store.failed(UnitKind::cell);
  const LastStates last(cells);
  Counts counts;
  for (const Cell& cell : cells) {
    Row& row = rows.at(key_of(cell), cell);
    if (const auto result = store.cell(cell.id)) {
      ++counts.done;
      row.add(cell, *result);
      if (!result->curves.empty() && last.has(cell))
        for (const Curve& curve : result->curves) add(series, head(cell.driver.arm, cell.world.id, cell.point, curve.metric, curve.x), curve);
      std::string line = "cell " + cell.id;
      for (const Episode& episode : result->episodes) line += " " + std::to_string(episode.index) + ":" + episode.hash;
      chain.push_back(std::move(line));
    } else if (failures.count(cell.id) != 0) {
      ++counts.failed;
      row.add_failure();
    }
  }
  return counts;
}

// Each training's time once in every row that tests it.
void add_training_times(Rows& rows, const std::vector<Training>& trainings, const std::vector<Cell>& cells,
                        const TrainingResults& results) {
  std::map<std::string, std::uint64_t> seeds;
  for (const Training& training : trainings) seeds[training.id] = seed_of(training);
  std::set<std::pair<const Row*, std::string>> seen;
  for (const Cell& cell : cells) {
    const auto result = results.find(cell.training);
    if (result == results.end()) continue;
    Row& row = rows.at(key_of(cell), cell);
    if (seen.emplace(&row, cell.training).second) row.add_training_time(seeds[cell.training], result->second.train_s);
  }
}

std::string fingerprint(std::vector<std::string> chain) {
  std::sort(chain.begin(), chain.end());
  chain.erase(std::unique(chain.begin(), chain.end()), chain.end());
  std::string text;
  for (const std::string& line : chain) text += line + "\n";
  return sha256(text);
}

}  // namespace

Json summarize(const std::string& experiment, const std::vector<Training>& trainings, const std::vector<Cell>& cells,
               const Store& store) {
  std::vector<std::string> chain;
  TrainingResults trained;
  for (const Training& training : trainings) {
    auto result = store.training(training.id);
    if (!result) continue;
    chain.push_back("training " + training.id + " " + result->hash);
    trained.emplace(training.id, std::move(*result));
  }
  Rows rows;
  CurveGroups series;
  const Counts counts = gather(rows, cells, store, chain, series);
  add_training_times(rows, trainings, cells, trained);

  std::set<std::string> worlds_with_outcomes;
  for (const Row& row : rows.groups())
    if (row.has_outcomes()) worlds_with_outcomes.insert(row.first().world.id);
  Json results = Json::array(), curves = Json::array();
  for (const Row& row : rows.groups())
    results.push_back(row.summarize(worlds_with_outcomes.count(row.first().world.id) != 0));
  add_training_curves(curves, trainings, cells, trained);
  add_snapshot_curves(curves, rows.groups(), results);
  move_into(curves, series);

  const Json version = store.build().value("version", Json());
  return {{"wend", version.is_string() ? version : Json("unknown")},
          {"experiment", experiment},
          {"fingerprint", fingerprint(std::move(chain))},
          {"cells", {{"planned", cells.size()}, {"done", counts.done}, {"failed", counts.failed}}},
          {"results", std::move(results)},
          {"curves", std::move(curves)}};
}

}  // namespace wend::core
