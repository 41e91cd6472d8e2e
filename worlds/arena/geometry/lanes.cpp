// Eight values at a time: see lanes.hpp.
#include "lanes.hpp"

#include <wend/math.hpp>

#if defined(__x86_64__) && defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ARENA_EVERY_CPU __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define ARENA_EVERY_CPU
#endif

namespace arena {
namespace {

using Eight = double __attribute__((vector_size(64)));
using Loaded = double __attribute__((vector_size(64), aligned(8), may_alias));

}  // namespace

ARENA_EVERY_CPU
double hit_discs(const Ray& ray, const double* x, const double* y, const double* radius2, std::uint32_t n,
                 double best) noexcept {
  const Eight nothing = Eight{} + infinity, zero{};
  Eight least = Eight{} + best;
  for (std::uint32_t k = 0; k < n; k += lanes) {
    const Eight r2 = *reinterpret_cast<const Loaded*>(radius2 + k);
    const Eight bx = *reinterpret_cast<const Loaded*>(x + k) - ray.x,
                by = *reinterpret_cast<const Loaded*>(y + k) - ray.y;
    const Eight along = bx * ray.dx + by * ray.dy, aside = bx * ray.dy - by * ray.dx;
    const Eight half2 = r2 - aside * aside, away2 = bx * bx + by * by;
    Eight root;
    for (std::uint32_t i = 0; i < lanes; ++i) root[i] = __builtin_sqrt(half2[i]);
    Eight hit = along - root;
    hit = hit < zero ? zero : hit;
    hit = ((half2 < zero) | (along < zero)) ? nothing : hit;
    hit = away2 <= r2 ? zero : hit;
    least = hit < least ? hit : least;
  }
  const Eight four = __builtin_shufflevector(least, least, 4, 5, 6, 7, 0, 1, 2, 3);
  least = four < least ? four : least;
  const Eight two = __builtin_shufflevector(least, least, 2, 3, 0, 1, 6, 7, 4, 5);
  least = two < least ? two : least;
  return least[1] < least[0] ? least[1] : least[0];
}

ARENA_EVERY_CPU
void directions(const double* heading, std::uint32_t n, double* dx, double* dy) noexcept {
  for (std::uint32_t k = 0; k < n; ++k) {
    double s, c;
    wend::math::sincos_near(heading[k], s, c);
    dx[k] = c, dy[k] = s;
  }
}

ARENA_EVERY_CPU
void hit_bounds(const double* x, const double* y, const double* dx, const double* dy, const double* x0,
                const double* y0, const double* x1, const double* y1, std::uint32_t n, double* hit) noexcept {
  for (std::uint32_t k = 0; k < n; ++k) {
    const double left = x[k] - x0[k], right = x1[k] - x[k], below = y[k] - y0[k], above = y1[k] - y[k];
    const double tx = (dx[k] < 0 ? left : right) / __builtin_fabs(dx[k]);
    const double ty = (dy[k] < 0 ? below : above) / __builtin_fabs(dy[k]);
    const double nearer = ty < tx ? ty : tx;
    hit[k] = (left > 0) & (right > 0) & (below > 0) & (above > 0) ? nearer : 0.0;
  }
}

}  // namespace arena
