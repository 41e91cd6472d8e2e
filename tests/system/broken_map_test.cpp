// Maps that are broken, met through the program: `validate` and `run` end with exit 3 or 5, or a failed cell where the
// map is read only as the episode begins, and the message names the file and the place in it.
#include <gtest/gtest.h>

#include "support/wend.hpp"

using namespace wend::test;

namespace {

const std::string maps = WEND_SOURCE_DIR "/worlds/arena/test/maps/";

Json experiment_on(const Json& params) {
  return {{"name", "broken map"},
          {"worlds", {{{"id", "w"}, {"type", "wend.arena"}, {"params", params}}}},
          {"robots",
           {{"r",
             {{"body", {{"radius", 0.3}}},
              {"kinematics", {{"type", "unicycle"}, {"speed", {0, 1}}, {"turn_rate", 2}}},
              {"sensors", {{{"id", "goal"}, {"type", "wend.goal"}}}}}}}},
          {"arms", {{{"id", "a"}, {"robot", "r"}, {"policy", "wend.goal_direct"}}}},
          {"test", {{"episodes", 1}}}};
}

struct Broken {
  const char* file;
  const char* message;  // behind the file's name
};

const Broken broken[] = {
    {"broken_bounds.json", ": the file: expected a \"bounds\", found none"},
    {"broken_cut.json", ": line 2, column 31: expected JSON, found the end of the file"},
    {"broken_radius.json", nullptr},
    {"broken_polygon.json", nullptr},
    {"broken_grid.json", nullptr},
    {"broken_twice.json", nullptr},
    {"broken_character.map", ": line 6: expected one of . G S @ O T W in column 2, found \"#\""},
    {"broken_rows.map", ": line 7: expected nothing after row 1, found \"...\""},
    {"broken_no_map.map", ": line 4: expected \"map\", found \"...\""},
    {"broken_size.map", nullptr},
    {"broken_occupied.scen", ": line 2: expected a start in a free cell, found an occupied one"},
    {"broken_fields.scen", nullptr},
};

}  // namespace

TEST(BrokenMap, IsNamedWithItsPlace) {
  const TemporaryDirectory place;
  for (const auto& [name, message] : broken) {
    const std::string file = maps + name;
    const bool scenario = file.find(".scen") != std::string::npos, grid = file.find(".map") != std::string::npos;
    const std::string parameter = scenario ? "scenario" : grid ? "map/0" : "scene/0";
    Json params = Json::object();
    if (scenario)
      params = {{"map", {maps + "hook.map"}}, {"scenario", file}};
    else
      params[grid ? "map" : "scene"] = {file};
    const std::string experiment = place.write("experiment.json", experiment_on(params).dump());
    const Outcome checked = run_wend({"validate", experiment});
    EXPECT_EQ(checked.exit, 3) << name;
    const std::string said =
        "world (wend.arena): create: parameter error: " + parameter + ": " + file + (message ? message : ": ");
    const std::string expected = "error: a @ w: " + said;
    EXPECT_EQ(checked.err.substr(0, expected.size()), expected);
    if (message) {
      EXPECT_EQ(checked.err, expected + "\n");
    }

    const Outcome ran = run(run_command(experiment, place / name));
    EXPECT_EQ(ran.exit, 1) << name;  // the cells on that map fail; those on others would go on
    EXPECT_NE(ran.err.find("failed cell a @ w, seed 0, variant 0\n  plugin: " + said), std::string::npos) << ran.err;
  }
}

TEST(BrokenMap, ImportSaysWhatIsWrong) {
  const Outcome outcome = run_wend({"worlds", "import", maps + "broken_rows.map"});
  EXPECT_EQ(outcome.exit, 5);
  EXPECT_EQ(replaced(outcome.err, maps, ""),
            "error: world (wend.arena): create: parameter error: map/0: broken_rows.map: line 7: expected nothing "
            "after row 1, found \"...\"\n");
  EXPECT_EQ(outcome.out, "");
}

TEST(BrokenMap, IsNotThere) {
  const TemporaryDirectory place;
  const std::string experiment = place.write("experiment.json", experiment_on({{"scene", {"nowhere.json"}}}).dump(1));
  for (const Outcome& outcome : {run_wend({"validate", experiment}), run(run_command(experiment, place / "run"))}) {
    EXPECT_EQ(outcome.exit, 3);
    EXPECT_NE(outcome.err.find("error: there is no file \"nowhere.json\"\n  --> " + experiment + ":"),
              std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find("looked for " + place.path() + "/nowhere.json\n"), std::string::npos) << outcome.err;
  }
}
