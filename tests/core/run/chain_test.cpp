#include <gtest/gtest.h>

#include <core/run/rollout.hpp>
#include <cstring>

namespace wend::core {
namespace {

TEST(Chain, IsTheXxh3OfAllBytes) {
  Chain chain;
  EXPECT_EQ(chain.digest(), "99aa06d3014798d86001c324468d497f");  // XXH3-128 of nothing
  chain.add("ab", 2);
  chain.add("c", 1);
  Chain whole;
  whole.add("abc", 3);
  EXPECT_EQ(chain.digest(), whole.digest());
  EXPECT_EQ(chain.digest(), whole.digest());  // asking changes nothing
  chain.reset();
  EXPECT_EQ(chain.digest(), "99aa06d3014798d86001c324468d497f");
}

TEST(Chain, TellsTheLastBitApart) {
  const double value = 1;
  for (int bit = 0; bit < 64; ++bit) {
    std::uint64_t bits;
    std::memcpy(&bits, &value, 8);
    bits ^= std::uint64_t{1} << bit;
    Chain a, b;
    a.add(&value, 8);
    b.add(&bits, 8);
    EXPECT_NE(a.digest(), b.digest()) << bit;
  }
}

}  // namespace
}  // namespace wend::core
