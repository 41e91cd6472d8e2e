// Where the rays of a range sensor point.
#include "beams.hpp"

#include <bit>
#include <wend/math.hpp>
#include <wend/random.hpp>

namespace range {

std::vector<double> spread_deg(std::uint32_t beams, double field_deg) {
  std::vector<double> bearings(beams);
  for (std::uint32_t k = 0; k < beams; ++k) {
    if (field_deg >= 360) {
      const double turned = 360.0 * k / beams;
      bearings[k] = turned < 180 ? turned : turned - 360;
    } else {
      bearings[k] = beams == 1 ? 0 : field_deg * ((beams - 1) - 2.0 * k) / (2.0 * (beams - 1));
    }
  }
  return bearings;
}

std::vector<double> cone_deg(double opening_deg, std::uint32_t rays) {
  if (opening_deg <= 0 || rays == 1) return {0};
  std::vector<double> offsets(rays);
  for (std::uint32_t j = 0; j < rays; ++j) offsets[j] = opening_deg * (2.0 * j - (rays - 1)) / (2.0 * (rays - 1));
  return offsets;
}

Beams::Beams(const std::vector<double>& axes_deg, double opening_deg, std::uint32_t rays) {
  const auto radians = [](double deg) {  // quarters of a circle stay exact
    while (deg >= 180) deg -= 360;
    while (deg < -180) deg += 360;
    return deg / 180 * wend::math::pi;
  };
  const std::vector<double> offsets = cone_deg(opening_deg, rays);
  for (const double axis : axes_deg) {
    bearings_.push_back(radians(axis));
    for (const double offset : offsets) {
      Ray ray{radians(axis + offset), 0, 0};
      wend::math::sincos(ray.bearing, ray.sin, ray.cos);
      rays_.push_back(ray);
    }
  }
}

std::uint64_t Beams::fingerprint() const noexcept {
  std::uint64_t key = wend::stream(0, rays_.size());
  for (const Ray& ray : rays_) key = wend::stream(key, std::bit_cast<std::uint64_t>(ray.bearing));
  return key;
}

}  // namespace range
