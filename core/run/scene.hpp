// Looks at one scene of a world without driving in it: for `wend worlds show` and `wend worlds import`.
#pragma once
#include <core/base/json.hpp>
#include <core/run/cell.hpp>

namespace wend::core {

// `request`: {"world": WorldSpec's type and params, "robot": definition, "key": scene key, "variant": number}.
// Result: {"scene": the scene in the world's own format, if it can write it; "shapes": count by form}; throws UnitFailed.
Json show_scene(const Json& request, const WorkOptions& options);

}  // namespace wend::core
