// Which numbers are drawn from where.  World, start and noise are keyed by (root seed, world, variant, seed, train or
// test, episode, robot) and by nothing else, so that all arms meet the same maps, starts and patrol phases; a learner's
// own streams add the arm's id.
#pragma once
#include <wend/abi.h>

#include <core/experiment/unit.hpp>

namespace wend::core {

// The key of a world's instance (its own seed parameter): root, world id.
std::uint64_t world_key(const StreamSpec& stream, const std::string& world);

// The episode that copy of the world is reset with; `robot_episode` is the same for a row.
wend_episode episode_of(const StreamSpec& stream, const WorldSpec& world, std::uint32_t variant, std::uint64_t index,
                        std::uint32_t mode);
wend_episode robot_episode(wend_episode episode, std::uint32_t robot);

// The parent of a component's own streams: root, seed, arm, path of the component in the arm ("policy/avoid").
std::uint64_t component_key(const StreamSpec& stream, const std::string& arm, const std::string& path);

}  // namespace wend::core
