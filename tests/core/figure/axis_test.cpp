#include <gtest/gtest.h>

#include <cmath>
#include <core/figure/axis.hpp>
#include <core/figure/simplify.hpp>
#include <core/figure/style.hpp>
#include <set>

namespace wend::core {
namespace {

std::vector<std::string> labels(const Axis& axis) {
  std::vector<std::string> all;
  for (const Tick& tick : axis.ticks()) all.push_back(tick.label);
  return all;
}

using Labels = std::vector<std::string>;

TEST(Axis, HasRoundTicks) {
  EXPECT_EQ(labels(Axis::fixed(0, 1, 0, 100, 5)), (Labels{"0", "0.2", "0.4", "0.6", "0.8", "1"}));
  EXPECT_EQ(labels(Axis::fixed(0, 10000, 0, 100, 5)), (Labels{"0", "2,000", "4,000", "6,000", "8,000", "10,000"}));
  EXPECT_EQ(labels(Axis::linear(-3, 14, 0, 100, 4)), (Labels{"−5", "0", "5", "10", "15"}));
  EXPECT_EQ(labels(Axis::logarithmic(500, 10000, true, 0, 100)),
            (Labels{"0", "500", "1,000", "2,000", "5,000", "10,000"}));
  EXPECT_EQ(labels(Axis::logarithmic(1, 1e5, false, 0, 100)), (Labels{"1", "10", "100", "1,000", "10,000", "100,000"}));
}

TEST(Axis, MapsValuesToPixels) {
  const Axis linear = Axis::fixed(2, 4, 100, 0), log = Axis::logarithmic(1, 100, false, 0, 10);
  EXPECT_DOUBLE_EQ(linear.pixel(2), 100);
  EXPECT_DOUBLE_EQ(linear.pixel(3), 50);
  EXPECT_DOUBLE_EQ(log.pixel(10), 5);
  EXPECT_DOUBLE_EQ(Axis::logarithmic(1, 100, true, 0, 10).pixel(0), 0);
}

TEST(Axis, SurvivesValuesThatSpanNothing) {
  for (const Axis& axis : {Axis::linear(5, 5, 0, 1), Axis::linear(0, 0, 0, 1), Axis::linear(NAN, 1, 0, 1),
                           Axis::fixed(1, INFINITY, 0, 1), Axis::logarithmic(0, -1, true, 0, 1)}) {
    EXPECT_GE(axis.ticks().size(), 2u);
    EXPECT_TRUE(std::isfinite(axis.pixel(1)));
  }
}

TEST(Axis, ReadsUnitsOffNames) {
  EXPECT_EQ(quantity("path_length_m").title(), "path length (m)");
  EXPECT_EQ(quantity("decision_us").title(), "decision (µs)");
  EXPECT_EQ(quantity("train_episodes").title(), "training episodes");
  EXPECT_EQ(quantity("success").title(), "success rate");
}

TEST(Axis, RoundsScaleBarsDown) {
  EXPECT_DOUBLE_EQ(round_down_nicely(9.99), 5);
  EXPECT_DOUBLE_EQ(round_down_nicely(0.2), 0.2);
  EXPECT_DOUBLE_EQ(round_down_nicely(1000), 1000);
}

TEST(Style, TellsArmsApartTwice) {
  std::set<std::uint32_t> colours;
  std::set<std::vector<double>> dashes;
  for (std::size_t i = 0; i < 8; ++i) {
    const LineStyle style = line_style(i);
    colours.insert(style.colour.red << 16 | style.colour.green << 8 | style.colour.blue);
    dashes.insert(style.dash);
  }
  EXPECT_EQ(colours.size(), 8u);
  EXPECT_EQ(dashes.size(), 8u);
  for (std::size_t i = 0; i < 64; ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(line_style(i) == line_style(j)) << i << " and " << j;
}

TEST(Style, GroupsThousands) {
  EXPECT_EQ(grouped(1234567.891, 1), "1,234,567.9");
  EXPECT_EQ(grouped(-1000), "−1,000");
  EXPECT_EQ(grouped(54, 1), "54");
  EXPECT_EQ(grouped(54, 1, true), "54.0");
  EXPECT_EQ(grouped(-0.0001, 2), "0");
}

TEST(Simplify, StaysWithinTheToleranceAndKeepsTheEnds) {
  std::vector<Place> line;
  for (int i = 0; i <= 20000; ++i) line.push_back({i * 0.05, 40 * std::sin(i * 0.001)});
  line[77].x = NAN;
  const std::vector<Place> kept = simplified(line, 0.15);
  EXPECT_LT(kept.size(), 400u);
  EXPECT_EQ(kept.front(), line.front());
  EXPECT_EQ(kept.back(), line.back());
  for (std::size_t k = 1; k < kept.size(); ++k) {  // upright, 0.15 px across a slope of 0.8 is 0.19 px
    const double x = (kept[k - 1].x + kept[k].x) / 2, y = (kept[k - 1].y + kept[k].y) / 2;
    EXPECT_NEAR(y, 40 * std::sin(x / 0.05 * 0.001), 0.2);
  }
}

}  // namespace
}  // namespace wend::core
