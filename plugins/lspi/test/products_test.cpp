// The kernels of every instruction set against three plain loops.
#include "products.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <wend/random.hpp>

namespace {

struct Case {
  std::size_t m;
  std::vector<double> x, y;
  std::vector<std::uint32_t> some;
};

Case random_case(std::size_t m, std::size_t rows, std::uint64_t seed) {
  wend::Random random(seed);
  Case made{m, std::vector<double>(rows * m), std::vector<double>(rows * m), {}};
  for (double& value : made.x) value = random.uniform(-1, 1);
  for (double& value : made.y) value = random.uniform(-1, 1);
  for (std::uint32_t i = 0; i < rows; ++i)
    if (i % 7 != 3) made.some.push_back(i);
  return made;
}

// Element (i, j): 256 rows at a time, each time from zero.
double expected(const Case& c, const std::vector<double>& y, std::size_t i, std::size_t j) {
  double sum = 0;
  for (std::size_t at = 0; at < c.some.size(); at += 256) {
    double part = 0;
    for (std::size_t k = at; k < std::min(at + 256, c.some.size()); ++k)
      part += c.x[c.some[k] * c.m + i] * y[c.some[k] * c.m + j];
    sum += part;
  }
  return sum;
}

const std::size_t sizes[] = {1, 2, 3, 4, 5, 7, 8, 9, 10, 11, 15, 16, 17, 25, 26, 31, 33, 50, 67};

}  // namespace

TEST(Products, EveryKernelGivesTheSameBits) {
  for (const std::size_t m : sizes)
    for (const std::size_t rows : {1, 2, 7, 9, 16, 40, 300, 700}) {
      const Case c = random_case(m, rows, 100 * m + rows);
      std::vector<double> first;
      for (const unsigned width : lspi::Products::widths()) {
        std::vector<double> sum(m * m, 0);
        lspi::Products(m, width).add(c.x.data(), c.y.data(), c.some, sum.data());
        if (first.empty()) first = sum;
        EXPECT_EQ(sum, first) << m << " features, " << rows << " rows, " << width << " lanes";
      }
      for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < m; ++j) {
          const bool pair = m % 4 > 1 && j >= m / 4 * 4 && j < m / 4 * 4 + 2;  // summed in another order
          const double plain = expected(c, c.y, i, j);
          if (pair)
            EXPECT_NEAR(first[i * m + j], plain, 1e-12);
          else
            EXPECT_EQ(first[i * m + j], plain) << m << " features, " << rows << " rows, " << i << " " << j;
        }
    }
}

TEST(Products, TheSquareIsThatOfPlainLoops) {
  for (const std::size_t m : sizes)
    for (const std::size_t rows : {1, 9, 300, 700}) {
      const Case c = random_case(m, rows, 100 * m + rows);
      for (const unsigned width : lspi::Products::widths()) {
        std::vector<double> sum(m * m, 0);
        lspi::Products(m, width).add_square(c.x.data(), c.some, sum.data());
        for (std::size_t i = 0; i < m; ++i)
          for (std::size_t j = 0; j <= i; ++j)
            EXPECT_EQ(sum[i * m + j], expected(c, c.x, i, j)) << m << " " << rows << " " << width;
      }
    }
}

TEST(Products, AreAddedToWhatIsThere) {
  lspi::Products products(2);
  std::vector<double> sum{1, 2, 3, 4};
  const std::vector<double> x{1, 2, 0, 1}, y{5, 6, 7, 8};
  const std::vector<std::uint32_t> both{0, 1};
  products.add(x.data(), y.data(), both, sum.data());
  EXPECT_EQ(sum, (std::vector<double>{1 + 5, 2 + 6, 3 + 10 + 7, 4 + 12 + 8}));
}

TEST(Products, NoRowsAddNothing) {
  lspi::Products products(3);
  std::vector<double> sum(9, 1);
  products.add(nullptr, nullptr, {}, sum.data());
  products.add_square(nullptr, {}, sum.data());
  EXPECT_EQ(sum, std::vector<double>(9, 1));
}
