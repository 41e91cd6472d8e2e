// The forces of Khatib's artificial potential field, in the frame of the robot (x ahead, y to the left).
#pragma once

namespace potential_field {

struct Force {
  double x = 0, y = 0;
  Force& operator+=(Force other) noexcept { return x += other.x, y += other.y, *this; }
  double magnitude() const noexcept;
  double angle() const noexcept;  // rad, relative to the heading; 0 where the forces cancel
};

struct Field {
  double k_a;     // attraction per metre of distance
  double eta;     // strength of repulsion
  double rho_0;   // m, distance of influence
  double d_star;  // m, distance to the goal beyond which attraction no longer grows; 0: it always grows

  Force attraction(double bearing, double distance) const noexcept;
  // `rho`: m, from the body's rim to the obstacle that lies at `bearing`.
  Force repulsion(double bearing, double rho) const noexcept;
};

}  // namespace potential_field
