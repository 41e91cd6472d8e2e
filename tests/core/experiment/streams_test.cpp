#include <gtest/gtest.h>

#include <core/experiment/streams.hpp>
#include <functional>
#include <set>
#include <vector>

namespace wend::core {
namespace {

WorldSpec world(const std::string& id, bool one_scene = false) {
  WorldSpec spec;
  spec.id = id;
  spec.variants = 10;
  spec.one_scene = one_scene;
  return spec;
}

const StreamSpec test_of_seed_3{2013, 3, false};

TEST(Streams, EachPartOfTheKeyDrawsAnotherEpisode) {
  std::set<std::uint64_t> seeds, scenes;
  const auto draw = [&](const StreamSpec& stream, const std::string& id, std::uint32_t variant, std::uint64_t index) {
    const wend_episode episode = episode_of(stream, world(id), variant, index, WEND_TEST);
    seeds.insert(episode.seed);
    scenes.insert(episode.scene);
  };
  draw(test_of_seed_3, "w", 1, 5);
  draw({2014, 3, false}, "w", 1, 5);
  draw({2013, 4, false}, "w", 1, 5);
  draw({2013, 3, true}, "w", 1, 5);
  draw(test_of_seed_3, "v", 1, 5);
  draw(test_of_seed_3, "w", 2, 5);
  EXPECT_EQ(seeds.size(), 6u);
  EXPECT_EQ(scenes.size(), 6u);
  draw(test_of_seed_3, "w", 1, 6);  // the next episode is on the same map
  EXPECT_EQ(seeds.size(), 7u);
  EXPECT_EQ(scenes.size(), 6u);
}

TEST(Streams, AnEpisodeKnowsItsIndexVariantAndMode) {
  const wend_episode episode = episode_of(test_of_seed_3, world("w"), 4, 17, WEND_TRAIN_EXPLORE);
  EXPECT_EQ(episode.index, 17u);
  EXPECT_EQ(episode.variant, 4u);
  EXPECT_EQ(episode.mode, WEND_TRAIN_EXPLORE);
  EXPECT_EQ(episode.seed, episode_of(test_of_seed_3, world("w"), 4, 17, WEND_TEST).seed);
}

TEST(Streams, NothingButTheKeyMatters) {
  WorldSpec other = world("w");
  other.type = "another type";
  other.params = {{"size", 5}};
  other.robots = 3;
  other.variants = 99;
  const wend_episode a = episode_of(test_of_seed_3, world("w"), 1, 5, WEND_TEST);
  const wend_episode b = episode_of(test_of_seed_3, other, 1, 5, WEND_TEST);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.scene, b.scene);
}

TEST(Streams, OneSceneServesEveryVariantSeedTrainingAndTest) {
  std::set<std::uint64_t> scenes, seeds;
  for (const StreamSpec& stream : {test_of_seed_3, StreamSpec{2013, 4, false}, StreamSpec{2013, 3, true}})
    for (const std::uint32_t variant : {0u, 1u}) {
      scenes.insert(episode_of(stream, world("w", true), variant, 0, WEND_TEST).scene);
      seeds.insert(episode_of(stream, world("w", true), variant, 0, WEND_TEST).seed);
    }
  EXPECT_EQ(scenes.size(), 1u);
  EXPECT_EQ(seeds.size(), 6u);
  scenes.insert(episode_of({2014, 3, false}, world("w", true), 0, 0, WEND_TEST).scene);
  scenes.insert(episode_of(test_of_seed_3, world("v", true), 0, 0, WEND_TEST).scene);
  EXPECT_EQ(scenes.size(), 3u);
}

TEST(Streams, RobotsDifferFromEachOtherAndFromTheirWorld) {
  const wend_episode episode = episode_of(test_of_seed_3, world("w"), 0, 0, WEND_TEST);
  std::set<std::uint64_t> seeds{episode.seed};
  for (std::uint32_t robot = 0; robot < 3; ++robot) {
    const wend_episode own = robot_episode(episode, robot);
    seeds.insert(own.seed);
    EXPECT_EQ(own.scene, episode.scene);
    EXPECT_EQ(own.index, episode.index);
  }
  EXPECT_EQ(seeds.size(), 4u);
}

TEST(Streams, ALearnersOwnStreamsAddItsArmAndPlace) {
  const std::set<std::uint64_t> keys{
      component_key(test_of_seed_3, "a", "policy"),       component_key(test_of_seed_3, "b", "policy"),
      component_key(test_of_seed_3, "a", "policy/avoid"), component_key({2013, 4, false}, "a", "policy"),
      component_key({2014, 3, false}, "a", "policy"),     world_key(test_of_seed_3, "a")};
  EXPECT_EQ(keys.size(), 6u);
  EXPECT_EQ(component_key(test_of_seed_3, "a", "policy"), component_key({2013, 3, true}, "a", "policy"));
  EXPECT_NE(component_key(test_of_seed_3, "a/b", "c"), component_key(test_of_seed_3, "a", "b/c"));
  EXPECT_EQ(world_key(test_of_seed_3, "w"), world_key({2013, 9, true}, "w"));
}

TEST(Streams, KeysAreWhatTheyWere) {  // a change here changes every result
  const wend_episode episode = episode_of(test_of_seed_3, world("ordinary"), 1, 5, WEND_TEST);
  EXPECT_EQ(episode.seed, 1382552129736718863u);
  EXPECT_EQ(episode.scene, 7082222363947947303u);
  EXPECT_EQ(robot_episode(episode, 0).seed, 7200004163930907902u);
  EXPECT_EQ(world_key(test_of_seed_3, "ordinary"), 8122800325277205392u);
  EXPECT_EQ(component_key(test_of_seed_3, "lspi", "policy/avoid"), 2769138463025864995u);
}

}  // namespace
}  // namespace wend::core
