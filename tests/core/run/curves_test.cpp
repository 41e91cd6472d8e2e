#include <gtest/gtest.h>

#include <cmath>
#include <core/run/curves.hpp>

namespace wend::core {
namespace {

TEST(CurveBook, KeepsFourHundredPointsAsTheyAre) {
  CurveBook book;
  for (int i = 1; i <= 400; ++i) book.add("y", "x", std::nullopt, i, 2 * i);
  const auto curves = book.take();
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].metric, "y");
  EXPECT_EQ(curves[0].x, "x");
  ASSERT_EQ(curves[0].points.size(), 400u);
  for (int i = 1; i <= 400; ++i)
    EXPECT_EQ(curves[0].points[static_cast<std::size_t>(i - 1)], std::make_pair(double(i), 2.0 * i));
}

// Of n points 1, 2, ... with y = x, bins of size b hold the mean of b neighbours, ending at x = k b.
TEST(CurveBook, AveragesNeighboursBeyond) {
  for (const int n : {401, 402, 800, 801, 5000}) {
    CurveBook book;
    for (int i = 1; i <= n; ++i) book.add("y", "x", std::nullopt, i, i);
    const auto points = book.take()[0].points;
    int bin = 1;
    while (n > 400 * bin) bin *= 2;
    ASSERT_EQ(points.size(), static_cast<std::size_t>((n + bin - 1) / bin)) << n;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const int first = static_cast<int>(k) * bin + 1, last = std::min(n, first + bin - 1);
      EXPECT_EQ(points[k], std::make_pair(double(last), (first + last) / 2.0)) << n;
    }
  }
}

TEST(CurveBook, LeavesOutWhatDoesNotApplyAndKeepsRobotsApart) {
  CurveBook book;
  book.add("y", "x", 1, 1, 10);
  book.add("y", "x", 0, 1, 20);
  book.add("y", "x", 0, 2, std::nan(""));
  book.add("y", "x", 0, INFINITY, 1);
  book.add("y", "x", std::nullopt, 1, 30);
  const auto curves = book.take();
  ASSERT_EQ(curves.size(), 3u);
  EXPECT_EQ(curves[0].robot, std::nullopt);
  EXPECT_EQ(curves[1].robot, 0u);
  EXPECT_EQ(curves[1].points, (std::vector<std::pair<double, double>>{{1, 20}}));
  EXPECT_EQ(curves[2].robot, 1u);
  EXPECT_TRUE(book.take().empty());
}

// Three plannings of 3, 1 and 2 generations: what ended early keeps its last value.
TEST(SeriesBook, IsTheMeanOverAllUses) {
  SeriesBook book;
  for (const auto& [x, y] : {std::pair(0, 9.0), {1, 6.0}, {2, 3.0}, {0, 3.0}, {0, 6.0}, {1, 0.0}})
    book.add("best", "generation", x, y);
  book.add("best", "generation", 2, NAN);
  const auto curves = book.take();
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].metric, "best");
  EXPECT_EQ(curves[0].x, "generation");
  EXPECT_EQ(curves[0].points, (std::vector<std::pair<double, double>>{{0, 6}, {1, 3}, {2, 2}}));
  EXPECT_TRUE(book.take().empty());
}

// Episodes side by side plan in another order than one after the other.
TEST(SeriesBook, TheOrderOfTheUsesIsOfNoConsequence) {
  SeriesBook book;
  for (int run = 0; run < 150; ++run) book.add("best", "generation", 0, 0.1 * run);
  const auto points = book.take()[0].points;
  for (int run = 150; run-- > 0;) book.add("best", "generation", 0, 0.1 * run);
  EXPECT_EQ(book.take()[0].points, points);
}

TEST(SeriesBook, LeavesOutWhatIsTooMuch) {
  SeriesBook book;
  for (int run = 0; run < 150; ++run) book.add("best", "generation", 0, run == 0 ? 100 : 0);
  const double mean = book.take()[0].points.at(0).second;
  EXPECT_TRUE(mean == 0 || mean == 1) << mean;  // of 100 uses
  for (int i = 0; i < 3000; ++i) book.add("best", "generation", i, i);
  EXPECT_EQ(book.take()[0].points.size(), 2000u);
}

}  // namespace
}  // namespace wend::core
