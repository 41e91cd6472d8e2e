// The multiplexer against its disjunctive normal form: a sum of products, one for each address.
#include "function.hpp"

#include <gtest/gtest.h>

#include <vector>

using multiplexer::Function;

namespace {

// Bits as text, "010..." -> x[0] x[1] ...
std::vector<bool> spelled(std::uint64_t input, int n) {
  std::vector<bool> x;
  for (int i = n - 1; i >= 0; --i) x.push_back((input / (std::uint64_t{1} << i)) % 2 == 1);
  return x;
}

bool six(const std::vector<bool>& x) {
  return (!x[0] && !x[1] && x[2]) || (!x[0] && x[1] && x[3]) || (x[0] && !x[1] && x[4]) || (x[0] && x[1] && x[5]);
}

bool eleven(const std::vector<bool>& x) {
  const bool a = x[0], b = x[1], c = x[2];
  return (!a && !b && !c && x[3]) || (!a && !b && c && x[4]) || (!a && b && !c && x[5]) || (!a && b && c && x[6]) ||
         (a && !b && !c && x[7]) || (a && !b && c && x[8]) || (a && b && !c && x[9]) || (a && b && c && x[10]);
}

}  // namespace

TEST(Function, AllAnswersOfTheSixMultiplexer) {
  const Function function(2);
  ASSERT_EQ(function.size(), 6u);
  ASSERT_EQ(function.inputs(), 64u);
  for (std::uint64_t input = 0; input < 64; ++input)
    EXPECT_EQ(function.answer(input) == 1, six(spelled(input, 6))) << input;
}

TEST(Function, AllAnswersOfTheElevenMultiplexer) {
  const Function function(3);
  ASSERT_EQ(function.size(), 11u);
  ASSERT_EQ(function.inputs(), 2048u);
  for (std::uint64_t input = 0; input < 2048; ++input)
    EXPECT_EQ(function.answer(input) == 1, eleven(spelled(input, 11))) << input;
}

TEST(Function, AllAnswersOfTheTwentyMultiplexer) {
  const Function function(4);
  ASSERT_EQ(function.size(), 20u);
  std::uint64_t wrong = 0, ones = 0;
  for (std::uint64_t input = 0; input < function.inputs(); ++input) {
    const std::uint64_t data = input & 0xffff, address = input >> 16;
    const bool expected = data >> (15 - address) & 1;  // the data bits are the lower 16, the first one on top
    ones += expected;
    wrong += (function.answer(input) == 1) != expected;
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_EQ(ones, std::uint64_t{1} << 19);
}

TEST(Function, ExamplesByHand) {
  const Function function(2);
  EXPECT_EQ(function.answer(0b100010), 1u);
  EXPECT_EQ(function.answer(0b000111), 0u);
  EXPECT_EQ(function.answer(0b110101), 1u);
}

TEST(Function, BitsAreReadFromTheMostSignificant) {
  const Function function(5);
  EXPECT_EQ(function.size(), 37u);
  const std::uint64_t input = 0b1000'0000'0000'0000'0000'0000'0000'0000'0000'1;
  EXPECT_EQ(function.bit(input, 0), 1u);
  EXPECT_EQ(function.bit(input, 1), 0u);
  EXPECT_EQ(function.bit(input, 36), 1u);
}
