#include "canvas.hpp"

#include <algorithm>
#include <cmath>
#include <core/base/error.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace wend::render {
namespace {

using core::Box;
using core::Colour;
using core::Place;

constexpr int samples_per_pixel = 4;      // in each direction
constexpr int fraction_bits = 8;          // of OpenCV's fixed-point coordinates
constexpr int pixels_per_band = 1 << 20;  // masks stay below 16 MB

// OpenCV paints the samples under a polygon's outline too: half a sample on each side.
constexpr double outline_excess = 1.0 / samples_per_pixel;

// The whole pixels that a box touches.
cv::Rect touched(const Box& box) {
  const double far = 1e6;
  const auto whole = [&](double v) { return static_cast<int>(std::clamp(v, -far, far)); };
  const int x = whole(std::floor(box.x)), y = whole(std::floor(box.y));
  return {x, y, whole(std::ceil(box.right())) - x, whole(std::ceil(box.bottom())) - y};
}

Box bounds_of(const Polygon& points, double margin) {
  double left = 1e300, top = 1e300, right = -1e300, bottom = -1e300;
  for (const Place p : points) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    top = std::min(top, p.y);
    bottom = std::max(bottom, p.y);
  }
  return {left - margin, top - margin, right - left + 2 * margin, bottom - top + 2 * margin};
}

// A sample's coordinate names its centre.
int fixed(double value, double corner) {
  const double samples = (value - corner) * samples_per_pixel - 0.5;
  return static_cast<int>(std::lround(std::clamp(samples, -8e6, 8e6) * (1 << fraction_bits)));
}

std::vector<cv::Point> fixed(const Polygon& polygon, Place corner) {
  std::vector<cv::Point> points;
  points.reserve(polygon.size());
  for (const Place p : polygon) points.emplace_back(fixed(p.x, corner.x), fixed(p.y, corner.y));
  return points;
}

void blend(cv::Mat pixels, const cv::Mat& coverage, Colour colour) {
  const int bgr[3] = {colour.blue, colour.green, colour.red};
  for (int y = 0; y < pixels.rows; ++y) {
    unsigned char* to = pixels.ptr<unsigned char>(y);
    const unsigned char* cover = coverage.ptr<unsigned char>(y);
    for (int x = 0; x < pixels.cols; ++x, to += 3) {
      const int alpha = cover[x] * colour.alpha;  // 0 to 255^2
      if (alpha == 0) continue;
      for (int c = 0; c < 3; ++c)
        to[c] = static_cast<unsigned char>((to[c] * (65025 - alpha) + bgr[c] * alpha + 32512) / 65025);
    }
  }
}

}  // namespace

void Canvas::clip(const Box& box) {
  const double right = std::round(box.right()), bottom = std::round(box.bottom());
  const Box whole{std::round(box.x), std::round(box.y), right - std::round(box.x), bottom - std::round(box.y)};
  clip_ = touched(whole) & cv::Rect(0, 0, pixels_.cols, pixels_.rows);
}

void Canvas::cover(const Box& bounds, Colour colour, const Paint& paint) {
  const cv::Rect region = touched(bounds) & clip_;
  if (region.empty() || colour.alpha == 0) return;
  const int band = std::max(1, pixels_per_band / region.width);
  cv::Mat samples, coverage;
  for (int y = region.y; y < region.br().y; y += band) {
    const int height = std::min(band, region.br().y - y);
    samples.create(height * samples_per_pixel, region.width * samples_per_pixel, CV_8UC1);
    samples.setTo(0);
    paint(samples, {static_cast<double>(region.x), static_cast<double>(y)});
    cv::resize(samples, coverage, cv::Size(region.width, height), 0, 0, cv::INTER_AREA);
    blend(pixels_(cv::Rect(region.x, y, region.width, height)), coverage, colour);
  }
}

void Canvas::fill(const Polygon& polygon, Colour colour) {
  if (polygon.size() < 3) return;
  cover(bounds_of(polygon, 1), colour, [&](cv::Mat& samples, Place corner) {
    const std::vector<std::vector<cv::Point>> contours = {fixed(polygon, corner)};
    cv::fillPoly(samples, contours, cv::Scalar(255), cv::LINE_8, fraction_bits);
  });
}

void Canvas::draw(const std::vector<Place>& line, bool closed, const core::Pen& pen) {
  if (line.empty()) return;
  std::vector<std::pair<Box, Polygon>> pieces;
  const double width = std::max(pen.width - outline_excess, 0.05);
  for (const Polygon& stretch : dashes(line, closed, pen.dash))
    for (Polygon& piece : stroke(stretch, width, pen.cap)) {
      const Box bounds = bounds_of(piece, 1);
      pieces.emplace_back(bounds, std::move(piece));
    }
  cover(bounds_of(line, pen.width + 1), pen.colour, [&](cv::Mat& samples, Place corner) {
    const double bottom = corner.y + samples.rows / samples_per_pixel;
    for (const auto& [bounds, piece] : pieces)
      if (bounds.bottom() >= corner.y && bounds.y <= bottom)
        cv::fillConvexPoly(samples, fixed(piece, corner), cv::Scalar(255), cv::LINE_8, fraction_bits);
  });
}

void Canvas::fill_cells(const core::Cells& cells) {
  if (cells.columns == 0 || cells.rows == 0) return;
  const double w = cells.box.width / cells.columns, h = cells.box.height / cells.rows;
  const auto sample = [](double value, double corner) {
    return static_cast<int>(std::lround((value - corner) * samples_per_pixel));
  };
  cover(cells.box, cells.fill, [&](cv::Mat& samples, Place corner) {
    for (std::uint32_t row = 0; row < cells.rows; ++row) {
      const int top = sample(cells.box.y + row * h, corner.y), bottom = sample(cells.box.y + (row + 1) * h, corner.y);
      if (bottom <= 0 || top >= samples.rows) continue;
      const std::uint8_t* line = cells.cells.data() + static_cast<std::size_t>(row) * cells.columns;
      for (std::uint32_t from = 0; from < cells.columns; ++from) {
        if (line[from] == 0) continue;
        std::uint32_t to = from;
        while (to < cells.columns && line[to] != 0) ++to;
        const int left = sample(cells.box.x + from * w, corner.x), right = sample(cells.box.x + to * w, corner.x);
        const cv::Rect run(left, top, std::max(1, right - left), std::max(1, bottom - top));
        samples(run & cv::Rect(0, 0, samples.cols, samples.rows)).setTo(255);
        from = to;
      }
    }
  });
}

void Canvas::stamp(const cv::Mat& coverage, int x, int y, Colour colour) {
  const cv::Rect region = cv::Rect(x, y, coverage.cols, coverage.rows) & clip_;
  if (!region.empty()) blend(pixels_(region), coverage(region - cv::Point(x, y)), colour);
}

std::vector<unsigned char> Canvas::png() const {
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".png", pixels_, bytes, {cv::IMWRITE_PNG_COMPRESSION, 6}))
    throw core::Error(core::Exit::data, "cannot encode a picture of " + std::to_string(pixels_.cols) + " x " +
                                            std::to_string(pixels_.rows) + " pixels as PNG");
  return bytes;
}

}  // namespace wend::render
