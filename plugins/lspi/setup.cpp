#include "setup.hpp"

#include <cmath>
#include <wend/math.hpp>

namespace lspi {
namespace {

constexpr double most_weights = 4096;  // A has their square: 128 MB

std::string quoted(const wend_column& column) {
  return "column \"" + std::string(column.name) + "\"";
}

std::vector<std::vector<double>> centres_of(const wend::Params& params, std::size_t columns) {
  const std::size_t found = params.size("centres");
  if (found != columns)
    throw wend::parameter_error("centres", "expected one list of centres for each of the " + std::to_string(columns) +
                                               " columns of the state, found " + std::to_string(found));
  std::vector<std::vector<double>> centres;
  for (std::size_t i = 0; i < columns; ++i) centres.push_back(params.numbers(wend::Params::element("centres", i)));
  return centres;
}

std::vector<Range> ranges_of(const wend::Reading& state) {
  std::vector<Range> ranges;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const wend_column& column = state.column(i);
    if (!std::isfinite(column.low) || !std::isfinite(column.high) || column.low >= column.high)
      throw wend::parameter_error("observe", quoted(column) +
                                                 ": expected a finite range to scale to [-1, 1], found none; " +
                                                 "take another column or basis rbf");
    ranges.push_back({column.low, column.high});
  }
  return ranges;
}

void check_size(const std::string& parameter, double features, std::uint32_t actions) {
  if (!(features * actions <= most_weights))
    throw wend::parameter_error(parameter, "expected at most " + std::to_string(static_cast<int>(most_weights)) +
                                               " weights, found " + std::to_string(static_cast<long long>(features)) +
                                               " features for each of " + std::to_string(actions) +
                                               " actions; take fewer columns, a lower degree or fewer centres");
}

}  // namespace

std::uint32_t count_actions(const wend::Space& action) {
  if (action.width() != 1)
    throw wend::unsupported("expected one column of discrete actions, found " + std::to_string(action.width()) +
                            " columns; give the robot an action table");
  if (action[0].count == 0)
    throw wend::unsupported("expected discrete actions, found the continuous " + quoted(action[0]) +
                            "; give the robot an action table");
  if (action[0].count < 2 || action[0].count > most_weights)
    throw wend::unsupported("expected 2.." + std::to_string(static_cast<int>(most_weights)) +
                            " actions to choose from, found " + std::to_string(action[0].count));
  return static_cast<std::uint32_t>(action[0].count);
}

std::unique_ptr<Basis> make_basis(const wend::Params& params, const wend::Reading& state, std::uint32_t actions) {
  const std::string kind = params.text("basis");
  double features = 1;
  if (kind == "rbf") {
    auto centres = centres_of(params, state.size());
    for (const auto& of_column : centres) features *= static_cast<double>(of_column.size());
    check_size("centres", 1 + features, actions);
    return gaussians(std::move(centres), params.number("width"));
  }
  const std::size_t n = state.size(), degree = params.count("degree");
  if (kind == "quartic") {
    for (std::size_t d = 1; d <= degree; ++d) features *= static_cast<double>(n + d) / static_cast<double>(d);
    check_size("degree", std::round(features), actions);
    return monomials(ranges_of(state), degree);
  }
  check_size("degree", static_cast<double>(1 + n * degree), actions);
  return powers(ranges_of(state), degree);
}

Memory::Mirror find_mirror(const wend::Params& params, const wend::Reading& state, std::uint32_t actions) {
  Memory::Mirror mirror;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const wend_column& column = state.column(i);
    std::vector<std::uint32_t> partners;
    for (std::uint32_t k = 0; k < state.size(); ++k)
      if (std::fabs(wend::math::wrap_angle(state.bearing(k) + column.at)) < 1e-9) partners.push_back(k);
    // An angle's mirror image is its negative, not another column.
    if (partners.size() != 1 || std::string_view(column.unit).substr(0, 3) == "rad")
      throw wend::parameter_error(
          "mirror", quoted(column) + " has no mirror image: expected a distance and one column at " +
                        "the opposite bearing, found " + column.unit + " and " + std::to_string(partners.size()) +
                        "; set mirror to false or change observe");
    mirror.columns.push_back(partners.front());
  }
  const std::vector<double> table = params.numbers("mirror_actions");
  bool good = table.size() == actions;
  for (const double action : table) good = good && action >= 0 && action < actions;
  for (std::uint32_t a = 0; good && a < actions; ++a) {
    mirror.actions.push_back(static_cast<std::uint32_t>(table[a]));
    good = table[mirror.actions[a]] == a;
  }
  if (!good) {
    std::string found;
    for (const double action : table)
      found += (found.empty() ? "" : " ") + std::to_string(static_cast<long long>(action));
    throw wend::parameter_error("mirror_actions", "expected for each of the " + std::to_string(actions) +
                                                      " actions the one it becomes in the mirror, and back; found " +
                                                      (found.empty() ? "none" : found));
  }
  return mirror;
}

}  // namespace lspi
