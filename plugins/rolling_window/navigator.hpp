// One decision of a row: remembers, plans, chooses the subgoal, asks the switch, and drives unless the switch says
// avoid.
#pragma once
#include <cstdint>
#include <string>
#include <vector>
#include <wend/steer.hpp>

#include "goal_distance.hpp"
#include "grid_memory.hpp"
#include "passage.hpp"
#include "percept.hpp"
#include "pursuit.hpp"
#include "safety_filter.hpp"
#include "subgoal.hpp"
#include "switching.hpp"
#include "turn_radius_planner.hpp"

namespace rolling_window {

enum class Planner { none, grid, turn_radius };

struct NavigatorSettings {
  bool memory = false;
  Planner planner = Planner::none;
  GridMemory::Settings grid;
  TurnRadiusPlanner::Settings lattice;
  double radius = 8;  // m, of the window
  std::size_t candidates = 72;
  Switching switching;
  bool driven_corridor = true;  // the switch looks along what seeking would drive, not straight to the subgoal
  double margin = 0.3;  // m
  double clearance_range = 3, clearance_weight = 3;
  double look_ahead = 8;  // m
  double top_speed = 1;   // m/s
  bool filter = true;
  double safety_margin = 0.2;       // m
  std::uint32_t replan = 3;         // steps
  bool sample_with_window = false;  // episodes that explore go without memory and planner
};

// What a row keeps between decisions.
struct Course {
  Percept percept;
  GridMemory memory;
  GoalDistance to_goal;
  std::vector<PlannedStep> plan;
  std::vector<Point> path;  // of planner grid: cell centres to the goal
  Subgoal subgoal;
  std::size_t plan_at = 0;
  std::uint32_t plan_age = 0;  // steps
  std::size_t path_at = 0;
  std::uint32_t standing = 0;  // decisions in a row without driving
  std::uint32_t patience = 0;  // steps to wait after a plan that was not found
  std::uint32_t overdue = 0;   // decisions since it believed to be at the goal
  std::uint32_t escaping = 0;  // decisions left of an escape, and where it leads
  Point escape;
  double padding = 0;  // m around robot and goal that the memory covers
  Passage passage;     // of the last plan
  std::uint64_t map_of_distance = 0;
  Point goal_of_distance;
  double inflation_of_distance = -1;
  bool planned = false;  // plan or path leads on
  bool avoids = false;
  bool plain = false;  // this episode goes without memory and planner
  std::uint64_t steps = 0, avoided = 0, replans = 0;
};

class Navigator {
 public:
  Navigator() = default;
  Navigator(const NavigatorSettings& settings, const wend::Steer& steer, wend::BodyRef body);

  Course start() const;                            // with its storage
  void begin(Course& course, bool samples) const;  // a new episode; `samples`: it explores, for a learner

  // From the course's percept: sets `avoids`, subgoal and plan; unless it avoids and `may_avoid`, writes the action.
  void decide(Course& course, bool may_avoid, std::span<double> action);

  std::string explain(const Course& course) const;
  const NavigatorSettings& settings() const noexcept { return settings_; }
  const wend::Steer& steer() const noexcept { return steer_; }

 private:
  void look_for_goal(Course& course) const;
  void remember(Course& course) const;
  void plan(Course& course);
  bool plan_holds(const Course& course) const;
  bool path_holds(Course& course) const;
  bool search(Course& course, double body, double room, bool last);
  void refresh_distance(Course& course, const Passage& passage, double slack) const;
  void choose_subgoal(Course& course);
  Point seen_along_path(const Course& course, double length) const;
  Point along_path(const Course& course, double distance) const;
  void drive(Course& course, std::span<double> action);
  Drive pursue(Course& course, Point to) const;
  bool sees_straight(const Course& course, Point to) const;

  NavigatorSettings settings_;
  wend::Steer steer_;
  SubgoalChooser chooser_;
  SafetyFilter filter_;
  Pursuit pursuit_;
  TurnRadiusPlanner lattice_;
  std::vector<PlannedStep> trial_;
};

}  // namespace rolling_window
