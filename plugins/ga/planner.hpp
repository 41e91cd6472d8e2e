// A genetic algorithm over ways through the plane: a chromosome is a list of way-points between start and goal.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>
#include <wend/random.hpp>

#include "clearance_grid.hpp"

namespace ga {

struct Settings {
  std::size_t way_points = 6;  // genes of a chromosome
  std::size_t population = 50, tournament = 3, elites = 2;
  double crossover = 0.8;  // probability that a child blends both parents
  double blend = 0;        // alpha of BLX-alpha: how far beyond the parents, as a share of their distance
  double mutation = 0.2;   // probability of each gene
  double sigma_first = 0.25, sigma_last = 0.01;  // of mutation, as a share of the area's longer side
  std::size_t generations = 400, patience = 60;  // stops after so many, or so many in a row without improvement
  double collision = 100, smoothness = 0.02;     // weights: a m within inflated obstacles; a rad^2 of turning
};

struct Problem {
  Point start, goal;
  double heading;  // rad, at the start
  const ClearanceGrid* grid;
  double needed;  // m of clearance of the body's centre: obstacles are inflated by so much
};

// Fitness, to be made small, and its parts.
struct Fitness {
  double length = 0;     // m
  double collision = 0;  // m within inflated obstacles
  double turning = 0;    // rad^2: the sum of squared turns, the first one from the heading at the start
  double total = 0;
};

struct Plan {
  std::vector<Point> path;  // start, way-points, goal
  Fitness fitness;
  std::size_t generations = 0;
};

class Planner {
 public:
  explicit Planner(const Settings& settings) : settings_(settings) {}

  // `known` (way-points, or empty) joins the first generation.  `told` hears of every generation's best fitness.
  Plan plan(const Problem& problem, wend::Random random, std::span<const Point> known,
            const std::function<void(std::size_t generation, double best)>& told);

  Fitness judge(const Problem& problem, std::span<const Point> way_points);

 private:
  using Chromosomes = std::vector<Point>;  // population x way_points
  std::span<Point> one(Chromosomes& all, std::size_t k) const noexcept {
    return std::span(all).subspan(k * settings_.way_points, settings_.way_points);
  }
  void draw_first(const Problem& problem, wend::Random& random, std::span<const Point> known);
  void evaluate(const Problem& problem, std::size_t first);
  void breed(const Problem& problem, wend::Random& random, double sigma);
  std::size_t winner(wend::Random& random) const;
  void sort();

  Settings settings_;
  Chromosomes parents_, children_;
  std::vector<Point> path_;  // of the one that is judged
  std::vector<Fitness> fitness_, sorted_fitness_;
  std::vector<std::size_t> order_;
};

// The way-points of a path that lie beyond arc length `from`, brought to a number by halving the last leg (which begins
// `here` if there is no other).
std::vector<Point> rest_of(std::span<const Point> path, double from, Point here, std::size_t way_points);

}  // namespace ga
