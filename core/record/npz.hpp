// NumPy's .npz: a zip archive of .npy arrays.  Entries are stored, not deflated, and carry a fixed date, so that equal
// arrays are equal bytes.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace wend::core {

using Shape = std::vector<std::uint64_t>;

// C order, little-endian.
struct NpyArray {
  std::string type;  // NumPy's name: "<f8", "<f4", "<u4", "|u1" or "<i8"
  Shape shape;
  std::string bytes;
};

class NpzWriter {
 public:
  // `name` without ".npy".  Throws std::invalid_argument where the shape is not that of the values or the name is
  // taken.
  void add(const std::string& name, const std::vector<double>& values, const Shape& shape);
  void add(const std::string& name, const std::vector<float>& values, const Shape& shape);
  void add(const std::string& name, const std::vector<std::uint32_t>& values, const Shape& shape);
  void add(const std::string& name, const std::vector<std::uint8_t>& values, const Shape& shape);
  void add(const std::string& name, const std::vector<std::int64_t>& values, const Shape& shape);
  // UTF-8 as an array of uint8: bytes(z["name"]).decode() in Python.
  void add_text(const std::string& name, std::string_view text);

  // The archive; throws Error(Exit::data) where it would exceed 4 GiB or 65,535 arrays.
  std::string bytes() const;
  // Whole or not at all (files.hpp).
  void write(const std::string& path) const;

 private:
  void add_raw(const std::string& name, const char* type, const void* values, std::size_t count, std::size_t width,
               const Shape& shape);
  std::vector<std::pair<std::string, NpyArray>> arrays_;
};

// Every length, offset, checksum and header is checked: a damaged file is Error(Exit::data) with its name and the
// reason.
class NpzReader {
 public:
  explicit NpzReader(const std::string& path);
  NpzReader(std::string_view bytes, const std::string& name);  // `name` stands in the errors

  bool has(const std::string& name) const { return arrays_.count(name) != 0; }
  const std::map<std::string, NpyArray>& arrays() const { return arrays_; }

  // The values of an array of exactly that type and number of dimensions; the shape goes to `shape`.
  std::vector<double> float64(const std::string& name, std::size_t dimensions, Shape* shape = nullptr) const;
  std::vector<float> float32(const std::string& name, std::size_t dimensions, Shape* shape = nullptr) const;
  std::vector<std::uint32_t> uint32(const std::string& name, std::size_t dimensions, Shape* shape = nullptr) const;
  std::vector<std::uint8_t> uint8(const std::string& name, std::size_t dimensions, Shape* shape = nullptr) const;
  std::vector<std::int64_t> int64(const std::string& name, std::size_t dimensions, Shape* shape = nullptr) const;
  std::string text(const std::string& name) const;

  [[noreturn]] void fail(const std::string& reason) const;  // Error(Exit::data): "PATH is damaged: reason"

 private:
  const NpyArray& find(const std::string& name, const char* type, std::size_t dimensions) const;
  template <class T>
  std::vector<T> values(const std::string& name, const char* type, std::size_t dimensions, Shape* shape) const;
  void read_archive(std::string_view bytes);

  std::string name_;
  std::map<std::string, NpyArray> arrays_;
};

}  // namespace wend::core
