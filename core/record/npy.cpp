#include <core/record/npy.hpp>

namespace wend::core {
namespace {

constexpr std::string_view magic = "\x93NUMPY";

// A cursor over the header, a Python dict of three known keys.
class DictReader {
 public:
  explicit DictReader(std::string_view text) : text_(text) {}

  bool accept(char c) {
    skip();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  std::optional<std::string> quoted() {
    skip();
    if (at_ >= text_.size() || (text_[at_] != '\'' && text_[at_] != '"')) return {};
    const char quote = text_[at_++];
    const std::size_t end = text_.find(quote, at_);
    if (end == std::string_view::npos) return {};
    std::string word(text_.substr(at_, end - at_));
    at_ = end + 1;
    return word;
  }

  std::optional<bool> boolean() {
    skip();
    for (const auto& [word, value] : {std::pair<std::string_view, bool>{"True", true}, {"False", false}}) {
      if (text_.substr(at_, word.size()) != word) continue;
      at_ += word.size();
      return value;
    }
    return {};
  }

  std::optional<std::uint64_t> number() {
    skip();
    if (at_ >= text_.size() || text_[at_] < '0' || text_[at_] > '9') return {};
    std::uint64_t value = 0;
    while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9') {
      if (__builtin_mul_overflow(value, std::uint64_t{10}, &value)) return {};
      if (__builtin_add_overflow(value, static_cast<std::uint64_t>(text_[at_++] - '0'), &value)) return {};
    }
    return value;
  }

  std::optional<Shape> tuple() {
    if (!accept('(')) return {};
    Shape shape;
    while (!accept(')')) {
      const auto n = number();
      if (!n || shape.size() >= 32) return {};
      shape.push_back(*n);
      if (!accept(',') && !accept(')')) return {};
      if (text_[at_ - 1] == ')') return shape;
    }
    return shape;
  }

  bool finished() {
    skip();
    return at_ == text_.size();
  }

 private:
  void skip() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

struct Header {
  std::optional<std::string> type;
  std::optional<bool> fortran;
  std::optional<Shape> shape;
};

bool parse_header(std::string_view text, Header& out) {
  DictReader reader(text);
  if (!reader.accept('{')) return false;
  while (!reader.accept('}')) {
    const auto key = reader.quoted();
    if (!key || !reader.accept(':')) return false;
    if (*key == "descr" && !out.type) {
      if (!(out.type = reader.quoted())) return false;
    } else if (*key == "fortran_order" && !out.fortran) {
      if (!(out.fortran = reader.boolean())) return false;
    } else if (*key == "shape" && !out.shape) {
      if (!(out.shape = reader.tuple())) return false;
    } else {
      return false;
    }
    reader.accept(',');
  }
  return reader.finished() && out.type && out.fortran && out.shape;
}

}  // namespace

std::size_t npy_width(std::string_view type) {
  if (type == "<f8" || type == "<i8") return 8;
  if (type == "<f4" || type == "<u4") return 4;
  return type == "|u1" ? 1 : 0;
}

std::optional<std::uint64_t> npy_count(const Shape& shape) {
  std::uint64_t count = 1;
  bool overflow = false;
  for (const std::uint64_t n : shape) {
    if (n == 0) return 0;
    overflow |= __builtin_mul_overflow(count, n, &count);
  }
  if (overflow) return {};
  return count;
}

std::string npy_header(const std::string& type, const Shape& shape) {
  std::string dict = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (";
  for (std::size_t i = 0; i < shape.size(); ++i) dict += (i > 0 ? " " : "") + std::to_string(shape[i]) + ",";
  if (shape.size() > 1) dict.pop_back();  // (3,) but (3, 4)
  dict += "), }";
  const std::size_t unpadded = magic.size() + 4 + dict.size() + 1;
  dict.append((64 - unpadded % 64) % 64, ' ').push_back('\n');  // the values start at a multiple of 64
  std::string out(magic);
  out += {'\x01', '\x00', static_cast<char>(dict.size() & 0xff), static_cast<char>(dict.size() >> 8)};
  return out + dict;
}

std::string parse_npy(std::string_view bytes, NpyArray& out) {
  if (bytes.size() < 10 || bytes.substr(0, magic.size()) != magic) return "not an array of NumPy's format";
  const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i])); };
  if (byte(6) != 1) return "array format " + std::to_string(byte(6)) + ", expected 1";
  const std::size_t length = byte(8) | byte(9) << 8;
  if (bytes.size() - 10 < length) return "the array's header is cut off";
  Header header;
  if (!parse_header(bytes.substr(10, length), header)) return "the array's header cannot be read";
  if (*header.fortran) return "Fortran order, expected C order";
  const std::size_t width = npy_width(*header.type);
  if (width == 0) return "type \"" + *header.type + "\", expected <f8, <f4, <u4, |u1 or <i8";
  const auto count = npy_count(*header.shape);
  const std::uint64_t held = bytes.size() - 10 - length;
  if (!count || *count > held / width || *count * width != held)
    return "holds " + std::to_string(held) + " bytes of values, and its shape asks for another number";
  out = {*header.type, *header.shape, std::string(bytes.substr(10 + length))};
  return "";
}

}  // namespace wend::core
