#include <array>
#include <core/figure/text_metrics.hpp>
#include <cstdint>

namespace wend::core {
namespace {

// Advance widths of DejaVu Sans 2.37, U+0020 to U+007E, in 1/1000 em.
constexpr std::array<std::uint16_t, 95> regular_widths = {
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};
constexpr std::array<std::uint16_t, 95> bold_widths = {
    348, 456,  521, 838, 696, 1002, 872, 306, 457, 457, 523, 838, 380, 415,  380, 365, 696, 696,  696,
    696, 696,  696, 696, 696, 696,  696, 400, 400, 838, 838, 838, 580, 1000, 774, 762, 734, 830,  683,
    683, 821,  837, 372, 372, 775,  637, 995, 837, 850, 733, 850, 770, 720,  682, 812, 774, 1103, 771,
    724, 725,  457, 365, 457, 838,  500, 500, 675, 716, 593, 716, 678, 435,  716, 712, 343, 343,  665,
    343, 1042, 712, 687, 716, 716,  493, 595, 478, 712, 652, 924, 645, 652,  582, 712, 365, 712,  838};

double advance(char32_t point, bool bold) {
  if (point >= 0x20 && point <= 0x7E) return (bold ? bold_widths : regular_widths)[point - 0x20];
  if (point == 0xB7) return bold ? 380 : 318;                          // middle dot
  if (point == 0x2013) return 500;                                     // en dash
  if (point < 0x20 || (point >= 0x0300 && point <= 0x036F)) return 0;  // control, combining
  if (point >= 0x2000 && point != 0x2019) return 1000;                 // symbols, CJK
  return bold ? 690 : 630;                                             // Latin, Greek, Cyrillic letters
}

}  // namespace

char32_t next_code_point(std::string_view text, std::size_t& position) {
  constexpr char32_t replacement = 0xFFFD;
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(position);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  const std::size_t start = position++;
  if (length == 0) return replacement;
  if (length == 1) return first;
  char32_t point = first & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(start + i) & 0xC0u) != 0x80u) return replacement;
    point = point << 6 | (byte(start + i) & 0x3Fu);
  }
  const bool overlong = (length == 3 && point < 0x800) || (length == 4 && point < 0x10000);
  if (overlong || point > 0x10FFFF || (point >= 0xD800 && point <= 0xDFFF)) return replacement;
  position = start + length;
  return point;
}

double text_width(std::string_view text, double size, bool bold) {
  double sum = 0;
  for (std::size_t i = 0; i < text.size();) sum += advance(next_code_point(text, i), bold);
  return sum * size / 1000;
}

std::string fit_text(std::string_view text, double size, double width, bool bold) {
  if (text_width(text, size, bold) <= width) return std::string(text);
  const double room = width - size;  // the ellipsis is one em wide
  double sum = 0;
  std::size_t end = 0;
  for (std::size_t i = 0; i < text.size();) {
    sum += advance(next_code_point(text, i), bold) * size / 1000;
    if (sum > room) break;
    end = i;
  }
  return std::string(text.substr(0, end)) + "…";
}

}  // namespace wend::core
