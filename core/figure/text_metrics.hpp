// How wide a text will be, so that figures can be laid out without a font library.
#pragma once
#include <string>
#include <string_view>

namespace wend::core {

// The next code point of UTF-8 text from `position` on, which moves past it; U+FFFD for each byte that is not UTF-8.
char32_t next_code_point(std::string_view text, std::size_t& position);

// px, of DejaVu Sans at `size` px, without kerning: within 1 % for ASCII and about 5 % beyond.
double text_width(std::string_view text, double size, bool bold = false);

// The text itself, or its longest beginning followed by "…" that fits in `width` px.
std::string fit_text(std::string_view text, double size, double width, bool bold = false);

}  // namespace wend::core
