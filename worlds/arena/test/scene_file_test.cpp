// The scene format: what it can say, that nothing is lost on the way out and in, and what it says of broken files.
#include "../scenes/scene_file.hpp"

#include <wend/math.hpp>

#include "../scenes/text_file.hpp"
#include "scene_support.hpp"

namespace arena {
namespace {

Scene read(const std::string& path) {
  return parse_scene(path, read_text(path));
}

TEST(SceneFile, ReadsEveryKindOfThing) {
  const Scene scene = read(map_path("all_kinds.json"));
  EXPECT_EQ(scene.name, "all_kinds");
  EXPECT_EQ(scene.x, -5);
  EXPECT_EQ(scene.width, 20);
  EXPECT_FALSE(scene.walled);
  ASSERT_EQ(scene.discs.size(), 2u);
  EXPECT_EQ(scene.discs[0].x, 0.1);
  EXPECT_EQ(scene.discs[1].radius, 1);
  ASSERT_EQ(scene.segments.size(), 1u);
  EXPECT_EQ(scene.segments[0].y1, 1);
  ASSERT_EQ(scene.polygons.size(), 2u);
  EXPECT_EQ(scene.polygons[0].points[0].x, 6);  // given clockwise, kept counter-clockwise
  EXPECT_EQ(scene.polygons[0].points[1].y, 6);
  EXPECT_EQ(scene.polygons[1].points[2].x, 10);
  EXPECT_EQ(scene.polygons[1].points[2].y, 4);
  ASSERT_EQ(scene.grid.columns, 3u);
  EXPECT_EQ(scene.grid.occupied, (std::vector<std::uint8_t>{0, 1, 1, 1, 0, 0}));
  ASSERT_EQ(scene.movers.size(), 2u);
  EXPECT_EQ(scene.movers[0].waypoints.size(), 2u);
  EXPECT_FALSE(scene.movers[0].random_phase);
  EXPECT_EQ(scene.movers[1].vy, 0.5);
  ASSERT_EQ(scene.starts.size(), 2u);
  EXPECT_EQ(scene.starts[0].heading, 90 * wend::math::degree);
  EXPECT_FALSE(scene.starts[0].random_heading);
  EXPECT_TRUE(scene.starts[1].random_heading);
  ASSERT_EQ(scene.goals.size(), 2u);
  EXPECT_EQ(scene.goals[0].speed, 0.8);
  EXPECT_EQ(scene.goals[0].waypoints[1].x, 12);
}

TEST(SceneFile, WritesWhatItReadsBackToTheSameBits) {
  Scene scene = read(map_path("all_kinds.json"));
  scene.discs.push_back({1.0 / 3, wend::math::pi, 0.1 + 0.2});
  scene.starts[0].heading = -1.2345678901234567;
  scene.optimal_length = 2.0 / 7;
  scene.name = "a \"name\" of \xc3\xa9";
  const std::string text = format_scene(scene);
  const Scene again = parse_scene("again", text);
  EXPECT_EQ(format_scene(again), text);
  EXPECT_EQ(again.name, scene.name);
  EXPECT_EQ(again.discs.back().x, scene.discs.back().x);
  EXPECT_EQ(again.discs.back().y, scene.discs.back().y);
  EXPECT_EQ(again.discs.back().radius, scene.discs.back().radius);
  EXPECT_EQ(again.starts[0].heading, scene.starts[0].heading);
  EXPECT_EQ(again.optimal_length, scene.optimal_length);
  EXPECT_EQ(again.grid.occupied, scene.grid.occupied);
  EXPECT_EQ(again.polygons[0].points[2].y, scene.polygons[0].points[2].y);
}

TEST(SceneFile, ShippedScenesAreWhatTheirPapersSay) {
  const std::string data = std::string(WEND_ARENA_FOLDER) + "/scenes/data/";
  const Scene hdp = read(data + "hdp_arena.json");
  EXPECT_EQ(hdp.discs.size(), 11u);
  EXPECT_EQ(hdp.goals.at(0).radius, 2);
  EXPECT_TRUE(hdp.starts.at(0).random_heading);
  const Scene room = read(data + "paper_room.json");
  EXPECT_EQ(room.polygons.size(), 8u);
  EXPECT_EQ(room.movers.size(), 3u);
  EXPECT_NEAR(room.polygons[7].points[0].x - room.polygons[6].points[1].x, 1.2, 1e-12);  // the door
  EXPECT_EQ(read(data + "u_trap.json").polygons.size(), 3u);
  EXPECT_EQ(read(data + "tutorial.json").movers.size(), 1u);
}

struct Broken {
  const char *file, *text;
};

TEST(SceneFile, SaysWhereABrokenFileIsBroken) {
  const Broken all[] = {
      {"cut.json", "line 2, column 31: expected JSON, found the end of the file"},
      {"key.json",
       "the file: expected only the keys wend_scene, name, bounds, walled, discs, segments, polygons, "
       "rectangles, grid, movers, starts, goals, optimal_length, found \"disc\""},
      {"twice.json", "expected each key once in an object, found \"walled\" twice"},
      {"radius.json", "/discs/1/2: expected a length in m above 0, at most 1e6, found -2"},
      {"polygon.json", "/polygons/0: expected edges that do not meet, found that those from points 0 and 2 do"},
      {"start.json", "/starts/0: expected a place within the bounds, which are walls, found {\"x\":12,\"y\":3}"},
      {"grid.json", "/grid/rows/1: expected as many characters as the first row, 3, found 2"},
      {"number.json", "expected numbers that a double can hold, found one beyond"},
      {"bounds.json", "the file: expected a \"bounds\", found none"},
      {"waypoints.json", "/movers/0/waypoints: expected 2 to 1000 way-points, found 1"}};
  for (const Broken& broken : all) {
    const std::string name = std::string("broken_") + broken.file;
    EXPECT_EQ(error_of([&] { read(map_path(name)); }), name + ": " + broken.text);
  }
}

TEST(SceneFile, RefusesWhatIsNotAScene) {
  const auto error = [](const std::string& text) { return error_of([&] { parse_scene("s", text); }); };
  const std::string head = R"({"wend_scene": 1, "bounds": {"width": 10, "height": 10}, )";
  EXPECT_EQ(error("[]"), "s: the file: expected an object, found []");
  EXPECT_EQ(error("{\"wend_scene\": 2}"), "s: /wend_scene: expected version 1, found 2");
  EXPECT_EQ(error(""), "s: line 1, column 1: expected JSON, found the end of the file");
  EXPECT_EQ(error("{\"a\": nul}"), "s: line 1, column 10: expected JSON, found \"}\"");
  EXPECT_EQ(error(head + "\"discs\": [[1, 2]]}"), "s: /discs/0: expected 3 numbers x, y, radius, found 2");
  EXPECT_EQ(error(head + "\"discs\": [[1, 2e7, 1]]}"),
            "s: /discs/0/1: expected a coordinate in m, -1e6 to 1e6, found 20000000.0");
  EXPECT_EQ(error(head + "\"polygons\": [[[1, 1], [2, 2], [3, 3]]]}"),
            "s: /polygons/0: expected a polygon with an area, found none");
  EXPECT_EQ(error(head + "\"segments\": [[1, 1, 1, 1]]}"),
            "s: /segments/0: expected two different ends, found [1,1,1,1]");
  EXPECT_EQ(error(head + "\"walled\": 1}"), "s: /walled: expected true or false, found 1");
  EXPECT_EQ(error(head + "\"grid\": {\"x\": 0, \"y\": 0, \"cell\": 1, \"rows\": [\".x\"]}}"),
            "s: /grid/rows/0: expected only . and @, found \"x\"");
  EXPECT_EQ(error(head + "\"starts\": [{\"x\": 1, \"y\": 1, \"heading\": 1, \"heading_deg\": 1}]}"),
            "s: /starts/0: expected heading (rad) or heading_deg, found both");
  EXPECT_EQ(error(head + "\"goals\": [{\"x\": 1, \"y\": 1, \"radius\": 1, \"speed\": 1}]}"),
            "s: /goals/0: expected way-points beside a speed, found none");
}

}  // namespace
}  // namespace arena
