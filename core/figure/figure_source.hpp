// Summary and traces, arranged for drawing: which arms there are, in which order and look.
#pragma once
#include <core/figure/interval_figure.hpp>
#include <core/figure/style.hpp>
#include <core/record/trace.hpp>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace wend::core {

// A recorded episode and what it is of.
struct Recorded {
  const Trace* trace = nullptr;
  std::string arm, world, point;  // point: canonical JSON
  std::uint64_t variant = 0, seed = 0, episode = 0;
  bool privileged = false;
  std::string unit;  // of a snapshot's amount; empty: no snapshot but the end
  double amount = std::numeric_limits<double>::infinity();
  bool training = false;  // an episode of the training, not of the test
};

class FigureSource {
 public:
  FigureSource(const Json& summary, const std::vector<Trace>& traces, const Json& options);

  const Json& summary() const { return summary_; }
  const std::string& title() const { return title_; }
  const std::vector<std::string>& worlds() const { return worlds_; }
  const std::vector<Recorded>& recorded() const { return recorded_; }  // tests that have a map
  const std::vector<Recorded>& trials() const { return trials_; }      // trainings that have a map
  const std::vector<Recorded>& episodes() const { return episodes_; }  // all of both
  std::size_t variants() const { return variants_; }
  const std::vector<std::string>& metrics() const { return metrics_; }
  const std::vector<std::string>& steps() const { return steps_; }
  bool log_x(const std::string& x) const { return log_x_.count(x) != 0; }
  bool wants_curve(const std::string& metric) const { return curves_.count(metric) != 0; }
  bool wants(const std::string& world) const;

  // The arm's place among all arms of the experiment, which gives its look.
  std::size_t style_of(const std::string& arm) const;
  // "arm", or in a sweep "arm, gamma = 0.9".
  std::string label(const std::string& arm, const std::string& point) const;
  // The place of arm and point among all that have results: one for each line of a figure.
  std::size_t line_of(const std::string& arm, const std::string& point) const;
  bool privileged(const std::string& arm) const { return privileged_.count(arm) != 0; }

  // Final results: for each arm and point the row without "at", else that of the last snapshot.
  std::vector<const Json*> final_results(const std::string& world) const;

 private:
  void note(const std::string& arm, const std::string& world, const std::string& point, bool privileged);
  void read_options(const Json& options);

  const Json& summary_;
  std::string title_;
  std::vector<std::string> worlds_, arms_, metrics_, steps_;
  std::vector<std::pair<std::string, std::string>> lines_;  // arm, point
  std::set<std::string> privileged_, log_x_, points_, curves_;
  std::optional<std::set<std::string>> only_worlds_;
  std::vector<Recorded> recorded_, trials_, episodes_;
  std::size_t variants_ = 4;
};

// "gamma = 0.9, noise = 2" from {"/arms/0/policy/params/gamma": 0.9, ...}; empty for {}.
std::string point_text(const std::string& point);

std::string text_of(const Json& json, const char* key);
double number_of(const Json& json, const char* key);  // NaN if missing or null

}  // namespace wend::core
