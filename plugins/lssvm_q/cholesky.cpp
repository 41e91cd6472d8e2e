#include "cholesky.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lssvm {
namespace {

// The 8 x 8 block of a strip at its diagonal, [column][row]; the diagonal of the factor is kept inverted, for it is
// only ever divided by.
bool factor_block(double* block) {
  for (Index j = 0; j < strip_rows; ++j) {
    double* column = block + j * strip_rows;
    if (!(column[j] > 0)) return false;
    column[j] = 1 / std::sqrt(column[j]);
    for (Index i = j + 1; i < strip_rows; ++i) column[i] *= column[j];
    for (Index k = j + 1; k < strip_rows; ++k)
      for (Index i = k; i < strip_rows; ++i) block[k * strip_rows + i] -= column[i] * column[k];
  }
  return true;
}

// y[8] := l^-1 y
void forward_block(const double* l, double* y) {
  for (Index j = 0; j < strip_rows; ++j) {
    y[j] *= l[j * strip_rows + j];
    for (Index i = j + 1; i < strip_rows; ++i) y[i] -= l[j * strip_rows + i] * y[j];
  }
}

// y[8] := l^-T (y - the sums of each column's eight parts)
void backward_block(const double* l, const double* sums, double* y) {
  for (Index j = strip_rows; j-- > 0;) {
    const double* p = sums + j * strip_rows;
    double rest = y[j] - (((p[0] + p[4]) + (p[2] + p[6])) + ((p[1] + p[5]) + (p[3] + p[7])));
    for (Index i = j + 1; i < strip_rows; ++i) rest -= l[j * strip_rows + i] * y[i];
    y[j] = rest * l[j * strip_rows + j];
  }
}

}  // namespace

void Cholesky::resize(Index n) {
  rows_ = n;
  strips_ = strips_of(n);
  offsets_.clear();
  Index size = 0;
  for (Index panel = 0; first_strip(panel) < strips_; ++panel) {
    offsets_.push_back(size);
    size += (strips_ - first_strip(panel)) * strip_rows * width(panel);
  }
  data_.resize(size);
}

Index Cholesky::width(Index panel) const noexcept {
  return std::min(panel_columns, strips_ * strip_rows - panel * panel_columns);
}

double* Cholesky::column(Index s, Index column) noexcept {
  return strip(column / panel_columns, s) + column % panel_columns * strip_rows;
}

// Columns of the panel, eight at a time: what the ones before take from them, their block, the strips below it.
bool Cholesky::factor_panel(const Loops& loops, Index panel) {
  const Index first = first_strip(panel), stride = strip_rows * width(panel);
  for (Index t = 0; t < width(panel) / strip_rows; ++t) {
    double* top = strip(panel, first + t);
    double* block = top + t * strip_rows * strip_rows;
    const Index below = strips_ - first - t;
    if (t > 0) loops.downdate(block, stride, top, stride, top, t * strip_rows, below);
    if (!factor_block(block)) return false;
    if (below > 1) loops.solve_strips(block + stride, stride, block, below - 1);
  }
  return true;
}

bool Cholesky::factor(const Loops& loops) {
  for (Index panel = 0; panel < offsets_.size(); ++panel) {
    if (!factor_panel(loops, panel)) return false;
    const Index from = strip_rows * width(panel);
    for (Index later = panel + 1; later < offsets_.size(); ++later) {
      const Index to = strip_rows * width(later), first = first_strip(later);
      constexpr Index at_once = 12;  // strips of this panel that the first cache keeps
      for (Index s = first; s < strips_; s += at_once)
        for (Index t = first; t < first + width(later) / strip_rows; ++t) {
          const Index top = std::max(s, t), end = std::min(s + at_once, strips_);
          if (top < end)
            loops.downdate(strip(later, top) + (t - first) * strip_rows * strip_rows, to, strip(panel, top), from,
                           strip(panel, t), width(panel), end - top);
        }
    }
  }
  return true;
}

void Cholesky::forward(const Loops& loops, double* y, Index count, Index stride) const {
  for (Index panel = 0; panel < offsets_.size(); ++panel) {
    const Index first = first_strip(panel), columns = width(panel);
    for (Index s = first; s < strips_; ++s) {
      const double* l = strip(panel, s);
      const Index before = std::min((s - first) * strip_rows, columns);
      for (Index k = 0; k < count; ++k) {
        double* own = y + k * stride;
        if (before > 0) loops.subtract_product(own + s * strip_rows, l, own + first * strip_rows, before);
        if (before < columns) forward_block(l + before * strip_rows, own + s * strip_rows);
      }
    }
  }
}

void Cholesky::backward(const Loops& loops, double* y) const {
  alignas(64) std::array<double, panel_columns * strip_rows> sums;
  for (Index panel = offsets_.size(); panel-- > 0;) {
    const Index first = first_strip(panel), columns = width(panel);
    sums.fill(0);
    for (Index s = strips_; s-- > first;) {
      const Index before = std::min((s - first) * strip_rows, columns);
      const double* l = strip(panel, s);
      if (before < columns)
        backward_block(l + before * strip_rows, sums.data() + before * strip_rows, y + s * strip_rows);
      if (before > 0) loops.add_transposed(sums.data(), l, y + s * strip_rows, before);
    }
  }
}

void Cholesky::solve(const Loops& loops, double* y, Index count, Index stride) const {
  forward(loops, y, count, stride);
  for (Index k = 0; k < count; ++k) backward(loops, y + k * stride);
}

}  // namespace lssvm
