// The two inner loops of a decision, exactly but without their matrices.
//
// Within a loop the input x is constant, so the hidden weights change by multiples of x: W1(k) = W1(0) + S(k) x^T, and
// the hidden sums are a(k) = a(0) + S(k) |x|^2.  A loop therefore runs over S and the output weights alone, and W1
// takes S x^T once at its end.  From one iteration to the next a unit's tanh moves by little: it follows its Taylor
// series, and is computed anew where it moves by more.  Same result as the plain loops within 1e-9.
#pragma once
#include <cstdint>
#include <span>

#include "network.hpp"

namespace hdp {

// E_c = (slope J - target)^2 / 2: slope alpha and target J(t - 1) - r(t) are (9), slope 1 and target r + alpha J(t) td.
struct CriticTask {
  double gain, slope, target, rate, tolerance;
  std::uint32_t most;
};

// E_a = (J - goal)^2 / 2, (3) and (4).
struct ActorTask {
  double gain, goal, rate, tolerance;
  std::uint32_t most;
};

// One instruction set's loops, over arrays of lanes.
struct Loops {
  const char* name;
  std::uint32_t (*critic)(const CriticTask& task, std::size_t lanes, double z2, const double* a, double* w, double* s);
  std::uint32_t (*actor)(const ActorTask& task, std::size_t lanes, double x2, const double* b, double* v, double* s,
                         const double* a, const double* w_u, const double* w);
};

std::span<const Loops> every_loops() noexcept;  // that this CPU can run, the best last; all give the same bits

// Both run while E exceeds the tolerance, at most `most` times, and return how many times they did.
std::uint32_t critic_loop(Network& critic, std::span<const double> z, const CriticTask& task,
                          const Loops& loops = every_loops().back());

// z: the critic's input where u = 0; by_u: what it changes by where u is 1.
std::uint32_t actor_loop(Network& actor, const Network& critic, std::span<const double> x, std::span<const double> z,
                         std::span<const double> by_u, const ActorTask& task,
                         const Loops& loops = every_loops().back());

}  // namespace hdp
