// The innermost loops of the LS-SVM, compiled for several instruction sets; the widest that the CPU has is picked when
// the plugin is loaded.  Lanes are rows, never terms of one sum, and sums over rows have eight fixed parts: all give
// the same bits.
#pragma once
#include <cstddef>
#include <span>

namespace lssvm {

using Index = std::size_t;

// Rows come in strips of 8: a strip of a matrix holds [column][row of the strip], the last one filled up.
inline constexpr Index strip_rows = 8;
inline constexpr Index strips_of(Index rows) {
  return (rows + strip_rows - 1) / strip_rows;
}

struct Loops {
  const char* name;
  Index lanes;
  // c[s] -= a[s] b^T for `strips` strips: c[s] and b have 8 columns, a[s] and b `depth` terms ([term][row]).
  void (*downdate)(double* c, Index c_stride, const double* a, Index a_stride, const double* b, Index depth,
                   Index strips);
  // x[s] := x[s] l^-T for `strips` strips of 8 columns; l is 8 x 8, lower, [column][row], its diagonal inverted.
  void (*solve_strips)(double* x, Index stride, const double* l, Index strips);
  // y[8] -= l z of one strip: `columns` columns.
  void (*subtract_product)(double* y, const double* l, const double* z, Index columns);
  // sums[column][8] += l[column][8] * x[8]
  void (*add_transposed)(double* sums, const double* l, const double* x, Index columns);
  // out[s][8] = exp(-scale |x_row - point|^2), x[s] = [feature][row].
  void (*gaussian)(double* out, Index out_stride, const double* x, Index x_stride, const double* point, Index features,
                   double scale, Index strips);
  // out[k] = sum over strips and rows of weights[k][strip][row] * values[strip][row], for `outputs` outputs.
  void (*weigh)(double* out, const double* weights, Index weights_stride, Index outputs, const double* values,
                Index strips);
};

// For this CPU.
const Loops& loops() noexcept;
// All that this CPU can run, the plain one first: for tests.
std::span<const Loops> every_loops() noexcept;

}  // namespace lssvm
