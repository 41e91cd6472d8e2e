// Measures the solver beside dlib::lspi: 10,000 samples of six sonars, 3 actions, 25 and 210 features an action.
//   bench_lspi [--json]
// Times are a thread's, of one policy iteration: of ours, a whole solve divided by its iterations; the two take turns
// and the least of several turns counts.
#include <malloc.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <string>
#include <utility>
#include <wend/testing_time.hpp>

#include "avoidance.hpp"
#include "dlib_lspi.hpp"

namespace {

using wend::testing::seconds_of;

constexpr std::size_t samples_each = 10000;
constexpr std::uint32_t actions = 3;
constexpr double discount = 0.9, lambda = 10, still = 1e-9;

// kB, from /proc/self/status: VmRSS is what is resident, VmHWM the most that was.
double resident(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kb = 0; word == key + ":" && status >> kb) return kb;
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::pair<std::string, double>> figures;
void tell(const std::string& key, std::size_t features, double figure) {
  figures.emplace_back(key + "_" + std::to_string(features), figure);
}

void compare(const lspi::Basis& basis, int turns, unsigned dlib_iterations) {
  const std::size_t m = basis.size();
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;  // the most that was resident starts anew
  const double before = resident("VmRSS");
  const lspi::Samples samples = peer::avoidance(basis, samples_each, 1);
  const lspi::SolverOptions options{actions, discount, peer::ridge_of(samples, actions, lambda), 100};
  const lspi::Solution found = lspi::solve(samples, options);
  tell("lspi_memory_mb", m, (resident("VmHWM") - before) * 1024 / 1e6);

  const std::vector<double> expected = peer::dlib_lspi(samples, actions, discount, lambda, still, 100);
  if (!found.converged || expected.size() != found.weights.size()) {
    std::fprintf(stderr, "%zu features: expected weights that stand still, found a cycle of policies\n", m);
    std::exit(1);
  }
  double difference = 0;
  for (std::size_t k = 0; k < expected.size(); ++k)
    difference = std::max(difference, std::fabs(found.weights[k] - expected[k]));
  tell("lspi_weights_from_dlib", m, difference);
  tell("lspi_condition", m, found.condition);

  double ours = 1e9, dlibs = 1e9;
  for (int turn = 0; turn < turns; ++turn) {
    ours = std::min(ours, seconds_of([&] { return lspi::solve(samples, options); }) / found.iterations);
    dlibs = std::min(dlibs, seconds_of([&] {
                              return peer::dlib_lspi(samples, actions, discount, lambda, still, dlib_iterations);
                            }) / dlib_iterations);
  }
  tell("lspi_ms", m, 1e3 * ours);
  tell("lspi_dlib_ms", m, 1e3 * dlibs);
  tell("lspi_vs_dlib", m, dlibs / ours);
}

}  // namespace

int main(int argc, char** argv) {
  const bool json = argc > 1 && std::strcmp(argv[1], "--json") == 0;
  compare(*lspi::monomials(peer::sonars(), 4), 4, 1);
  compare(*lspi::powers(peer::sonars(), 4), 10, 3);
  const char* separator = json ? "{" : "";
  for (const auto& [key, figure] : figures) {
    std::printf(json ? "%s\"%s\": %.6g" : "%s%-26s %.6g\n", separator, key.c_str(), figure);
    if (json) separator = ", ";
  }
  if (json) std::puts("}");
}
