// What an observation is to the kernels: scaled distances, the goal's direction and its distance.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>
#include <wend/config.hpp>
#include <wend/reading.hpp>

namespace lssvm {

class Features {
 public:
  explicit Features(const wend::Config& config);

  std::size_t size() const noexcept { return state_.size() + (goal_ ? 3 : 0); }
  // Throws where a value is not finite.
  void read(std::span<const double> observation, std::span<double> out) const;

  bool has_goal() const noexcept { return goal_.has_value(); }
  double goal_distance(std::span<const double> observation) const { return goal_->distance(observation); }  // m

  // What tells features of other columns or scales apart.
  std::vector<double> constants() const;

 private:
  struct Goal {
    wend::Reading distance, bearing;
  };
  wend::Reading state_;
  std::optional<Goal> goal_;
  double power_, bearing_weight_, distance_weight_, goal_reach_;
};

}  // namespace lssvm
