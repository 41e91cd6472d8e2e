// Oracles: the same algebra written naively.
#pragma once
#include <cmath>
#include <utility>
#include <vector>
#include <wend/random.hpp>

namespace dense {

using Matrix = std::vector<std::vector<double>>;

// a x = b by Gaussian elimination with pivoting; b may have several columns.
inline Matrix solve(Matrix a, Matrix b) {
  const std::size_t n = a.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::fabs(a[i][k]) > std::fabs(a[pivot][k])) pivot = i;
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      for (std::size_t j = 0; j < b[i].size(); ++j) b[i][j] -= factor * b[k][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i)
    for (double& value : b[i]) value /= a[i][i];
  return b;
}

inline double gauss(const double* x, const double* y, std::size_t d, double sigma) {
  double square = 0;
  for (std::size_t f = 0; f < d; ++f) square += (x[f] - y[f]) * (x[f] - y[f]);
  return std::exp(-square / (2 * sigma * sigma));
}

// H = K + I / C
inline Matrix system(const std::vector<double>& x, std::size_t d, double sigma, double c) {
  const std::size_t n = x.size() / d;
  Matrix h(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) h[i][j] = gauss(&x[i * d], &x[j * d], d, sigma) + (i == j ? 1 / c : 0);
  return h;
}

// b and alpha of the whole saddle-point system.
inline std::vector<double> lssvm(const std::vector<double>& x, std::size_t d, double sigma, double c,
                                 const std::vector<double>& y) {
  const Matrix h = system(x, d, sigma, c);
  const std::size_t n = h.size();
  Matrix a(n + 1, std::vector<double>(n + 1, 1.0)), right(n + 1, std::vector<double>(1, 0.0));
  a[0][0] = 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) a[i + 1][j + 1] = h[i][j];
    right[i + 1][0] = y[i];
  }
  std::vector<double> out;
  for (const auto& row : solve(a, right)) out.push_back(row[0]);
  return out;
}

inline double norm1(const Matrix& a) {
  double most = 0;
  for (std::size_t j = 0; j < a.size(); ++j) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::fabs(a[i][j]);
    most = std::max(most, sum);
  }
  return most;
}

inline double condition(const Matrix& a) {
  Matrix unit(a.size(), std::vector<double>(a.size(), 0.0));
  for (std::size_t i = 0; i < a.size(); ++i) unit[i][i] = 1;
  return norm1(a) * norm1(solve(a, unit));
}

inline std::vector<double> normals(std::size_t n, std::uint64_t key) {
  wend::Random random(key);
  std::vector<double> all(n);
  for (double& value : all) value = random.normal();
  return all;
}

}  // namespace dense
