#include <charconv>
#include <core/base/diagnostics.hpp>
#include <core/base/document.hpp>
#include <core/experiment/pointer.hpp>
#include <utility>

namespace wend::core {

namespace {

// The index that a token is, if it is one below `size`.
std::optional<std::size_t> index_of(const std::string& token, std::size_t size) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), index);
  const bool good =
      error == std::errc() && end == token.data() + token.size() && index < size && std::to_string(index) == token;
  return good ? std::optional(index) : std::nullopt;
}

}  // namespace

bool is_there(const Json& document, const std::vector<std::string>& tokens) {
  const Json* here = &document;
  for (const std::string& token : tokens) {
    if (here->is_object() && here->contains(token)) {
      here = &(*here)[token];
      continue;
    }
    const auto index = here->is_array() ? index_of(token, here->size()) : std::nullopt;
    if (!index) return false;
    here = &(*here)[*index];
  }
  return true;
}

std::optional<std::string> assign(Json& document, const std::string& pointer, Json value) {
  Json changed = document;
  Json* here = &changed;
  std::string path;
  for (const std::string& token : pointer_tokens(pointer)) {
    if (here->is_null()) *here = Json::object();
    if (here->is_array()) {
      const auto index = index_of(token, here->size());
      if (!index)
        return quote(path) + " has " + std::to_string(here->size()) + " elements, numbered from 0, found " +
               quote(token);
      here = &(*here)[*index];
    } else if (here->is_object()) {
      here = &(*here)[token];
    } else {
      return quote(path) + " is " + here->dump().substr(0, 60) + ", which has nothing below it";
    }
    path += "/" + pointer_token(token);
  }
  *here = std::move(value);
  document = std::move(changed);
  return std::nullopt;
}

}  // namespace wend::core
