#include "votes.hpp"

#include <algorithm>

namespace xcs {
namespace {

constexpr std::size_t lanes = 8;
constexpr double least = 1e-12;  // of the mean fitness: below it a rule's vote grows no more

struct Columns {
  const double *fitness, *numerosity, *experience, *set_size;
  std::size_t n;
};

[[gnu::always_inline]] inline double vote(const Columns& c, std::size_t r, double theta_del, double low, double mean) {
  const double copies = mean * c.numerosity[r], own = c.fitness[r];
  const double scale = copies / (own > least * copies ? own : least * copies);
  const bool poor = (c.experience[r] > theta_del) & (own < low * c.numerosity[r]);
  return c.set_size[r] * c.numerosity[r] * (poor ? scale : 1.0);
}

[[gnu::always_inline]] inline void vote_all(const Columns& c, double theta_del, double low, double mean,
                                            double* votes) {
  std::size_t i = 0;
  for (; i + lanes <= c.n; i += lanes)
    for (std::size_t k = 0; k < lanes; ++k) votes[i + k] = vote(c, i + k, theta_del, low, mean);
  for (; i < c.n; ++i) votes[i] = vote(c, i, theta_del, low, mean);
}

[[gnu::always_inline]] inline void add_lanes(const double* values, std::size_t n, double* sums) {
  double own[lanes] = {};
  std::size_t i = 0;
  for (; i + lanes <= n; i += lanes)
    for (std::size_t k = 0; k < lanes; ++k) own[k] += values[i + k];
  for (; i < n; ++i) own[i % lanes] += values[i];
  for (std::size_t k = 0; k < lanes; ++k) sums[k] = own[k];
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void vote_avx2(const Columns& c, double t, double low, double mean, double* votes) {
  vote_all(c, t, low, mean, votes);
}
__attribute__((target("avx512f"))) void vote_avx512(const Columns& c, double t, double low, double mean,
                                                    double* votes) {
  vote_all(c, t, low, mean, votes);
}
__attribute__((target("avx2"))) void add_avx2(const double* values, std::size_t n, double* sums) {
  add_lanes(values, n, sums);
}
__attribute__((target("avx512f"))) void add_avx512(const double* values, std::size_t n, double* sums) {
  add_lanes(values, n, sums);
}
#endif

void vote_by(Kernel kernel, const Columns& c, double theta_del, double low, double mean, double* votes) {
#if defined(__x86_64__)
  if (kernel == Kernel::kAvx512) return vote_avx512(c, theta_del, low, mean, votes);
  if (kernel == Kernel::kAvx2) return vote_avx2(c, theta_del, low, mean, votes);
#endif
  (void)kernel;
  vote_all(c, theta_del, low, mean, votes);
}

void add_by(Kernel kernel, const double* values, std::size_t n, double* sums) {
#if defined(__x86_64__)
  if (kernel == Kernel::kAvx512) return add_avx512(values, n, sums);
  if (kernel == Kernel::kAvx2) return add_avx2(values, n, sums);
#endif
  (void)kernel;
  add_lanes(values, n, sums);
}

double total_of(const double* sums) {
  return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

}  // namespace

void Wheel::cast_votes(const Population& population, const Parameters& parameters) {
  const Columns columns{population.fitness.data(), population.numerosities().data(), population.experience.data(),
                        population.set_size.data(), population.size()};
  kernel_ = population.kernel();
  add_by(kernel_, columns.fitness, columns.n, sums_);
  const double mean = total_of(sums_) / population.micro();
  weights_.resize(columns.n);
  vote_by(kernel_, columns, parameters.theta_del, parameters.delta * mean, mean, weights_.data());
  add_by(kernel_, weights_.data(), columns.n, sums_);
}

void Wheel::set(Kernel kernel, const std::vector<double>& weights) {
  kernel_ = kernel;
  weights_ = weights;
  add_by(kernel_, weights_.data(), weights_.size(), sums_);
}

std::uint32_t Wheel::draw(wend::Random& random) const {
  double left = random.uniform() * total_of(sums_);
  std::size_t lane = 0;
  while (lane + 1 < lanes && left >= sums_[lane]) left -= sums_[lane++];
  std::uint32_t last = Population::none;  // rounding may leave a remainder: the last that has a weight takes it
  for (std::size_t r = lane; r < weights_.size(); r += lanes) {
    if (!(weights_[r] > 0)) continue;
    last = static_cast<std::uint32_t>(r);
    left -= weights_[r];
    if (left < 0) return last;
  }
  if (last != Population::none) return last;
  for (std::size_t r = weights_.size(); r-- > 0;)
    if (weights_[r] > 0) return static_cast<std::uint32_t>(r);
  return Population::none;
}

}  // namespace xcs
