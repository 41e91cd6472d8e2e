// What the generators share: is there room here, does a way lead there, and how they give up.
#pragma once
#include <string>
#include <wend/random.hpp>

#include "../scene.hpp"

namespace arena {

inline constexpr int most_tries = 1000;

// m from a point to the nearest surface that stands still, walls included; negative inside of one.
double clearance(const Scene&, Point) noexcept;

// A place with at least this clearance, uniform over a rectangle; false after many misses.
bool draw_place(const Scene&, wend::Random&, double x0, double y0, double x1, double y1, double clearance, Point& out);

// Whether a disc can be moved from one point to the other, by steps of `cell` m (0: a quarter of the body).  On the
// safe side: every step has room on its whole length, so that a way narrower than the disc and a cell does not count.
bool joined(const Scene&, Point from, Point to, double body, double cell = 0);

// Whether all of the room that the disc has is one piece.
bool all_joined(const Scene&, double body);

// Throws a wend::Error for the parameter below "generate/".
[[noreturn]] void refuse(const std::string& parameter, const std::string& message);

// A rectangle with one corner at (x, y) and the others counter-clockwise from there.
Polygon rectangle(double x, double y, double width, double height);

}  // namespace arena
