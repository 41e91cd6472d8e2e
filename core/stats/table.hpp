// The summary as a table for a terminal.
#pragma once
#include <core/base/json.hpp>
#include <string>

namespace wend::core {

// A row for each result: success with its interval, collisions, timeouts, steps, path length and SPL (means).  "-"
// where a figure has no meaning.  Arms that read the true map carry a mark that a note below explains.
std::string table(const Json& summary);

}  // namespace wend::core
