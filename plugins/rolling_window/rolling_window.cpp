// wend.rolling_window: rolling windows, with memory, planners and a slot for avoidance.
//
// Liu C., Li Z., Huang Z., Zuo L., Wu J., Xu X.: A reactive navigation method of mobile robots based on LSPI and
// rolling windows; J. Central South University (Science and Technology) 44(3), 2013, 970-977; sections 2.2 and 2.3.
//
//   symbol     here                                  equation
//   r_w        radius (SubgoalChooser)               Win(p_t) = {p : d(p, p_t) <= r_w}
//   p          Subgoal::at                           (12) argmin f(p) = g(p) + h(p)
//   g(p)       free_length, r_w or infinite          (12)
//   h(p)       straight distance, or GoalDistance    (12)
//   D          switch_distance (Switching)           2.3, step 3
//   epsilon    one period of the robot's actions     2.2
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>
#include <wend/plugin.hpp>

#include "navigator.hpp"
#include "reader.hpp"

namespace rolling_window {
namespace {

NavigatorSettings settings_of(const wend::Config& config, const wend::Steer& steer) {
  const wend::Params& params = config.params;
  const wend_limits& limits = steer.limits();
  const double body = limits.radius;
  NavigatorSettings s;
  s.memory = params.text("memory") == "grid";
  const std::string planner = params.text("planner");
  if (planner == "auto") {
    const bool turns = limits.turn_radius > 0 || steer.discrete();
    s.planner = !s.memory ? Planner::none : turns ? Planner::turn_radius : Planner::grid;
  } else {
    s.planner = planner == "grid" ? Planner::grid : planner == "turn_radius" ? Planner::turn_radius : Planner::none;
  }
  if (s.planner != Planner::none && !s.memory)
    throw wend::parameter_error(
        "planner", "expected none or auto where memory is none, found " + planner + "; set memory to grid");
  s.radius = params.number("radius");
  s.candidates = params.count("candidates");
  s.margin = params.number_or("margin", body / 6);
  s.clearance_range = params.number_or("clearance_range", body);
  s.clearance_weight = params.number("clearance_weight");
  s.look_ahead = params.number_or("look_ahead", 8.0 / 3.0 * body);
  s.top_speed = std::min(params.number_or("speed", std::numeric_limits<double>::infinity()), steer.top_speed());
  s.filter = params.flag("safety_filter");
  s.safety_margin = params.number_or("safety_margin", body / 6);
  s.replan = static_cast<std::uint32_t>(params.count("replan"));
  s.grid.cell = params.number_or("cell", s.planner == Planner::grid ? body / 6 : body / 3);
  s.grid.influence = body + limits.stop_distance + s.margin + std::max(s.clearance_range, 2 * s.grid.cell);
  s.grid.range_noise = params.number("range_noise");
  s.grid.most_cells = params.count("memory_cells");
  s.lattice = {params.count("headings"), params.count("expansions"), params.number_or("horizon", 10 * body)};
  const std::string rule = params.text("switch");
  s.switching.rule = rule == "A" ? Switch::a : rule == "B" ? Switch::b : Switch::never;
  s.sample_with_window = params.text("sample_with") == "window";
  s.switching.distance = params.number("switch_distance");
  s.driven_corridor = params.text("corridor") == "driven";
  s.switching.margin = params.number_or("switch_margin", s.driven_corridor && !s.memory ? body / 10 : 0);
  if (!steer.discrete() && !std::isfinite(s.top_speed))
    throw wend::parameter_error("speed", "expected a greatest speed, as the body has none; found none");
  if (s.grid.influence / s.grid.cell > 1000)
    throw wend::parameter_error("cell", "expected at least a thousandth of the clearance that plans look at, " +
                                            std::to_string(s.grid.influence) + " m, found " +
                                            std::to_string(s.grid.cell));
  return s;
}

}  // namespace

class RollingWindow {
 public:
  explicit RollingWindow(const wend::Config& config) : action_width_(config.action.width()) {
    const wend::Steer steer(config);
    const NavigatorSettings settings = settings_of(config, steer);
    navigator_ = Navigator(settings, steer, wend::BodyRef(config.use("world")));
    reader_ = Reader(config, steer.limits().radius, settings.memory);
    if (const auto slot = config.slot("avoid")) {
      avoid_ = wend::PolicyRef(*slot);
      learner_ = wend::LearnerRef(*slot);
    }
    for (std::uint32_t row = 0; row < config.rows(); ++row)
      rows_.push_back({navigator_.start(), std::vector<double>(action_width_), false, false, {}});
    per_step_.discrete("avoids", 2).box("subgoal_x", "m").box("subgoal_y", "m");
    per_episode_.box("avoid_share", "1", 0, 1).box("replans", "1", 0);
  }

  // What it can learn, its slot can.
  bool answers(std::string_view id) const { return id != WEND_LEARNER || static_cast<bool>(learner_); }

  // ---- policy
  void begin(wend::Rows rows, wend::Episodes episodes) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Row& row = rows_[rows[i]];
      navigator_.begin(row.course, learner_ && episodes[i].mode == WEND_TRAIN_EXPLORE);
      row.decided = row.avoided = false;
    }
    if (avoid_) avoid_.begin(rows, episodes);
  }
  void act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) {
    avoiding_.clear(), places_.clear(), observed_.clear();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Row& row = rows_[rows[i]];
      if (!row.decided) decide(row, observations[i]);
      row.decided = false;
      row.avoided = row.course.avoids;
      row.subgoal = row.course.subgoal.at;
      if (row.avoided) {
        avoiding_.push_back(rows[i]), places_.push_back(i);
        observed_.insert(observed_.end(), observations[i].begin(), observations[i].end());
      } else {
        std::copy(row.action.begin(), row.action.end(), actions[i].begin());
      }
    }
    if (avoiding_.empty()) return;
    chosen_.resize(avoiding_.size() * action_width_);
    avoid_.act(avoiding_, observed_.data(), chosen_.data());
    for (std::size_t k = 0; k < places_.size(); ++k)
      std::copy_n(chosen_.begin() + static_cast<std::ptrdiff_t>(k * action_width_), action_width_,
                  actions[places_[k]].begin());
  }

  // ---- learner: passes on the steps that the slot acted in
  std::uint64_t learn(const wend::Batch& batch) {
    avoiding_.clear(), places_.clear(), observed_.clear(), next_.clear(), chosen_.clear(), outcomes_.clear();
    for (std::size_t i = 0; i < batch.size(); ++i) {
      Row& row = rows_[batch.rows[i]];
      if (!row.avoided) continue;
      wend_outcome outcome = batch.outcomes[i];
      if (!(outcome.flags & (WEND_TERMINATED | WEND_TRUNCATED))) {
        decide(row, batch.next_observations[i]);  // act() keeps to it
        row.decided = true;
        if (!row.course.avoids) outcome.flags |= WEND_HANDED_OVER;
      }
      const auto append = [](std::vector<double>& all, std::span<const double> more) {
        all.insert(all.end(), more.begin(), more.end());
      };
      avoiding_.push_back(batch.rows[i]);
      append(observed_, batch.observations[i]), append(chosen_, batch.actions[i]),
          append(next_, batch.next_observations[i]);
      outcomes_.push_back(outcome);
    }
    if (avoiding_.empty()) return 0;
    const wend_batch passed{sizeof(wend_batch), static_cast<std::uint32_t>(avoiding_.size()),
                            avoiding_.data(),   observed_.data(),
                            chosen_.data(),     next_.data(),
                            outcomes_.data()};
    return learner_.learn(passed);
  }
  void finish() { learner_.finish(); }

  // ---- state: its own part is empty, the slot's is the host's business
  void save(wend::Writer& writer) const { writer.put(std::string_view(state_name)); }
  void load(wend::Reader& reader) const {
    reader.expect(state_name);
    reader.end();
  }

  // ---- telemetry
  const wend::Columns* telemetry(std::uint32_t when) const {
    return when == WEND_PER_STEP ? &per_step_ : when == WEND_PER_EPISODE ? &per_episode_ : nullptr;
  }
  void read(std::uint32_t when, wend::Rows rows, wend::Matrix<double> out) const {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Course& course = rows_[rows[i]].course;
      if (when == WEND_PER_STEP) {
        const Row& row = rows_[rows[i]];
        out[i][0] = row.avoided, out[i][1] = row.subgoal.x, out[i][2] = row.subgoal.y;
      } else {
        out[i][0] = course.steps ? static_cast<double>(course.avoided) / static_cast<double>(course.steps)
                                 : std::numeric_limits<double>::quiet_NaN();
        out[i][1] = static_cast<double>(course.replans);
      }
    }
  }
  void explain(std::uint32_t row, wend::Writer& writer) const { writer.text(navigator_.explain(rows_[row].course)); }

 private:
  static constexpr const char* state_name = "wend.rolling_window 1";
  struct Row {
    Course course;
    std::vector<double> action;  // where the window itself decided
    bool decided;                // learn() has decided on the observation that act() is going to be handed
    bool avoided;                // the slot chose the last action
    Point subgoal;               // at that action
  };

  void decide(Row& row, std::span<const double> observation) {
    reader_.read(observation, row.course.percept);
    navigator_.decide(row.course, static_cast<bool>(avoid_), row.action);
  }

  std::size_t action_width_;
  Navigator navigator_;
  Reader reader_;
  wend::PolicyRef avoid_;
  wend::LearnerRef learner_;
  std::vector<Row> rows_;
  wend::Columns per_step_, per_episode_;
  std::vector<std::uint32_t> avoiding_;  // rows that the slot is asked for, and their places in the batch
  std::vector<std::size_t> places_;
  std::vector<double> observed_, next_, chosen_;
  std::vector<wend_outcome> outcomes_;
};

}  // namespace rolling_window

WEND_PLUGIN(wend::component<rolling_window::RollingWindow>("wend.rolling_window"))
