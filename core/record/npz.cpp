#include <zlib.h>

#include <bit>
#include <core/base/error.hpp>
#include <core/base/files.hpp>
#include <core/record/npy.hpp>
#include <core/record/npz.hpp>
#include <cstring>
#include <stdexcept>

namespace wend::core {
namespace {

static_assert(std::endian::native == std::endian::little, "NPZ values are written as they lie in memory");

constexpr std::uint32_t local_magic = 0x04034b50, central_magic = 0x02014b50, end_magic = 0x06054b50;
constexpr std::size_t local_size = 30, central_size = 46, end_size = 22;
constexpr std::uint64_t limit = 0xffffffff;      // of every size and offset in a zip archive without zip64
constexpr std::uint16_t first_of_1980 = 0x0021;  // the earliest date that zip knows

void put16(std::string& out, std::uint32_t value) {
  out.push_back(static_cast<char>(value & 0xff));
  out.push_back(static_cast<char>(value >> 8 & 0xff));
}

void put32(std::string& out, std::uint64_t value) {
  put16(out, static_cast<std::uint32_t>(value));
  put16(out, static_cast<std::uint32_t>(value >> 16));
}

std::uint32_t get16(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at])) |
         static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + 1])) << 8;
}

std::uint32_t get32(std::string_view bytes, std::size_t at) {
  return get16(bytes, at) | get16(bytes, at + 2) << 16;
}

std::uint32_t checksum(std::string_view bytes, std::uint32_t before = 0) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

// What a local and a central header share, from "version needed" to the length of the extra field.
std::string common_header(std::uint32_t crc, std::uint64_t size, std::size_t name_length) {
  std::string out;
  put16(out, 20);  // version needed: 2.0
  put16(out, 0);   // flags
  put16(out, 0);   // stored
  put16(out, 0);   // midnight
  put16(out, first_of_1980);
  put32(out, crc);
  put32(out, size);
  put32(out, size);
  put16(out, static_cast<std::uint32_t>(name_length));
  put16(out, 0);
  return out;
}

std::string central_header(const std::string& common, std::uint64_t offset) {
  std::string out;
  put32(out, central_magic);
  put16(out, 20);  // made by
  out += common;
  put16(out, 0);  // comment
  put16(out, 0);  // disk
  put16(out, 0);  // internal attributes
  put32(out, 0);  // external attributes
  put32(out, offset);
  return out;
}

std::string end_record(std::size_t entries, std::uint64_t central_bytes, std::uint64_t central_at) {
  std::string out;
  put32(out, end_magic);
  put16(out, 0);
  put16(out, 0);
  put16(out, static_cast<std::uint32_t>(entries));
  put16(out, static_cast<std::uint32_t>(entries));
  put32(out, central_bytes);
  put32(out, central_at);
  put16(out, 0);
  return out;
}

}  // namespace

// ------------------------------------------------------------------------------------------------------------ writer

void NpzWriter::add_raw(const std::string& name, const char* type, const void* values, std::size_t count,
                        std::size_t width, const Shape& shape) {
  if (npy_count(shape) != count)
    throw std::invalid_argument("NPZ array \"" + name + "\": its shape is not that of " + std::to_string(count) +
                                " values");
  for (const auto& [taken, array] : arrays_)
    if (taken == name) throw std::invalid_argument("NPZ array \"" + name + "\" is there twice");
  NpyArray array{type, shape, std::string(count * width, '\0')};
  if (count > 0) std::memcpy(array.bytes.data(), values, count * width);
  arrays_.emplace_back(name, std::move(array));
}

void NpzWriter::add(const std::string& name, const std::vector<double>& values, const Shape& shape) {
  add_raw(name, "<f8", values.data(), values.size(), 8, shape);
}
void NpzWriter::add(const std::string& name, const std::vector<float>& values, const Shape& shape) {
  add_raw(name, "<f4", values.data(), values.size(), 4, shape);
}
void NpzWriter::add(const std::string& name, const std::vector<std::uint32_t>& values, const Shape& shape) {
  add_raw(name, "<u4", values.data(), values.size(), 4, shape);
}
void NpzWriter::add(const std::string& name, const std::vector<std::uint8_t>& values, const Shape& shape) {
  add_raw(name, "|u1", values.data(), values.size(), 1, shape);
}
void NpzWriter::add(const std::string& name, const std::vector<std::int64_t>& values, const Shape& shape) {
  add_raw(name, "<i8", values.data(), values.size(), 8, shape);
}
void NpzWriter::add_text(const std::string& name, std::string_view text) {
  add_raw(name, "|u1", text.data(), text.size(), 1, {text.size()});
}

std::string NpzWriter::bytes() const {
  std::uint64_t total = end_size;
  for (const auto& [name, array] : arrays_)
    total += local_size + central_size + 2 * (name.size() + 4) + npy_header(array.type, array.shape).size() +
             array.bytes.size();
  if (total > limit || arrays_.size() > 0xffff)
    throw Error(Exit::data, "an NPZ file holds at most 4 GiB and 65535 arrays, found " + std::to_string(total) +
                                " bytes in " + std::to_string(arrays_.size()) + " arrays: record fewer steps");
  std::string out, central;
  out.reserve(total);
  for (const auto& [name, array] : arrays_) {
    const std::string file = name + ".npy", header = npy_header(array.type, array.shape);
    const std::string common =
        common_header(checksum(array.bytes, checksum(header)), header.size() + array.bytes.size(), file.size());
    central += central_header(common, out.size()) + file;
    put32(out, local_magic);
    out += common + file + header;
    out += array.bytes;
  }
  const std::uint64_t central_at = out.size();
  out += central;
  return out + end_record(arrays_.size(), central.size(), central_at);
}

void NpzWriter::write(const std::string& path) const {
  try {
    write_file(path, bytes());
  } catch (const std::length_error&) {
    throw Error(Exit::data, "cannot write " + path + ": out of memory");
  }
}

// ------------------------------------------------------------------------------------------------------------ reader

NpzReader::NpzReader(const std::string& path) : name_(path) {
  read_archive(read_file(path, limit));
}

NpzReader::NpzReader(std::string_view bytes, const std::string& name) : name_(name) {
  read_archive(bytes);
}

void NpzReader::fail(const std::string& reason) const {
  throw Error(Exit::data, name_ + " is damaged: " + reason);
}

void NpzReader::read_archive(std::string_view bytes) {
  if (bytes.size() < end_size || bytes.size() > limit) fail("not an NPZ file");
  std::size_t end = bytes.size() - end_size;  // the end record stands before a comment of up to 64 kB
  const std::size_t first = bytes.size() - std::min<std::size_t>(bytes.size(), end_size + 0xffff);
  while (get32(bytes, end) != end_magic) {
    if (end == first) fail("not an NPZ file, or its end is cut off");
    --end;
  }
  const std::uint32_t entries = get16(bytes, end + 10);
  const std::uint64_t central_bytes = get32(bytes, end + 12), central_at = get32(bytes, end + 16);
  if (central_at + central_bytes > end) fail("its directory lies outside the file");
  std::uint64_t total = 0;
  std::size_t at = central_at;
  for (std::uint32_t i = 0; i < entries; ++i) {
    if (at + central_size > end || get32(bytes, at) != central_magic) fail("its directory cannot be read");
    const std::size_t name_length = get16(bytes, at + 28);
    if (at + central_size + name_length > end) fail("its directory cannot be read");
    std::string name(bytes.substr(at + central_size, name_length));
    const std::string where = "array \"" + name + "\": ";
    if (get16(bytes, at + 10) != 0) fail(where + "compressed, expected a stored entry");
    const std::uint64_t size = get32(bytes, at + 20), local = get32(bytes, at + 42);
    total += size;  // entries that overlap could grow a small file to gigabytes
    if (local + local_size > central_at || get32(bytes, local) != local_magic || total > bytes.size())
      fail(where + "lies outside the file");
    const std::uint64_t data = local + local_size + get16(bytes, local + 26) + get16(bytes, local + 28);
    if (data > central_at || size > central_at - data) fail(where + "lies outside the file");
    const std::string_view entry = bytes.substr(data, size);
    if (checksum(entry) != get32(bytes, at + 16)) fail(where + "its checksum does not agree");
    NpyArray array;
    if (const std::string wrong = parse_npy(entry, array); !wrong.empty()) fail(where + wrong);
    if (name.size() > 4 && name.ends_with(".npy")) name.resize(name.size() - 4);
    if (!arrays_.emplace(name, std::move(array)).second) fail(where + "is there twice");
    at += central_size + name_length + get16(bytes, at + 30) + get16(bytes, at + 32);
  }
}

const NpyArray& NpzReader::find(const std::string& name, const char* type, std::size_t dimensions) const {
  const auto found = arrays_.find(name);
  if (found == arrays_.end()) fail("array \"" + name + "\" is missing");
  const NpyArray& array = found->second;
  if (array.type != type) fail("array \"" + name + "\": expected values of type " + type + ", found " + array.type);
  if (array.shape.size() != dimensions)
    fail("array \"" + name + "\": expected " + std::to_string(dimensions) + " dimensions, found " +
         std::to_string(array.shape.size()));
  return array;
}

template <class T>
std::vector<T> NpzReader::values(const std::string& name, const char* type, std::size_t dimensions,
                                 Shape* shape) const {
  const NpyArray& array = find(name, type, dimensions);
  std::vector<T> out(array.bytes.size() / sizeof(T));
  if (!out.empty()) std::memcpy(out.data(), array.bytes.data(), array.bytes.size());
  if (shape) *shape = array.shape;
  return out;
}

std::vector<double> NpzReader::float64(const std::string& name, std::size_t dimensions, Shape* shape) const {
  return values<double>(name, "<f8", dimensions, shape);
}
std::vector<float> NpzReader::float32(const std::string& name, std::size_t dimensions, Shape* shape) const {
  return values<float>(name, "<f4", dimensions, shape);
}
std::vector<std::uint32_t> NpzReader::uint32(const std::string& name, std::size_t dimensions, Shape* shape) const {
  return values<std::uint32_t>(name, "<u4", dimensions, shape);
}
std::vector<std::uint8_t> NpzReader::uint8(const std::string& name, std::size_t dimensions, Shape* shape) const {
  return values<std::uint8_t>(name, "|u1", dimensions, shape);
}
std::vector<std::int64_t> NpzReader::int64(const std::string& name, std::size_t dimensions, Shape* shape) const {
  return values<std::int64_t>(name, "<i8", dimensions, shape);
}
std::string NpzReader::text(const std::string& name) const {
  return find(name, "|u1", 1).bytes;
}

}  // namespace wend::core
