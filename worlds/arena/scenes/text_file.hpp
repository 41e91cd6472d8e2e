// Whole text files, and how an error quotes what it found in one.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace arena {

// Throws wend::Error, without a parameter: "maps/a.map: can't be read: no such file", or more than 64 MiB.
std::string read_text(const std::string& path);

// Without their ends, be they \n or \r\n; the last line may lack one.
std::vector<std::string_view> lines_of(std::string_view text);

// Pieces between separators: tabs if the line has any, else runs of blanks.
std::vector<std::string_view> fields_of(std::string_view line);

// The number that the whole text is, in the notation of C whatever the locale; else none.
std::optional<std::uint32_t> whole_number(std::string_view text);
std::optional<double> real_number(std::string_view text);

// In quotes, at most 40 characters, unprintable ones as \xNN.
std::string in_quotes(std::string_view text);

// "maps/a.map" -> "a"
std::string stem_of(const std::string& path);

}  // namespace arena
