// The mazes of the literature, from the north; each is named by who drew it.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace grid_maze {

// Throws where there is no maze of that name.
std::vector<std::string> named_map(std::string_view name);

}  // namespace grid_maze
