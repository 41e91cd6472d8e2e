// A JSON file that remembers where everything stands.  Stricter than RFC 8259 where JSON leaves traps: duplicate keys,
// numbers that do not fit and NUL in texts are refused.
#pragma once
#include <core/base/diagnostics.hpp>
#include <core/base/json.hpp>
#include <core/base/json_reader.hpp>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wend::core {

class Document {
 public:
  static constexpr std::size_t max_bytes = std::size_t{16} << 20;
  static constexpr std::size_t max_values = 1'000'000;
  static constexpr std::size_t max_depth = 64;

  // Nothing, and what is wrong in `diagnostics`, where the text is not JSON.  `name` is what messages call the file.
  // Integers are kept as 64-bit integers; one that does not fit, and a number beyond double, is refused.
  static std::optional<Document> parse(std::string name, std::string text, Diagnostics& diagnostics);

  const Json& root() const { return root_; }
  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }

  // A diagnostic at the value of `pointer`, or at its key.  Where the file has no such value (a default, --set) it is
  // at the nearest ancestor that it has; `pointer` stays what it is.
  Diagnostic at(const std::string& pointer, std::string message, bool key = false) const;

  // From now on the value at `pointer` is not what the file says: at() points to its parent and notes `origin`
  // ("--set /seed=x").
  void replaced(const std::string& pointer, std::string origin);

 private:
  struct Position {
    std::size_t line = 1, column = 1;
  };
  struct Found {
    std::size_t place = 0;
    bool exact = false;
  };
  Found find(const std::string& pointer) const;
  Position position(std::size_t offset) const;
  Diagnostic locate(std::size_t begin, std::size_t end, std::string message) const;

  std::string name_, text_;
  Json root_;
  std::vector<JsonPlace> places_;
  std::vector<Position> blocks_;                               // where every 64 KiB of the text begin
  std::vector<std::pair<std::string, std::string>> replaced_;  // pointer, origin
};

// The tokens of an RFC 6901 pointer, unescaped; pointer_token (json_reader.hpp) makes one.
std::vector<std::string> pointer_tokens(const std::string& pointer);

}  // namespace wend::core
