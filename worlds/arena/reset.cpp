// The arena's beginning of an episode: the scene, movers' phases, starts and goals.
#include "world.hpp"

namespace arena {
namespace {

constexpr int most_tries = 2000;  // places tried for one start or goal
constexpr int most_ways = 40;     // pairs of start and goal tried until a way leads from one to the other

double distance(double ax, double ay, double bx, double by) noexcept {
  const double dx = ax - bx, dy = ay - by;
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace

Place::Place(std::uint64_t k, std::uint32_t v, const ScenePtr& scene) : key(k), variant(v), map(scene) {
  for (const Mover& mover : scene->movers) movers.emplace_back(mover, *scene);
  for (const Goal& goal : scene->goals) goals.emplace_back(goal.waypoints, goal.speed, Point{goal.x, goal.y});
  for (const Track& goal : goals) moving_goals = moving_goals || goal.moves();
  fields.resize(scene->goals.size());
}

// Equal keys are equal scenes, so the last few are kept: as many as there are copies, and some.
std::shared_ptr<Place> World::place_for(const wend_episode& episode) {
  const std::uint64_t key = source_.drawn() ? episode.scene : 0;
  const std::uint32_t wanted = source_.variant(episode);
  const auto variant = source_.drawn() ? 0 : static_cast<std::uint32_t>(wanted % source_.size());
  auto at = std::find_if(places_.begin(), places_.end(),
                         [&](const auto& place) { return place->key == key && place->variant == variant; });
  if (at == places_.end()) {
    if (places_.size() >= copies_.size() + 16) places_.pop_back();
    places_.push_back(std::make_shared<Place>(key, variant, make_scene(source_, episode.scene, wanted)));
    at = places_.end() - 1;
  }
  std::rotate(places_.begin(), at, at + 1);
  for (const auto& reach : reaches_) places_.front()->map.prepare(reach.load(std::memory_order_relaxed));
  return places_.front();
}

void World::reset(wend::Rows copies, wend::Episodes episodes) {
  one_map_ = false;
  for (std::size_t k = 0; k < copies.size(); ++k) reset_copy(copies[k], episodes[k]);
  one_map_ = std::all_of(maps_.begin(), maps_.end(), [this](const StaticMap* map) { return map == maps_[0]; });
}

void World::reset_copy(std::uint32_t index, const wend_episode& episode) {
  Copy& copy = copies_[index];
  Robot* robots = &rows_[std::size_t{index} * robots_];
  copy.place = place_for(episode);
  std::fill_n(maps_.begin() + std::size_t{index} * robots_, robots_, &copy.place->map);
  movers_ = movers_ || !copy.place->movers.empty();
  copy.ticks = 0;
  copy.listed = false;
  copy.movers.assign(copy.place->movers.size(), {});
  for (std::uint32_t r = 0; r < robots_; ++r) {
    robots[r] = {};
    robots[r].noise = wend::stream(wend::stream(episode.seed, "noise"), r);
  }
  put_fixed(copy, robots, episode);
  draw_phases(copy, robots, episode);
  move_movers(copy);
  for (Moving& mover : copy.movers) mover.old_x = mover.x, mover.old_y = mover.y;
  for (std::uint32_t r = 0; r < robots_; ++r) draw_robot(copy, robots, r, episode);
  for (std::uint32_t r = 0; r < robots_; ++r) begin(copy, robots[r]);
  for (std::uint32_t r = 0; r < robots_; ++r)
    for (std::uint32_t other = 0; other < robots_; ++other) {
      if (other == r) continue;
      const Robot &a = robots[r], &b = robots[other];
      robots[r].nearest =
          std::min(a.nearest, distance(a.motion.x, a.motion.y, b.motion.x, b.motion.y) - 2 * options_.radius);
    }
}

// The starts and goals that the scene has.
void World::put_fixed(Copy& copy, Robot* robots, const wend_episode& episode) {
  const Scene& scene = copy.place->scene();
  for (std::uint32_t r = 0; r < robots_; ++r) {
    Robot& robot = robots[r];
    if (r < scene.starts.size()) {
      const Start& start = scene.starts[r];
      robot.motion.x = start.x, robot.motion.y = start.y, robot.motion.heading = wend::math::wrap_angle(start.heading);
      if (start.random_heading)
        robot.motion.heading = wend::Random(wend::stream(wend::stream(episode.seed, "heading"), r))
                                   .uniform(-wend::math::pi, wend::math::pi);
    }
    robot.goal_radius = options_.goal_radius;
    if (r < scene.goals.size()) {
      const Track::State at = copy.place->goals[r].at(0);
      robot.goal_x = at.x, robot.goal_y = at.y;
      if (scene.goals[r].radius > 0) robot.goal_radius = scene.goals[r].radius;
    }
  }
}

// Where patrols are at the start: nowhere on a robot that the scene has placed.
void World::draw_phases(Copy& copy, const Robot* robots, const wend_episode& episode) {
  const Scene& scene = copy.place->scene();
  const std::size_t placed = std::min<std::size_t>(robots_, scene.starts.size());
  for (std::size_t m = 0; m < scene.movers.size(); ++m) {
    const Track& track = copy.place->movers[m];
    copy.movers[m].radius = scene.movers[m].radius;
    if (!scene.movers[m].random_phase || track.cycle() == 0) continue;
    wend::Random random(wend::stream(wend::stream(episode.seed, "phase"), m));
    for (int k = 0; k < most_tries; ++k) {
      copy.movers[m].phase = random.uniform(0, track.cycle());
      const Track::State at = track.at(copy.movers[m].phase);
      const double apart = scene.movers[m].radius + options_.radius + options_.stop_distance + options_.draw_clearance;
      const bool free = std::all_of(robots, robots + placed, [&](const Robot& robot) {
        return distance(at.x, at.y, robot.motion.x, robot.motion.y) > apart;
      });
      if (free) break;
    }
  }
}

// Whether robot `r` may start at a point, or have its goal there: clear of what stands, of movers where it starts, and
// of the other robots' starts or goals that are already there.
bool World::room(const Copy& copy, const Robot* robots, std::uint32_t r, double x, double y, bool goal) const {
  const Scene& scene = copy.place->scene();
  const double around = options_.radius + options_.stop_distance + options_.draw_clearance;
  const double wall = from_bounds(x, y, scene.x, scene.y, scene.x + scene.width, scene.y + scene.height);
  if (wall <= around || copy.place->map.clearance(x, y) <= around) return false;
  if (!goal)
    for (const Moving& mover : copy.movers)
      if (distance(x, y, mover.x, mover.y) <= around + mover.radius) return false;
  const std::size_t fixed = goal ? scene.goals.size() : scene.starts.size();
  for (std::uint32_t other = 0; other < robots_; ++other) {
    if (other == r || (other > r && other >= fixed)) continue;  // not placed yet
    const Robot& robot = robots[other];
    const double apart = around + options_.radius + (goal ? std::max(robot.goal_radius, robots[r].goal_radius) : 0);
    const double ox = goal ? robot.goal_x : robot.motion.x, oy = goal ? robot.goal_y : robot.motion.y;
    if (distance(x, y, ox, oy) <= apart) return false;
  }
  return true;
}

// Distances to robot r's goal; `own` where the goal is the scene's, whose field is kept.
std::shared_ptr<const DistanceField> World::field_to(Place& place, const Robot& robot, std::uint32_t r, bool own) {
  if (own && place.fields[r]) return place.fields[r];
  if (!place.space) {
    const Scene& scene = place.scene();
    std::vector<Point> also;
    for (const Start& start : scene.starts) also.push_back({start.x, start.y});
    for (const Goal& goal : scene.goals) also.push_back({goal.x, goal.y});
    const double cell = options_.optimal_cell > 0 ? options_.optimal_cell : suitable_cell(scene, options_.radius);
    place.space = std::make_shared<FreeSpace>(scene, cell, options_.radius, also);
  }
  // To the goal's centre; to its rim where the body cannot stand on the centre.
  const Point goal{robot.goal_x, robot.goal_y};
  const std::ptrdiff_t cell = place.space->index(goal);
  const bool stands = cell >= 0 && place.space->free(static_cast<std::size_t>(cell));
  auto field = std::make_shared<const DistanceField>(place.space, goal, stands ? 0 : robot.goal_radius);
  if (own) place.fields[r] = field;
  return field;
}

// The start and the goal that the scene leaves open for robot r, so that a way leads from one to the other; and the
// length of that way.
void World::draw_robot(Copy& copy, Robot* robots, std::uint32_t r, const wend_episode& episode) {
  Place& place = *copy.place;
  const Scene& scene = place.scene();
  Robot& robot = robots[r];
  robot.optimal = std::numeric_limits<double>::quiet_NaN();
  const bool draw_start = r >= scene.starts.size(), draw_goal = r >= scene.goals.size();
  if (!draw_start && !draw_goal) {
    if (!options_.optimal || place.goals[r].moves()) return;
    const double known = r == 0 ? scene.optimal_length : -1;
    const double length =
        known >= 0 ? known : field_to(place, robot, r, true)->length({robot.motion.x, robot.motion.y});
    if (length >= 0) robot.optimal = length;
    return;
  }
  wend::Random random(wend::stream(wend::stream(episode.seed, "place"), r));
  const auto draw = [&](bool goal, double& x, double& y) {
    for (int k = 0; k < most_tries; ++k) {
      x = random.uniform(scene.x, scene.x + scene.width), y = random.uniform(scene.y, scene.y + scene.height);
      if (room(copy, robots, r, x, y, goal)) return true;
    }
    return false;
  };
  for (int way = 0; way < most_ways; ++way) {
    const auto apart = [&] { return distance(robot.motion.x, robot.motion.y, robot.goal_x, robot.goal_y); };
    bool found = true;
    int k = 0;
    do {
      found = (!draw_start || draw(false, robot.motion.x, robot.motion.y)) &&
              (!draw_goal || draw(true, robot.goal_x, robot.goal_y));
    } while (found && apart() < options_.draw_distance && ++k < most_tries);
    if (!found || apart() < options_.draw_distance) break;
    const double length = field_to(place, robot, r, !draw_goal)->length({robot.motion.x, robot.motion.y});
    if (length < 0) continue;
    if (draw_start) robot.motion.heading = random.uniform(-wend::math::pi, wend::math::pi);
    if (options_.optimal && (draw_goal || !place.goals[r].moves())) robot.optimal = length;
    return;
  }
  throw wend::parameter_error(
      "draw", "no start and goal found for robot " + std::to_string(r) + " in the scene \"" + scene.name +
                  "\": expected a free way for a body of radius " + std::to_string(options_.radius) + " m with " +
                  std::to_string(options_.draw_clearance) + " m of clearance, " +
                  std::to_string(options_.draw_distance) +
                  " m or more from start to goal; lower draw/clearance or draw/distance, or give starts and goals");
}

void World::begin(Copy& copy, Robot& robot) {
  const double x = robot.motion.x, y = robot.motion.y;
  robot.old_x = x, robot.old_y = y;
  robot.at_least = std::min(copy.place->map.clearance(x, y), copy.place->map.clearance_wall(x, y));
  robot.nearest = robot.at_least - options_.radius;
  for (const Moving& mover : copy.movers)
    robot.nearest = std::min(robot.nearest, distance(x, y, mover.x, mover.y) - mover.radius - options_.radius);
}

}  // namespace arena
