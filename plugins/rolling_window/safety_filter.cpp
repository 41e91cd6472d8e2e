#include "safety_filter.hpp"

#include <algorithm>
#include <cmath>
#include <wend/math.hpp>

namespace rolling_window {
namespace {

constexpr double brake_reserve = 1.2;  // stopping distances are this much longer: noise of the actuators
constexpr double shares[] = {1, 0.85, 0.7, 0.55, 0.4, 0.28, 0.18, 0.1, 0.05};
constexpr double turns[] = {0, 0.1, -0.1, 0.2, -0.2, 0.35, -0.35, 0.5, -0.5, 0.75, -0.75, 1, -1};
constexpr double turn_cost = 0.8;
constexpr double brisk = 0.35;  // share of the top speed from which on the whole margin is kept
constexpr double crawl = 0.4;   // share of the margin that is kept at a crawl
constexpr double bends[] = {0,   0.3,  -0.3, 0.7, -0.7,
                            1.2, -1.2, 2,    -2};  // body radius over the arc's, of emergency braking

}  // namespace

SafetyFilter::SafetyFilter(const wend_limits& limits, double period, double top_speed)
    : limits_(limits), period_(period), top_speed_(top_speed) {
  for (const double share : shares)
    for (const double turn : turns)
      candidates_.push_back({share, turn * std::min(limits.turn_rate, wend::math::half_pi)});
  const double most = std::min(limits.turn_rate, wend::math::half_pi);
  std::stable_sort(candidates_.begin(), candidates_.end(), [&](const Candidate& a, const Candidate& b) {
    const auto cost = [&](const Candidate& c) { return 1 - c.speed_share + turn_cost * std::fabs(c.turn) / most; };
    return cost(a) < cost(b) - 1e-12;
  });
}

Drive SafetyFilter::reachable(const wend_motion& motion, Drive wanted) const {
  const double dv = limits_.acceleration * period_, dw = limits_.turn_acceleration * period_;
  return {
      std::clamp(std::clamp(wanted.speed, limits_.speed_low, limits_.speed_high), motion.speed - dv, motion.speed + dv),
      std::clamp(std::clamp(wanted.turn_rate, -limits_.turn_rate, limits_.turn_rate), motion.turn_rate - dw,
                 motion.turn_rate + dw)};
}

// m from a place to the nearest surface, as far as it matters whether it is less than `needed`.
double SafetyFilter::clearance(const Percept& percept, const GridMemory* memory, double x, double y, double needed) {
  double least = memory ? memory->clearance(x, y) : needed;
  if (least < needed) return least;
  least = std::min(least, needed);
  double squared = least * least;
  for (const Point& p : percept.surface) {
    const double dx = p.x - x, dy = p.y - y;
    squared = std::min(squared, dx * dx + dy * dy);
  }
  return std::sqrt(squared);
}

// The least clearance along the arc of one period and of the braking that could follow it; at most `needed`, and not
// looked at beyond the first place that is below `enough`.
double SafetyFilter::least_clearance(const Percept& percept, const GridMemory* memory, double needed, double enough,
                                     Drive drive) const {
  const double speed = std::fabs(drive.speed);
  const double braking = std::isfinite(limits_.acceleration) ? speed * speed / (2 * limits_.acceleration) : 0;
  const double length = brake_reserve * (speed * period_ + braking);
  if (length <= 0) return needed;
  const double curvature = drive.turn_rate / speed, spacing = 0.1 * percept.body;
  const int samples = std::max(2, static_cast<int>(std::ceil(length / spacing)));
  const double direction = drive.speed < 0 ? -1 : 1;
  double least = needed;
  for (int k = 1; k <= samples && least >= enough; ++k) {
    const double s = length * k / samples, half = 0.5 * curvature * s;
    const double chord = direction * s * (std::fabs(half) < 1e-6 ? 1 : wend::math::sin(half) / half);
    double sine, cosine;
    wend::math::sincos(percept.motion.heading + direction * half, sine, cosine);
    least = std::min(
        least, clearance(percept, memory, percept.motion.x + chord * cosine, percept.motion.y + chord * sine, needed));
  }
  return least;
}

Drive SafetyFilter::nearest_safe(const Percept& percept, const GridMemory* memory, double margin, Drive wanted) const {
  // Where the robot is already too near, it may go wherever it does not come nearer.
  const double touching = percept.body + limits_.stop_distance;
  const double now =
      clearance(percept, memory, percept.motion.x, percept.motion.y, touching + margin) - 1e-3 * percept.body;
  // The slower, the less room is kept: narrow gaps are passed at a crawl.
  const auto needed_at = [&](double speed) {
    return std::min(now, touching + margin * std::clamp(std::fabs(speed) / (brisk * top_speed_), crawl, 1.0));
  };
  const double needed = needed_at(0);
  const auto safe = [&](Drive drive) {
    const Drive next = reachable(percept.motion, drive);
    const double enough = needed_at(next.speed);
    return least_clearance(percept, memory, enough, enough, next) >= enough;
  };
  if (wanted.speed == 0) {
    if (safe(wanted)) return wanted;
    return brake(percept, memory, needed, wanted);
  }
  for (const Candidate& candidate : candidates_) {
    const double turn = wanted.turn_rate * candidate.speed_share + candidate.turn;
    const Drive drive{wanted.speed * candidate.speed_share, std::clamp(turn, -limits_.turn_rate, limits_.turn_rate)};
    if (safe(drive)) return drive;
  }
  return brake(percept, memory, needed, wanted);
}

// Stops.  A disc at rest may turn where it stands; one that still rolls takes the arc with the most room.
Drive SafetyFilter::brake(const Percept& percept, const GridMemory* memory, double needed, Drive wanted) const {
  const double stop = std::clamp(0.0, limits_.speed_low, limits_.speed_high);
  const double rolling = std::fabs(reachable(percept.motion, {stop, 0}).speed);
  if (rolling <= 1e-9) return {stop, wanted.turn_rate};
  Drive best{stop, wanted.turn_rate};
  double most = -1;
  for (const double bend : bends) {
    const Drive drive{stop, std::clamp(bend / percept.body * rolling, -limits_.turn_rate, limits_.turn_rate)};
    const double least = least_clearance(percept, memory, needed, -1, reachable(percept.motion, drive));
    if (least > most + 1e-12) most = least, best = drive;
  }
  return best;
}

double SafetyFilter::way_out(const Percept& percept, const GridMemory* memory, double margin, double towards) const {
  const double wished = percept.body + limits_.stop_distance + margin;
  const double now = clearance(percept, memory, percept.motion.x, percept.motion.y, wished);
  const double enough = std::min(wished, now + 0.5 * margin), length = 0.5 * percept.body;
  for (int k = 0; k <= 36; ++k) {  // 0, 10, -10, 20, ... degrees beside `towards`
    const double bearing = towards + (k % 2 ? 1 : -1) * ((k + 1) / 2) * 10 * wend::math::degree;
    double sine, cosine;
    wend::math::sincos(percept.motion.heading + bearing, sine, cosine);
    bool free = true;
    for (int s = 1; s <= 5 && free; ++s) {
      const double x = percept.motion.x + 0.2 * s * length * cosine, y = percept.motion.y + 0.2 * s * length * sine;
      free = clearance(percept, memory, x, y, wished) >= (s == 5 ? enough : now - 1e-3 * percept.body);
    }
    if (free) return wend::math::wrap_angle(bearing);
  }
  return towards;
}

}  // namespace rolling_window
