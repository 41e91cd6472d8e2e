// wend.ga: a genetic algorithm plans a way on the true map, the robot follows it.  The baseline "GA" of Li et al.,
//   "Path obstacle avoidance planning of an ALV in narrow environments, based on XCS and LS-SVM" (in Chinese),
//   section 4, which leaves every detail of it open; the operators are those of Goldberg 1989 and of Eshelman and
//   Schaffer 1993.
//
//   symbol              here                     meaning
//   chromosome          Planner, way_points      6 points in the plane between start and goal
//   f                   Fitness::total           length + collision + smoothness, to be made small
//     length            Fitness::length          m of the way start, way-points, goal
//     collision         Fitness::collision       m of it within inflated obstacles, times 100
//     smoothness        Fitness::turning         sum of squared turns, rad^2, times `smoothness`
//   selection           Planner::winner          tournament of 3
//   crossover           Planner::breed           BLX-alpha with probability 0.8
//   mutation            Planner::breed           each gene with 0.2, normal, its deviation annealed
//   elitism             Planner::breed           2
//   stop                Planner::plan            400 generations, or 60 without improvement
//
// Privileged: it reads the true map and the true pose.  Movers and other robots are taken as they stand when it plans.
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>
#include <wend/period.hpp>
#include <wend/plugin.hpp>

#include "follower.hpp"
#include "planner.hpp"
#include "surroundings.hpp"

namespace ga {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Settings settings_of(const wend::Params& params) {
  Settings s;
  s.way_points = params.count("way_points");
  s.population = params.count("population");
  s.tournament = params.count("tournament");
  s.elites = params.count("elites");
  s.crossover = params.number("crossover"), s.blend = params.number("blend");
  s.mutation = params.number("mutation");
  s.sigma_first = params.number("sigma/0"), s.sigma_last = params.number("sigma/1");
  s.generations = params.count("generations"), s.patience = params.count("patience");
  s.collision = params.number("collision"), s.smoothness = params.number("smoothness");
  const auto within = [&](const char* name, std::size_t value) {
    if (value <= s.population) return;
    throw wend::parameter_error(
        name, "expected at most the population, " + std::to_string(s.population) + "; found " + std::to_string(value));
  };
  within("tournament", s.tournament);
  if (s.elites >= s.population)
    throw wend::parameter_error("elites", "expected fewer than the population, " + std::to_string(s.population) +
                                              ", so that there are children; found " + std::to_string(s.elites));
  if (s.sigma_last > s.sigma_first)
    throw wend::parameter_error("sigma", "expected [first, last] with last <= first, found a last above the first");
  return s;
}

std::size_t actions_of(const wend::Space& action) {
  if (action.width() != 1 || action[0].count == 0)
    throw wend::unsupported("cannot follow a path with the actions " + action.names() +
                            ": expected one discrete action");
  return action[0].count;
}

// What a row is about.
struct Trip {
  std::uint64_t key = 0, scene = 0;
  std::uint32_t variant = 0;
  std::uint64_t steps = 0, plans = 0;
  Track track;
  ClearanceGrid grid;  // as it was when the plan was made
  double way = 0;      // m of the track that lie behind
  double off_track = none;
  Fitness planned;  // of the first plan
  std::size_t generations = 0;
  wend_motion expected{};  // after the last action
};

class Ga {
 public:
  explicit Ga(const wend::Config& config)
      : host_(config.host()),
        world_(config.use("world")),
        body_(config.use("world")),
        robots_(config.robots()),
        margin_(config.params.number("margin")),
        replan_(config.params.count("replan")),
        planner_(settings_of(config.params)),
        way_points_(config.params.count("way_points")),
        surroundings_(world_, config.robots(), config.params.number("cell"), config.params.flag("see_robots")),
        trips_(config.rows()) {
    if (!world_ || !body_) throw wend::unsupported("wend.ga needs a world with " WEND_GEOMETRY2D " and " WEND_BODY);
    follower_.emplace(body_, actions_of(config.action), wend::period_of(config.use("world")),
                      config.params.count("look_ahead"));
    episode_.box("planned_fitness", "1", 0).box("planned_length_m", "m", 0).box("planned_collision_m", "m", 0);
    episode_.box("generations", "1", 0).box("plans", "1", 0);
    step_.box("off_path", "m", 0).box("way_left", "m", 0);
  }

  void begin(wend::Rows rows, wend::Episodes episodes) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Trip& trip = trips_[rows[i]] = Trip{};
      trip.key = wend::stream(episodes[i].seed, "plans");
      trip.scene = episodes[i].scene, trip.variant = episodes[i].variant;
    }
  }

  void act(wend::Rows rows, wend::Matrix<const double>, wend::Matrix<double> actions) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::uint32_t row = rows[i];
      Trip& trip = trips_[row];
      wend_pose pose;
      wend_disc body, goal;
      world_.poses(rows.subspan(i, 1), std::span(&pose, 1));
      world_.bodies(rows.subspan(i, 1), std::span(&body, 1), std::span(&goal, 1));
      const wend_limits limits = body_.limits(row % robots_);
      const double touching = limits.radius + limits.stop_distance;
      if (trip.plans == 0 || (replan_ > 0 && trip.steps % replan_ == 0)) plan(row, trip, pose, goal, touching);

      const wend_motion now{pose.x, pose.y, pose.heading, trip.expected.speed, trip.expected.turn_rate};
      const Follower::Choice choice =
          follower_->choose(row % robots_, now, trip.track, trip.way, goal, trip.grid, touching);
      trip.off_track = trip.track.foot({pose.x, pose.y}, trip.way, trip.way).distance;
      trip.expected = choice.next;
      ++trip.steps;
      actions[i][0] = static_cast<double>(choice.action);
    }
  }

  const wend::Columns* telemetry(std::uint32_t when) const {
    return when == WEND_PER_EPISODE ? &episode_ : when == WEND_PER_STEP ? &step_ : nullptr;
  }
  void read(std::uint32_t when, wend::Rows rows, wend::Matrix<double> out) const {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Trip& trip = trips_[rows[i]];
      const bool planned = trip.plans > 0;
      if (when == WEND_PER_STEP) {
        out[i][0] = trip.off_track;
        out[i][1] = planned ? trip.track.length() - trip.way : none;
      } else {
        out[i][0] = planned ? trip.planned.total : none;
        out[i][1] = planned ? trip.planned.length : none;
        out[i][2] = planned ? trip.planned.collision : none;
        out[i][3] = planned ? static_cast<double>(trip.generations) : none;
        out[i][4] = static_cast<double>(trip.plans);
      }
    }
  }
  void explain(std::uint32_t row, wend::Writer& writer) const {
    const Trip& trip = trips_[row];
    char text[240] = "no plan yet";
    if (trip.plans > 0)
      std::snprintf(text, sizeof text,
                    "plan %llu: %.2f m left of %.2f m, %.2f m off it; first plan: fitness %.2f, %.2f m in obstacles, "
                    "%zu generations",
                    static_cast<unsigned long long>(trip.plans), trip.track.length() - trip.way, trip.track.length(),
                    trip.off_track, trip.planned.total, trip.planned.collision, trip.generations);
    writer.text(text);
  }

 private:
  // The first plan of an episode tells its fitness against generation.
  void plan(std::uint32_t row, Trip& trip, const wend_pose& pose, const wend_disc& goal, double touching) {
    trip.grid = surroundings_.of(row, trip.scene, trip.variant);
    const Problem problem{{pose.x, pose.y}, {goal.x, goal.y}, pose.heading, &trip.grid, touching + margin_};
    std::vector<Point> known;
    if (trip.plans > 0) known = rest_of(trip.track.path(), trip.way, problem.start, way_points_);
    const auto tell = [this](std::size_t generation, double best) {
      host_->series(host_, "generation", static_cast<double>(generation), "best_fitness", best);
    };
    Plan plan = planner_.plan(problem, wend::Random(wend::stream(trip.key, trip.plans)), known,
                              trip.plans == 0 ? tell : std::function<void(std::size_t, double)>());
    if (trip.plans++ == 0) trip.planned = plan.fitness, trip.generations = plan.generations;
    trip.track = Track(std::move(plan.path));
    trip.way = 0;
  }

  const wend_host* host_;
  wend::GeometryRef world_;
  wend::BodyRef body_;
  std::uint32_t robots_;
  double margin_;         // m
  std::uint64_t replan_;  // decisions; 0: never
  Planner planner_;
  std::size_t way_points_;
  Surroundings surroundings_;
  std::optional<Follower> follower_;
  std::vector<Trip> trips_;  // of each row
  wend::Columns episode_, step_;
};

}  // namespace
}  // namespace ga

WEND_PLUGIN(wend::component<ga::Ga>("wend.ga"))
