#include "lssvm.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <wend/error.hpp>

namespace lssvm {

Points::Points(std::span<const double> row_major, Index features)
    : rows_(features ? row_major.size() / features : 0), features_(features), data_(strips() * stride()) {
  for (Index i = 0; i < rows_; ++i)
    for (Index f = 0; f < features_; ++f)
      data_[i / strip_rows * stride() + f * strip_rows + i % strip_rows] = row_major[i * features_ + f];
}

void Points::copy(Index row, double* out) const noexcept {
  const double* at = strip(row / strip_rows) + row % strip_rows;
  for (Index f = 0; f < features_; ++f) out[f] = at[f * strip_rows];
}

Lssvm::Lssvm(Points x, double sigma, double c, const Loops& loops)
    : loops_(&loops), x_(std::move(x)), scale_(0.5 / (sigma * sigma)), ridge_(1 / c) {
  const Index n = x_.rows(), strips = x_.strips(), padded = strips * strip_rows;
  factor_.resize(n);
  std::vector<double> point(x_.features());
  for (Index j = 0; j < padded; ++j) {
    const Index top = j / strip_rows, stride = factor_.stride(j);
    double* column = factor_.column(top, j);
    if (j < n) {
      x_.copy(j, point.data());
      loops.gaussian(column, stride, x_.strip(top), x_.stride(), point.data(), x_.features(), scale_, strips - top);
      column[j % strip_rows] += ridge_;
    }
    double* last = column + (strips - 1 - top) * stride;  // the rows that fill it up are those of a unit matrix
    for (Index i = std::max(n, j); i < padded; ++i) last[i % strip_rows] = i == j ? 1 : 0;
  }
  if (!factor_.factor(loops))
    throw wend::Error(WEND_E_PARAMETER, {},
                      "the LS-SVM's system of " + std::to_string(n) +
                          " samples: expected a positive definite K + I/C, found none within rounding; lower C "
                          "(advice_C of the classification)");
  eta_.assign(padded, 0);
  std::fill_n(eta_.begin(), n, 1.0);
  invert(eta_);
}

std::vector<Dual> Lssvm::fit(std::span<const double> targets, Index count) const {
  const Index n = x_.rows(), padded = x_.strips() * strip_rows;
  Buffer nu(padded * count);
  for (Index k = 0; k < count; ++k) std::copy_n(targets.data() + k * n, n, nu.data() + k * padded);
  factor_.solve(*loops_, nu.data(), count, padded);
  double eta = 0;
  for (Index i = 0; i < n; ++i) eta += eta_[i];
  std::vector<Dual> all(count);
  for (Index k = 0; k < count; ++k) {
    const double* own = nu.data() + k * padded;
    double sum = 0;
    for (Index i = 0; i < n; ++i) sum += own[i];
    all[k].b = sum / eta;
    all[k].alpha.resize(n);
    for (Index i = 0; i < n; ++i) all[k].alpha[i] = own[i] - all[k].b * eta_[i];
  }
  return all;
}

void Lssvm::multiply(const double* v, double* out) const {
  const Index n = x_.rows(), strips = x_.strips();
  std::vector<double> point(x_.features());
  Buffer values(strips * strip_rows), weights(strips * strip_rows);
  std::copy_n(v, n, weights.begin());
  for (Index i = 0; i < n; ++i) {
    x_.copy(i, point.data());
    loops_->gaussian(values.data(), strip_rows, x_.strip(0), x_.stride(), point.data(), x_.features(), scale_, strips);
    loops_->weigh(out + i, weights.data(), values.size(), 1, values.data(), strips);
    out[i] += ridge_ * v[i];
  }
}

double Lssvm::residual(const Dual& solution, std::span<const double> target) const {
  const Index n = x_.rows();
  std::vector<double> product(n);
  multiply(solution.alpha.data(), product.data());
  double sum = 0, wrong = 0, right = 0;
  for (Index i = 0; i < n; ++i) {
    const double off = product[i] + solution.b - target[i];
    sum += solution.alpha[i];
    wrong += off * off;
    right += target[i] * target[i];
  }
  wrong += sum * sum;
  return right > 0 ? std::sqrt(wrong / right) : std::sqrt(wrong);
}

double Lssvm::condition() const {
  const Index n = x_.rows(), padded = x_.strips() * strip_rows;
  std::vector<double> ones(n, 1.0), sums(n);
  multiply(ones.data(), sums.data());  // all entries are positive: row sums are the 1-norm's column sums
  const double norm = *std::max_element(sums.begin(), sums.end());
  Buffer v(padded), sign(padded);
  std::fill_n(v.begin(), n, 1 / static_cast<double>(n));
  double inverse = 0;
  for (int round = 0; round < 5; ++round) {
    invert(v);
    double size = 0;
    for (Index i = 0; i < n; ++i) size += std::fabs(v[i]);
    if (size <= inverse) break;
    inverse = size;
    std::fill(sign.begin(), sign.end(), 0.0);
    for (Index i = 0; i < n; ++i) sign[i] = v[i] < 0 ? -1 : 1;
    invert(sign);
    Index steepest = 0;
    for (Index i = 1; i < n; ++i)
      if (std::fabs(sign[i]) > std::fabs(sign[steepest])) steepest = i;
    std::fill(v.begin(), v.end(), 0.0);
    v[steepest] = 1;
  }
  return norm * inverse;
}

Expansion::Expansion(Points x, double sigma, Index outputs, const Loops& loops)
    : loops_(&loops),
      x_(std::move(x)),
      scale_(0.5 / (sigma * sigma)),
      weights_(outputs * padded()),
      values_(padded()),
      biases_(outputs) {}

void Expansion::kernel(const double* point, double* values) const {
  loops_->gaussian(values, strip_rows, x_.strip(0), x_.stride(), point, x_.features(), scale_, x_.strips());
}

void Expansion::weigh(const double* values, double* out, Index count) const {
  loops_->weigh(out, weights_.data(), padded(), count, values, x_.strips());
  for (Index k = 0; k < count; ++k) out[k] += biases_[k];
}

void Expansion::evaluate(const double* point, double* out, Index count) {
  kernel(point, values_.data());
  weigh(values_.data(), out, count);
}

void Expansion::save(wend::Writer& writer) const {
  std::vector<double> points(x_.rows() * x_.features()), weights;
  for (Index i = 0; i < x_.rows(); ++i) x_.copy(i, points.data() + i * x_.features());
  for (Index k = 0; k < outputs(); ++k)
    weights.insert(weights.end(), weights_.data() + k * padded(), weights_.data() + k * padded() + x_.rows());
  writer.put(std::span<const double>(points));
  writer.put(std::span<const double>(weights));
  writer.put(std::span<const double>(biases_));
}

Expansion Expansion::load(wend::Reader& reader, Index features, double sigma, Index outputs) {
  const std::vector<double> points = reader.get_all<double>(), weights = reader.get_all<double>();
  std::vector<double> biases = reader.get_all<double>();
  if (points.empty() && weights.empty() && biases.empty()) return {};
  const Index n = points.size() / features;
  if (n == 0 || points.size() != n * features || biases.size() != outputs || weights.size() != n * outputs)
    throw wend::damaged_state("expected " + std::to_string(outputs) + " weights for each support vector of " +
                              std::to_string(features) + " features, found " + std::to_string(weights.size()) +
                              " weights for " + std::to_string(points.size()) + " numbers");
  for (const std::vector<double>* values : {&points, &weights, static_cast<const std::vector<double>*>(&biases)})
    for (const double value : *values)
      if (!std::isfinite(value)) throw wend::damaged_state("a support vector or weight is not a finite number");
  Expansion expansion(Points(points, features), sigma, outputs);
  for (Index k = 0; k < outputs; ++k)
    for (Index i = 0; i < n; ++i) expansion.set(k, i, weights[k * n + i]);
  expansion.biases_ = std::move(biases);
  return expansion;
}

}  // namespace lssvm
