// Where an arena's scenes come from: the parameters "generate", "scene", "map" and "scenario", read and checked once.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>
#include <wend/config.hpp>

#include "../scene.hpp"
#include "generators.hpp"
#include "movingai.hpp"

namespace arena {

using Generator = std::variant<RandomObstacles, UTrap, Rooms, DoorRoom, Cellular>;

struct SceneSource {
  std::vector<ScenePtr> files;         // of "scene" or "map"; scene k % size
  std::optional<Generator> generator;  // of "generate"; else files
  std::vector<Record> records;         // of "scenario": a start and a goal each, on the one map in `files`
  bool record_by_episode = true;       // record k serves episode k, else variant k
  MapOptions map;                      // how the cells of `files` were laid out
  std::vector<Start> starts;           // in place of the scene's own, unless empty
  std::vector<Goal> goals;             // likewise
  double goal_radius = -1;             // m, of every goal; negative: as the scene has it

  // What make_scene wants as `variant` in this episode.
  std::uint32_t variant(const wend_episode& episode) const noexcept {
    return !records.empty() && record_by_episode ? static_cast<std::uint32_t>(episode.index) : episode.variant;
  }
  // Whether another scene key gives another scene: if not, the variant alone tells scenes apart.
  bool drawn() const noexcept { return generator.has_value(); }
  // How many different scenes there are; 0 where they are drawn.
  std::size_t size() const noexcept { return drawn() ? 0 : records.empty() ? files.size() : records.size(); }
};

// Throws wend::Error that names the parameter at fault.
SceneSource read_source(const wend::Params&);

// A pure function of its arguments.  `variant` is taken modulo the number of files or records; a generator leaves it
// out, since the host's scene key differs between variants.
ScenePtr make_scene(const SceneSource&, std::uint64_t scene_key, std::uint32_t variant);

}  // namespace arena
