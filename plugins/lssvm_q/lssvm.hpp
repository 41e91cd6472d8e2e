// Least-squares support vector machines with Gaussian kernels (Suykens, Vandewalle 1999), of any number of targets:
//   [0 1^T; 1 H] [b; alpha] = [0; y],  H = K + I / C,  K_ij = exp(-|x_i - x_j|^2 / (2 sigma^2))
// One Cholesky factor of H serves them all: H eta = 1, H nu = y, b = 1^T nu / 1^T eta, alpha = nu - b eta.  A
// classifier of several classes is the same with targets +1 and -1, one against the rest.
#pragma once
#include <span>
#include <vector>
#include <wend/bytes.hpp>

#include "cholesky.hpp"

namespace lssvm {

// n x d inputs in strips: [feature][row of the strip].
class Points {
 public:
  Points() = default;
  Points(std::span<const double> row_major, Index features);

  Index rows() const noexcept { return rows_; }
  Index strips() const noexcept { return strips_of(rows_); }
  Index features() const noexcept { return features_; }
  Index stride() const noexcept { return strip_rows * features_; }
  const double* strip(Index s) const noexcept { return data_.data() + s * stride(); }
  void copy(Index row, double* out) const noexcept;

 private:
  Index rows_ = 0, features_ = 0;
  Buffer data_;
};

struct Dual {
  std::vector<double> alpha;
  double b = 0;
};

class Lssvm {
 public:
  // Throws wend::Error where H is not positive definite within rounding (C too large for inputs that repeat).
  Lssvm(Points x, double sigma, double c, const Loops& loops = lssvm::loops());

  Index rows() const noexcept { return x_.rows(); }

  // For `count` targets of rows() numbers each.
  std::vector<Dual> fit(std::span<const double> targets, Index count) const;

  // |A z - rhs| / |rhs| of the whole system, from kernel values computed anew (2-norm).
  double residual(const Dual& solution, std::span<const double> target) const;

  // Estimate of H's condition number (1-norm; Hager 1984, Higham 1988), never too high by more than rounding.
  double condition() const;

 private:
  void multiply(const double* v, double* out) const;  // out = H v
  void invert(Buffer& v) const { factor_.solve(*loops_, v.data(), 1, v.size()); }

  const Loops* loops_;
  Points x_;
  double scale_, ridge_;
  Cholesky factor_;
  Buffer eta_;
};

// f_k(x) = b_k + sum_j w_kj exp(-|x - x_j|^2 / (2 sigma^2)) for k < outputs.
class Expansion {
 public:
  Expansion() = default;
  Expansion(Points x, double sigma, Index outputs, const Loops& loops = lssvm::loops());

  Index outputs() const noexcept { return biases_.size(); }
  const Points& points() const noexcept { return x_; }
  void set(Index output, Index row, double weight) noexcept { weights_[output * padded() + row] = weight; }
  void set_bias(Index output, double b) noexcept { biases_[output] = b; }

  // out[k] = f_k(point) for k < count.
  void evaluate(const double* point, double* out, Index count);

  // The kernel values of a point, padded() of them, to be weighed as often as wanted.
  Index padded() const noexcept { return x_.strips() * strip_rows; }
  void kernel(const double* point, double* values) const;
  void weigh(const double* values, double* out, Index count) const;

  void save(wend::Writer& writer) const;
  // `features` and `outputs` are what is expected; nothing at all may have been saved too.
  static Expansion load(wend::Reader& reader, Index features, double sigma, Index outputs);

 private:
  const Loops* loops_ = nullptr;
  Points x_;
  double scale_ = 0;
  Buffer weights_, values_;  // outputs x padded(); padded()
  std::vector<double> biases_;
};

}  // namespace lssvm
