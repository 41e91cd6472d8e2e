// The inner loops as they are printed, matrices and all, in plain double and with the C library's tanh: what the fast
// ones are measured against.
#pragma once
#include <cmath>
#include <vector>

#include "../loops.hpp"

namespace hdp::plain {

struct Net {
  std::vector<std::vector<double>> first;  // hidden x inputs
  std::vector<double> second;

  explicit Net(const Network& from)
      : second(from.second.begin(), from.second.begin() + static_cast<std::ptrdiff_t>(from.hidden)) {
    for (std::size_t i = 0; i < from.hidden; ++i) {
      first.emplace_back();
      for (std::size_t j = 0; j < from.inputs; ++j) first.back().push_back(from.first[j * from.lanes + i]);
    }
  }
  std::vector<double> units(const std::vector<double>& x, double gain) const {
    std::vector<double> h;
    for (const auto& row : first) {
      double a = 0;
      for (std::size_t j = 0; j < x.size(); ++j) a += row[j] * x[j];
      h.push_back(std::tanh(gain * a));
    }
    return h;
  }
  double sum(const std::vector<double>& x, double gain) const {
    const std::vector<double> h = units(x, gain);
    double total = 0;
    for (std::size_t i = 0; i < h.size(); ++i) total += second[i] * h[i];
    return total;
  }
  // Weights += step * d(sum)/d(weights).
  void climb(const std::vector<double>& x, double gain, double step) {
    const std::vector<double> h = units(x, gain);
    for (std::size_t i = 0; i < h.size(); ++i) {
      const double by_a = second[i] * (1 - h[i] * h[i]) * gain;
      for (std::size_t j = 0; j < x.size(); ++j) first[i][j] += step * by_a * x[j];
    }
    for (std::size_t i = 0; i < h.size(); ++i) second[i] += step * h[i];
  }
};

inline std::uint32_t critic_loop(Net& critic, const std::vector<double>& z, const CriticTask& task) {
  for (std::uint32_t k = 0; k < task.most; ++k) {
    const double e = task.slope * critic.sum(z, task.gain) - task.target;
    if (!(e * e / 2 > task.tolerance)) return k;
    critic.climb(z, task.gain, -task.rate * e * task.slope);
  }
  return task.most;
}

// dJ/du for a critic input z + u by_u.
inline double slope_in_u(const Net& critic, const std::vector<double>& z, const std::vector<double>& by_u,
                         double gain) {
  const std::vector<double> h = critic.units(z, gain);
  double slope = 0;
  for (std::size_t i = 0; i < h.size(); ++i)
    for (std::size_t j = 0; j < z.size(); ++j)
      slope += critic.second[i] * (1 - h[i] * h[i]) * gain * critic.first[i][j] * by_u[j];
  return slope;
}

inline std::uint32_t actor_loop(Net& actor, const Net& critic, const std::vector<double>& x,
                                const std::vector<double>& z0, const std::vector<double>& by_u, const ActorTask& task) {
  std::vector<double> z(z0.size());
  for (std::uint32_t k = 0; k < task.most; ++k) {
    const double u = std::tanh(task.gain * actor.sum(x, task.gain));
    for (std::size_t j = 0; j < z.size(); ++j) z[j] = z0[j] + u * by_u[j];
    const double e = critic.sum(z, task.gain) - task.goal;
    if (!(e * e / 2 > task.tolerance)) return k;
    actor.climb(x, task.gain, -task.rate * e * slope_in_u(critic, z, by_u, task.gain) * task.gain * (1 - u * u));
  }
  return task.most;
}

}  // namespace hdp::plain
