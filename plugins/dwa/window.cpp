// The dynamic window: search space (section 3 of the paper) and objective function (section 4).
#include "window.hpp"

#include <algorithm>
#include <cmath>
#include <wend/math.hpp>

namespace dwa {
namespace {

// Whether what moves at `rate` for one more period and then brakes at `braking` comes to rest within `way`.
bool stops(double rate, double braking, double period, double way) noexcept {
  rate = std::fabs(rate);
  return rate * period + rate * rate / (2 * braking) <= way;
}

// Where an arc leads in a time: (x, y) and the turn.
Point after(Motion m, double seconds) noexcept {
  const double half = 0.5 * m.w * seconds;
  double s, c;
  wend::math::sincos(half, s, c);
  const double chord = m.v * seconds * (std::fabs(half) < 1e-12 ? 1 : s / half);
  return {chord * c, chord * s};
}

double sample(double low, double high, std::uint32_t i, std::uint32_t n) noexcept {
  return n == 1 ? high : i + 1 == n ? high : low + (high - low) * i / (n - 1);
}

}  // namespace

Window::Window(const Settings& settings) : settings_(settings) {
  candidates_.reserve(std::size_t{settings.v_samples} * settings.w_samples);
  values_.reserve(candidates_.capacity());
}

double Window::way(const Situation& situation, Motion motion) const {
  double way = settings_.look_ahead;
  if (motion.v != 0) {
    for (const Point& point : situation.obstacles)
      way = std::min(way, free_way(motion.v, motion.w, point, settings_.radius));
    return way;
  }
  double s, c;
  wend::math::sincos(turned(motion.w), s, c);
  for (const Point& p : situation.obstacles)
    way = std::min(way, free_way(1, 0, {c * p.x + s * p.y, c * p.y - s * p.x}, settings_.radius));
  return way;
}

double Window::turned(double w) const noexcept {
  return w * settings_.period + w * std::fabs(w) / (2 * settings_.turn_acceleration);
}

Candidate Window::judge(const Situation& situation, Motion m) const {
  Candidate candidate{m, way(situation, m), true, 0};
  if (m.v != 0)
    candidate.admissible =
        stops(m.v, settings_.acceleration, settings_.period, candidate.way) &&
        stops(m.w, settings_.turn_acceleration, settings_.period, candidate.way * std::fabs(m.w / m.v));
  if (settings_.turn_radius > 0 && std::fabs(m.v) < std::fabs(m.w) * settings_.turn_radius * (1 - 1e-9))
    candidate.admissible = false;
  if (!candidate.admissible) return candidate;
  const Point at = after(m, settings_.period);
  double s, c;
  wend::math::sincos(situation.goal_bearing, s, c);
  const double to_goal = wend::math::atan2(situation.goal_distance * s - at.y, situation.goal_distance * c - at.x);
  const double heading = 1 - std::fabs(wend::math::wrap_angle(to_goal - turned(m.w))) / wend::math::pi;
  candidate.value = settings_.alpha * heading + settings_.beta * candidate.way / settings_.look_ahead +
                    settings_.gamma * std::max(m.v, 0.0) / settings_.speed_high;
  return candidate;
}

std::span<const Candidate> Window::search(const Situation& situation) {
  const double dv = settings_.acceleration * settings_.period, dw = settings_.turn_acceleration * settings_.period;
  const auto [v, w] = situation.now;
  const double v_high = std::clamp(v + dv, settings_.speed_low, settings_.speed_high);
  const double v_low = std::clamp(v - dv, settings_.speed_low, v_high);
  const double w_high = std::clamp(w + dw, -settings_.turn_rate, settings_.turn_rate);
  const double w_low = std::clamp(w - dw, -settings_.turn_rate, w_high);
  candidates_.clear();
  for (std::uint32_t i = 0; i < settings_.v_samples; ++i)
    for (std::uint32_t j = 0; j < settings_.w_samples; ++j)
      candidates_.push_back(judge(
          situation, {sample(v_low, v_high, i, settings_.v_samples), sample(w_low, w_high, j, settings_.w_samples)}));
  smooth();
  return candidates_;
}

std::span<const Candidate> Window::search(const Situation& situation, std::span<const Motion> motions) {
  candidates_.clear();
  for (const Motion& motion : motions) candidates_.push_back(judge(situation, motion));
  return candidates_;
}

void Window::smooth() {
  const int rows = static_cast<int>(settings_.v_samples), columns = static_cast<int>(settings_.w_samples);
  values_.clear();
  for (const Candidate& candidate : candidates_) values_.push_back(candidate.value);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      double sum = 0;
      int n = 0;
      for (int a = std::max(i - 1, 0); a <= std::min(i + 1, rows - 1); ++a)
        for (int b = std::max(j - 1, 0); b <= std::min(j + 1, columns - 1); ++b) sum += values_[a * columns + b], ++n;
      Candidate& candidate = candidates_[i * columns + j];
      if (candidate.admissible) candidate.value = sum / n;
    }
}

}  // namespace dwa
