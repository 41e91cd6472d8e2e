// From parameters to scenes.
#include <wend/math.hpp>

#include "../scenes/scene_file.hpp"
#include "../scenes/text_file.hpp"
#include "scene_support.hpp"

namespace arena {
namespace {

using Json = nlohmann::json;

TEST(SceneSource, FilesServeVariantsInTurn) {
  const SceneSource source = source_of({{"map", {map_path("small.map"), map_path("crlf.map")}}});
  EXPECT_FALSE(source.drawn());
  EXPECT_EQ(source.size(), 2u);
  EXPECT_EQ(make_scene(source, 1, 0)->name, "small");
  EXPECT_EQ(make_scene(source, 2, 3)->name, "crlf");
  EXPECT_EQ(make_scene(source, 1, 0), make_scene(source, 9, 2));  // one copy of it, whatever the key
}

TEST(SceneSource, StartsAndGoalsReplaceThoseOfTheScene) {
  const SceneSource source = source_of({{"scene", {map_path("all_kinds.json")}},
                                        {"starts", {{{"x", -8}, {"y", 2}, {"heading_deg", 180}}, {{"x", 1}, {"y", 2}}}},
                                        {"goals", {{{"x", 3}, {"y", 30}, {"radius", 2}}}}});
  const ScenePtr scene = make_scene(source, 1, 0);
  ASSERT_EQ(scene->starts.size(), 2u);
  EXPECT_EQ(scene->starts[0].heading, 180 * wend::math::degree);
  EXPECT_TRUE(scene->starts[1].random_heading);
  ASSERT_EQ(scene->goals.size(), 1u);
  EXPECT_EQ(scene->goals[0].radius, 2);
  EXPECT_EQ(scene->x, -8);  // open bounds take them in
  EXPECT_EQ(scene->y + scene->height, 32);
  EXPECT_EQ(scene->x + scene->width, 15);
}

TEST(SceneSource, GoalRadiusRulesAllGoals) {
  const SceneSource source = source_of({{"scene", {map_path("all_kinds.json")}}, {"goal_radius", 3}});
  for (const Goal& goal : make_scene(source, 1, 0)->goals) EXPECT_EQ(goal.radius, 3);
}

TEST(SceneSource, BarnProtocol) {
  const SceneSource source = source_of({{"map", {map_path("small.map")}},
                                        {"cell", 0.15},
                                        {"origin", {-4.5, 0}},
                                        {"layout", "rows_along_x"},
                                        {"walled", false},
                                        {"starts", {{{"x", -2.25}, {"y", 3}, {"heading_deg", 90}}}},
                                        {"goals", {{{"x", -2.25}, {"y", 13}, {"radius", 1}}}}});
  const ScenePtr scene = make_scene(source, 1, 0);
  EXPECT_EQ(scene->grid.columns, 4u);
  EXPECT_EQ(scene->grid.x, -4.5);
  EXPECT_FALSE(scene->walled);
  EXPECT_EQ(scene->y + scene->height, 14);
  EXPECT_EQ(scene->starts[0].heading, wend::math::half_pi);
}

// The schema's defaults are those of the structs, so that a caller without a host gets the same scenes.
TEST(SceneSource, SchemaAndCodeHaveTheSameDefaults) {
  const Json schema = Json::parse(read_text(std::string(WEND_ARENA_FOLDER) + "/scenes/parameters.json"));
  ASSERT_EQ(schema["generate"]["oneOf"].size(), 5u);
  for (const Json& kind : schema["generate"]["oneOf"]) {
    Json bare, full;
    bare["kind"] = full["kind"] = kind["properties"]["kind"]["const"];
    for (const auto& [name, property] : kind["properties"].items())
      if (property.contains("default")) full[name] = property["default"];
    EXPECT_GT(full.size(), 5u);
    const auto text = [](const Json& generate) {
      return format_scene(*make_scene(source_of({{"generate", generate}}), 11, 0));
    };
    EXPECT_EQ(text(bare), text(full)) << full["kind"];
  }
}

TEST(SceneSource, ReadsEveryParameterOfAGenerator) {
  const auto read = [](const Json& generate) { return *source_of({{"generate", generate}}).generator; };
  const RandomObstacles discs{.size = {60, 70},
                              .count = 3,
                              .density = 0.2,
                              .radius = {1, 2},
                              .gap = 5,
                              .wall_gap = 6,
                              .body = 1.5,
                              .goal_radius = 2,
                              .placement = "corners",
                              .distance = 30,
                              .clearance = 2,
                              .blocked = false};
  EXPECT_EQ(std::get<RandomObstacles>(read({{"kind", "random_obstacles"},
                                            {"size", {60, 70}},
                                            {"count", 3},
                                            {"density", 0.2},
                                            {"radius", {1, 2}},
                                            {"gap", 5},
                                            {"wall_gap", 6},
                                            {"body", 1.5},
                                            {"goal_radius", 2},
                                            {"placement", "corners"},
                                            {"distance", 30},
                                            {"clearance", 2},
                                            {"blocked", false}})),
            discs);
  const UTrap trap{.width = 9,
                   .depth = 8,
                   .thickness = 1,
                   .size = {90, 80},
                   .before = 7,
                   .behind = 6,
                   .jitter = 0.1,
                   .turn = false,
                   .body = 2,
                   .goal_radius = 1};
  EXPECT_EQ(std::get<UTrap>(read({{"kind", "u_trap"},
                                  {"width", 9},
                                  {"depth", 8},
                                  {"thickness", 1},
                                  {"size", {90, 80}},
                                  {"before", 7},
                                  {"behind", 6},
                                  {"jitter", 0.1},
                                  {"turn", false},
                                  {"body", 2},
                                  {"goal_radius", 1}})),
            trap);
  const Rooms rooms{.size = {50, 40},
                    .rooms = {3, 2},
                    .door = {4, 5},
                    .thickness = 2,
                    .loops = 0.5,
                    .passages = 2,
                    .count = 4,
                    .radius = {1, 2},
                    .gap = 3,
                    .body = 1,
                    .goal_radius = 2};
  EXPECT_EQ(std::get<Rooms>(read({{"kind", "rooms"},
                                  {"size", {50, 40}},
                                  {"rooms", {3, 2}},
                                  {"door", {4, 5}},
                                  {"thickness", 2},
                                  {"loops", 0.5},
                                  {"passages", 2},
                                  {"count", 4},
                                  {"radius", {1, 2}},
                                  {"gap", 3},
                                  {"body", 1},
                                  {"goal_radius", 2}})),
            rooms);
  const DoorRoom room{.size = {12, 11},
                      .door = 1.5,
                      .door_offset = 2,
                      .passage = {1.3, 1.5},
                      .goals = 2,
                      .goal_spread = 4,
                      .patrols = 1,
                      .patrol_radius = 0.1,
                      .patrol_beat = 4,
                      .patrol_speed = {0.02, 0.03},
                      .body = 0.12,
                      .goal_radius = 0.4};
  EXPECT_EQ(std::get<DoorRoom>(read({{"kind", "door_room"},
                                     {"size", {12, 11}},
                                     {"door", 1.5},
                                     {"door_offset", 2},
                                     {"passage", {1.3, 1.5}},
                                     {"goals", 2},
                                     {"goal_spread", 4},
                                     {"patrols", 1},
                                     {"patrol_radius", 0.1},
                                     {"patrol_beat", 4},
                                     {"patrol_speed", {0.02, 0.03}},
                                     {"body", 0.12},
                                     {"goal_radius", 0.4}})),
            room);
  const Cellular cells{.cells = {20, 40},
                       .cell = 0.2,
                       .corridor = 20,
                       .fill = {0.1, 0.2},
                       .smoothing = {1, 2},
                       .discs = true,
                       .body = 0.2,
                       .margin = 0.1,
                       .goal_radius = 0.5};
  EXPECT_EQ(std::get<Cellular>(read({{"kind", "cellular"},
                                     {"cells", {20, 40}},
                                     {"cell", 0.2},
                                     {"corridor", 20},
                                     {"fill", {0.1, 0.2}},
                                     {"smoothing", {1, 2}},
                                     {"discs", true},
                                     {"body", 0.2},
                                     {"margin", 0.1},
                                     {"goal_radius", 0.5}})),
            cells);
}

// What the manifest says of scenes is this fragment, word for word.
TEST(SceneSource, ManifestHasTheFragment) {
  const Json fragment = Json::parse(read_text(std::string(WEND_ARENA_FOLDER) + "/scenes/parameters.json"));
  const Json manifest = Json::parse(read_text(std::string(WEND_ARENA_FOLDER) + "/manifest.json"));
  const Json& properties = manifest["components"][0]["parameters"]["properties"];
  for (const auto& [name, property] : fragment.items()) EXPECT_EQ(properties.value(name, Json()), property) << name;
}

TEST(SceneSource, RefusesContradictions) {
  const Json map = {map_path("hook.map")}, scenario = map_path("hook.map.scen");
  const auto error = [](const Json& json) { return error_of([&] { source_of(json); }); };
  EXPECT_EQ(error(Json::object()), "generate: expected one of generate, scene and map, found none");
  EXPECT_EQ(error({{"map", map}, {"generate", {{"kind", "u_trap"}}}}),
            "generate: expected one of generate, scene and map, found generate and map");
  EXPECT_EQ(error({{"generate", {{"kind", "maze"}}}}),
            "generate/kind: expected random_obstacles, u_trap, rooms, door_room or cellular, found \"maze\"");
  EXPECT_EQ(error({{"generate", {{"kind", "u_trap"}}}, {"scenario", scenario}}),
            "scenario: expected its one map in \"map\", found none");
  EXPECT_EQ(error({{"map", {map_path("hook.map"), map_path("small.map")}}, {"scenario", scenario}}),
            "scenario: expected its one map in \"map\", found 2");
  EXPECT_EQ(error({{"map", map}, {"scenario", scenario}, {"starts", {{{"x", 1}, {"y", 1}}}}}),
            "scenario: expected no starts and goals beside its own, found some");
  EXPECT_EQ(error({{"map", {map_path("small.map"), "/nowhere/at.map"}}}),
            "map/1: /nowhere/at.map: can't be opened: No such file or directory");
  EXPECT_EQ(error({{"map", map}, {"goals", {{{"x", 1}, {"y", 1}, {"waypoints", {{1, 1}}}}}}}),
            "goals/0/waypoints: expected two way-points or more, found 1");
}

}  // namespace
}  // namespace arena
