#include <gtest/gtest.h>

#include <cmath>
#include <core/run/bounds.hpp>
#include <core/run/failure.hpp>
#include <limits>

namespace wend::core {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

const wend_column columns[] = {{-1, 1, 0, 0, "in", "1"},
                               {0, infinite, 0, 0, "from", "1"},
                               {-infinite, 5, 0, 0, "to", "1"},
                               {-infinite, infinite, 0, 0, "any", "1"},
                               {0, 0, 3, 0, "turn", "1"}};  // a discrete column's low and high mean nothing
const Bounds bounds(wend_space{sizeof(wend_space), 5, columns});

TEST(Bounds, AllowWhatIsInRange) {
  const double rows[] = {-1, 0, 5, 1e308, 0, 1, 1e308, -1e308, -1e308, 2, 0.5, 0, 0, -0.0, 1};
  EXPECT_EQ(bounds.first_outside(rows, 3), 15u);
  EXPECT_EQ(bounds.first_outside(rows, 0), 0u);
}

TEST(Bounds, FindTheFirstValueOutside) {
  const double good[] = {0, 1, 2, 3, 2};
  const struct {
    std::size_t column;
    double value;
  } cases[] = {{0, std::nextafter(1.0, 2.0)},
               {0, -2},
               {1, -1e-300},
               {1, infinite},
               {2, 5.5},
               {2, -infinite},
               {3, infinite},
               {3, NAN},
               {0, NAN},
               {4, 3},
               {4, 0.5},
               {4, -1},
               {4, NAN}};
  for (const auto& one : cases) {
    double rows[10];
    for (std::size_t i = 0; i < 10; ++i) rows[i] = good[i % 5];
    rows[5 + one.column] = one.value;
    EXPECT_EQ(bounds.first_outside(rows, 2), 5 + one.column) << one.column << " " << one.value;
    EXPECT_EQ(bounds.first_outside(rows, 1), 5u);
  }
}

TEST(Bounds, SayWhatTheyExpect) {
  EXPECT_EQ(bounds.expected(0), "a number in -1..1");
  EXPECT_EQ(bounds.expected(1), "a number from 0");
  EXPECT_EQ(bounds.expected(2), "a number up to 5");
  EXPECT_EQ(bounds.expected(3), "a finite number");
  EXPECT_EQ(bounds.expected(4), "a whole number 0..2");
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(bounds.any(i), 0);
  const wend_column high{2, 3, 0, 0, "high", "1"};
  EXPECT_EQ(Bounds(wend_space{sizeof(wend_space), 1, &high}).any(0), 2);
}

TEST(AsText, IsTheShortestThatIsTheNumber) {
  EXPECT_EQ(as_text(2), "2");
  EXPECT_EQ(as_text(0.1), "0.1");
  EXPECT_EQ(as_text(std::nextafter(1.0, 2.0)), "1.0000000000000002");
  EXPECT_EQ(as_text(-NAN), "NaN");
  EXPECT_EQ(as_text(-infinite), "-infinity");
}

}  // namespace
}  // namespace wend::core
