// Numbers in messages.
#include <gtest/gtest.h>

#include <wend/error.hpp>

TEST(NumberText, IsShortAndKeepsWhatMatters) {
  EXPECT_EQ(wend::number_text(300), "300");
  EXPECT_EQ(wend::number_text(-0.25), "-0.25");
  EXPECT_EQ(wend::number_text(0.1 + 0.2), "0.3");
  EXPECT_EQ(wend::number_text(1e-9), "1e-09");
  EXPECT_EQ(wend::number_text(1e12), "1e+12");
  EXPECT_EQ(wend::number_text(10000000), "10000000");
}
