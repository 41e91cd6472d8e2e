#include <algorithm>
#include <core/base/diagnostics.hpp>
#include <tuple>

namespace wend::core {
namespace {

std::string block(const Diagnostic& diagnostic) {
  std::string out = "error: " + diagnostic.message + "\n";
  if (!diagnostic.file.empty() || !diagnostic.pointer.empty()) {
    out += "  --> " + diagnostic.file;
    if (diagnostic.line > 0) out += ":" + std::to_string(diagnostic.line) + ":" + std::to_string(diagnostic.column);
    if (!diagnostic.pointer.empty()) out += (diagnostic.file.empty() ? "(" : "  (") + diagnostic.pointer + ")";
    out += "\n";
  }
  if (diagnostic.line > 0 && !diagnostic.source_line.empty()) {
    const std::string number = std::to_string(diagnostic.line);
    const std::size_t width = std::max<std::size_t>(4, number.size());
    const std::size_t start = diagnostic.source_column > 0 ? diagnostic.source_column : diagnostic.column;
    out += std::string(width - number.size(), ' ') + number + " |  " + diagnostic.source_line + "\n";
    out += std::string(width, ' ') + " |  " + std::string(std::max<std::size_t>(start, 1) - 1, ' ') +
           std::string(std::max<std::size_t>(diagnostic.length, 1), '^');
    if (!diagnostic.hint.empty()) out += " " + diagnostic.hint;
    out += "\n";
  } else if (!diagnostic.hint.empty()) {
    out += "   = " + diagnostic.hint + "\n";
  }
  for (const std::string& note : diagnostic.notes) out += "   = " + note + "\n";
  return out;
}

char folded(char c) {
  if (c >= 'A' && c <= 'Z') return static_cast<char>(c - 'A' + 'a');
  return c == '-' ? '_' : c;
}

// Optimal string alignment: insertions, deletions, substitutions and swaps of neighbours cost 1.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) now[j] = std::min(now[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(now);
  }
  return last[b.size()];
}

// U+0000..1F, DEL and U+0080..9F: what could drive a terminal.
bool is_control(std::string_view sequence) {
  const auto first = static_cast<unsigned char>(sequence[0]);
  if (sequence.size() == 1) return first < 0x20 || first == 0x7f;
  return sequence.size() == 2 && first == 0xc2 && static_cast<unsigned char>(sequence[1]) < 0xa0;
}

std::string escaped(std::string_view sequence) {
  static constexpr char digits[] = "0123456789abcdef";
  const auto code = static_cast<unsigned char>(sequence.back());
  if (code == '\n') return "\\n";
  if (code == '\t') return "\\t";
  if (code == '\r') return "\\r";
  return std::string("\\u00") + digits[code >> 4] + digits[code & 15];
}

}  // namespace

void Diagnostics::add(Diagnostic diagnostic) {
  if (full()) {
    ++omitted_;
    return;
  }
  std::string place = diagnostic.file + '\n' + std::to_string(diagnostic.line) + ':' +
                      std::to_string(diagnostic.column) + '\n' + diagnostic.pointer + '\n' + diagnostic.message;
  if (seen_.insert(std::move(place)).second) kept_.push_back(std::move(diagnostic));
}

void Diagnostics::add(const Diagnostics& others) {
  for (const Diagnostic& diagnostic : others.kept_) add(diagnostic);
  omitted_ += others.omitted_;
}

const std::vector<Diagnostic>& Diagnostics::sorted() {
  kept_ = in_order();
  return kept_;
}

std::vector<Diagnostic> Diagnostics::in_order() const {
  std::vector<Diagnostic> all = kept_;
  std::stable_sort(all.begin(), all.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.file, a.line, a.column) < std::tie(b.file, b.line, b.column);
  });
  return all;
}

std::string Diagnostics::text() const {
  std::string out;
  for (const Diagnostic& diagnostic : in_order()) out += block(diagnostic);
  if (omitted_ > 0) out += "error: " + std::to_string(omitted_) + " more, not shown\n";
  return out;
}

Json Diagnostics::json() const {
  Json all = Json::array();
  for (const Diagnostic& diagnostic : in_order()) {
    Json notes = Json::array();
    for (const std::string& note : diagnostic.notes) notes.push_back(valid_utf8(note));
    all.push_back({{"message", valid_utf8(diagnostic.message)},
                   {"file", valid_utf8(diagnostic.file)},
                   {"line", diagnostic.line},
                   {"column", diagnostic.column},
                   {"length", diagnostic.length},
                   {"pointer", valid_utf8(diagnostic.pointer)},
                   {"hint", valid_utf8(diagnostic.hint)},
                   {"notes", std::move(notes)}});
  }
  return all;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  if (word.size() < 2 || word.size() > 100) return {};
  std::string own(word);
  std::transform(own.begin(), own.end(), own.begin(), folded);
  std::string best;
  std::size_t least = own.size();
  for (const std::string& candidate : candidates) {
    std::string other = candidate;
    std::transform(other.begin(), other.end(), other.begin(), folded);
    const std::size_t longer = std::max(own.size(), other.size());
    if (other.size() > 100) continue;
    const bool last_part = other.size() > own.size() && other.ends_with("." + own);
    const std::size_t d = last_part ? 1 : distance(own, other);
    if ((!last_part && d > longer / 3) || d >= least) continue;
    least = d;
    best = candidate;
  }
  return best;
}

std::size_t utf8_sequence(std::string_view text) {
  if (text.empty()) return 0;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t n = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < n) return 0;
  for (std::size_t i = 1; i < n; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  // No second spelling of a shorter code, no surrogates, nothing beyond U+10FFFF.
  if ((first == 0xe0 && byte(1) < 0xa0) || (first == 0xed && byte(1) > 0x9f)) return 0;
  if ((first == 0xf0 && byte(1) < 0x90) || (first == 0xf4 && byte(1) > 0x8f)) return 0;
  return n;
}

std::string valid_utf8(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t n = utf8_sequence(text);
    out += n > 0 ? text.substr(0, n) : std::string_view("\xef\xbf\xbd");
    text.remove_prefix(std::max<std::size_t>(n, 1));
  }
  return out;
}

std::string quote(std::string_view text, std::size_t most) {
  std::string out = "\"";
  for (std::size_t count = 0; !text.empty(); ++count) {
    if (count == most) {
      out += "...";
      break;
    }
    const std::size_t n = utf8_sequence(text);
    const std::string_view sequence = text.substr(0, std::max<std::size_t>(n, 1));
    if (n == 0)
      out += "\xef\xbf\xbd";
    else if (is_control(sequence))
      out += escaped(sequence);
    else if (sequence == "\"" || sequence == "\\")
      out.append("\\").append(sequence);
    else
      out += sequence;
    text.remove_prefix(sequence.size());
  }
  return out + "\"";
}

std::string quote_list(const std::vector<std::string>& words, std::string_view conjunction, std::size_t most) {
  std::string out;
  const std::size_t shown = std::min(words.size(), most);
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) out += i + 1 == words.size() ? " " + std::string(conjunction) + " " : ", ";
    out += quote(words[i]);
  }
  if (shown < words.size()) out += " (" + std::to_string(words.size() - shown) + " more)";
  return out;
}

}  // namespace wend::core
