#include "navigator.hpp"

#include <algorithm>
#include <cmath>
#include <wend/math.hpp>

namespace rolling_window {
namespace {

double distance(Point a, Point b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

// A plan must leave some room; where that finds none, less and less of it, and at last a body that is a little smaller:
// noise and drift close gaps that are open.
constexpr double rooms[] = {1, 0.4, 0};
constexpr double shrunk = 0.92;
constexpr double goal_share = 0.9;  // of the goal's radius, to arrive for sure
constexpr double room_around =
    10;  // body radii around robot and goal that plans may use; up to four times that if they fail
constexpr std::uint32_t stuck = 6;            // decisions without driving
constexpr std::uint32_t longest_escape = 25;  // decisions
constexpr double escape_share = 0.3;          // of the top speed
constexpr double aligned = 8 * wend::math::degree;
constexpr std::uint32_t longest_wait = 32;  // steps until a plan that was not found is looked for again

}  // namespace

Navigator::Navigator(const NavigatorSettings& settings, const wend::Steer& steer, wend::BodyRef body)
    : settings_(settings), steer_(steer), chooser_(settings.radius, settings.candidates) {
  if (!steer.discrete()) filter_ = SafetyFilter(steer.limits(), steer.period(), settings.top_speed);
  pursuit_.look_ahead = settings.look_ahead;
  if (settings.planner == Planner::turn_radius)
    lattice_ = TurnRadiusPlanner(
        Motions(steer, body, settings.grid.cell, settings.lattice.headings, settings.top_speed), settings.lattice);
}

Course Navigator::start() const {
  Course course;
  course.memory = GridMemory(settings_.grid);
  return course;
}

void Navigator::begin(Course& course, bool samples) const {
  course.plain = samples && settings_.sample_with_window;
  course.memory.clear();
  course.plan.clear(), course.path.clear();
  course.subgoal = {};
  course.plan_at = course.path_at = 0, course.plan_age = 0, course.standing = course.overdue = course.escaping = 0;
  course.padding = room_around * steer_.limits().radius;
  course.patience = 0;
  course.inflation_of_distance = -1;
  course.planned = course.avoids = false;
  course.steps = course.avoided = course.replans = 0;
}

void Navigator::decide(Course& course, bool may_avoid, std::span<double> action) {
  look_for_goal(course);
  if (settings_.memory && !course.plain) remember(course);
  if (settings_.planner != Planner::none && !course.plain) plan(course);
  choose_subgoal(course);
  // A plan is driven as it stands, and was found free.
  const bool steers = settings_.driven_corridor && !course.planned;
  course.avoids =
      may_avoid && settings_.switching.avoids(course.percept, course.subgoal.at, steers ? &steer_ : nullptr);
  ++course.steps;
  if (course.avoids) {
    ++course.avoided;
    course.planned = false;  // the robot leaves the plan
  } else {
    drive(course, action);
  }
}

// Who believes to be at the goal and has not arrived has drifted: the goal is looked for along a spiral.
void Navigator::look_for_goal(Course& course) const {
  Percept& percept = course.percept;
  if (course.overdue == 0 && percept.goal_distance > 0.5 * percept.goal_radius) return;
  const double turns = 0.1 * ++course.overdue, away = percept.goal_radius * std::min(2.0, 0.1 * turns);
  percept.goal = {percept.goal.x + away * wend::math::cos(turns), percept.goal.y + away * wend::math::sin(turns)};
  percept.goal_distance = distance(percept.goal, percept.at());
  if (percept.goal_distance > 0)
    percept.goal_bearing =
        wend::math::wrap_angle(wend::math::atan2(percept.goal.y - percept.motion.y, percept.goal.x - percept.motion.x) -
                               percept.motion.heading);
}

// ---- memory and plans

void Navigator::remember(Course& course) const {
  const Percept& percept = course.percept;
  course.memory.observe(percept);
  const Point at = percept.at(), goal = percept.goal;
  const double pad = course.padding;
  course.memory.cover(std::min(at.x, goal.x) - pad, std::min(at.y, goal.y) - pad, std::max(at.x, goal.x) + pad,
                      std::max(at.y, goal.y) + pad);
}

void Navigator::plan(Course& course) {
  // A search that fails looks everywhere, so it is not repeated at every step.
  if (!course.planned && course.plan_age <= course.patience && course.patience > 0) {
    ++course.plan_age;
    return;
  }
  const bool holds = course.planned && course.plan_age < settings_.replan &&
                     (settings_.planner == Planner::grid ? path_holds(course) : plan_holds(course));
  ++course.plan_age;
  if (!holds) {
    ++course.replans;
    course.plan_age = 1;
    course.planned = false;
    const double body = course.percept.body + steer_.limits().stop_distance;
    course.plan.clear();
    for (const double room : rooms)
      if (!course.planned) course.planned = search(course, body, room * settings_.margin, false);
    if (!course.planned) course.planned = search(course, shrunk * body, 0, true);
    course.patience =
        course.planned || settings_.planner != Planner::grid ? 0 : std::min(longest_wait, 2 * course.patience + 1);
    if (!course.planned) course.padding = std::min(1.5 * course.padding, 4 * room_around * course.percept.body);
  }
}

void Navigator::refresh_distance(Course& course, const Passage& passage, double slack) const {
  const Percept& percept = course.percept;
  const bool same = course.map_of_distance == course.memory.version() &&
                    course.inflation_of_distance == passage.inflation &&
                    distance(course.goal_of_distance, percept.goal) < 0.5 * settings_.grid.cell &&
                    passage.start_clearance >= passage.inflation;
  if (same) return;
  course.to_goal.begin(course.memory, passage, percept.goal, goal_share * percept.goal_radius, percept.at(), slack);
  course.map_of_distance = course.memory.version();
  course.goal_of_distance = percept.goal;
  course.inflation_of_distance = passage.start_clearance >= passage.inflation ? passage.inflation : -1;
}

// One try for a body of this radius with this much room; `last`: takes what there is, if anything.
bool Navigator::search(Course& course, double body, double room, bool last) {
  const Percept& percept = course.percept;
  const bool grid = settings_.planner == Planner::grid;  // it may squeeze through, at a price; motions keep their room
  if (grid && room < settings_.margin && !last) return false;
  Passage passage{grid ? body : body + room,
                  settings_.clearance_range,
                  settings_.clearance_weight,
                  grid ? settings_.margin : 0,
                  {}};
  passage.start_at(percept.at(), course.memory.clearance(percept.motion.x, percept.motion.y), percept.body);
  course.passage = passage;
  if (grid) {
    refresh_distance(course, passage, 0);
    course.path_at = 0;
    if (!course.to_goal.path(percept.at(), course.path)) return false;
    course.path.push_back(percept.goal);  // and on to its centre: who drifts may not be where he believes
    return true;
  }
  // Cells are forgiven their rounding: the planner itself checks exact poses.
  refresh_distance(course, passage, 0.5 * settings_.grid.cell);
  const auto result = lattice_.plan(course.memory, passage, course.to_goal, percept.motion, percept.goal,
                                    goal_share * percept.goal_radius, trial_);
  if (trial_.size() > course.plan.size() || (result != TurnRadiusPlanner::Result::trapped && !trial_.empty()))
    course.plan = trial_;
  course.plan_at = 0;
  return !course.plan.empty() && (last || result != TurnRadiusPlanner::Result::trapped);
}

// The robot is where the plan expects it, and the next steps are still free.
bool Navigator::plan_holds(const Course& course) const {
  if (course.plan_at >= course.plan.size()) return false;
  const Percept& percept = course.percept;
  if (course.plan_at > 0 && steer_.discrete()) {
    const wend_motion& expected = course.plan[course.plan_at - 1].pose;
    const double heading = wend::math::wrap_angle(expected.heading - percept.motion.heading);
    if (distance({expected.x, expected.y}, percept.at()) > 0.5 * settings_.grid.cell) return false;
    if (std::fabs(heading) > wend::math::pi / static_cast<double>(settings_.lattice.headings)) return false;
  }
  const std::size_t end = std::min(course.plan.size(), course.plan_at + 3 * std::size_t{settings_.replan} + 3);
  for (std::size_t k = course.plan_at; k < end; ++k) {
    const wend_motion& pose = course.plan[k].pose;
    if (course.memory.clearance(pose.x, pose.y) < course.passage.least(pose.x, pose.y)) return false;
  }
  return true;
}

// The path near the robot is still free, and the robot near the path; moves path_at on to the nearest point.
bool Navigator::path_holds(Course& course) const {
  const Point at = course.percept.at();
  const double reach = 3 * settings_.look_ahead;
  double nearest = 1e300, gone = 0;
  for (std::size_t k = course.path_at; k < course.path.size() && gone <= settings_.look_ahead; ++k) {
    const double d = distance(course.path[k], at);
    if (d < nearest) nearest = d, course.path_at = k;
    if (k + 1 < course.path.size()) gone += distance(course.path[k], course.path[k + 1]);
  }
  if (nearest > 0.5 * settings_.look_ahead) return false;
  gone = 0;
  for (std::size_t k = course.path_at; k < course.path.size() && gone <= reach; ++k) {
    const Point& p = course.path[k];
    if (course.memory.clearance(p.x, p.y) < course.passage.least(p.x, p.y)) return false;
    if (k + 2 < course.path.size())
      gone += distance(p, course.path[k + 1]);
    else
      break;  // what stands on the goal does not spoil the path to it
  }
  return true;
}

// ---- subgoal

void Navigator::choose_subgoal(Course& course) {
  const Percept& percept = course.percept;
  if (course.planned) {
    const bool inside = percept.goal_distance <= settings_.radius && sees_straight(course, percept.goal);
    course.subgoal = {inside ? percept.goal : seen_along_path(course, settings_.radius), 0, inside, true};
    return;
  }
  const double body = percept.body + steer_.limits().stop_distance;
  const bool remembers = settings_.memory && !course.plain;
  const bool learned =
      remembers && settings_.planner == Planner::none;  // h(p) of the memory, where it is not the planner's
  if (learned) {
    Passage passage{body, settings_.clearance_range, settings_.clearance_weight, settings_.margin, {}};
    passage.start_at(percept.at(), course.memory.clearance(percept.motion.x, percept.motion.y), percept.body);
    refresh_distance(course, passage, 0.5 * settings_.grid.cell);
  }
  const auto free = [&](double ux, double uy, double length) {
    length = free_length(percept.surface, percept.at(), ux, uy, body + settings_.margin, length);
    if (!remembers) return length;
    const double step = std::max(settings_.grid.cell, 0.1 * length);
    const double inside = std::min(body, course.memory.clearance(percept.motion.x, percept.motion.y));
    for (double s = step; s < length; s += step)
      if (course.memory.clearance(percept.motion.x + s * ux, percept.motion.y + s * uy) < inside) return s - step;
    return length;
  };
  course.subgoal = chooser_.choose(percept, free, [&](Point p) {
    const double straight = distance(p, percept.goal);
    if (!learned) return straight;
    const double known = course.to_goal.cost(p.x, p.y);
    return known < Passage::infinite ? known : 1e6 + straight;
  });
}

// The point of the plan that is this far along it.
Point Navigator::along_path(const Course& course, double length) const {
  Point last = course.percept.at(), at = last;
  double gone = 0;
  const auto walk = [&](Point p) {
    const double step = distance(last, p);
    if (gone + step >= length) return false;
    gone += step;
    last = at = p;
    return true;
  };
  if (settings_.planner == Planner::grid) {
    for (std::size_t k = course.path_at; k < course.path.size() && walk(course.path[k]);) ++k;
  } else {
    for (std::size_t k = course.plan_at;
         k < course.plan.size() && walk({course.plan[k].pose.x, course.plan[k].pose.y});)
      ++k;
  }
  return at;
}

// ---- driving

bool Navigator::sees_straight(const Course& course, Point to) const {
  const Point at = course.percept.at();
  const double length = distance(at, to), step = 0.5 * settings_.grid.cell;
  for (double s = step; s < length; s += step) {
    const double x = at.x + (to.x - at.x) * s / length, y = at.y + (to.y - at.y) * s / length;
    if (course.memory.clearance(x, y) < course.passage.least(x, y)) return false;
  }
  return true;
}

// The farthest point of the plan within this length whose straight way is free.
Point Navigator::seen_along_path(const Course& course, double length) const {
  Point to = along_path(course, length);
  while (length > 2 * settings_.grid.cell && !sees_straight(course, to)) to = along_path(course, length *= 0.8);
  return to;
}

void Navigator::drive(Course& course, std::span<double> action) {
  const Percept& percept = course.percept;
  if (course.planned && settings_.planner == Planner::turn_radius && steer_.discrete()) {
    const PlannedStep& step = course.plan[course.plan_at++];
    action[0] = lattice_.motions().all[step.motion].action[0];
    return;
  }
  const Point to = course.planned ? seen_along_path(course, settings_.look_ahead) : course.subgoal.at;
  if (steer_.discrete()) {
    const double dx = to.x - percept.motion.x, dy = to.y - percept.motion.y;
    const double bearing =
        dx == 0 && dy == 0 ? percept.goal_bearing : wend::math::atan2(dy, dx) - percept.motion.heading;
    steer_.towards(bearing, wend::Steer::as_fast_as_possible, action);
    return;
  }
  if (course.planned && settings_.planner == Planner::turn_radius) ++course.plan_at;
  const Drive drive = pursue(course, to);
  steer_.drive(drive.speed, drive.turn_rate, action);
}

// Continuous actions: pursuit of the point, or of the way out where the robot is wedged, made safe.
Drive Navigator::pursue(Course& course, Point to) const {
  const Percept& percept = course.percept;
  const GridMemory* memory = settings_.memory && !course.plain ? &course.memory : nullptr;
  Pursuit pursuit = pursuit_;
  if (settings_.filter && course.escaping == 0 && course.standing >= stuck) {
    // Wedged: no arc is free, but there may be a straight way off once the robot has turned to it.
    const double bearing = wend::math::atan2(to.y - percept.motion.y, to.x - percept.motion.x) - percept.motion.heading;
    const double out = percept.motion.heading + filter_.way_out(percept, memory, settings_.safety_margin, bearing);
    course.escape = {percept.motion.x + percept.body * wend::math::cos(out),
                     percept.motion.y + percept.body * wend::math::sin(out)};
    course.escaping = longest_escape;
  }
  if (course.escaping > 0) {
    --course.escaping;
    to = course.escape;
    pursuit.turn_in_place = aligned;
    if (distance(percept.at(), course.escape) < 0.5 * percept.body) course.escaping = 0;
  }
  Drive wanted =
      pursuit.towards(percept, to, steer_.limits(),
                      course.escaping > 0 ? escape_share * settings_.top_speed : settings_.top_speed, steer_.period());
  const bool wants_to_drive = wanted.speed > 0;  // who only turns does not stand
  if (settings_.filter) {
    // Who stands for long gives up more and more of the margin.
    const double margin = settings_.safety_margin * std::max(0.3, 1 - course.standing / 7.0);
    wanted = filter_.nearest_safe(percept, memory, margin, wanted);
  }
  if (std::fabs(wanted.speed) >= 0.02 * settings_.top_speed)
    course.standing -= course.standing > 0;
  else if (wants_to_drive)
    course.standing += course.standing < 10;
  return wanted;
}

std::string Navigator::explain(const Course& course) const {
  const auto number = [](double x) {
    std::string text = std::to_string(x);
    return text.substr(0, text.find('.') + 3);
  };
  std::string text = course.avoids ? "avoids" : course.planned ? "follows its plan" : "seeks the subgoal";
  text += ": subgoal (" + number(course.subgoal.at.x) + ", " + number(course.subgoal.at.y) + ") m";
  if (course.subgoal.is_goal) text += ", which is the goal";
  if (!course.subgoal.free) text += ", no free point on the rim";
  if (settings_.planner == Planner::turn_radius && course.planned)
    text += "; " + std::to_string(course.plan.size() - std::min(course.plan_at, course.plan.size())) + " steps planned";
  return text + "; avoided in " + std::to_string(course.avoided) + " of " + std::to_string(course.steps) + " steps";
}

}  // namespace rolling_window
