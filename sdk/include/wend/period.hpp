// wend/period.hpp -- the time between two decisions, from a world in uses "world" (the manifest asks for wend.world/1).
#pragma once
#include <wend/error.hpp>

namespace wend {

// s between two decisions.
inline double period_of(wend_ref world) {
  const auto* table = static_cast<const wend_world*>(world.type->query(world.self, WEND_WORLD));
  if (table == nullptr) throw unsupported("the world does not answer for " WEND_WORLD);
  return table->period(world.self);
}

}  // namespace wend
