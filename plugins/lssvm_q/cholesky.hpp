// Cholesky factor of a symmetric positive definite matrix, blocked, in strips of rows (simd.hpp), and solving with it.
#pragma once
#include <new>
#include <span>
#include <vector>

#include "simd.hpp"

namespace lssvm {

// Doubles that begin on a cache line.
template <class T>
struct CacheLines {
  using value_type = T;
  CacheLines() = default;
  template <class U>
  CacheLines(const CacheLines<U>&) noexcept {}
  T* allocate(Index n) { return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{64})); }
  void deallocate(T* at, Index) noexcept { ::operator delete (at, std::align_val_t{64}); }
  bool operator==(const CacheLines&) const noexcept { return true; }
};
using Buffer = std::vector<double, CacheLines<double>>;

// The lower triangle in panels of `panel_columns` columns, each of them in strips from its diagonal down.
class Cholesky {
 public:
  static constexpr Index panel_columns = 128;

  // Room for n x n, filled up to whole strips: the caller fills the columns' strips and then factors.
  void resize(Index n);
  Index rows() const noexcept { return rows_; }
  Index strips() const noexcept { return strips_; }

  // Rows 8 s .. 8 s + 7 of `column`, for s >= column / 8; those of the next strip come `stride(column)` further on.
  double* column(Index s, Index column) noexcept;
  Index stride(Index column) const noexcept { return strip_rows * width(column / panel_columns); }

  // H := L.  False where H is not positive definite within rounding.
  bool factor(const Loops& loops);

  // y := H^-1 y for `count` right-hand sides of strips() * 8 numbers, `stride` apart.
  void solve(const Loops& loops, double* y, Index count, Index stride) const;

 private:
  Index first_strip(Index panel) const noexcept { return panel * (panel_columns / strip_rows); }
  Index width(Index panel) const noexcept;
  double* strip(Index panel, Index s) noexcept {
    return data_.data() + offsets_[panel] + (s - first_strip(panel)) * strip_rows * width(panel);
  }
  const double* strip(Index panel, Index s) const noexcept { return const_cast<Cholesky*>(this)->strip(panel, s); }
  bool factor_panel(const Loops& loops, Index panel);
  void forward(const Loops& loops, double* y, Index count, Index stride) const;
  void backward(const Loops& loops, double* y) const;

  Index rows_ = 0, strips_ = 0;
  std::vector<Index> offsets_;  // of the panels
  Buffer data_;
};

}  // namespace lssvm
