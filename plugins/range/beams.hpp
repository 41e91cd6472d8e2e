// Where the rays of a range sensor point: axes, each with the rays of its cone.
#pragma once
#include <cstdint>
#include <vector>

namespace range {

struct Ray {
  double bearing;   // rad, relative to the heading
  double cos, sin;  // of the bearing
};

// Bearings in degrees of `beams` axes over a field of view, each in [-180, 180).  A full circle starts ahead and runs
// counter-clockwise; less runs from left to right with both ends.
std::vector<double> spread_deg(std::uint32_t beams, double field_deg);

// Offsets in degrees of the rays of a cone from its axis; one ray where the cone has no width.
std::vector<double> cone_deg(double opening_deg, std::uint32_t rays);

class Beams {
 public:
  Beams(const std::vector<double>& axes_deg, double opening_deg, std::uint32_t rays);

  std::size_t axes() const noexcept { return bearings_.size(); }
  double bearing(std::size_t axis) const noexcept { return bearings_[axis]; }  // rad, in [-pi, pi)
  std::size_t rays_per_axis() const noexcept { return rays_.size() / bearings_.size(); }
  const std::vector<Ray>& rays() const noexcept { return rays_; }  // axis by axis

  // The same for equal layouts only: keys the noise, so that two sensors of a robot err independently.
  std::uint64_t fingerprint() const noexcept;

 private:
  std::vector<double> bearings_;
  std::vector<Ray> rays_;
};

}  // namespace range
