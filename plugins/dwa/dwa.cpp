// wend.dwa -- D. Fox, W. Burgard, S. Thrun, "The dynamic window approach to collision avoidance", IEEE Robotics &
// Automation Magazine 4(1), 1997.
//
//   symbol       here                  meaning
//   V_d          Window::search        velocities that can be reached within one period
//   V_a          Candidate.admissible  velocities from which the robot stops before the obstacle on its arc
//   dist(v,w)    Candidate.way         free way along the arc, m (arc.hpp: closed form for points)
//   heading      in Window::judge      1 - |angle to the goal| / pi, at the predicted pose
//   G(v,w)       Candidate.value       smoothed alpha heading + beta dist + gamma velocity, each within [0, 1]
//
// Obstacle points are the ends of the range columns.  Where no arc forward is admissible the robot turns in place.
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>
#include <wend/plugin.hpp>
#include <wend/reading.hpp>
#include <wend/steer.hpp>

#include "window.hpp"

namespace dwa {
namespace {

constexpr double infinity = wend::math::detail::infinity;

// What a row did last.
struct Memory {
  double turning = 0;  // rad/s: of a recovery under way, which keeps its direction
  Candidate chosen{};
  double admissible = 0;  // share of the candidates
};

class Dwa {
 public:
  explicit Dwa(const wend::Config& config)
      : ranges_(config.observation, config.params.texts("observe"), "observe"),
        goal_distance_(config.observation, config.params.text("goal") + ".distance", "goal"),
        goal_bearing_(config.observation, config.params.text("goal") + ".bearing", "goal"),
        steer_(config),
        body_(config.use("world")),
        settings_(settings_of(config)),
        window_(settings_),
        recover_distance_(config.params.number("recover_distance")),
        start_(config.params.text("from") == "rim" ? steer_.limits().radius : 0),
        memory_(config.rows()) {
    if (recover_distance_ <= 0) recover_distance_ = settings_.radius;
    // A robot without limits of acceleration need not know how it moves.
    if (std::isfinite(settings_.acceleration) || std::isfinite(settings_.turn_acceleration)) {
      speed_.emplace(config.observation, config.params.text("pose") + ".speed", "pose");
      turn_rate_.emplace(config.observation, config.params.text("pose") + ".turn_rate", "pose");
    }
    if (steer_.discrete()) {
      for (std::size_t k = 0; k < steer_.table().size(); ++k) actions_.push_back(static_cast<double>(k));
      from_.resize(actions_.size()), to_.resize(actions_.size()), motions_.resize(actions_.size());
    }
    points_.reserve(ranges_.size());
    columns_.box("objective", "1", 0)
        .box("free_way", "m", 0, settings_.look_ahead)
        .box("admissible", "1", 0, 1)
        .box("recovering", "1", 0, 1);
  }

  void begin(wend::Rows rows, wend::Episodes) {
    for (const std::uint32_t row : rows) memory_[row] = {};
  }

  void act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Situation situation = see(observations[i]);
      Memory& memory = memory_[rows[i]];
      if (steer_.discrete()) {
        actions[i][0] = static_cast<double>(choose(situation, memory));
      } else {
        const Motion motion = drive(situation, memory);
        steer_.drive(motion.v, motion.w, actions[i]);
      }
    }
  }

  const wend::Columns* telemetry(std::uint32_t when) const { return when == WEND_PER_STEP ? &columns_ : nullptr; }
  void read(std::uint32_t, wend::Rows rows, wend::Matrix<double> out) const {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Memory& memory = memory_[rows[i]];
      out[i][0] = memory.chosen.value, out[i][1] = memory.chosen.way, out[i][2] = memory.admissible;
      out[i][3] = memory.turning != 0 ? 1 : 0;
    }
  }
  void explain(std::uint32_t row, wend::Writer& writer) const {
    const Memory& memory = memory_[row];
    const Candidate& c = memory.chosen;
    char text[200];
    const int n = std::snprintf(
        text, sizeof text, "%s %.3g m/s, %.3g rad/s: %.3g m free, objective %.3g; %.0f %% of the window admissible",
        memory.turning != 0 ? "recovery:" : "arc", c.motion.v, c.motion.w, c.way, c.value, 100 * memory.admissible);
    writer.text({text, static_cast<std::size_t>(n)});
  }

 private:
  Settings settings_of(const wend::Config& config) const {
    const wend::Params& p = config.params;
    const wend_limits& body = steer_.limits();
    Settings s{};
    s.period = steer_.period();
    s.radius = body.radius + body.stop_distance + p.number("margin");
    s.speed_high = std::min(p.number_or("max_speed", infinity), steer_.top_speed());
    s.speed_low = std::clamp(0.0, body.speed_low, s.speed_high);
    s.turn_rate = std::min(p.number_or("max_turn_rate", infinity), body.turn_rate);
    if (!steer_.discrete() && !(std::isfinite(s.speed_high) && std::isfinite(s.turn_rate)))
      throw wend::parameter_error(std::isfinite(s.speed_high) ? "max_turn_rate" : "max_speed",
                                  "expected a limit, since neither the body nor the action space has one; found none");
    if (!(s.speed_high > 0)) throw wend::unsupported("the dynamic window needs a body that drives forward");
    s.acceleration = std::min(p.number_or("acceleration", infinity), body.acceleration);
    s.turn_acceleration = std::min(p.number_or("turn_acceleration", infinity), body.turn_acceleration);
    s.turn_radius = steer_.discrete() ? 0 : body.turn_radius;
    s.look_ahead = p.number("look_ahead");
    s.alpha = p.number("alpha"), s.beta = p.number("beta"), s.gamma = p.number("gamma");
    s.v_samples = static_cast<std::uint32_t>(p.count("v_samples"));
    s.w_samples = static_cast<std::uint32_t>(p.count("w_samples"));
    return s;
  }

  Situation see(std::span<const double> observation) {
    points_.clear();
    for (std::size_t k = 0; k < ranges_.size(); ++k) {
      const double range = ranges_(observation, k);
      if (range >= ranges_.column(k).high) continue;  // the reach itself is no echo
      double s, c;
      wend::math::sincos(ranges_.bearing(k), s, c);
      points_.push_back({(start_ + range) * c, (start_ + range) * s});
    }
    return {{speed_ ? (*speed_)(observation) : 0, turn_rate_ ? (*turn_rate_)(observation) : 0},
            goal_distance_(observation),
            goal_bearing_(observation),
            points_};
  }

  // The best admissible candidate, or nullptr; among equals the first.  Notes it.  Standing still is no choice: nothing
  // would ever change.
  static const Candidate* best_of(std::span<const Candidate> candidates, Memory& memory) {
    const Candidate* best = nullptr;
    std::size_t admissible = 0;
    for (const Candidate& candidate : candidates) {
      if (!candidate.admissible) continue;
      ++admissible;
      if (candidate.motion.v == 0 && candidate.motion.w == 0) continue;
      if (best == nullptr || candidate.value > best->value) best = &candidate;
    }
    memory.admissible = static_cast<double>(admissible) / static_cast<double>(candidates.size());
    if (best) memory.chosen = *best;
    return best;
  }

  Motion drive(const Situation& situation, Memory& memory) {
    const auto candidates = window_.search(situation);
    const Candidate* best = best_of(candidates, memory);
    const bool forward = can_drive(candidates);
    if (memory.turning != 0 && window_.way(situation, {1, 0}) >= recover_distance_) memory.turning = 0;
    if (forward && best && memory.turning == 0) return best->motion;
    return recover(situation, memory);
  }

  // Brakes and turns on the spot towards the side with more room, until the way ahead is free for recover_distance.
  Motion recover(const Situation& situation, Memory& memory) {
    if (settings_.turn_radius > 0) {
      memory.turning = 0;
      memory.chosen = window_.judge(situation, {settings_.speed_low, 0});
      return memory.chosen.motion;
    }
    if (memory.turning == 0) memory.turning = std::copysign(recovery_rate(), roomier_side(situation));
    // Still rolling: brake along the arc that was found free, not off it.
    const double rest = situation.now.v - settings_.acceleration * settings_.period;
    const double w = rest > 0 ? situation.now.w * rest / situation.now.v : memory.turning;
    memory.chosen = window_.judge(situation, {settings_.speed_low, w});
    return memory.chosen.motion;
  }
  double recovery_rate() const noexcept {
    return std::min(settings_.turn_rate, 0.25 * wend::math::pi / settings_.period);
  }

  // +1 left, -1 right: where the points ahead and beside push less; without a difference, where the goal is.
  static double roomier_side(const Situation& situation) {
    double push = 0, total = 0;
    for (const Point& p : situation.obstacles) {
      const double d2 = p.x * p.x + p.y * p.y, d = std::sqrt(d2);
      if (!(p.x > -0.1 * d)) continue;
      push += p.y / (d2 * d);
      total += 1 / d2;
    }
    if (std::fabs(push) > 1e-9 * total) return push < 0 ? 1 : -1;
    return situation.goal_bearing >= 0 ? 1 : -1;
  }

  std::size_t choose(const Situation& situation, Memory& memory) {
    for (wend_motion& from : from_) from = {0, 0, 0, situation.now.v, situation.now.w};
    body_.predict(0, from_, actions_.data(), settings_.period, to_);
    for (std::size_t k = 0; k < to_.size(); ++k) {  // the arc through both poses
      const double half = 0.5 * to_[k].heading;
      const double chord = std::copysign(wend::math::hypot(to_[k].x, to_[k].y), to_[k].x);
      motions_[k] = {chord * (std::fabs(half) < 1e-9 ? 1 : half / wend::math::sin(half)) / settings_.period,
                     to_[k].heading / settings_.period};
      if (std::fabs(motions_[k].v) < 1e-12) motions_[k].v = 0;
    }
    const auto candidates = window_.search(situation, motions_);
    const Candidate* best = best_of(candidates, memory);
    memory.turning = 0;
    if (best && best->motion.v != 0) return static_cast<std::size_t>(best - candidates.data());
    // Turn on the spot if the table can; a table that cannot takes the longest free way.
    const auto turn = turning_action(candidates, roomier_side(situation));
    if (turn && !can_drive(candidates)) return memory.turning = 1, memory.chosen = candidates[*turn], *turn;
    if (best) return static_cast<std::size_t>(best - candidates.data());
    const auto longest = std::max_element(candidates.begin(), candidates.end(),
                                          [](const auto& a, const auto& b) { return a.way < b.way; });
    memory.chosen = *longest;
    return static_cast<std::size_t>(longest - candidates.begin());
  }
  static bool can_drive(std::span<const Candidate> candidates) {
    return std::any_of(candidates.begin(), candidates.end(),
                       [](const Candidate& c) { return c.admissible && c.motion.v > 0; });
  }
  static std::optional<std::size_t> turning_action(std::span<const Candidate> candidates, double side) {
    for (std::size_t k = 0; k < candidates.size(); ++k)
      if (candidates[k].motion.v == 0 && candidates[k].motion.w * side > 0) return k;
    return std::nullopt;
  }

  wend::Reading ranges_, goal_distance_, goal_bearing_;
  std::optional<wend::Reading> speed_, turn_rate_;
  wend::Steer steer_;
  wend::BodyRef body_;
  Settings settings_;
  Window window_;
  double recover_distance_;     // m
  double start_;                // m from the centre, of a range reading
  std::vector<Memory> memory_;  // of each row
  std::vector<Point> points_;
  std::vector<double> actions_;  // discrete: 0, 1, ...
  std::vector<wend_motion> from_, to_;
  std::vector<Motion> motions_;
  wend::Columns columns_;
};

}  // namespace
}  // namespace dwa

WEND_PLUGIN(wend::component<dwa::Dwa>("wend.dwa"))
