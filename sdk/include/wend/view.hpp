// wend/view.hpp -- rows and matrices as a plugin sees them: views, nothing is copied or owned.
#pragma once
#include <wend/abi.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace wend {

using Rows = std::span<const std::uint32_t>;      // rows of a batch, ascending; row = copy * robots + robot
using Episodes = std::span<const wend_episode>;

// n x width, row-major, `stride` values from one row to the next.
template <class T>
class Matrix {
 public:
  Matrix() = default;
  Matrix(T* data, std::size_t rows, std::size_t width, std::size_t stride) noexcept
      : data_(data), rows_(rows), width_(width), stride_(stride) {}
  Matrix(T* data, std::size_t rows, std::size_t width) noexcept : Matrix(data, rows, width, width) {}

  std::span<T> operator[](std::size_t row) const noexcept { return {data_ + row * stride_, width_}; }
  std::size_t rows() const noexcept { return rows_; }
  std::size_t width() const noexcept { return width_; }
  std::size_t stride() const noexcept { return stride_; }
  T* data() const noexcept { return data_; }
  operator Matrix<const T>() const noexcept { return {data_, rows_, width_, stride_}; }

 private:
  T* data_ = nullptr;
  std::size_t rows_ = 0, width_ = 0, stride_ = 0;
};

// n transitions (s, a, r, s'), in each row in the order they happened.
struct Batch {
  Rows rows;
  Matrix<const double> observations, actions, next_observations;
  std::span<const wend_outcome> outcomes;

  Batch(const wend_batch& batch, std::size_t observation_width, std::size_t action_width) noexcept
      : rows(batch.rows, batch.n),
        observations(batch.observations, batch.n, observation_width),
        actions(batch.actions, batch.n, action_width),
        next_observations(batch.next_observations, batch.n, observation_width),
        outcomes(batch.outcomes, batch.n) {}
  std::size_t size() const noexcept { return rows.size(); }
};

}  // namespace wend
