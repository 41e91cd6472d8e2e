// One array of an NPZ archive: the .npy header of NumPy's format 1.0, written and read.
#pragma once
#include <core/record/npz.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace wend::core {

// Bytes of one value, or 0 for a type that is none of ours.
std::size_t npy_width(std::string_view type);

// The number of values, or nothing where it does not fit 64 bits.
std::optional<std::uint64_t> npy_count(const Shape& shape);

std::string npy_header(const std::string& type, const Shape& shape);

// Returns an empty string and fills `out`, or returns what is wrong.
std::string parse_npy(std::string_view bytes, NpyArray& out);

}  // namespace wend::core
