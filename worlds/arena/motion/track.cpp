// Track: see track.hpp.
#include "track.hpp"

#include <algorithm>
#include <cmath>

namespace arena {
namespace {

// x runs to and fro in 0..length: its place, and whether it is on its way back.
double fold(double x, double length, bool& back) noexcept {
  const double twice = 2 * length;
  x -= twice * std::floor(x / twice);
  back = x > length;
  return std::min(std::max(back ? twice - x : x, 0.0), length);
}

void bounce(double from, double velocity, double low, double high, double seconds, double& at, double& v) noexcept {
  if (velocity == 0 || high <= low) {
    at = from, v = 0;
    return;
  }
  bool back = false;
  at = low + fold(from - low + velocity * seconds, high - low, back);
  v = back ? -velocity : velocity;
}

}  // namespace

Track::Track(const std::vector<Point>& waypoints, double speed, Point rest) : speed_(speed), from_(rest) {
  for (const Point& point : waypoints) {
    double length = 0;
    if (!points_.empty()) {
      const double dx = point.x - points_.back().x, dy = point.y - points_.back().y;
      length = std::sqrt(dx * dx + dy * dy);
      if (length == 0) continue;
    }
    along_.push_back(along_.empty() ? 0 : along_.back() + length);
    points_.push_back(point);
  }
  if (!points_.empty()) from_ = points_.front();
  if (points_.size() > 1 && speed_ > 0) kind_ = Kind::patrol;
}

Track::Track(const Mover& mover, const Scene& scene) : Track(mover.waypoints, mover.speed, {mover.x, mover.y}) {
  if (!mover.waypoints.empty() || (mover.vx == 0 && mover.vy == 0)) return;
  kind_ = Kind::bounce;
  velocity_ = {mover.vx, mover.vy};
  low_ = {scene.x + mover.radius, scene.y + mover.radius};
  high_ = {scene.x + scene.width - mover.radius, scene.y + scene.height - mover.radius};
}

double Track::speed() const noexcept {
  switch (kind_) {
    case Kind::rest:
      return 0;
    case Kind::patrol:
      return speed_;
    case Kind::bounce:
      break;
  }
  return std::sqrt(velocity_.x * velocity_.x + velocity_.y * velocity_.y);
}

Track::State Track::at(double seconds) const noexcept {
  State state{from_.x, from_.y, 0, 0};
  if (kind_ == Kind::bounce) {
    bounce(from_.x, velocity_.x, low_.x, high_.x, seconds, state.x, state.vx);
    bounce(from_.y, velocity_.y, low_.y, high_.y, seconds, state.y, state.vy);
  } else if (kind_ == Kind::patrol) {
    bool back = false;
    const double s = fold(speed_ * seconds, along_.back(), back);
    std::size_t k = 1;
    while (k + 1 < along_.size() && along_[k] < s) ++k;
    const Point &a = points_[k - 1], &b = points_[k];
    const double length = along_[k] - along_[k - 1], u = (s - along_[k - 1]) / length;
    const double v = (back ? -speed_ : speed_) / length;
    state = {a.x + u * (b.x - a.x), a.y + u * (b.y - a.y), v * (b.x - a.x), v * (b.y - a.y)};
  }
  return state;
}

}  // namespace arena
