// Maps and scenarios of MovingAI's benchmarks, the BARN worlds among them.
#include "../scenes/movingai.hpp"
#include "../scenes/text_file.hpp"
#include "scene_support.hpp"

namespace arena {
namespace {

Scene read_map(const std::string& path, const MapOptions& options = {}) {
  return parse_movingai_map(path, read_text(path), options);
}

// Row by row from the top, as one would draw it.
std::string drawn(const Grid& grid) {
  std::string out;
  for (std::uint32_t row = grid.rows; row-- > 0; out += '\n')
    for (std::uint32_t column = 0; column < grid.columns; ++column) out += grid.at(column, row) ? '@' : '.';
  return out;
}

TEST(Import, MapLiesWithItsLastRowAtTheBottom) {
  MapOptions options;
  options.cell = 0.5, options.x = 3, options.y = -2;
  const Scene scene = read_map(map_path("small.map"), options);
  EXPECT_EQ(drawn(scene.grid), "@@@@@\n@...@\n@.@.@\n@@@@@\n");  // G and S are free, W is not
  EXPECT_EQ(scene.name, "small");
  EXPECT_EQ(scene.x, 3);
  EXPECT_EQ(scene.y, -2);
  EXPECT_EQ(scene.width, 2.5);
  EXPECT_EQ(scene.height, 2);
  EXPECT_TRUE(scene.walled);
  const Point p = cell_centre(options, 4, 2, 1);  // the S
  EXPECT_EQ(p.x, 4.25);
  EXPECT_EQ(p.y, -0.75);
}

TEST(Import, RowsMayLieAlongX) {
  MapOptions options;
  options.rows_along_x = true;
  EXPECT_EQ(drawn(read_map(map_path("small.map"), options).grid), "@@@@\n@..@\n@.@@\n@..@\n@@@@\n");
  const Point p = cell_centre(options, 4, 2, 1);
  EXPECT_EQ(p.x, 1.5);
  EXPECT_EQ(p.y, 2.5);
}

TEST(Import, TypeLineIsOptionalAndLinesMayEndInAnyWay) {
  EXPECT_EQ(drawn(read_map(map_path("crlf.map")).grid), "....\n.@.@\n...@\n");
}

TEST(Import, CellsMayBeCylinders) {
  MapOptions options;
  options.cell = 0.2, options.discs = true;
  const Scene scene = read_map(map_path("crlf.map"), options);
  EXPECT_EQ(scene.grid.columns, 0u);
  ASSERT_EQ(scene.discs.size(), 3u);
  EXPECT_DOUBLE_EQ(scene.discs[0].x, 0.7);  // lower right
  EXPECT_DOUBLE_EQ(scene.discs[0].y, 0.1);
  EXPECT_DOUBLE_EQ(scene.discs[0].radius, 0.1);
}

TEST(Import, ScenarioGivesStartGoalAndLengthOfEachRecord) {
  const SceneSource source =
      source_of({{"map", {map_path("hook.map")}}, {"scenario", map_path("hook.map.scen")}, {"cell", 2}});
  EXPECT_EQ(source.size(), 3u);
  const ScenePtr scene = make_scene(source, 5, 4);  // record 1 of 3
  EXPECT_EQ(scene->starts.at(0).x, 7);
  EXPECT_EQ(scene->starts.at(0).y, 5);
  EXPECT_TRUE(scene->starts[0].random_heading);
  EXPECT_EQ(scene->goals.at(0).x, 11);
  EXPECT_EQ(scene->goals[0].y, 5);
  EXPECT_EQ(scene->goals[0].radius, 1);
  EXPECT_EQ(scene->optimal_length, 18);
  const wend_episode episode{2, 0, 0, 1, WEND_TEST};
  EXPECT_EQ(source.variant(episode), 2u);
}

struct Broken {
  const char *file, *text;
};

TEST(Import, SaysInWhichLineABrokenMapIsBroken) {
  const Broken all[] = {
      {"height.map", "line 8: expected row 4 of 4, found the end of the file"},
      {"width.map", "line 6: expected a row of 3 characters, found 4"},
      {"character.map", "line 6: expected one of . G S @ O T W in column 2, found \"#\""},
      {"type.map", "line 1: expected \"type octile\", found \"type hexagonal\""},
      {"no_map.map", "line 4: expected \"map\", found \"...\""},
      {"size.map", "line 2: expected \"height\" and a whole number from 1 to 16384, found \"height 0\""},
      {"rows.map", "line 7: expected nothing after row 1, found \"...\""}};
  for (const Broken& broken : all) {
    const std::string name = std::string("broken_") + broken.file;
    EXPECT_EQ(error_of([&] { read_map(map_path(name)); }), name + ": " + broken.text);
  }
}

TEST(Import, SaysInWhichLineABrokenScenarioIsBroken) {
  const Broken all[] = {
      {"version.scen", "line 1: expected \"version 1\", found \"version 2\""},
      {"fields.scen",
       "line 2: expected 9 fields: bucket, map, width, height, start x, start y, goal x, goal y, optimal "
       "length, found 8"},
      {"outside.scen",
       "line 2: expected start and goal within 6 x 5 cells, found "
       "\"0\\x09hook.map\\x096\\x095\\x090\\x090\\x096\\x094\\x099\""},
      {"occupied.scen", "line 2: expected a start in a free cell, found an occupied one"},
      {"other_map.scen", "line 2: expected the map's 6 x 5 cells, found 60 x 5"}};
  for (const Broken& broken : all) {
    const std::string name = std::string("broken_") + broken.file;
    const auto read = [&] { source_of({{"map", {map_path("hook.map")}}, {"scenario", map_path(name)}}); };
    EXPECT_EQ(error_of(read), "scenario: " + name + ": " + broken.text);
  }
}

TEST(Import, ReadsTheCorridorsOfOtherPeople) {
  SKIP_WITHOUT(data_path("corridors"));
  for (const auto& entry : std::filesystem::directory_iterator(data_path("corridors")))
    EXPECT_GT(read_map(entry.path().string()).grid.columns, 0u) << entry.path();
}

// The cylinders of the original world stand in the occupied cells of the map, and nowhere else.
TEST(Import, BarnMapLiesAsItsWorldDoes) {
  const std::string map = data_path("barn/maps/barn_264.map"), world = data_path("barn/raw/world_264.world");
  SKIP_WITHOUT(map);
  SKIP_WITHOUT(world);
  MapOptions options;
  options.cell = 0.15, options.x = -4.5, options.rows_along_x = true, options.discs = true, options.walled = false;
  const Scene scene = read_map(map, options);
  std::string text = read_text(world);
  text.resize(text.find("<state"));
  std::size_t cylinders = 0;
  const std::string open = "<pose frame=''>";
  for (std::size_t at = text.find("unit_cylinder"); at != std::string::npos; at = text.find("unit_cylinder", at + 1)) {
    const std::size_t pose = text.find(open, at) + open.size();
    double x = 0, y = 0;
    ASSERT_EQ(std::sscanf(text.c_str() + pose, "%lf %lf", &x, &y), 2);
    ++cylinders;
    EXPECT_TRUE(std::any_of(scene.discs.begin(), scene.discs.end(),
                            [&](const Disc& d) { return std::abs(d.x - x) < 1e-6 && std::abs(d.y - y) < 1e-6; }))
        << x << " " << y;
  }
  EXPECT_EQ(cylinders, scene.discs.size());
}

}  // namespace
}  // namespace arena
