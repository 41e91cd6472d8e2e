// JSON pointers that change a document: what --set and sweeps do.
#pragma once
#include <core/base/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace wend::core {

bool is_there(const Json& document, const std::vector<std::string>& tokens);

// Puts `value` where `pointer` says; objects on the way are made, elements of arrays have to be there.  On failure why,
// and the document is as it was.
std::optional<std::string> assign(Json& document, const std::string& pointer, Json value);

}  // namespace wend::core
