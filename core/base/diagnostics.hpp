// What is wrong with an input, where, and what to do: collected, then told all at once in the order of the file.
#pragma once
#include <core/base/json.hpp>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace wend::core {

struct Diagnostic {
  std::string message;                           // where (if no file says it), expected, found
  std::string file, pointer;                     // pointer: RFC 6901; "" is the whole document
  std::size_t line = 0, column = 0, length = 1;  // from 1, in characters; line 0: no position
  std::string source_line, hint;                 // the hint stands behind the carets: what to do
  std::vector<std::string> notes;
  std::size_t source_column = 0;  // where the carets start in source_line, which may be cut; 0: at `column`
};

class Diagnostics {
 public:
  static constexpr std::size_t max_kept = 500;  // a hostile file cannot make more text than this

  // An equal one (same place, same message) is kept once.
  void add(Diagnostic diagnostic);
  void add(const Diagnostics& others);

  bool any() const { return size() > 0; }
  std::size_t size() const { return kept_.size() + omitted_; }
  bool full() const { return kept_.size() >= max_kept; }  // further ones are only counted

  const std::vector<Diagnostic>& sorted();  // by file, line, column
  std::string text() const;                 // one block each, as people read them; ends with a newline; "" if none
  Json json() const;                        // array of {message, file, line, column, length, pointer, hint, notes}

 private:
  std::vector<Diagnostic> in_order() const;

  std::vector<Diagnostic> kept_;
  std::set<std::string> seen_;
  std::size_t omitted_ = 0;
};

// The candidate that somebody who typed `word` most likely meant (Damerau-Levenshtein distance of at most a third of
// the length, case and -_ ignored; "learner" for "my.learner" too), or "" if none is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

// The text of a file, key or value in double quotes, fit for one line of a message: control characters escaped, invalid
// UTF-8 replaced, cut after `most` characters.
std::string quote(std::string_view text, std::size_t most = 60);

// "a", "b" or "c": a list for a message, each quoted; after `most` of them the rest is counted.
std::string quote_list(const std::vector<std::string>& words, std::string_view conjunction = "or",
                       std::size_t most = 12);

// The number of bytes of the UTF-8 sequence at the start of `text`, 0 if it is not one.
std::size_t utf8_sequence(std::string_view text);

// Invalid UTF-8 replaced by U+FFFD.
std::string valid_utf8(std::string_view text);

}  // namespace wend::core
