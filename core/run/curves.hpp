// Curves of one training or test, in bounded memory: neighbouring points are averaged when there are too many.
#pragma once
#include <core/experiment/unit.hpp>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
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

// Curves of which every one starts anew with each use, such as best fitness against generation in every planning: the
// mean over all uses, in which one that ended early keeps its last value.  The order of the uses, which differs with the
// number of episodes side by side, is of no consequence.
class SeriesBook {
 public:
  void add(const std::string& metric, const std::string& x_name, double x, double y);
  std::vector<Curve> take();

 private:
  static constexpr std::size_t most_runs = 100, most_points = 2000;  // of which more are left out
  using Points = std::vector<std::pair<double, double>>;
  using Runs = std::multiset<std::pair<std::string, Points>>;  // by hash: of too many, those with the least ones stay
  struct Series {
    Runs runs;
    Points present;  // the run that goes on
    void close();
  };
  static Points mean(const Runs& runs);
  std::map<std::pair<std::string, std::string>, Series> all_;
};

}  // namespace wend::core
