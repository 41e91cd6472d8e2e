// The innermost loops, several values at a time, compiled for several instruction sets: the best one that the CPU has
// is picked when the plugin is loaded.  All give the bits of the plain expressions in hits.hpp and motion/arc.hpp.
#pragma once
#include <wend/abi.h>

#include <cstdint>
#include <span>

#include "cells.hpp"

namespace arena {

inline constexpr std::uint32_t block = 128;  // values worked on together

// Room for a block, and for the lanes of a last one that begins at its end.
struct Lane {
  alignas(64) double at[block + most_lanes];
};

// Rays, and m to the nearest surface met so far.
struct Rays {
  Lane x, y, heading, dx, dy, best, kind, hit;
  std::int32_t cell[block + most_lanes];  // of candidate lists; negative: none
  std::uint32_t n = 0;

  // Up to here everything is worked out: for whole lanes.
  std::uint32_t padded() const noexcept { return (n + most_lanes - 1) / most_lanes * most_lanes; }
  Ray at(std::uint32_t k) const noexcept { return {x.at[k], y.at[k], dx.at[k], dy.at[k]}; }
};

struct Bounds {
  double x0, y0, x1, y1;  // m
};

// Discs by member; a negative square is met by no ray.
struct Discs {
  const double *x, *y, *radius2;
  std::uint32_t n;
};

// Bodies on arcs; the heading is not wrapped.
struct Arcs {
  Lane x, y, heading, speed, turn_rate;
  std::uint32_t n = 0;

  std::uint32_t padded() const noexcept { return (n + most_lanes - 1) / most_lanes * most_lanes; }
};

struct Kernels {
  // All but hit and cell, from n poses; best is `reach`, of kind WEND_NOTHING.  Directions are only right where it is
  // true: headings of more than 8192 rad are for wend::math::sincos.
  bool (*aim)(Rays&, const wend_pose*, double reach);
  // hit: the least of best and the walls around the bounds.
  void (*meet_bounds)(Rays&, const Bounds&);
  // best = hit where that is less, and then of this kind: of kinds at the same distance the first one counts.
  void (*keep_nearer)(Rays&, double kind);
  // cell: of the lists, negative outside.  True where none is outside.
  bool (*find_cells)(Rays&, const CellLists&);
  // hit: the least of best and the candidates of each ray's cell, without regard to the inside of polygons.
  void (*meet_lists)(Rays&, const CellLists&);
  // hit of rays first..last - 1: the least of hit and the discs.
  void (*meet_discs)(Rays&, std::uint32_t first, std::uint32_t last, const Discs&);
  // follow<true>() of each.
  void (*follow_arcs)(Arcs&, double seconds);
};

// For this CPU.
const Kernels& kernels() noexcept;
// All that this CPU can run, the plain one first: for tests.
std::span<const Kernels> every_kernels() noexcept;

}  // namespace arena
