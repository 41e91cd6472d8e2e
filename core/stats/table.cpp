#include <algorithm>
#include <core/stats/table.hpp>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <vector>

namespace wend::core {
namespace {

constexpr std::size_t most_columns = 110, least_name = 10;
constexpr const char* gap = "  ";

using Line = std::vector<std::string>;

// Bytes of the UTF-8 character at `at`, and its code point; a broken byte is a character of its own.
std::size_t decode(std::string_view text, std::size_t at, std::uint32_t& code) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(at);
  const std::size_t n = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc0 ? 2 : 1;
  code = n == 1 ? first : first & (0xffu >> (n + 1));
  if ((n == 1 && first >= 0x80) || at + n > text.size()) {
    code = 0xfffd;
    return 1;
  }
  for (std::size_t i = 1; i < n; ++i) {
    if ((byte(at + i) & 0xc0) != 0x80) {
      code = 0xfffd;
      return 1;
    }
    code = code << 6 | (byte(at + i) & 0x3f);
  }
  return n;
}

// Columns that a terminal gives a character: none to combining marks, two to East Asian wide ones.
std::size_t columns_of(std::uint32_t c) {
  if ((c >= 0x300 && c <= 0x36f) || (c >= 0x200b && c <= 0x200f) || (c >= 0xfe00 && c <= 0xfe0f)) return 0;
  const bool wide = (c >= 0x1100 && c <= 0x115f) || (c >= 0x2e80 && c <= 0xa4cf) || (c >= 0xac00 && c <= 0xd7a3) ||
                    (c >= 0xf900 && c <= 0xfaff) || (c >= 0xfe30 && c <= 0xfe6f) || (c >= 0xff00 && c <= 0xff60) ||
                    (c >= 0x1f300 && c <= 0x1faff) || (c >= 0x20000 && c <= 0x3fffd);
  return wide ? 2 : 1;
}

std::size_t width(std::string_view text) {
  std::size_t columns = 0;
  for (std::size_t i = 0; i < text.size();) {
    std::uint32_t code = 0;
    i += decode(text, i, code);
    columns += columns_of(code);
  }
  return columns;
}

// A name out of a file: no control character, and so no escape sequence, reaches the terminal.
std::string printable(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    std::uint32_t code = 0;
    const std::size_t n = decode(text, i, code);
    const bool control = code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0xfffd;
    out += control ? "?" : std::string(text.substr(i, n));
    i += n;
  }
  return out;
}

// At most `columns` wide, with an ellipsis where something had to go.
std::string shortened(const std::string& text, std::size_t columns) {
  if (width(text) <= columns) return text;
  std::string out;
  std::size_t used = 1;
  for (std::size_t i = 0; i < text.size();) {
    std::uint32_t code = 0;
    const std::size_t n = decode(text, i, code);
    if (used + columns_of(code) > columns) break;
    used += columns_of(code);
    out += text.substr(i, n);
    i += n;
  }
  return out + "…";
}

std::string number(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string percent(const Json& row, const char* rate) {
  return row.contains(rate) ? number(100 * row[rate]["rate"].get<double>(), 1) : "-";
}

std::string success(const Json& row) {
  if (!row.contains("success")) return "-";
  const Json& rate = row["success"];
  return percent(row, "success") + " [" + number(100 * rate["low"].get<double>(), 1) + ", " +
         number(100 * rate["high"].get<double>(), 1) + "]";
}

std::string mean(const Json& row, const char* metric, int digits) {
  const Json& metrics = row.at("metrics");
  return metrics.contains(metric) ? number(metrics[metric]["mean"].get<double>(), digits) : "-";
}

// {"samples": 2300} and {"/arms/0/gamma": 0.9} as "samples 2300, gamma 0.9".
std::string variables(const Json& row) {
  std::string out;
  for (const char* part : {"point", "at"}) {
    if (!row.contains(part) || !row[part].is_object()) continue;
    for (const auto& [key, value] : row[part].items()) {
      if (!out.empty()) out += ", ";
      const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
      out += printable(key.substr(key.rfind('/') + 1) + " " + text);
    }
  }
  return out;
}

bool is_true(const Json& row, const char* key) {
  return row.contains(key) && row[key] == true;
}

std::vector<Line> lines(const Json& rows) {
  std::vector<Line> out = {
      {"arm", "world", "at", "n", "success % [95 %]", "collided", "timeout", "steps", "path m", "SPL"}};
  for (const Json& row : rows)
    out.push_back({printable(row.at("arm").get<std::string>()) + (is_true(row, "privileged") ? " *" : ""),
                   printable(row.at("world").get<std::string>()), variables(row),
                   std::to_string(row.at("episodes").get<std::uint64_t>()), success(row), percent(row, "collision"),
                   percent(row, "timeout"), mean(row, "steps", 0), mean(row, "path_length_m", 1), mean(row, "spl", 3)});
  return out;
}

// Drops a column of which only the head is there or every value is "-".
void drop_empty(std::vector<Line>& lines) {
  for (std::size_t c = lines[0].size(); c-- > 2;) {
    const bool empty = std::all_of(lines.begin() + 1, lines.end(),
                                   [c](const Line& line) { return line[c].empty() || line[c] == "-"; });
    if (!empty) continue;
    for (Line& line : lines) line.erase(line.begin() + static_cast<std::ptrdiff_t>(c));
  }
}

// Widths of the columns; names give way, the widest first, until the table fits.
std::vector<std::size_t> fit(std::vector<Line>& lines, std::size_t names) {
  std::vector<std::size_t> widths(lines[0].size());
  for (const Line& line : lines)
    for (std::size_t c = 0; c < line.size(); ++c) widths[c] = std::max(widths[c], width(line[c]));
  std::size_t total = 2 * (widths.size() - 1);
  for (const std::size_t w : widths) total += w;
  for (; total > most_columns; --total) {
    const auto widest = std::max_element(widths.begin(), widths.begin() + static_cast<std::ptrdiff_t>(names));
    if (*widest <= least_name) break;
    --*widest;
  }
  for (Line& line : lines)
    for (std::size_t c = 0; c < names; ++c) {
      const bool mark = line[c].ends_with(" *") && width(line[c]) > widths[c];
      line[c] =
          mark ? shortened(line[c].substr(0, line[c].size() - 2), widths[c] - 2) + " *" : shortened(line[c], widths[c]);
    }
  return widths;
}

std::string drawn(const std::vector<Line>& lines, const std::vector<std::size_t>& widths, std::size_t names) {
  std::string out;
  for (const Line& line : lines) {
    std::string text;
    for (std::size_t c = 0; c < line.size(); ++c) {
      const std::string space(widths[c] - width(line[c]), ' ');
      text += (c > 0 ? gap : "") + (c < names ? line[c] + space : space + line[c]);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    out += text + "\n";
    if (&line != &lines[0]) continue;
    for (std::size_t c = 0; c < widths.size(); ++c) {
      if (c > 0) out += gap;
      for (std::size_t i = 0; i < widths[c]; ++i) out += "─";
    }
    out += "\n";
  }
  return out;
}

}  // namespace

std::string table(const Json& summary) {
  const Json& rows = summary.at("results");
  std::vector<Line> all = lines(rows);
  drop_empty(all);
  const std::size_t names = all[0].size() > 2 && all[0][2] == "at" ? 3 : 2;
  const std::vector<std::size_t> widths = fit(all, names);
  std::string out = drawn(all, widths, names);
  if (std::any_of(rows.begin(), rows.end(), [](const Json& row) { return is_true(row, "privileged"); }))
    out += "* privileged: reads the true map\n";
  const Json& cells = summary.at("cells");
  const auto count = [&](const char* key) { return cells.at(key).get<std::uint64_t>(); };
  if (count("done") != count("planned"))
    out += std::to_string(count("done")) + " of " + std::to_string(count("planned")) + " cells are done, " +
           std::to_string(count("failed")) + " failed\n";
  return out;
}

}  // namespace wend::core
