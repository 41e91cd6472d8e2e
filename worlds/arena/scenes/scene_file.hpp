// Our own scene format: JSON, strict, written for people and for tools.
#pragma once
#include <string>
#include <string_view>

#include "../scene.hpp"

namespace arena {

// `name` stands at the head of an error ("maps/room.json: /discs/2/2: expected a radius above 0, found -1").
// Throws wend::Error, without a parameter.
Scene parse_scene(const std::string& name, std::string_view text);

// Text that parse_scene reads back to the same scene, bit by bit.
std::string format_scene(const Scene&);

}  // namespace arena
