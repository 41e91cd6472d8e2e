// From observation columns to a Percept.
#pragma once
#include <span>
#include <string>
#include <vector>
#include <wend/config.hpp>
#include <wend/reading.hpp>

#include "percept.hpp"

namespace rolling_window {

class Reader {
 public:
  Reader() = default;
  // `needs_pose`: throws where the pose is missing.  Without one, a percept lies in the robot's own frame.
  Reader(const wend::Config& config, double body, bool needs_pose);

  void read(std::span<const double> observation, Percept& percept) const;

 private:
  static void read_beams(const wend::Reading& from, std::span<const double> observation, double heading,
                         std::vector<Beam>& beams);

  wend::Reading window_, sonar_, distance_, bearing_, radius_;
  std::vector<wend::Reading> pose_;  // x, y, heading, speed, turn_rate; or none
  bool own_sonar_ = false;
  double body_ = 0;
};

}  // namespace rolling_window
