// Sums of products of feature rows: the matrix products in which LSPI spends its time.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace lspi {

// sum += X^T Y over chosen rows of X and Y.  The kernels of the instruction sets differ in speed and in no bit: each
// element is added up over 256 rows at a time, in an order of its own, in one lane, by one rounded multiplication and
// one rounded addition a row.
class Products {
 public:
  // Lanes of the kernels that this processor can run, the widest last.
  static std::span<const unsigned> widths() noexcept;

  explicit Products(std::size_t m, unsigned width = widths().back());

  // x, y: L x m, row-major; some: numbers of rows; sum: m x m, row-major.
  void add(const double* x, const double* y, std::span<const std::uint32_t> some, double* sum);
  // Of X^T X, which is symmetric, the lower triangle; what this leaves above the diagonal has no meaning.
  void add_square(const double* x, std::span<const std::uint32_t> some, double* sum);

 private:
  struct Kernel;
  static const Kernel kernels[];

  void gather(const double* x, const double* y, std::span<const std::uint32_t> some);
  void take_pair(std::size_t n);
  void add_pair(std::size_t n, double* sum);
  void add_tiles(std::size_t n, bool lower, double* sum);

  const Kernel* kernel_;
  std::size_t m_;
  std::size_t strip_;                      // columns of X that a tile takes
  std::vector<double> own_, other_;        // rows of X one after another; of Y in panels, filled up with zeros
  std::vector<double> pair_, even_, odd_;  // see take_pair()
};

}  // namespace lspi
