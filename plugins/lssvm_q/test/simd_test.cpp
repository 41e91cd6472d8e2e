// Every instruction set gives the bits of the plain loops, and the plain loops are what they say.
#include "simd.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cholesky.hpp"
#include "dense.hpp"

namespace {

using lssvm::Buffer;
using lssvm::every_loops;
using lssvm::Loops;

Buffer buffer(std::size_t n, std::uint64_t key) {
  const std::vector<double> values = dense::normals(n, key);
  return {values.begin(), values.end()};
}

}  // namespace

TEST(Simd, TheWidestSetIsPicked) {
  EXPECT_EQ(lssvm::loops().name, every_loops().back().name);
}

TEST(Simd, DowndatesAlikeInEverySet) {
  for (const std::size_t strips : {1u, 2u, 3u, 4u, 7u}) {
    const std::size_t depth = 24;
    const Buffer a = buffer(strips * 8 * depth, 1), b = buffer(8 * depth, 2), c = buffer(strips * 64, 3);
    Buffer first;
    for (const Loops& loops : every_loops()) {
      Buffer out = c;
      loops.downdate(out.data(), 64, a.data(), 8 * depth, b.data(), depth, strips);
      if (first.empty()) first = out;
      EXPECT_EQ(out, first) << loops.name;
    }
    for (std::size_t s = 0; s < strips; ++s)
      for (std::size_t j = 0; j < 8; ++j)
        for (std::size_t i = 0; i < 8; ++i) {
          double sum = 0;
          for (std::size_t k = 0; k < depth; ++k) sum += a[s * 8 * depth + k * 8 + i] * b[k * 8 + j];
          EXPECT_NEAR(first[s * 64 + j * 8 + i], c[s * 64 + j * 8 + i] - sum, 1e-12);
        }
  }
}

TEST(Simd, TheOtherLoopsAreAlikeInEverySet) {
  const std::size_t strips = 5, features = 11, columns = 16;
  const Buffer x = buffer(strips * 8 * features, 4), l = buffer(8 * columns, 5), z = buffer(columns, 6);
  const std::vector<double> point = dense::normals(features, 7);
  std::vector<Buffer> first;
  for (const Loops& loops : every_loops()) {
    std::vector<Buffer> out{buffer(strips * 64, 8), buffer(8, 9), buffer(8 * columns, 10), Buffer(strips * 8),
                            Buffer(2)};
    loops.solve_strips(out[0].data(), 64, l.data(), strips);
    loops.subtract_product(out[1].data(), l.data(), z.data(), columns);
    loops.add_transposed(out[2].data(), l.data(), z.data(), columns);
    loops.gaussian(out[3].data(), 8, x.data(), 8 * features, point.data(), features, 0.05, strips);
    loops.weigh(out[4].data(), x.data(), strips * 8, 2, out[3].data(), strips);
    if (first.empty()) first = out;
    EXPECT_EQ(out, first) << loops.name;
  }
  for (std::size_t i = 0; i < strips * 8; ++i) {
    double square = 0;
    for (std::size_t f = 0; f < features; ++f) {
      const double apart = x[i / 8 * 8 * features + f * 8 + i % 8] - point[f];
      square += apart * apart;
    }
    EXPECT_NEAR(first[3][i], std::exp(-0.05 * square), 1e-15);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    double sum = 0;
    for (std::size_t i = 0; i < strips * 8; ++i) sum += x[k * strips * 8 + i] * first[3][i];
    EXPECT_NEAR(first[4][k], sum, 1e-13);
  }
}

TEST(Simd, TheExponentialIsRightToTwoUnitsInTheLastPlace) {
  const double zero = 0;
  for (const Loops& loops : every_loops())
    for (int i = 0; i < 4000; ++i) {
      double x[8], out[8];
      for (int r = 0; r < 8; ++r) x[r] = std::sqrt((i * 8 + r) * (699.0 / 32000));
      loops.gaussian(out, 8, x, 8, &zero, 1, 1, 1);
      for (int r = 0; r < 8; ++r) {
        const double expected = std::exp(-(x[r] * x[r]));
        ASSERT_NEAR(out[r], expected, 4.5e-16 * expected) << x[r];
      }
    }
}

TEST(Simd, FarPointsHaveNothingInCommon) {
  const double zero = 0, x[8] = {0, 26.4, 26.5, 1e3, 1e100, 1e154, 1e200, 27};
  for (const Loops& loops : every_loops()) {
    double out[8];
    loops.gaussian(out, 8, x, 8, &zero, 1, 1, 1);
    EXPECT_EQ(out[0], 1);
    EXPECT_GT(out[1], 0);
    for (int r = 2; r < 8; ++r) EXPECT_EQ(out[r], 0) << r;
  }
}
