// The algorithm step by step: see ga.cpp for its symbols.
#include "planner.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <wend/math.hpp>

namespace ga {
namespace {

// Less than this share of the fitness is no improvement: mutation gets ever finer and would always find a little.
constexpr double improvement = 1e-4;

double distance(Point a, Point b) noexcept {
  const double dx = b.x - a.x, dy = b.y - a.y;
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace

Fitness Planner::judge(const Problem& problem, std::span<const Point> way_points) {
  path_.assign(1, problem.start);
  path_.insert(path_.end(), way_points.begin(), way_points.end());
  path_.push_back(problem.goal);
  Fitness fitness;
  fitness.collision = problem.grid->length_within(path_, problem.needed);
  Point from = problem.start;
  double along_x, along_y;  // direction of the last leg that had a length
  wend::math::sincos(problem.heading, along_y, along_x);
  for (const Point& to : path_) {
    const double dx = to.x - from.x, dy = to.y - from.y, length = std::sqrt(dx * dx + dy * dy);
    if (!(length > 0)) continue;
    const double turn = wend::math::atan2(along_x * dy - along_y * dx, along_x * dx + along_y * dy);
    fitness.length += length;
    fitness.turning += turn * turn;
    along_x = dx, along_y = dy, from = to;
  }
  fitness.total = fitness.length + settings_.collision * fitness.collision + settings_.smoothness * fitness.turning;
  return fitness;
}

Plan Planner::plan(const Problem& problem, wend::Random random, std::span<const Point> known,
                   const std::function<void(std::size_t, double)>& told) {
  const Area& area = problem.grid->area();
  const double side = std::max(area.x1 - area.x0, area.y1 - area.y0);
  parents_.assign(settings_.population * settings_.way_points, {});
  children_ = parents_;
  fitness_.assign(settings_.population, {});
  draw_first(problem, random, known);
  evaluate(problem, 0);
  sort();
  double best = fitness_[0].total;
  std::size_t generation = 0, idle = 0;
  if (told) told(generation, best);
  while (generation < settings_.generations && idle < settings_.patience) {
    const double progress = static_cast<double>(generation) / static_cast<double>(settings_.generations);
    const double sigma = side * (settings_.sigma_first + progress * (settings_.sigma_last - settings_.sigma_first));
    breed(problem, random, sigma);
    evaluate(problem, settings_.elites);
    sort();
    ++generation;
    idle = fitness_[0].total < best * (1 - improvement) ? 0 : idle + 1;
    if (idle == 0) best = fitness_[0].total;
    if (told) told(generation, fitness_[0].total);
  }
  Plan plan{{problem.start}, fitness_[0], generation};
  for (const Point& point : one(parents_, 0)) plan.path.push_back(point);
  plan.path.push_back(problem.goal);
  return plan;
}

// Way-points anywhere in the area.
void Planner::draw_first(const Problem& problem, wend::Random& random, std::span<const Point> known) {
  const Area& area = problem.grid->area();
  for (Point& point : parents_) {
    point.x = random.uniform(area.x0, area.x1);
    point.y = random.uniform(area.y0, area.y1);
  }
  if (known.size() == settings_.way_points) std::copy(known.begin(), known.end(), parents_.begin());
}

void Planner::evaluate(const Problem& problem, std::size_t first) {
  for (std::size_t k = first; k < settings_.population; ++k) fitness_[k] = judge(problem, one(parents_, k));
}

// Best first; equals keep their order.
void Planner::sort() {
  order_.resize(settings_.population);
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::size_t a, std::size_t b) { return fitness_[a].total < fitness_[b].total; });
  sorted_fitness_.resize(settings_.population);
  for (std::size_t k = 0; k < settings_.population; ++k) {
    sorted_fitness_[k] = fitness_[order_[k]];
    const auto from = one(parents_, order_[k]);
    std::copy(from.begin(), from.end(), one(children_, k).begin());
  }
  fitness_.swap(sorted_fitness_);
  parents_.swap(children_);
}

// Tournament selection: the parents are sorted, so the best of some is the lowest number.
std::size_t Planner::winner(wend::Random& random) const {
  std::uint64_t best = settings_.population;
  for (std::size_t k = 0; k < settings_.tournament; ++k) best = std::min(best, random.below(settings_.population));
  return static_cast<std::size_t>(best);
}

// The elites stay; the others are children of tournament winners, blended and mutated.
void Planner::breed(const Problem& problem, wend::Random& random, double sigma) {
  const Area& area = problem.grid->area();
  std::copy_n(parents_.begin(), settings_.elites * settings_.way_points, children_.begin());
  for (std::size_t k = settings_.elites; k < settings_.population; ++k) {
    const auto a = one(parents_, winner(random)), b = one(parents_, winner(random)), child = one(children_, k);
    const bool blends = random.chance(settings_.crossover);
    for (std::size_t g = 0; g < settings_.way_points; ++g) {
      Point point = a[g];
      if (blends) {  // BLX-alpha (Eshelman and Schaffer 1993), each coordinate for itself
        const double low = -settings_.blend, high = 1 + settings_.blend;
        point.x += random.uniform(low, high) * (b[g].x - a[g].x);
        point.y += random.uniform(low, high) * (b[g].y - a[g].y);
      }
      if (random.chance(settings_.mutation)) {
        point.x += random.normal(0, sigma);
        point.y += random.normal(0, sigma);
      }
      child[g] = {std::clamp(point.x, area.x0, area.x1), std::clamp(point.y, area.y0, area.y1)};
    }
  }
  parents_.swap(children_);
}

std::vector<Point> rest_of(std::span<const Point> path, double from, Point here, std::size_t way_points) {
  std::vector<Point> rest;
  double way = 0;
  for (std::size_t k = 1; k + 1 < path.size(); ++k) {
    way += distance(path[k - 1], path[k]);
    if (way > from) rest.push_back(path[k]);
  }
  while (rest.size() < way_points) {
    const Point last = rest.empty() ? here : rest.back();
    rest.push_back({(last.x + path.back().x) / 2, (last.y + path.back().y) / 2});
  }
  return rest;
}

}  // namespace ga
