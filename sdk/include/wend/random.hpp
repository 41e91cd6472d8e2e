// wend/random.hpp -- random numbers that are a function of (key, position) and of nothing else.
//
// A stream is a 64-bit key.  Number i of a stream comes from word i % 4 of philox({i / 4, 0, 0, 0}, {key, 0}), so any
// part of a stream can be had at once, in any order, on any thread, with the same bits everywhere.  Derive the key of
// a part from its owner's with stream(); streams of different names are independent for every practical purpose.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <wend/math/normal.hpp>

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

namespace wend {

namespace detail {

struct Product {
  uint64_t high, low;
};

[[gnu::always_inline]] inline Product multiply_wide(uint64_t a, uint64_t b) {
  __extension__ using Wide = unsigned __int128;
  const Wide product = static_cast<Wide>(a) * b;
  return {static_cast<uint64_t>(product >> 64), static_cast<uint64_t>(product)};
}

// FNV-1a, 64 bits.
inline constexpr uint64_t fnv1a64(std::string_view text) {
  uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

// The upper 53 bits as a number in [0, 1).
[[gnu::always_inline]] inline double unit(uint64_t word) {
  return static_cast<double>(static_cast<int64_t>(word >> 11)) * 0x1p-53;
}

}  // namespace detail

/// Philox4x64-10 (Salmon, Moraes, Dror, Shaw: Parallel random numbers: as easy as 1, 2, 3; SC 2011): a bijection of
/// the counters for each key, whose values pass TestU01's BigCrush.
inline std::array<uint64_t, 4> philox(std::array<uint64_t, 4> counter, std::array<uint64_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const detail::Product a = detail::multiply_wide(0xd2e7470ee14c6c93, counter[0]);
    const detail::Product b = detail::multiply_wide(0xca5a826395121157, counter[2]);
    counter = {b.high ^ counter[1] ^ key[0], b.low, a.high ^ counter[3] ^ key[1], a.low};
    key[0] += 0x9e3779b97f4a7c15;  // golden ratio - 1
    key[1] += 0xbb67ae8584caa73b;  // sqrt(3) - 1
  }
  return counter;
}

/// The key of the stream called `name` below the stream `parent`.
inline uint64_t stream(uint64_t parent, std::string_view name) {
  return philox({detail::fnv1a64(name), name.size(), 0, 0x77656e64}, {parent, 0x73747265616d})[0];
}

/// The key of stream number `index` below the stream `parent`; never that of a name there.
inline uint64_t stream(uint64_t parent, uint64_t index) {
  return philox({index, 0, 1, 0x77656e64}, {parent, 0x73747265616d})[0];
}

/// out[j] = number position + j of stream `key`, uniform in [0, 1), for j < n: what Random(key, position).uniform()
/// gives in n calls.
inline void uniform(uint64_t key, uint64_t position, double* out, uint64_t n) {
  uint64_t done = 0;
  while (done < n) {
    const uint64_t at = position + done;
    const std::array<uint64_t, 4> block = philox({at / 4, 0, 0, 0}, {key, 0});
    for (uint64_t word = at % 4; word < 4 && done < n; ++word) out[done++] = detail::unit(block[word]);
  }
}

/// A reader of one stream.  Its whole state is (key, position): Random(key, r.position()) goes on as r does.
class Random {
 public:
  explicit Random(uint64_t key, uint64_t position = 0) : key_(key), position_(position) {
    if (position % 4 != 0) block_ = philox({position / 4, 0, 0, 0}, {key, 0});
  }

  /// The next position to be read.
  uint64_t position() const { return position_; }

  /// 64 random bits.  One position.
  uint64_t word() {
    if (position_ % 4 == 0) block_ = philox({position_ / 4, 0, 0, 0}, {key_, 0});
    return block_[position_++ % 4];
  }

  /// Uniform in [0, 1), a multiple of 2^-53.  One position.
  double uniform() { return detail::unit(word()); }

  /// Uniform in [low, high]; high itself only by rounding.  One position.
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Normal with mean 0 and standard deviation 1, |x| < 8.3.  One position: the quantile of a midpoint of 2^52 cells.
  double normal() {
    const double cell = static_cast<double>(static_cast<int64_t>(word() >> 12));
    return math::normal_quantile((cell + 0.5) * 0x1p-52);
  }

  /// Normal with this mean and standard deviation.  One position.
  double normal(double mean, double deviation) { return mean + deviation * normal(); }

  /// Uniform among 0, ..., n - 1, without bias; 0 if n = 0.  One position, more with probability < n / 2^64
  /// (Lemire: Fast random integer generation in an interval; TOMACS 2019).
  uint64_t below(uint64_t n) {
    detail::Product scaled = detail::multiply_wide(word(), n);
    if (scaled.low < n) {
      const uint64_t surplus = (0 - n) % n;
      while (scaled.low < surplus) scaled = detail::multiply_wide(word(), n);
    }
    return scaled.high;
  }

  /// True with this probability.  One position.
  bool chance(double probability) { return uniform() < probability; }

  /// Puts anything with size() and [], such as a std::span or std::vector, in random order (Fisher and Yates).
  template <class Sequence>
  void shuffle(Sequence&& values) {
    using std::swap;
    for (std::size_t left = values.size(); left > 1; --left) {
      swap(values[left - 1], values[static_cast<std::size_t>(below(left))]);
    }
  }

  /// An index with probability proportional to its weight; weights <= 0 or NaN are never chosen.  weights.size() if
  /// no weight is positive or their sum is infinite.  One position.
  std::size_t weighted(std::span<const double> weights) {
    double total = 0;
    for (const double weight : weights) total += weight > 0 ? weight : 0;
    const double target = uniform() * total;
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      sum += weights[i] > 0 ? weights[i] : 0;
      if (target < sum && total < math::detail::infinity) return i;
    }
    return weights.size();
  }

 private:
  uint64_t key_, position_;
  std::array<uint64_t, 4> block_{};
};

}  // namespace wend
