// Khatib 1986, equations of the attractive and the repulsive force.
#include "field.hpp"

#include <algorithm>
#include <wend/math.hpp>

namespace potential_field {
namespace {

Force along(double bearing, double magnitude) noexcept {
  double s, c;
  wend::math::sincos(bearing, s, c);
  return {magnitude * c, magnitude * s};
}

}  // namespace

double Force::magnitude() const noexcept {
  return wend::math::hypot(x, y);
}
double Force::angle() const noexcept {
  return x == 0 && y == 0 ? 0 : wend::math::atan2(y, x);
}

Force Field::attraction(double bearing, double distance) const noexcept {
  return along(bearing, k_a * (d_star > 0 ? std::min(distance, d_star) : distance));
}

Force Field::repulsion(double bearing, double rho) const noexcept {
  if (rho >= rho_0) return {};
  rho = std::max(rho, 1e-3 * rho_0);  // contact: strong, and finite
  return along(bearing, -eta * (1 / rho - 1 / rho_0) / (rho * rho));
}

}  // namespace potential_field
