// Learning curves of one training, in bounded memory: neighbouring points are averaged when there are too many.
#pragma once
#include <core/experiment/unit.hpp>

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace wend::core {

class CurveBook {
 public:
  // NaN means "does not apply" and is left out.
  void add(const std::string& metric, const std::string& x_name, std::optional<std::uint32_t> robot, double x, double y);
  std::vector<Curve> take();

 private:
  static constexpr std::size_t most_points = 400;
  struct Bin {
    double x = 0, sum = 0;  // x of the last point in it
    std::uint64_t n = 0;
  };
  struct Line {
    std::vector<Bin> bins;
    std::uint64_t per_bin = 1;
  };
  std::map<std::tuple<std::string, std::string, std::optional<std::uint32_t>>, Line> lines_;
};

}  // namespace wend::core
