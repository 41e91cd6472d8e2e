#include "products.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace lspi {

// sum += x^T y of n rows.  Of x it takes as many columns as the tile is for, m apart from row to row; of y a panel, of
// which the first `columns` count; sum has m columns.  The sums stay in registers while it runs.
using Tile = void (*)(const double* x, std::size_t m, const double* y, std::size_t n, double* sum, std::size_t columns);

}  // namespace lspi

#define LSPI_SET plain
#define LSPI_LANES 2
#define LSPI_REGISTERS 2
#define LSPI_ROWS 5
#define LSPI_TARGET
#include "product_tiles.inc"

#if defined(__x86_64__)
#define LSPI_SET avx2
#define LSPI_LANES 4
#define LSPI_REGISTERS 2
#define LSPI_ROWS 6
#define LSPI_TARGET __attribute__((target("avx2")))
#include "product_tiles.inc"

#define LSPI_SET avx512
#define LSPI_LANES 8
#define LSPI_REGISTERS 2
#define LSPI_ROWS 12
#define LSPI_TARGET __attribute__((target("avx512f")))
#include "product_tiles.inc"
#endif

namespace lspi {
namespace {

constexpr std::size_t chunk = 256;  // rows at a time, so that their copies stay in the cache
constexpr unsigned widths_known[] = {2, 4, 8};

std::size_t kernels_supported() noexcept {
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f")) return 3;
  if (__builtin_cpu_supports("avx2")) return 2;
#endif
  return 1;
}

constexpr std::size_t parts(std::size_t n, std::size_t most) noexcept {
  return (n + most - 1) / most;
}

}  // namespace

struct Products::Kernel {
  std::size_t panel;            // columns of Y that a tile takes
  std::span<const Tile> tiles;  // [n - 1]: the one for n columns of X
};

const Products::Kernel Products::kernels[] = {
    {plain::panel, plain::tiles},
#if defined(__x86_64__)
    {avx2::panel, avx2::tiles},
    {avx512::panel, avx512::tiles},
#endif
};

std::span<const unsigned> Products::widths() noexcept {
  static const std::size_t n = kernels_supported();
  return {widths_known, n};
}

Products::Products(std::size_t m, unsigned width)
    : kernel_(&kernels[std::find(widths().begin(), widths().end() - 1, width) - widths().begin()]),
      m_(m),
      strip_(parts(m, parts(m, kernel_->tiles.size()))),  // strips of nearly the same width
      own_(chunk * m),
      other_(chunk * parts(m, kernel_->panel) * kernel_->panel),
      pair_(chunk * 2),
      even_(m),
      odd_(m) {}

void Products::add(const double* x, const double* y, std::span<const std::uint32_t> some, double* sum) {
  for (std::size_t n; !some.empty(); some = some.subspan(n)) {
    n = std::min(chunk, some.size());
    gather(x, y, some.first(n));
    take_pair(n);
    add_tiles(n, false, sum);
    add_pair(n, sum);
  }
}

void Products::add_square(const double* x, std::span<const std::uint32_t> some, double* sum) {
  for (std::size_t n; !some.empty(); some = some.subspan(n)) {
    n = std::min(chunk, some.size());
    gather(x, x, some.first(n));
    add_tiles(n, true, sum);
  }
}

void Products::gather(const double* x, const double* y, std::span<const std::uint32_t> some) {
  const std::size_t panel = kernel_->panel;
  for (std::size_t k = 0; k < some.size(); ++k) {
    std::copy_n(x + some[k] * m_, m_, own_.data() + k * m_);
    const double* row = y + some[k] * m_;
    double* to = other_.data() + k * panel;
    for (std::size_t j = 0; j < m_; j += panel, to += chunk * panel) std::copy_n(row + j, std::min(panel, m_ - j), to);
  }
}

void Products::add_tiles(std::size_t n, bool lower, double* sum) {
  const std::size_t panel = kernel_->panel;
  for (std::size_t i = 0; i < m_; i += strip_) {
    const std::size_t rows = std::min(strip_, m_ - i);
    for (std::size_t j = 0; j < (lower ? i + rows : m_); j += panel)
      kernel_->tiles[rows - 1](own_.data() + i, m_, other_.data() + j * chunk, n, sum + i * m_ + j,
                               std::min(panel, m_ - j));
  }
}

// Where m mod 4 is 2 or 3, the first two of the columns of Y after the last whole four are summed in another order:
// over every eight rows, the even and the odd ones apart.  Eigen's kernel for two lanes does so, and sums that are the
// same to the last bit keep results the same that were computed with it.
void Products::take_pair(std::size_t n) {
  if (m_ % 4 < 2) return;
  const std::size_t first = m_ / 4 * 4, panel = kernel_->panel;
  double* from = other_.data() + first / panel * panel * chunk + first % panel;
  for (std::size_t k = 0; k < n; ++k, from += panel) {
    pair_[2 * k] = std::exchange(from[0], 0.0);
    pair_[2 * k + 1] = std::exchange(from[1], 0.0);
  }
}

void Products::add_pair(std::size_t n, double* sum) {
  if (m_ % 4 < 2) return;
  const std::size_t first = m_ / 4 * 4, eights = n / 8 * 8;
  for (std::size_t column = 0; column < 2; ++column) {
    std::fill(even_.begin(), even_.end(), 0);
    std::fill(odd_.begin(), odd_.end(), 0);
    const auto add_row = [&](std::size_t k, std::size_t begin, std::size_t end, double* to) {
      const double* x = own_.data() + k * m_;
      const double y = pair_[2 * k + column];
      for (std::size_t i = begin; i < end; ++i) to[i] += x[i] * y;
    };
    for (std::size_t k = 0; k < eights; ++k) add_row(k, 0, first, (k % 2 ? odd_ : even_).data());
    for (std::size_t i = 0; i < first; ++i) even_[i] += odd_[i];
    for (std::size_t k = eights; k < n; ++k) add_row(k, 0, first, even_.data());
    for (std::size_t k = 0; k < n; ++k) add_row(k, first, m_, even_.data());
    for (std::size_t i = 0; i < m_; ++i) sum[i * m_ + first + column] += even_[i];
  }
}

}  // namespace lspi
