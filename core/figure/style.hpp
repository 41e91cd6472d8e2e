// The look that all pictures share: colours, dashes, end markers, type sizes.
#pragma once
#include <core/figure/display.hpp>
#include <string>
#include <vector>

namespace wend::core {

namespace ink {
constexpr Colour text = rgb(0x1f2328), faint_text = rgb(0x5b6370), frame = rgb(0x9aa1ab), grid_line = rgb(0xe6e8ec);
constexpr Colour ground = rgb(0xfcfcfb), obstacle = rgb(0xb4b9c1), obstacle_edge = rgb(0x7d848f), wall = rgb(0x3c4350);
constexpr Colour mover = rgb(0xe9e4d4), mover_edge = rgb(0x6e6547), mover_path = rgb(0xb9ae8c);
constexpr Colour goal = rgb(0xfff3bf), goal_edge = rgb(0x1f2328);
constexpr Colour white = rgb(0xffffff);
}  // namespace ink

// Never told apart by colour alone: arm i has its own colour and its own dash pattern.
struct LineStyle {
  Colour colour;
  std::vector<double> dash;
  double width = 2.2;

  Pen pen() const { return {colour, width, Cap::butt, dash}; }
  bool operator==(const LineStyle&) const = default;
};

// Okabe and Ito's colours, which people with any colour vision tell apart; the pair with the dash repeats after 64.
LineStyle line_style(std::size_t index);

enum class Ending { arrived, collided, timeout, ended, unfinished };
const char* name(Ending ending);  // "arrived"

// A star, a cross, a square, a diamond, a disc: `radius` px around `at`, on a white seam.
void add_end_marker(std::vector<Item>& items, Ending ending, Place at, double radius, Colour colour, int clip = -1);

// A triangle that points along `heading` (rad, counter-clockwise, y up).
void add_start_marker(std::vector<Item>& items, Place at, double heading, double radius, Colour colour, int clip = -1);

// A short horizontal sample of the style, from `at` on.
void add_line_sample(std::vector<Item>& items, const LineStyle& style, Place at, double length);

Text label(Place at, std::string text, double size = 12, Colour colour = ink::text, Anchor anchor = Anchor::start,
           bool bold = false);

// "1,234.5" with at most `decimals` digits after the point, or exactly as many.
std::string grouped(double value, int decimals = 0, bool exactly = false);

}  // namespace wend::core
