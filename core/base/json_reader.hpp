// A strict reader of JSON text that notes where every value stands; Document is what the host uses.
#pragma once
#include <core/base/json.hpp>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace wend::core {

// A value, in the order of the text.
struct JsonPlace {
  std::uint32_t begin = 0, end = 0;          // bytes of the value
  std::uint32_t key_begin = 0, key_end = 0;  // bytes of its key with the quotes; equal if it has none
  std::uint32_t next = 0;                    // index behind its last descendant
  std::uint32_t key_hash = 0;                // of the decoded key
};

struct JsonMistake {
  std::size_t begin = 0, end = 0;  // bytes
  std::size_t first = 0;           // a duplicate key: where the first one begins
  bool duplicate = false;
  std::string pointer, message, hint;
};

struct JsonText {
  Json root;
  std::vector<JsonPlace> places;
  std::vector<JsonMistake> mistakes;  // every duplicate key, and the first syntax error; if any, root is not to be used
};

// `text` is valid UTF-8 of less than 4 GiB.
JsonText read_json(std::string_view text, std::size_t max_depth, std::size_t max_values);

// The text of a string token with its quotes, as read_json has accepted it.
std::string decode_json_string(std::string_view token);

std::uint32_t json_key_hash(std::string_view key);

// One token of an RFC 6901 pointer: "~" and "/" escaped.
std::string pointer_token(std::string_view key);

}  // namespace wend::core
