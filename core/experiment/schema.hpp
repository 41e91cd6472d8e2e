// The schema of experiment files: the text that editors use, and the parts of it that the host checks files by.
#pragma once
#include <core/base/json.hpp>
#include <map>
#include <string>

namespace wend::core {

// The text of experiment.schema.json, which is built into the program.
std::string experiment_schema_text();

// One object of the file, in the subset of core/plugin/schema.hpp.  What it refers to, and objects that take any key,
// are `open`: `schema` has an empty object or a text in their place, and code looks into them.
struct SchemaPart {
  Json schema;
  std::map<std::string, std::string> open;  // property -> "object" or "string"
};

// The part called `name` in "$defs", or the file itself for "".
const SchemaPart& experiment_schema(const std::string& name);

}  // namespace wend::core
