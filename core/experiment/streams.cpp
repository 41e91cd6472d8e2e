// Streams are named by chains of stream(parent, part): no part can run into the next one, whatever characters it has.
#include <core/experiment/streams.hpp>
#include <wend/random.hpp>

namespace wend::core {

namespace {

// What a draw of a world in one seed of a training or a test starts from.
std::uint64_t draw_key(std::uint64_t parent, const StreamSpec& stream, std::uint32_t variant) {
  const std::uint64_t of_variant = wend::stream(parent, std::uint64_t{variant});
  return wend::stream(wend::stream(of_variant, stream.seed), stream.train ? "train" : "test");
}

}  // namespace

std::uint64_t world_key(const StreamSpec& stream, const std::string& world) {
  return wend::stream(wend::stream(stream.root, "world"), world);
}

wend_episode episode_of(const StreamSpec& stream, const WorldSpec& world, std::uint32_t variant, std::uint64_t index,
                        std::uint32_t mode) {
  const std::uint64_t scenes = wend::stream(wend::stream(stream.root, "scene"), world.id);
  const std::uint64_t episodes = wend::stream(wend::stream(stream.root, "episode"), world.id);
  wend_episode episode{};
  episode.index = index;
  episode.seed = wend::stream(draw_key(episodes, stream, variant), index);
  episode.scene = world.one_scene ? scenes : draw_key(scenes, stream, variant);
  episode.variant = variant;
  episode.mode = mode;
  return episode;
}

wend_episode robot_episode(wend_episode episode, std::uint32_t robot) {
  episode.seed = wend::stream(episode.seed, std::uint64_t{robot} + 1);
  return episode;
}

std::uint64_t component_key(const StreamSpec& stream, const std::string& arm, const std::string& path) {
  const std::uint64_t of_seed = wend::stream(wend::stream(stream.root, "component"), stream.seed);
  return wend::stream(wend::stream(of_seed, arm), path);
}

}  // namespace wend::core
