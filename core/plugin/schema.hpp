// The subset of JSON Schema in which plugins describe their parameters: checks values, fills defaults in, and says in
// words what is allowed.
//
// type: number, integer, boolean, string, array, object; enum, const, default, minimum, maximum, exclusiveMinimum,
// exclusiveMaximum, minItems, maxItems, items, properties, required, additionalProperties (false), oneOf, description,
// and format: "file" or "files".  An object takes only the keys that it names.  The alternatives of oneOf are told
// apart by their JSON type; several objects among them by a property that is const in each of them; the alternative
// whose const is also its default is taken where the property is missing.
#pragma once
#include <core/base/diagnostics.hpp>
#include <core/base/document.hpp>
#include <core/base/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace wend::core {

struct SchemaContext {
  std::string subject;                 // learner "my.learner", as in: unknown parameter "gama" for learner "my.learner"
  const Document* document = nullptr;  // where the value comes from; may be none
  std::vector<std::string> notes;      // added to each diagnostic: all parameters: wend plugins show my.learner
  std::string noun = "parameter";
};

// Checks `value`, which stands at `pointer` of the document, and changes it in place: defaults are filled in, and
// numbers get the type that the schema gives (2.0 becomes 2 for an integer, 2 becomes 2.0 for a number), so that equal
// values have equal text.  A property that is missing is created if it has a default and only then: an object whose
// members have defaults appears with "default": {}, and without it stays absent.  Every mistake is reported, none hides
// another.
void check_schema(const Json& schema, Json& value, const std::string& pointer, const SchemaContext& context,
                  Diagnostics& diagnostics);

// The first reason why `schema` itself cannot be used, with the pointer inside it; nothing if it can.  It uses the
// subset only, its bounds leave something, its defaults satisfy it and its alternatives can be told apart.
std::optional<std::string> schema_defect(const Json& schema);

// The same with every defect, for a schema at `pointer` of `document` (which may be none).
void check_schema_itself(const Json& schema, const std::string& pointer, const Document* document,
                         Diagnostics& diagnostics);

// "number in [0, 1), default 0.9"
std::string describe(const Json& schema);

}  // namespace wend::core
