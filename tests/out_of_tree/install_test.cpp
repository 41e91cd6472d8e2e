// What `cmake --install` brings, and that it works where it was put.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "installed.hpp"

using namespace wend::test;
namespace fs = std::filesystem;

namespace {

std::set<std::string> names(const std::string& folder, const std::string& extension = "") {
  std::set<std::string> all;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none))
    if (extension.empty() || entry.path().extension() == extension) all.insert(entry.path().filename());
  return all;
}

}  // namespace

TEST(Install, BringsEverything) {
  const Installed wend;
  EXPECT_EQ(names(wend / "bin"), (std::set<std::string>{"wend", "wend-render", "wend-worker"}));
  EXPECT_EQ(names(wend / "lib/wend/plugins"), names(WEND_BINARY_DIR "/lib/wend/plugins", ".so"));
  EXPECT_EQ(names(wend / "include/wend"), names(WEND_SOURCE_DIR "/sdk/include/wend"));
  EXPECT_EQ(names(wend / "share/wend/template"), names(WEND_SOURCE_DIR "/sdk/template"));
  for (const char* language : {"c", "cpp", "rust"})
    EXPECT_EQ(names(wend / ("share/wend/examples/" + std::string(language))),
              names(WEND_SOURCE_DIR "/sdk/examples/" + std::string(language)));
  EXPECT_EQ(names(wend / "share/wend/experiments"), names(WEND_SOURCE_DIR "/experiments"));
  EXPECT_EQ(names(wend / "share/wend/worlds/arena/scenes/data"), names(WEND_SOURCE_DIR "/worlds/arena/scenes/data"));
  for (const char* file :
       {"wend-config.cmake", "wend-config-version.cmake", "WendPlugin.cmake", "check_manifest.cmake"})
    EXPECT_TRUE(fs::exists(wend / ("lib/cmake/wend/" + std::string(file)))) << file;
  EXPECT_TRUE(fs::exists(wend / "lib/pkgconfig/wend.pc"));
  EXPECT_FALSE(names(wend / "share/wend/experiments").empty());
  EXPECT_FALSE(names(wend / "share/wend/worlds/arena/scenes/data").empty());
}

TEST(Install, RunsWhereItWasPut) {
  const Installed wend;
  const Outcome listed = run({wend.program(), "plugins", "list", "--json"});
  ASSERT_EQ(listed.exit, 0) << listed.err;
  for (const Json& component : Json::parse(listed.out)["components"])
    EXPECT_EQ(component["file"].get<std::string>().rfind(wend / "lib/wend/plugins/", 0), 0u) << component["file"];
  EXPECT_EQ(run({wend.program(), "validate", wend / "share/wend/experiments/demo.json"}).exit, 0);
  const std::string file = wend.place().write("small.json", small_experiment(1).dump());
  const Outcome ran = run({wend.program(), "run", file, "--out", wend.place() / "run"});
  ASSERT_EQ(ran.exit, 0) << ran.err;
  ASSERT_EQ(run(run_command(file, wend.place() / "tree")).exit, 0);
  EXPECT_EQ(fingerprint(wend.place() / "run"), fingerprint(wend.place() / "tree")) << "the build tree's differs";

  // Through a link from elsewhere it still finds its worker and its plugins.
  fs::create_symlink(wend.program(), wend.place() / "link");
  EXPECT_EQ(run({wend.place() / "link", "validate", file}).exit, 0);
}

TEST(Install, PkgConfig) {
  if (find_program({"pkg-config"}).empty()) GTEST_SKIP() << "pkg-config is missing";
  const Installed wend;
  Setting setting;
  setting.environment["PKG_CONFIG_PATH"] = wend / "lib/pkgconfig";
  const auto ask = [&](const std::string& what) {
    const Outcome outcome = run({"pkg-config", what, "wend"}, setting);
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    return outcome.out.substr(0, outcome.out.find_last_not_of(" \n") + 1);
  };
  EXPECT_EQ(ask("--modversion"), WEND_VERSION);
  const std::string flags = ask("--cflags");
  ASSERT_EQ(flags.rfind("-I", 0), 0u) << flags;
  EXPECT_EQ(fs::canonical(flags.substr(2)), fs::canonical(wend / "include"));
  EXPECT_EQ(fs::canonical(ask("--variable=plugindir")), fs::canonical(wend / "lib/wend/plugins"));

  // The plugin guide's way without CMake.
  const std::string folder = wend / "share/wend/examples/cpp";
  const std::string section = wend.place().write(
      "section.cpp",
      "asm(\".section .wend.manifest,\\\"a\\\",@progbits\\n.incbin \\\"manifest.json\\\"\\n.previous\\n\");\n");
  Setting there;
  there.directory = folder;
  fs::create_directories(wend.place() / "hand");
  EXPECT_EQ(run({"c++", "-std=c++20", "-fPIC", "-fvisibility=hidden", "-ffp-contract=off", flags, "-shared",
                 "turn_to_goal.cpp", section, "-o", wend.place() / "hand/by_hand.so"},
                there)
                .exit,
            0);
  Json experiment = small_experiment(1);
  experiment["arms"] = {{{"id", "hand"}, {"robot", "simrobot"}, {"policy", "example.turn_to_goal_cpp"}}};
  const std::string file = wend.place().write("hand.json", experiment.dump());
  EXPECT_EQ(run({wend.program(), "run", file, "--out", wend.place() / "hand_run", "--no-pictures", "--plugin-path",
                 wend.place() / "hand"})
                .exit,
            0);
}
