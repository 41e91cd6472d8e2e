// A row of the summary: the episodes of all its cells, and what they come to.
#pragma once
#include <core/base/json.hpp>
#include <core/experiment/unit.hpp>
#include <core/stats/intervals.hpp>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace wend::core {

class Row {
 public:
  explicit Row(const Cell& first);

  void add(const Cell& cell, const CellResult& result);
  void add_failure() { ++failed_; }
  void add_training_time(std::uint64_t seed, double seconds) { train_s_.emplace(seed, seconds); }

  // Whether any robot arrived or collided: then rates mean something in this world.
  bool has_outcomes() const { return has_outcomes_; }
  bool is_empty() const { return episodes_.empty(); }
  const Cell& first() const { return first_; }

  Json summarize(bool with_rates) const;

  // The mean of a metric with a bootstrap interval of the mean, for curves of snapshots.
  struct Mean {
    double mean;
    Interval interval;
  };
  std::optional<Mean> mean_of(const std::string& metric) const;

 private:
  struct Outcome {
    bool success = false, collision = false, timeout = false;
  };
  struct EpisodeData {
    std::uint32_t variant;
    std::uint64_t seed, steps;
    Outcome all;
    std::vector<Outcome> robots;  // only of several
  };
  struct Value {
    double value;
    std::uint32_t episode, robot;
  };
  struct Units {  // what the bootstrap draws
    std::vector<std::uint32_t> strata, of_episode;
  };
  static Outcome outcome_of(std::uint32_t flags);
  Units units() const;
  bool seeds_are_units() const { return trains_ && seeds_.size() > 1; }
  std::vector<Json> rates(const std::vector<std::vector<bool>>& kinds) const;
  void add_rates(Json& row) const;
  void add_robot_rates(Json& metrics) const;
  Json metrics(bool with_rates) const;

  const Cell& first_;
  bool trains_ = false, has_outcomes_ = false;
  std::uint32_t robots_ = 0;
  std::uint64_t failed_ = 0;
  std::set<std::uint64_t> seeds_;
  std::vector<EpisodeData> episodes_;
  std::map<std::string, std::vector<Value>> values_;
  std::vector<double> decision_us_;
  std::multimap<std::uint64_t, double> train_s_;
};

}  // namespace wend::core
