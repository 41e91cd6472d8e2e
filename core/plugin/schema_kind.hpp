// What the parts of the schema code share: kinds of values and how alternatives are told apart.
#pragma once
#include <core/base/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wend::core {

// "number", "string", "boolean", "array", "object" or "null".
std::string_view kind_of_value(const Json& value);

// The kind of value that a schema allows ("number" for integers too), or "" where it does not say, as for oneOf.
std::string_view kind_of_schema(const Json& schema);

// The alternatives of `schema`'s oneOf that are of `kind`.
std::vector<const Json*> alternatives(const Json& schema, std::string_view kind);

// The property that is const in each of these object schemas and different in each, or "".
std::string discriminator(const std::vector<const Json*>& objects);

// The same kind and the same value; 1 and 1.0 are one number, true and 1 are two values.
bool same_value(const Json& a, const Json& b);

// A value in a message: a text in quotes, an object or array by its size.
std::string shown(const Json& value);
std::string shown_list(const std::vector<Json>& values);

// describe() without the default.
std::string allowed(const Json& schema);

}  // namespace wend::core
