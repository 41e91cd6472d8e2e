// Renders figures with the real wend-render and looks at their pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <core/base/error.hpp>
#include <core/base/files.hpp>
#include <core/figure/map_figure.hpp>
#include <core/figure/render.hpp>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <opencv2/imgcodecs.hpp>

#include "synthetic.hpp"

namespace wend::core {
namespace {

const std::string program = WEND_BINARY_DIR "/bin/wend-render";

class Render : public testing::Test {
 protected:
  Render()
      : folder_(testing::TempDir() + "wend_render_" + testing::UnitTest::GetInstance()->current_test_info()->name()) {}
  ~Render() override { std::filesystem::remove_all(folder_); }

  cv::Mat render(const Figure& figure, double scale = 2) const {
    const std::string path = folder_ + "/deep/picture.png";
    render_png({{path, figure}}, {scale, program, 60});
    return cv::imread(path, cv::IMREAD_COLOR);
  }
  std::string error_of(const std::function<void()>& run) const {
    try {
      run();
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::data);
      return error.what();
    }
    return "no error";
  }

  std::string folder_;
};

Figure empty(double width, double height) {
  Figure figure;
  figure.width = width;
  figure.height = height;
  return figure;
}

bool near(const cv::Vec3b& pixel, Colour colour, int tolerance = 12) {
  return std::abs(pixel[0] - colour.blue) <= tolerance && std::abs(pixel[1] - colour.green) <= tolerance &&
         std::abs(pixel[2] - colour.red) <= tolerance;
}

int count(const cv::Mat& image, Colour colour, const cv::Rect& where) {
  int n = 0;
  const cv::Rect inside = where & cv::Rect(0, 0, image.cols, image.rows);
  for (int y = inside.y; y < inside.br().y; ++y)
    for (int x = inside.x; x < inside.br().x; ++x) n += near(image.at<cv::Vec3b>(y, x), colour);
  return n;
}

cv::Rect around(Place p, double scale, int radius) {
  return {static_cast<int>(p.x * scale) - radius, static_cast<int>(p.y * scale) - radius, 2 * radius + 1,
          2 * radius + 1};
}

std::vector<Trace> four_arms() {
  std::vector<Trace> traces;
  for (int i = 0; i < 4; ++i) {  // they share the start
    const double up = 25.0 * i;
    traces.push_back(test::drive({{10, 10}, {20, 12 + up * 0.9}, {60, 12 + up}, {80 - 5.0 * i, 14 + up}}, 0.5, 0,
                                 i == 2   ? test::collided
                                 : i == 3 ? test::timed_out
                                          : test::arrived,
                                 {85, 15 + up}, 3, 2));
    traces.back().shapes = {test::bounds(100, 100), test::disc(30, 50, 4)};
  }
  return traces;
}

std::vector<MapArm> arms_of(const std::vector<Trace>& traces) {
  std::vector<MapArm> arms;
  for (std::size_t i = 0; i < traces.size(); ++i)
    arms.push_back({"arm " + std::to_string(i), &traces[i], i, i == 0, {}});
  return arms;
}

// The map's view, as map_figure lays it out: its frame is the figure's first clip.
MapView view_of(const Figure& figure, const std::vector<MapArm>& arms) {
  const Box page = figure.clips[0];
  return fit_map(map_bounds(arms), {page.x, page.y}, std::max(page.width, page.height), 0.3, 4);
}

TEST_F(Render, EachArmHasItsColourAtItsStartMiddleAndEnd) {
  const auto traces = four_arms();
  const auto arms = arms_of(traces);
  const Figure figure = map_figure(arms, "traps · ordinary · map 3");
  const MapView view = view_of(figure, arms);
  const cv::Mat image = render(figure);
  ASSERT_EQ(image.cols, static_cast<int>(std::ceil(2 * figure.width)));
  for (std::size_t i = 0; i < traces.size(); ++i) {
    const std::size_t last = traces[i].time.size() - 1;
    for (const std::size_t t : {std::size_t{8}, last / 2, last}) {
      const Place at = view(traces[i].pose[3 * t], traces[i].pose[3 * t + 1]);
      EXPECT_GT(count(image, line_style(i).colour, around(at, 2, 26)), 8) << "arm " << i << ", step " << t;
    }
  }
}

TEST_F(Render, DashesTellArmsApartWithoutColour) {
  std::vector<std::vector<int>> runs;  // of ink along each line, px
  Figure figure = empty(400, 200);
  for (std::size_t i = 0; i < 8; ++i) {
    LineStyle style = line_style(i);
    style.colour = rgb(0);
    add_line_sample(figure.items, style, {0, 20.0 + 20 * static_cast<double>(i)}, 400);
  }
  const cv::Mat image = render(figure);
  for (int i = 0; i < 8; ++i) {
    std::vector<int> lengths;
    bool last = false;
    for (int x = 0; x < image.cols; ++x) {
      const bool ink = image.at<cv::Vec3b>(40 + 40 * i, x)[0] < 128;
      if (ink != last || lengths.empty()) lengths.push_back(0);
      ++lengths.back();
      last = ink;
    }
    EXPECT_EQ(lengths.size() == 1, i == 0) << "only the first is solid";
    lengths.resize(std::min<std::size_t>(lengths.size(), 12));
    runs.push_back(lengths);
  }
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      int difference =
          static_cast<int>(std::max(runs[i].size(), runs[j].size()) - std::min(runs[i].size(), runs[j].size())) * 4;
      for (std::size_t k = 0; k < std::min(runs[i].size(), runs[j].size()); ++k)
        difference += std::abs(runs[i][k] - runs[j][k]);
      EXPECT_GT(difference, 6) << i << " and " << j;
    }
}

TEST_F(Render, TheScaleBarIsAsLongAsItSays) {
  for (const double size : {10.0, 100.0, 437.0}) {
    Trace trace = test::drive({{0.1 * size, 0.1 * size}, {0.8 * size, 0.8 * size}}, 0.01 * size, 0, test::arrived,
                              {0.9 * size, 0.9 * size}, 0.03 * size, 0.02 * size);
    trace.shapes = {test::bounds(size, size)};
    const std::vector<MapArm> arms = {{"a", &trace, 0, false, {}}};
    Figure figure = map_figure(arms, "t");
    const MapView view = view_of(figure, arms);
    const cv::Mat image = render(figure);
    const int row = static_cast<int>(2 * (view.page.bottom() + 20));  // on the bar
    int left = -1, right = -1;
    for (int x = 0; x < static_cast<int>(2 * view.page.right()); ++x) {
      if (image.at<cv::Vec3b>(row, x)[0] >= 128) {
        if (left >= 0 && x - right > 4) break;
        continue;
      }
      if (left < 0) left = x;
      right = x;
    }
    Figure probe;
    const double metres = add_scale_bar(probe, view, {0, 0}, std::min(180.0, view.page.width * 0.45));
    const double line = 1.4 * 2;  // the ticks at both ends stand half a line beyond
    EXPECT_NEAR(right - left + 1 - line, metres * view.scale * 2, 1) << metres << " m";
  }
}

TEST_F(Render, LettersAreNotTheMissingGlyphBox) {
  const auto ink = [&](const char* text) {
    Figure figure = empty(60, 40);
    figure.items.push_back({label({20, 30}, text, 28), -1});
    return render(figure);
  };
  const cv::Mat missing = ink("\xF4\x8F\xBF\xBD");  // U+10FFFD, which no font has
  EXPECT_GT(count(missing, ink::text, {0, 0, 120, 80}), 30);
  for (const char* letter : {"é", "τ", "µ", "·", "–", "−", "…"})
    EXPECT_GT(cv::norm(ink(letter), missing, cv::NORM_L1), 1000) << letter;
  EXPECT_GT(cv::norm(ink("é"), ink("e"), cv::NORM_L1), 500);
}

TEST_F(Render, TextIsKernedAnchoredAndTurned) {
  const auto columns = [&](Anchor anchor, double turn) {
    Figure figure = empty(200, 200);
    Text text = label({100, 100}, "AVAVAVAV", 20, rgb(0), anchor);
    text.turn = turn;
    figure.items.push_back({text, -1});
    const cv::Mat image = render(figure);
    int left = image.cols, right = 0, top = image.rows, bottom = 0;
    for (int y = 0; y < image.rows; ++y)
      for (int x = 0; x < image.cols; ++x)
        if (image.at<cv::Vec3b>(y, x)[0] < 128)
          left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
    return cv::Rect(left, top, right - left, bottom - top);
  };
  const cv::Rect start = columns(Anchor::start, 0), middle = columns(Anchor::middle, 0), end = columns(Anchor::end, 0),
                 up = columns(Anchor::start, -90);
  EXPECT_LT(start.width, 2 * 8 * 0.684 * 20 - 8);  // less than the sum of the advances
  EXPECT_NEAR(start.x, 200, 3);
  EXPECT_NEAR(middle.x + middle.width / 2.0, 200, 3);
  EXPECT_NEAR(end.br().x, 200, 3);
  EXPECT_NEAR(up.height, start.width, 2);
  EXPECT_NEAR(up.br().y, 200, 3);
}

TEST_F(Render, EdgesLieWhereTheyAreDrawn) {
  Figure figure = empty(100, 100);
  figure.items.push_back({Rectangle{{10, 10, 30.25, 20}, rgb(0), {}}, -1});
  figure.items.push_back({Circle{{70, 70}, 20, rgb(0), {}}, -1});
  figure.items.push_back({Path{{{0, 95}, {100, 95}}, false, {}, Pen{rgb(0), 3, Cap::butt, {}}}, -1});
  const cv::Mat image = render(figure, 1);
  double rectangle = 0, circle = 0, line = 0;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x)
      (y >= 92 ? line : x < 45 && y < 45 ? rectangle : circle) += (255 - image.at<cv::Vec3b>(y, x)[0]) / 255.0;
  EXPECT_NEAR(rectangle, 30.25 * 20, 15);
  EXPECT_NEAR(circle, 3.14159 * 400, 20);
  EXPECT_NEAR(line, 300, 10);
}

TEST_F(Render, ClipsAndBlends) {
  Figure figure = empty(40, 40);
  figure.clips = {{10, 10, 10, 10}};
  figure.items.push_back({Rectangle{{0, 0, 40, 40}, rgb(0xff0000, 0.5), {}}, 0});
  const cv::Mat image = render(figure, 1);
  EXPECT_TRUE(near(image.at<cv::Vec3b>(15, 15), rgb(0xff7f7f), 2));
  EXPECT_TRUE(near(image.at<cv::Vec3b>(15, 21), rgb(0xffffff), 0));
}

TEST_F(Render, CellsAreWhereTheGridHasThem) {
  Trace trace = test::drive({{1, 1}, {1, 2}}, 0.5, 0, test::arrived, {1, 3}, 0.2, 0.2);
  TraceShape grid;
  grid.form = WEND_SHAPE_GRID;
  grid.kind = WEND_OBSTACLE;
  grid.columns = 3;
  grid.rows = 2;
  grid.xy = {3, 1, 2};
  grid.cells = {1, 0, 0, 0, 0, 1};  // lower left and upper right
  trace.shapes = {grid};
  const std::vector<MapArm> arms = {{"a", &trace, 0, false, {}}};
  const Figure figure = map_figure(arms, "t");
  const MapView view = view_of(figure, arms);
  const cv::Mat image = render(figure);
  for (const auto& [x, y, filled] :
       {std::tuple{4.0, 2.0, true}, {6.0, 2.0, false}, {4.0, 4.0, false}, {8.0, 4.0, true}})
    EXPECT_EQ(count(image, ink::obstacle_edge, around(view(x, y), 2, 3)) > 0, filled) << x << ", " << y;
}

TEST_F(Render, SaysWhatWentWrong) {
  const Figure good = empty(10, 10);
  EXPECT_EQ(error_of([&] {
              render_png({{folder_ + "/a.png", empty(19000, 19000)}}, {2, program, 60});
            }),
            "cannot draw " + folder_ +
                "/a.png: figure: expected at most 20000 pixels a side and 100000000 in all, found 38000 x 38000");
  EXPECT_EQ(error_of([&] {
              render_png({{folder_ + "/a.png", good}}, {99, program, 60});
            }),
            "cannot draw " + folder_ + "/a.png: scale: expected a number in [0.1, 10]");
  std::filesystem::create_directories(folder_ + "/taken.png");
  EXPECT_EQ(error_of([&] {
              render_png({{folder_ + "/taken.png", good}}, {2, program, 60});
            }),
            "cannot draw " + folder_ + "/taken.png: cannot rename " + folder_ + "/taken.png.tmp to " + folder_ +
                "/taken.png: Is a directory");
  EXPECT_EQ(error_of([&] {
              render_png({{folder_ + "/a.png", good}}, {2, "/no/such/wend-render", 60});
            }),
            "cannot run /no/such/wend-render: No such file or directory; it draws the pictures and stands beside the "
            "wend program");
  EXPECT_EQ(error_of([&] {
              render_png({{folder_ + "/a.png", good}}, {2, "/bin/false", 60});
            }),
            "cannot draw " + folder_ + "/a.png: /bin/false ended with exit code 1 before it answered");
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/a.png"));
}

TEST_F(Render, NamesTheFontItMisses) {
  ::setenv("WEND_FONTS", folder_.c_str(), 1);
  const std::string error = error_of([&] { render_png({{folder_ + "/a.png", empty(10, 10)}}, {2, program, 60}); });
  ::unsetenv("WEND_FONTS");
  EXPECT_EQ(error, "cannot draw " + folder_ +
                       "/a.png: cannot draw text: expected the font DejaVuSans.ttf, found none in " + folder_ +
                       "; install the package fonts-dejavu-core or set WEND_FONTS to the font's folder");
}

TEST_F(Render, TheProgramAnswersEachLineAndGoesOn) {
  std::filesystem::create_directories(folder_);
  const std::string in = folder_ + "/in", out = folder_ + "/out";
  const Json job = {{"out", folder_ + "/b.png"}, {"scale", 1}, {"figure", to_json(empty(10, 10))}};
  write_file(in, "nonsense\n{\"out\": 3}\n" + job.dump() + "\n");
  const int status = std::system((program + " < " + in + " > " + out).c_str());
  EXPECT_EQ(WEXITSTATUS(status), 5);
  const std::string answers = read_file(out);
  EXPECT_NE(answers.find("\"not JSON: "), std::string::npos);
  EXPECT_NE(answers.find("{\"error\":\"expected an object with the path \\\"out\\\"\",\"ok\":false,\"out\":\"\"}\n"),
            std::string::npos);
  EXPECT_TRUE(answers.ends_with("{\"ok\":true,\"out\":\"" + folder_ + "/b.png\"}\n")) << answers;
  EXPECT_EQ(WEXITSTATUS(std::system((program + " --gui 2> /dev/null").c_str())), 2);
}

}  // namespace
}  // namespace wend::core
