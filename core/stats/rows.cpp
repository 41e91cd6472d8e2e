#include <wend/abi.h>

#include <algorithm>
#include <cmath>
#include <core/stats/bootstrap.hpp>
#include <core/stats/rows.hpp>
#include <numeric>

namespace wend::core {
namespace {

constexpr BootstrapOptions options{10'000, 2'000'000};  // a summary is made after every run; a report takes all 50,000

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Left out where it is not finite, as a sum of huge values may be: JSON has no such number.
void put_metric(Json& metrics, const std::string& name, const std::vector<double>& values, const Interval& interval) {
  const double average = mean(values), iqm = interquartile_mean(values);
  for (const double number : {average, iqm, interval.low, interval.high})
    if (!std::isfinite(number)) return;
  metrics[name] = {
      {"mean", average}, {"iqm", iqm}, {"low", interval.low}, {"high", interval.high}, {"n", values.size()}};
}

// Values that are a unit each: one a cell or one a training.
void put_metric(Json& metrics, const std::string& name, const std::vector<double>& values) {
  if (values.empty()) return;
  std::vector<Measurement> list;
  for (const double value : values) list.push_back({value, static_cast<std::uint32_t>(list.size())});
  const auto n = static_cast<std::uint32_t>(values.size());
  put_metric(metrics, name, values, bootstrap({n}, {list}, Centre::interquartile_mean, options)[0].value());
}

std::string of_robot(const std::string& name, std::uint32_t robot) {
  return name + "_robot_" + std::to_string(robot);
}

}  // namespace

Row::Row(const Cell& first) : first_(first) {}

Row::Outcome Row::outcome_of(std::uint32_t flags) {
  const bool arrived = flags & WEND_ARRIVED, collided = flags & WEND_COLLIDED;
  return {arrived, collided, (flags & WEND_TRUNCATED) != 0 && !collided && !arrived};
}

void Row::add(const Cell& cell, const CellResult& result) {
  trains_ |= !cell.training.empty();
  seeds_.insert(cell.stream.seed);
  if (std::isfinite(result.decision_us)) decision_us_.push_back(result.decision_us);
  std::vector<std::vector<Value>*> lists;
  for (const std::string& name : result.metrics) lists.push_back(&values_[name]);
  for (const Episode& episode : result.episodes) {
    if (episode.robots.empty()) continue;
    const auto index = static_cast<std::uint32_t>(episodes_.size());
    EpisodeData data{cell.variant, cell.stream.seed, 0, {true, false, false}, {}};
    for (const RobotEpisode& robot : episode.robots) {
      const Outcome outcome = outcome_of(robot.flags);
      has_outcomes_ |= outcome.success || outcome.collision;
      data.all.success &= outcome.success;
      data.all.collision |= outcome.collision;
      data.all.timeout |= outcome.timeout;
      data.steps = std::max(data.steps, robot.steps);  // until the last one is there
      data.robots.push_back(outcome);
      for (std::size_t m = 0; m < lists.size(); ++m)
        if (std::isfinite(robot.metrics[m])) lists[m]->push_back({robot.metrics[m], index, robot.robot});
    }
    data.all.timeout &= !data.all.collision;
    robots_ = std::max(robots_, static_cast<std::uint32_t>(data.robots.size()));
    episodes_.push_back(std::move(data));
  }
}

Row::Units Row::units() const {
  Units units;
  if (seeds_are_units()) {
    units.strata = {static_cast<std::uint32_t>(seeds_.size())};
    for (const EpisodeData& episode : episodes_)
      units.of_episode.push_back(static_cast<std::uint32_t>(std::distance(seeds_.begin(), seeds_.find(episode.seed))));
    return units;
  }
  std::map<std::uint32_t, std::vector<std::uint32_t>> variants;  // episodes of each
  for (std::uint32_t i = 0; i < episodes_.size(); ++i) variants[episodes_[i].variant].push_back(i);
  std::vector<std::vector<std::uint32_t>> strata;
  std::vector<std::uint32_t> lone;  // a stratum of one would always draw it: they make one stratum together
  for (auto& [variant, episodes] : variants) {
    if (episodes.size() > 1) {
      strata.push_back(std::move(episodes));
    } else {
      lone.push_back(episodes[0]);
    }
  }
  if (!lone.empty()) strata.push_back(std::move(lone));
  units.of_episode.resize(episodes_.size());
  std::uint32_t unit = 0;
  for (const auto& stratum : strata) {
    units.strata.push_back(static_cast<std::uint32_t>(stratum.size()));
    for (const std::uint32_t episode : stratum) units.of_episode[episode] = unit++;
  }
  return units;
}

// The wider of Wilson's interval and, where the seed trains, the bootstrap over seeds, of each kind of outcome.
std::vector<Json> Row::rates(const std::vector<std::vector<bool>>& kinds) const {
  std::vector<Interval> over_seeds;
  if (seeds_are_units()) {
    std::map<std::uint64_t, SeedCounts> seeds;
    for (std::size_t i = 0; i < episodes_.size(); ++i) {
      SeedCounts& seed = seeds[episodes_[i].seed];
      seed.counts.resize(kinds.size());
      ++seed.n;
      for (std::size_t k = 0; k < kinds.size(); ++k) seed.counts[k] += kinds[k][i];
    }
    std::vector<SeedCounts> list;
    for (auto& [seed, counts] : seeds) list.push_back(std::move(counts));
    over_seeds = bootstrap_rates(list, options);
  }
  std::vector<Json> out;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const auto n = static_cast<std::uint64_t>(kinds[k].size());
    const auto count = static_cast<std::uint64_t>(std::count(kinds[k].begin(), kinds[k].end(), true));
    Interval interval = wilson(count, n);
    if (k < over_seeds.size() && over_seeds[k].width() > interval.width()) interval = over_seeds[k];
    out.push_back({{"rate", static_cast<double>(count) / static_cast<double>(n)},
                   {"low", interval.low},
                   {"high", interval.high},
                   {"n", n}});
  }
  return out;
}

void Row::add_rates(Json& row) const {
  std::vector<std::vector<bool>> kinds(3);
  std::map<std::uint64_t, std::pair<std::uint64_t, std::uint64_t>> seeds;  // successes, episodes
  for (const EpisodeData& episode : episodes_) {
    kinds[0].push_back(episode.all.success);
    kinds[1].push_back(episode.all.collision);
    kinds[2].push_back(episode.all.timeout);
    auto& [successes, n] = seeds[episode.seed];
    successes += episode.all.success;
    ++n;
  }
  const std::vector<Json> found = rates(kinds);
  row["success"] = found[0];
  row["collision"] = found[1];
  row["timeout"] = found[2];
  double worst = 1;
  for (const auto& [seed, counts] : seeds)
    worst = std::min(worst, static_cast<double>(counts.first) / static_cast<double>(counts.second));
  row["worst_seed_success"] = worst;
}

Json Row::metrics(bool with_rates) const {
  const Units drawn = units();
  std::vector<std::string> names;
  std::vector<std::vector<Measurement>> lists;
  std::vector<Measurement> steps;
  for (std::size_t i = 0; i < episodes_.size(); ++i)
    if (episodes_[i].all.success || !with_rates)
      steps.push_back({static_cast<double>(episodes_[i].steps), drawn.of_episode[i]});
  names.push_back("steps");
  lists.push_back(std::move(steps));
  for (const auto& [name, values] : values_) {
    if (name == "steps") continue;
    const std::size_t all = lists.size(), robots = robots_ > 1 ? robots_ : 0;
    names.push_back(name);
    for (std::uint32_t k = 0; k < robots; ++k) names.push_back(of_robot(name, k));
    lists.resize(all + 1 + robots);
    for (const Value& value : values) {
      const Measurement measurement{value.value, drawn.of_episode[value.episode]};
      lists[all].push_back(measurement);
      if (value.robot < robots) lists[all + 1 + value.robot].push_back(measurement);
    }
  }
  Json out = Json::object();
  const auto intervals = bootstrap(drawn.strata, lists, Centre::interquartile_mean, options);
  for (std::size_t m = 0; m < lists.size(); ++m) {
    if (!intervals[m]) continue;
    std::vector<double> values;
    for (const Measurement& measurement : lists[m]) values.push_back(measurement.value);
    put_metric(out, names[m], values, *intervals[m]);
  }
  return out;
}

void Row::add_robot_rates(Json& metrics) const {
  for (std::uint32_t k = 0; k < robots_; ++k) {
    std::vector<std::vector<bool>> kinds(3);
    for (const EpisodeData& episode : episodes_) {
      const Outcome outcome = k < episode.robots.size() ? episode.robots[k] : Outcome{};
      kinds[0].push_back(outcome.success);
      kinds[1].push_back(outcome.collision);
      kinds[2].push_back(outcome.timeout);
    }
    const std::vector<Json> found = rates(kinds);
    const char* const names[] = {"success", "collision", "timeout"};
    for (std::size_t i = 0; i < 3; ++i)
      metrics[of_robot(names[i], k)] = {
          {"mean", found[i]["rate"]}, {"low", found[i]["low"]}, {"high", found[i]["high"]}, {"n", found[i]["n"]}};
  }
}

Json Row::summarize(bool with_rates) const {
  Json row = {{"arm", first_.driver.arm},
              {"world", first_.world.id},
              {"point", first_.point},
              {"at", first_.at ? Json{{first_.at->unit, first_.at->amount}} : Json::object()},
              {"privileged", first_.privileged},
              {"seeds", seeds_.size()},
              {"episodes", episodes_.size()},
              {"metrics", Json::object()}};
  if (failed_ > 0) row["failed"] = failed_;
  if (episodes_.empty()) return row;
  if (with_rates) add_rates(row);
  Json& found = row["metrics"] = metrics(with_rates);
  if (with_rates && robots_ > 1) add_robot_rates(found);
  put_metric(found, "decision_us", decision_us_);
  std::vector<double> times;
  for (const auto& [seed, seconds] : train_s_)
    if (std::isfinite(seconds)) times.push_back(seconds);
  put_metric(found, "train_s", times);
  return row;
}

std::optional<Row::Mean> Row::mean_of(const std::string& name) const {
  const auto found = values_.find(name);
  if (found == values_.end() || found->second.empty()) return {};
  const Units drawn = units();
  std::vector<double> values;
  std::vector<Measurement> list;
  for (const Value& value : found->second) {
    values.push_back(value.value);
    list.push_back({value.value, drawn.of_episode[value.episode]});
  }
  return Mean{mean(values), bootstrap(drawn.strata, {list}, Centre::mean, options)[0].value()};
}

}  // namespace wend::core
