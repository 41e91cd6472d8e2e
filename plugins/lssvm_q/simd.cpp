// The loops of simd_loops.inc for each instruction set, and the choice between them.
#include "simd.hpp"

#include <wend/cpu.hpp>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#define LSSVM_SET plain
#define LSSVM_NAME "plain"
#define LSSVM_W 2
#define LSSVM_STRIPS 1
#define LSSVM_COLUMNS 2
#define LSSVM_TARGET
#include "simd_loops.inc"

#if defined(__x86_64__)
#define LSSVM_SET avx2
#define LSSVM_NAME "avx2"
#define LSSVM_W 4
#define LSSVM_STRIPS 1
#define LSSVM_COLUMNS 4
#define LSSVM_TARGET __attribute__((target("avx2")))
#include "simd_loops.inc"

#define LSSVM_SET avx512
#define LSSVM_NAME "avx512"
#define LSSVM_W 8
#define LSSVM_STRIPS 3
#define LSSVM_COLUMNS 8
#define LSSVM_TARGET __attribute__((target("avx512f,avx512dq,avx512vl")))
#include "simd_loops.inc"
#endif

namespace lssvm {
namespace {

constexpr Loops tables[] = {
    plain::table,
#if defined(__x86_64__)
    avx2::table,
    avx512::table,
#endif
};

const std::size_t count = wend::vector_level();

}  // namespace

const Loops& loops() noexcept {
  return tables[count - 1];
}

std::span<const Loops> every_loops() noexcept {
  return {tables, count};
}

}  // namespace lssvm
