#include <algorithm>
#include <charconv>
#include <core/base/document.hpp>

namespace wend::core {
namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 16;
constexpr std::size_t shown_before = 60, shown_bytes = 100,
                      searched_back = 4096;  // of a long line, around what is meant

bool continues(char c) {
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return !continues(c); }));
}

// One line, in which every control character and every invalid byte is one visible character.
std::string visible(std::string_view line) {
  std::string out = valid_utf8(line);
  for (char& c : out)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = c == '\t' ? ' ' : '?';
  return out;
}

std::string parent_of(const std::string& pointer) {
  const std::size_t slash = pointer.rfind('/');
  return slash == std::string::npos ? std::string() : pointer.substr(0, slash);
}

bool at_or_below(const std::string& pointer, const std::string& ancestor) {
  return pointer.starts_with(ancestor) && (pointer.size() == ancestor.size() || pointer[ancestor.size()] == '/');
}

}  // namespace

std::optional<Document> Document::parse(std::string name, std::string text, Diagnostics& diagnostics) {
  Document document;
  document.name_ = std::move(name);
  if (text.size() > max_bytes) {
    diagnostics.add(
        {"the file has " + std::to_string(text.size()) + " bytes, expected at most " + std::to_string(max_bytes),
         document.name_,
         "",
         0,
         0,
         1,
         "",
         "",
         {},
         0});
    return std::nullopt;
  }
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);  // the byte order mark that some editors write
  document.text_ = std::move(text);
  const std::string_view all = document.text_;
  Position here;
  std::size_t invalid = all.size();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i % block_bytes == 0) document.blocks_.push_back(here);
    if (all[i] == '\n')
      here = {here.line + 1, 1};
    else if (!continues(all[i]))
      ++here.column;
  }
  for (std::size_t i = 0; i < all.size();) {
    const std::size_t n = utf8_sequence(all.substr(i, 4));
    if (n == 0) {
      invalid = i;
      break;
    }
    i += n;
  }
  if (invalid < all.size()) {
    Diagnostic diagnostic = document.locate(invalid, invalid + 1, "a byte that is not UTF-8");
    diagnostic.hint = "save the file as UTF-8";
    diagnostics.add(std::move(diagnostic));
    return std::nullopt;
  }
  JsonText parsed = read_json(all, max_depth, max_values);
  for (JsonMistake& mistake : parsed.mistakes) {
    if (mistake.duplicate)
      mistake.message += ", first on line " + std::to_string(document.position(mistake.first).line);
    Diagnostic diagnostic = document.locate(mistake.begin, mistake.end, std::move(mistake.message));
    diagnostic.pointer = std::move(mistake.pointer);
    diagnostic.hint = std::move(mistake.hint);
    diagnostics.add(std::move(diagnostic));
  }
  if (!parsed.mistakes.empty()) return std::nullopt;
  document.root_ = std::move(parsed.root);
  document.places_ = std::move(parsed.places);
  return document;
}

Document::Position Document::position(std::size_t offset) const {
  if (blocks_.empty()) return {};
  const std::size_t block = std::min(offset / block_bytes, blocks_.size() - 1);
  Position here = blocks_[block];
  for (std::size_t i = block * block_bytes; i < offset && i < text_.size(); ++i) {
    if (text_[i] == '\n')
      here = {here.line + 1, 1};
    else if (!continues(text_[i]))
      ++here.column;
  }
  return here;
}

Diagnostic Document::locate(std::size_t begin, std::size_t end, std::string message) const {
  Diagnostic diagnostic;
  diagnostic.message = std::move(message);
  diagnostic.file = name_;
  const Position here = position(begin);
  diagnostic.line = here.line;
  diagnostic.column = here.column;

  const std::string_view all = text_;
  std::size_t first = begin > searched_back ? begin - searched_back : 0;
  const std::size_t newline = all.substr(first, begin - first).rfind('\n');
  if (newline != std::string_view::npos) first += newline + 1;
  while (first < begin && (all[first] == ' ' || all[first] == '\t')) ++first;  // indentation is not shown
  const bool cut = std::min(end, begin + shown_bytes - shown_before) - first > shown_bytes;
  if (cut) first = begin - shown_before;
  while (cut && first < begin && continues(all[first])) ++first;
  std::size_t last = std::min(all.find('\n', begin), std::min(all.size(), first + shown_bytes));
  const bool more = last < all.size() && all[last] != '\n';
  while (more && last > begin && continues(all[last])) --last;
  std::string_view line = all.substr(first, last - first);
  if (!more && line.ends_with('\r')) line.remove_suffix(1);

  diagnostic.source_line = (cut ? "..." : "") + visible(line) + (more ? "..." : "");
  diagnostic.source_column = characters(visible(all.substr(first, begin - first))) + (cut ? 4 : 1);
  const std::size_t shown_end = std::clamp(end, begin, std::max(begin, first + line.size()));
  diagnostic.length = std::max<std::size_t>(characters(all.substr(begin, shown_end - begin)), 1);
  return diagnostic;
}

std::vector<std::string> pointer_tokens(const std::string& pointer) {
  std::vector<std::string> tokens;
  for (std::size_t i = 0; i < pointer.size(); ++i) {
    if (pointer[i] == '/')
      tokens.emplace_back();
    else if (tokens.empty())
      tokens.emplace_back(1, pointer[i]);  // no pointer: it has to start with a slash
    else if (pointer[i] == '~' && i + 1 < pointer.size() && (pointer[i + 1] == '0' || pointer[i + 1] == '1'))
      tokens.back() += pointer[++i] == '0' ? '~' : '/';
    else
      tokens.back() += pointer[i];
  }
  return tokens;
}

Document::Found Document::find(const std::string& pointer) const {
  Found found{0, true};
  for (const std::string& token : pointer_tokens(pointer)) {
    const JsonPlace& parent = places_[found.place];
    const char kind = text_[parent.begin];
    std::size_t child = found.place + 1;
    if (kind == '{') {
      const std::uint32_t hash = json_key_hash(token);
      const auto same = [&](const JsonPlace& place) {
        return place.key_hash == hash && decode_json_string(std::string_view(text_).substr(
                                             place.key_begin, place.key_end - place.key_begin)) == token;
      };
      while (child < parent.next && !same(places_[child])) child = places_[child].next;
    } else if (kind == '[') {
      std::size_t index = 0;
      const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), index);
      const bool is_index =
          error == std::errc() && end == token.data() + token.size() && token == std::to_string(index);
      for (; is_index && index > 0 && child < parent.next; --index) child = places_[child].next;
      if (!is_index) child = parent.next;
    } else {
      child = parent.next;
    }
    if (child >= parent.next) return {found.place, false};
    found.place = child;
  }
  return found;
}

Diagnostic Document::at(const std::string& pointer, std::string message, bool key) const {
  const auto origin = std::find_if(replaced_.rbegin(), replaced_.rend(),
                                   [&](const auto& entry) { return at_or_below(pointer, entry.first); });
  const bool foreign = origin != replaced_.rend();
  const Found found = find(foreign ? parent_of(origin->first) : pointer);
  const JsonPlace& place = places_[found.place];
  const bool at_key = key && found.exact && !foreign && place.key_end > place.key_begin;
  const bool container = text_[place.begin] == '{' || text_[place.begin] == '[';
  Diagnostic diagnostic = at_key ? locate(place.key_begin, place.key_end, std::move(message))
                                 : locate(place.begin, container ? place.begin + 1 : place.end, std::move(message));
  diagnostic.pointer = pointer;
  if (foreign) diagnostic.notes.push_back("the value comes from " + origin->second);
  return diagnostic;
}

void Document::replaced(const std::string& pointer, std::string origin) {
  replaced_.emplace_back(pointer, std::move(origin));
}

}  // namespace wend::core
