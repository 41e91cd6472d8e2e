// A picture in memory: polygons, strokes, cells and glyphs blended into it with anti-aliased edges.
#pragma once
#include <core/figure/display.hpp>
#include <functional>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "stroke.hpp"

namespace wend::render {

// All coordinates are pixels of the picture; its first pixel covers [0, 1) x [0, 1).
class Canvas {
 public:
  Canvas(int width, int height)
      : pixels_(height, width, CV_8UC3, cv::Scalar(255, 255, 255)), clip_(0, 0, width, height) {}

  void clip(const core::Box& box);
  void unclip() { clip_ = cv::Rect(0, 0, pixels_.cols, pixels_.rows); }

  void fill(const Polygon& polygon, core::Colour colour);
  void draw(const std::vector<core::Place>& line, bool closed, const core::Pen& pen);
  void fill_cells(const core::Cells& cells);

  // Blends `coverage` (8 bit) in with its upper left corner at column x, row y.
  void stamp(const cv::Mat& coverage, int x, int y, core::Colour colour);

  std::vector<unsigned char> png() const;
  const cv::Mat& pixels() const { return pixels_; }

 private:
  // Calls `paint` with masks of 4 x 4 samples a pixel that together span `bounds`, and the place of their corner.
  using Paint = std::function<void(cv::Mat& samples, core::Place corner)>;
  void cover(const core::Box& bounds, core::Colour colour, const Paint& paint);

  cv::Mat pixels_;
  cv::Rect clip_;
};

}  // namespace wend::render
