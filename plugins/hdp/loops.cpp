// The loops of lane_loops.inc for each instruction set, and the choice between them.
#include "loops.hpp"

#include <wend/cpu.hpp>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace hdp {

// How far the argument of a tanh may move for the series that follow it: errors < 6e-14 and 4e-13.
constexpr double short_way = 0x1p-11, long_way = 0x1p-4;
constexpr double third = 1.0 / 3, two_fifteenths = 2.0 / 15, seventeen_315ths = 17.0 / 315;

}  // namespace hdp

#define HDP_SET plain
#define HDP_W 2
#define HDP_TARGET
#include "lane_loops.inc"

#if defined(__x86_64__)
#define HDP_SET avx2
#define HDP_W 4
#define HDP_TARGET __attribute__((target("avx2")))
#include "lane_loops.inc"

#define HDP_SET avx512
#define HDP_W 8
#define HDP_TARGET __attribute__((target("avx512f,avx512dq,avx512vl")))
#include "lane_loops.inc"
#endif

namespace hdp {
namespace {

constexpr Loops tables[] = {
    plain::table,
#if defined(__x86_64__)
    avx2::table,
    avx512::table,
#endif
};

const std::size_t count = wend::vector_level();

double square(std::span<const double> x) noexcept {
  double total = 0;
  for (const double value : x) total += value * value;
  return total;
}

}  // namespace

std::span<const Loops> every_loops() noexcept {
  return {tables, count};
}

std::uint32_t critic_loop(Network& critic, std::span<const double> z, const CriticTask& task, const Loops& loops) {
  double a[most_hidden], s[most_hidden];
  critic.weigh(z, a);
  const std::uint32_t ran = loops.critic(task, critic.lanes, square(z), a, critic.second.data(), s);
  if (ran != 0) critic.add(z, s);
  return ran;
}

std::uint32_t actor_loop(Network& actor, const Network& critic, std::span<const double> x, std::span<const double> z,
                         std::span<const double> by_u, const ActorTask& task, const Loops& loops) {
  double a[most_hidden], b[most_hidden], s[most_hidden], w_u[most_hidden];
  actor.weigh(x, b);
  critic.weigh(z, a);
  critic.weigh(by_u, w_u);
  const std::uint32_t ran =
      loops.actor(task, actor.lanes, square(x), b, actor.second.data(), s, a, w_u, critic.second.data());
  if (ran != 0) actor.add(x, s);
  return ran;
}

}  // namespace hdp
