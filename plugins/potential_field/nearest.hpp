// The nearest point of every obstacle of a map: each disc, segment and polygon, and each connected patch of grid cells.
#pragma once
#include <wend/abi.h>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace potential_field {

struct Near {
  double dx, dy;    // m, from the query to the nearest point
  double distance;  // m; 0 inside
};

class Obstacles {
 public:
  // The nearest points that lie within `reach` of (x, y), in the order of the shapes; goals and robots are left out.
  // Valid until the next call.
  std::span<const Near> around(double x, double y, double reach, std::span<const wend_shape> shapes);

 private:
  void add_segment(double x, double y, const double* a, const double* b);
  void add_polygon(double x, double y, const wend_shape& polygon);
  void add_patches(double x, double y, const wend_shape& grid);
  void add(double dx, double dy, double distance);

  double reach_ = 0;
  std::vector<Near> near_;
  std::vector<std::uint8_t> visited_;  // of the cells within reach
  std::vector<std::uint32_t> open_;
};

}  // namespace potential_field
