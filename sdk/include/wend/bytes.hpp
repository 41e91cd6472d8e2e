// wend/bytes.hpp -- what was learned, as bytes: little-endian numbers, counted texts, a name and version in front.
#pragma once
#include <wend/error.hpp>

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace wend {

class Writer {
 public:
  explicit Writer(const wend_sink* sink) noexcept : sink_(sink) {}

  void bytes(const void* data, std::size_t n) { check(sink_->write(sink_->context, data, n)); }
  void text(std::string_view text) { bytes(text.data(), text.size()); }  // as it is, with no count
  template <class T>
    requires std::is_arithmetic_v<T>
  void put(T value) {
    bytes(&value, sizeof value);
  }
  template <class T>
    requires std::is_trivially_copyable_v<T>
  void put(std::span<const T> values) {
    put(static_cast<std::uint64_t>(values.size()));
    bytes(values.data(), values.size_bytes());
  }
  void put(std::string_view text) { put(std::span<const char>(text.data(), text.size())); }

 private:
  const wend_sink* sink_;
};

// Reads what a Writer wrote; throws WEND_E_STATE where the bytes end early or are not what is expected.
class Reader {
 public:
  Reader(const void* data, std::uint64_t n) noexcept : at_(static_cast<const unsigned char*>(data)), left_(n) {}

  template <class T>
    requires std::is_arithmetic_v<T>
  T get() {
    T value;
    take(&value, sizeof value);
    return value;
  }
  template <class T>
  std::vector<T> get_all() {
    const auto n = get<std::uint64_t>();
    if (n > left_ / sizeof(T)) throw damaged_state("the state ends early: " + std::to_string(n) + " values announced");
    std::vector<T> values(n);
    take(values.data(), n * sizeof(T));
    return values;
  }
  std::string get_text() {
    const auto all = get_all<char>();
    return {all.begin(), all.end()};
  }
  // The name and version in front of a state.
  void expect(std::string_view what) {
    const std::string found = get_text();
    if (found != what) throw damaged_state("expected a state of " + std::string(what) + ", found " + found.substr(0, 60));
  }
  void end() const {
    if (left_ != 0) throw damaged_state("the state has " + std::to_string(left_) + " bytes too many");
  }
  std::uint64_t left() const noexcept { return left_; }

 private:
  void take(void* to, std::uint64_t n) {
    if (n > left_) throw damaged_state("the state ends early");
    if (n != 0) std::memcpy(to, at_, n);
    at_ += n;
    left_ -= n;
  }

  const unsigned char* at_;
  std::uint64_t left_;
};

}  // namespace wend
