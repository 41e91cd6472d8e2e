// The loops of lane_loops.inc for each instruction set, and the choice between them.
#include "lanes.hpp"

#include "../motion/arc.hpp"
#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace arena {

constexpr std::uint32_t between_looks = 16;  // discs, until it is asked whether the rest is too far away

}  // namespace arena

#define ARENA_SET plain
#define ARENA_W 2
#define ARENA_TARGET
#include "lane_loops.inc"

#if defined(__x86_64__)
#define ARENA_SET avx2
#define ARENA_W 4
#define ARENA_TARGET __attribute__((target("avx2")))
#include "lane_loops.inc"

#define ARENA_SET avx512
#define ARENA_W 8
#define ARENA_TARGET __attribute__((target("avx512f,avx512dq,avx512vl")))
#include "lane_loops.inc"
#endif

namespace arena {
namespace {

constexpr Kernels tables[] = {
    plain::table,
#if defined(__x86_64__)
    avx2::table,
    avx512::table,
#endif
};

std::size_t supported() noexcept {
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (!__builtin_cpu_supports("avx2")) return 1;
  const bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512vl");
  return wide ? 3 : 2;
#else
  return 1;
#endif
}

const std::size_t count = supported();

}  // namespace

const Kernels& kernels() noexcept {
  return tables[count - 1];
}

std::span<const Kernels> every_kernels() noexcept {
  return {tables, count};
}

}  // namespace arena
