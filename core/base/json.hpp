// JSON inside the host: nlohmann::json with sorted keys, so that dump() is canonical.
#pragma once
#include <nlohmann/json.hpp>

namespace wend::core {

using Json = nlohmann::json;

}  // namespace wend::core
