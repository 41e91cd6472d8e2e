// Hybrid A* (Dolgov, Thrun, Montemerlo, Diebel 2010) over the robot's own motions: poses stay continuous, one is kept
// for each cell and heading, the distance to the goal over the memory guides.
#pragma once
#include <cstdint>
#include <vector>

#include "goal_distance.hpp"
#include "motions.hpp"

namespace rolling_window {

struct PlannedStep {
  std::size_t motion = 0;  // of Motions::all
  wend_motion pose{};      // after the step
};

class TurnRadiusPlanner {
 public:
  struct Settings {
    std::size_t headings = 24;
    std::size_t expansions = 3000;
    double horizon = 30;  // m
  };
  enum class Result {
    reached,
    open,
    trapped
  };  // the goal or the horizon; the budget ended; every way ends in a collision

  TurnRadiusPlanner() = default;
  TurnRadiusPlanner(Motions motions, const Settings& settings) : motions_(std::move(motions)), settings_(settings) {}

  // Writes the steps of the best plan from `start`: none where every motion collides at once.
  Result plan(const GridMemory& memory, const Passage& passage, GoalDistance& to_goal, const wend_motion& start,
              Point goal, double goal_radius, std::vector<PlannedStep>& steps);

  const Motions& motions() const noexcept { return motions_; }
  std::size_t expanded() const noexcept { return expanded_; }

 private:
  struct Node {
    double x, y, heading, g, h;
    std::int32_t parent;
    std::int32_t motion;
    bool closed;
  };
  struct Entry {
    double f;
    std::int32_t node;
  };
  struct Best {  // of one cell and heading
    std::uint64_t key = 0;
    std::uint32_t generation = 0;
    std::int32_t node = 0;
  };
  Best& slot(std::uint64_t key);
  std::uint64_t key(const GridMemory& memory, double x, double y, double heading) const;
  void push(const Node& node, const GridMemory& memory);
  void expand(std::int32_t from, const GridMemory& memory, const Passage& passage, GoalDistance& to_goal);
  void trace(std::int32_t node, std::vector<PlannedStep>& steps);
  static double guide(GoalDistance& to_goal, const GridMemory& memory, double x, double y);

  Motions motions_;
  Settings settings_;
  std::size_t expanded_ = 0;
  std::uint32_t generation_ = 0;
  std::vector<Node> nodes_;
  std::vector<Entry> open_;
  std::vector<Best> table_;
  std::vector<std::int32_t> chain_;
};

}  // namespace rolling_window
