#include <gtest/gtest.h>
#include <unistd.h>

#include <clocale>
#include <core/run/process_state.hpp>

namespace wend::core {
namespace {

TEST(ProcessState, PutsBackWhatChanged) {
  const ProcessState before;
  EXPECT_EQ(before.restore(), "");
  volatile double third = 1.0 / 3;  // raises the inexact flag, which is no change
  (void)third;
  EXPECT_EQ(before.restore(), "");

  std::fesetround(FE_UPWARD);
  EXPECT_EQ(before.restore(), "floating-point rounding");
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);

  char here[4096];
  ASSERT_NE(::getcwd(here, sizeof here), nullptr);
  ASSERT_EQ(::chdir("/"), 0);
  ASSERT_NE(std::setlocale(LC_ALL, "C.UTF-8"), nullptr);
  EXPECT_EQ(before.restore(), "locale, working directory");
  char now[4096];
  EXPECT_STREQ(::getcwd(now, sizeof now), here);
  EXPECT_STREQ(std::setlocale(LC_ALL, nullptr), "C");
  EXPECT_EQ(before.restore(), "");
}

}  // namespace
}  // namespace wend::core
