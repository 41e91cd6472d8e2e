// Learning curves over seeds: one mean with a band out of several trainings' own curves.
#pragma once
#include <core/base/json.hpp>
#include <core/stats/bootstrap.hpp>
#include <utility>
#include <vector>

namespace wend::core {

using Points = std::vector<std::pair<double, double>>;  // x, y

constexpr std::size_t most_curve_points = 500;

// [[x, mean, low, high], ...] at the union of all x; each seed counts from its first point on and keeps its last value.
// Points that are not finite are left out; a longer union is thinned evenly, first and last kept.
Json aggregate(const std::vector<Points>& seeds, const BootstrapOptions& options = {10'000, 10'000'000});

}  // namespace wend::core
