#include <algorithm>
#include <charconv>
#include <core/base/diagnostics.hpp>
#include <core/base/json_reader.hpp>
#include <functional>

namespace wend::core {
namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_word(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '+' || c == '-' ||
         c == '.';
}

void append_utf8(std::string& out, std::uint32_t code) {
  const auto put = [&out](std::uint32_t byte) { out += static_cast<char>(byte); };
  if (code < 0x80) return put(code);
  if (code < 0x800)
    put(0xc0 | code >> 6);
  else if (code < 0x10000)
    put(0xe0 | code >> 12), put(0x80 | (code >> 6 & 0x3f));
  else
    put(0xf0 | code >> 18), put(0x80 | (code >> 12 & 0x3f)), put(0x80 | (code >> 6 & 0x3f));
  put(0x80 | (code & 0x3f));
}

std::uint32_t hex4(std::string_view digits) {
  std::uint32_t code = 0;
  std::from_chars(digits.data(), digits.data() + 4, code, 16);
  return code;
}

class Reader {
 public:
  Reader(std::string_view text, std::size_t max_depth, std::size_t max_values, JsonText& out)
      : text_(text), max_depth_(max_depth), max_values_(max_values), out_(out) {}

  void read() {
    try {
      out_.root = value({0, 0, 0, 0, 0, 0});
      skip_space();
      if (at_ < text_.size())
        fail(at_, word_end(at_), "expected the end of the file, found " + found(at_), "one file holds one value");
    } catch (JsonMistake& mistake) {
      out_.mistakes.push_back(std::move(mistake));
    }
  }

 private:
  struct Frame {  // where we are, for the pointer of a message
    const std::string* key;
    std::size_t index;
  };
  static constexpr std::size_t between = static_cast<std::size_t>(-1);  // in an object, before a key

  [[noreturn]] void fail(std::size_t begin, std::size_t end, std::string message, std::string hint = {}) const {
    throw JsonMistake{begin, std::max(end, begin + 1), 0, false, pointer(), std::move(message), std::move(hint)};
  }

  std::string pointer() const {
    std::string all;
    for (const Frame& frame : path_)
      if (frame.key || frame.index != between)
        all += "/" + (frame.key ? pointer_token(*frame.key) : std::to_string(frame.index));
    return all;
  }

  void skip_space() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  }

  // The end of the file is where its last character is, so that a message can show a line.
  [[noreturn]] void fail_at_end(const std::string& expected) const {
    std::size_t end = text_.size();
    while (end > 0 && is_space(text_[end - 1])) --end;
    fail(end, end, "expected " + expected + ", found the end of the file");
  }

  std::size_t word_end(std::size_t begin) const {
    std::size_t end = begin;
    while (end < text_.size() && is_word(text_[end])) ++end;
    return end > begin ? end : begin + std::max<std::size_t>(utf8_sequence(text_.substr(begin)), 1);
  }

  std::string found(std::size_t begin) const { return quote(text_.substr(begin, word_end(begin) - begin), 30); }

  Json value(JsonPlace place) {
    skip_space();
    if (at_ >= text_.size()) fail_at_end("a value");
    if (out_.places.size() >= max_values_)
      fail(at_, at_, "more than " + std::to_string(max_values_) + " values in one file");
    const std::size_t index = out_.places.size();
    place.begin = static_cast<std::uint32_t>(at_);
    out_.places.push_back(place);
    Json result = any();
    out_.places[index].end = static_cast<std::uint32_t>(at_);
    out_.places[index].next = static_cast<std::uint32_t>(out_.places.size());
    return result;
  }

  Json any() {
    const char c = text_[at_];
    if (c == '{') return object();
    if (c == '[') return array();
    if (c == '"') return string();
    if (c == '-' || is_digit(c)) return number();
    const std::size_t end = word_end(at_);
    const std::string_view word = text_.substr(at_, end - at_);
    if (word != "true" && word != "false" && word != "null")
      fail(at_, end, "expected a value, found " + found(at_), help(word));
    at_ = end;
    return word == "null" ? Json() : Json(word == "true");
  }

  std::string help(std::string_view word) const {
    if (word[0] == ']' || word[0] == '}') return last_ == ',' ? "remove the comma before it" : "";
    if (word[0] == '/' || word[0] == '#') return "JSON has no comments";
    if (word[0] == '\'') return "texts stand in double quotes";
    if (word == "True" || word == "False" || word == "None" || word == "nil")
      return word == "True" ? "write true" : word == "False" ? "write false" : "write null";
    if (word[0] == '.') return "a number starts with a digit";
    if (word[0] == '+') return "a number has no plus sign";
    if (word == "NaN" || word == "nan" || word == "Infinity" || word == "inf") return "JSON has no NaN and no infinity";
    return is_word(word[0]) ? "texts stand in double quotes" : "";
  }

  void open() {
    if (path_.size() >= max_depth_) fail(at_, at_, "nested deeper than " + std::to_string(max_depth_) + " levels");
    last_ = text_[at_++];
    skip_space();
  }

  // After a member or element: true if another one follows.
  bool goes_on(char close) {
    skip_space();
    const std::string expected = std::string("\",\" or \"") + close + "\"";
    if (at_ >= text_.size()) fail_at_end(expected);
    last_ = text_[at_];
    if (last_ != ',' && last_ != close)
      fail(at_, word_end(at_), "expected " + expected + ", found " + found(at_),
           last_ == '/' || last_ == '#'   ? "JSON has no comments"
           : last_ == ']' || last_ == '}' ? "close the inner bracket first"
                                          : "is a comma missing before it?");
    ++at_;
    return last_ == ',';
  }

  Json array() {
    Json result = Json::array();
    auto& elements = result.get_ref<Json::array_t&>();
    open();
    if (at_ < text_.size() && text_[at_] == ']') return ++at_, result;
    path_.push_back({nullptr, 0});
    do {
      path_.back().index = elements.size();
      elements.push_back(value({0, 0, 0, 0, 0, 0}));
    } while (goes_on(']'));
    path_.pop_back();
    return result;
  }

  Json object() {
    const std::size_t own = out_.places.size() - 1;
    Json result = Json::object();
    auto& members = result.get_ref<Json::object_t&>();
    open();
    if (at_ < text_.size() && text_[at_] == '}') return ++at_, result;
    path_.push_back({nullptr, between});
    do {
      JsonPlace place{};
      const std::string key = read_key(place);
      path_.back().key = &key;
      if (const auto first = members.find(key); first != members.end()) note_duplicate(own, place, key);
      skip_space();
      if (at_ >= text_.size()) fail_at_end("\":\"");
      if (text_[at_] != ':') fail(at_, word_end(at_), "expected \":\" after the key, found " + found(at_));
      last_ = text_[at_++];
      Json member = value(place);
      members.insert_or_assign(key, std::move(member));
      path_.back().key = nullptr;
    } while (goes_on('}'));
    path_.pop_back();
    return result;
  }

  std::string read_key(JsonPlace& place) {
    skip_space();
    if (at_ >= text_.size()) fail_at_end("a key");
    if (text_[at_] != '"')
      fail(at_, word_end(at_), "expected a key in double quotes, found " + found(at_),
           text_[at_] == '}' && last_ == ',' ? "remove the comma before it"
           : text_[at_] == '/'               ? "JSON has no comments"
                                             : "");
    place.key_begin = static_cast<std::uint32_t>(at_);
    std::string key = string();
    place.key_end = static_cast<std::uint32_t>(at_);
    place.key_hash = json_key_hash(key);
    return key;
  }

  void note_duplicate(std::size_t parent, const JsonPlace& place, const std::string& key) {
    if (out_.mistakes.size() >= Diagnostics::max_kept) return;
    std::size_t child = parent + 1;
    const auto same = [&](const JsonPlace& other) {
      return other.key_hash == place.key_hash &&
             decode_json_string(text_.substr(other.key_begin, other.key_end - other.key_begin)) == key;
    };
    while (!same(out_.places[child])) child = out_.places[child].next;
    out_.mistakes.push_back({place.key_begin, place.key_end, out_.places[child].key_begin, true, pointer(),
                             "duplicate key " + quote(key), "remove one of them"});
  }

  std::string string() {
    const std::size_t begin = at_++;
    for (; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      const auto c = static_cast<unsigned char>(text_[at_]);
      if (c == '\n' || c == '\r')
        fail(begin, at_, "a text that does not end on its line", "close the quotes; \\n is a new line");
      if (c < 0x20) fail(at_, at_, "a control character in a text", "write \\t for a tab, \\u00XX for others");
      if (c == '\\') check_escape();
    }
    if (at_ >= text_.size()) fail(begin, begin, "a text that does not end: the closing quote is missing");
    ++at_;
    return decode_json_string(text_.substr(begin, at_ - begin));
  }

  // at_ is at the backslash; leaves it at the last character of the escape.
  void check_escape() {
    const std::size_t begin = at_++;
    const char c = at_ < text_.size() ? text_[at_] : '\0';
    if (std::string_view("\"\\/bfnrt").find(c) != std::string_view::npos && c != '\0') return;
    if (c != 'u') fail(begin, begin + 2, "an unknown escape in a text", "write \\\\ for a backslash");
    const std::uint32_t code = check_hex(begin);
    if (code == 0) fail(begin, at_ + 1, "a text may not contain NUL");
    if (code < 0xd800 || code > 0xdfff) return;
    const bool pair = code < 0xdc00 && text_.substr(at_ + 1, 2) == "\\u";
    if (pair) at_ += 2;
    const std::uint32_t low = pair ? check_hex(at_ - 1) : 0;
    if (low < 0xdc00 || low > 0xdfff) fail(begin, at_ + 1, "half of a surrogate pair in a text");
  }

  std::uint32_t check_hex(std::size_t begin) {  // at_ is at the u; leaves it at the last digit
    const std::string_view digits = text_.substr(at_ + 1, 4);
    const bool good =
        digits.size() == 4 && digits.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
    if (!good) fail(begin, at_ + 1, "expected four hexadecimal digits after \\u");
    at_ += 4;
    return hex4(digits);
  }

  void digits(const char* where) {
    if (at_ >= text_.size() || !is_digit(text_[at_]))
      fail(at_, at_, std::string("expected a digit ") + where + (at_ < text_.size() ? ", found " + found(at_) : ""));
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
  }

  Json number() {
    const std::size_t begin = at_, end = word_end(begin);
    if (text_[at_] == '-') ++at_;
    const std::string_view rest = text_.substr(at_, end - at_);
    if (rest == "Infinity" || rest == "NaN")
      fail(begin, end, "expected a value, found " + found(begin), "JSON has no NaN and no infinity");
    const std::size_t first = at_;
    digits("in the number");
    if (text_[first] == '0' && at_ > first + 1) fail(begin, end, "a number that starts with 0", "remove the 0");
    bool integer = true;
    if (at_ < text_.size() && text_[at_] == '.') {
      integer = false;
      ++at_;
      digits("after the decimal point");
    }
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      integer = false;
      ++at_;
      if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
      digits("in the exponent");
    }
    if (at_ != end) fail(begin, end, "expected a number, found " + found(begin));
    return integer ? integer_of(begin) : real_of(begin);
  }

  Json integer_of(std::size_t begin) const {
    const char* last = text_.data() + at_;
    std::uint64_t magnitude = 0;
    std::int64_t negative = 0;
    const bool fits = text_[begin] == '-' ? std::from_chars(text_.data() + begin, last, negative).ec == std::errc()
                                          : std::from_chars(text_.data() + begin, last, magnitude).ec == std::errc();
    if (!fits) fail(begin, at_, "an integer that does not fit into 64 bits", "write it as 1e20 if rounding is meant");
    return text_[begin] == '-' ? Json(negative) : Json(magnitude);
  }

  Json real_of(std::size_t begin) const {
    double number = 0;
    if (std::from_chars(text_.data() + begin, text_.data() + at_, number).ec != std::errc())
      fail(begin, at_, "a number beyond the range of double (about 4.9e-324 to 1.8e308)");
    return number;
  }

  std::string_view text_;
  std::size_t max_depth_, max_values_, at_ = 0;
  char last_ = '\0';  // the last of { [ , : that was read
  std::vector<Frame> path_;
  JsonText& out_;
};

}  // namespace

JsonText read_json(std::string_view text, std::size_t max_depth, std::size_t max_values) {
  JsonText out;
  Reader(text, max_depth, max_values, out).read();
  return out;
}

std::string decode_json_string(std::string_view token) {
  std::string out;
  for (std::size_t i = 1; i + 1 < token.size(); ++i) {
    if (token[i] != '\\') {
      out += token[i];
      continue;
    }
    const char c = token[++i];
    static constexpr std::string_view names = "bfnrt", controls = "\b\f\n\r\t";
    if (const auto known = names.find(c); known != std::string_view::npos)
      out += controls[known];
    else if (c != 'u')
      out += c;
    else {
      std::uint32_t code = hex4(token.substr(i + 1));
      i += 4;
      if (code >= 0xd800 && code < 0xdc00) {
        code = 0x10000 + ((code - 0xd800) << 10) + (hex4(token.substr(i + 3)) - 0xdc00);
        i += 6;
      }
      append_utf8(out, code);
    }
  }
  return out;
}

std::uint32_t json_key_hash(std::string_view key) {
  return static_cast<std::uint32_t>(std::hash<std::string_view>{}(key));
}

std::string pointer_token(std::string_view key) {
  std::string token;
  for (const char c : key) token += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return token;
}

}  // namespace wend::core
