// The innermost loops of ray casting, eight values at a time, compiled for several instruction sets: the fastest that
// the CPU has is picked when the plugin is loaded.  All give the bits of the plain expressions in hits.hpp.
#pragma once
#include <cstdint>

#include "hits.hpp"

namespace arena {

inline constexpr std::uint32_t lanes = 8;

// The least of `best` and the hits with n discs, n a multiple of `lanes`.
double hit_discs(const Ray& ray, const double* x, const double* y, const double* radius2, std::uint32_t n,
                 double best) noexcept;

// n directions from angles of at most 8192 rad.
void directions(const double* heading, std::uint32_t n, double* dx, double* dy) noexcept;

// n rays and the bounds around each: hit_bounds of each.
void hit_bounds(const double* x, const double* y, const double* dx, const double* dy, const double* x0,
                const double* y0, const double* x1, const double* y1, std::uint32_t n, double* hit) noexcept;

}  // namespace arena
