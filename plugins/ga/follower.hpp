// Follows a path with a table of actions: looks a few decisions ahead in what the body says each action does.
#pragma once
#include <vector>
#include <wend/refs.hpp>

#include "track.hpp"

namespace ga {

class Follower {
 public:
  // `period`: s between two decisions; `steps` of them are looked ahead, fewer where that would be too many sequences.
  Follower(wend::BodyRef body, std::size_t actions, double period, std::size_t steps);

  struct Choice {
    std::size_t action;
    wend_motion next;  // where it leads
  };
  // The first action of the best sequence; among equals the lowest.  `way` is what is behind, m, and is brought up to
  // date.  Sequences that come nearer than `needed` to what the grid knows, m, are the last resort.
  Choice choose(std::uint32_t robot, const wend_motion& now, const Track& track, double& way, const wend_disc& goal,
                const ClearanceGrid& grid, double needed);

  std::size_t depth() const noexcept { return depth_; }
  double advance() const noexcept { return advance_; }  // m: the farthest that one action leads

 private:
  struct Node {
    wend_motion motion;
    double cost = 0;        // in units of the farthest advance
    std::size_t first = 0;  // action at the root
    bool arrived = false;
  };
  void extend(std::uint32_t robot);
  void judge(Node& node, const Track& track, double way, const wend_disc& goal, const ClearanceGrid& grid,
             double needed) const;
  double left_over(const Node& node, const Track& track, double way) const;

  wend::BodyRef body_;
  std::size_t actions_, depth_ = 1;
  double period_, advance_ = 0;
  std::vector<Node> nodes_, next_;
  std::vector<double> columns_;  // the action rows of a level
  std::vector<wend_motion> from_, to_;
};

}  // namespace ga
