// JSON text out of files that may be damaged: nesting is bounded, and an error is one message.
#pragma once
#include <core/base/json.hpp>
#include <optional>
#include <string_view>

namespace wend::core {

// Nothing where the text is not JSON or is nested more than 64 levels deep.
inline std::optional<Json> parse_recorded(std::string_view text) {
  bool too_deep = false;
  const auto bound = [&](int depth, Json::parse_event_t, Json&) {
    too_deep |= depth > 64;
    return !too_deep;  // drops what lies deeper, so that no later walk over the value overflows the stack
  };
  Json value = Json::parse(text.begin(), text.end(), bound, false);
  if (too_deep || value.is_discarded()) return {};
  return value;
}

}  // namespace wend::core
