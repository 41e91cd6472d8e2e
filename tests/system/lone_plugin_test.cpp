// Each shipped plugin stands alone: moved to an empty folder and named by --plugin-path it is found and can be loaded,
// and it takes nothing from a library whose results depend on the machine.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "support/wend.hpp"

using namespace wend::test;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> shipped() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(WEND_BINARY_DIR "/lib/wend/plugins"))
    if (entry.path().extension() == ".so") names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

// A program whose own folder of plugins is empty: copies of wend and wend-worker beside an empty lib/wend/plugins.
std::string bare_program(const TemporaryDirectory& place) {
  fs::create_directories(place / "bare/bin");
  fs::create_directories(place / "bare/lib/wend/plugins");
  for (const char* name : {"wend", "wend-worker"})
    fs::copy_file(WEND_BINARY_DIR "/bin/" + std::string(name), place / ("bare/bin/" + std::string(name)));
  return place / "bare/bin/wend";
}

// What each exports and needs of others, by nm.
std::set<std::string> symbols(const std::string& file, const std::string& option) {
  std::set<std::string> names;
  std::istringstream lines(run({"nm", "-D", option, file}).out);
  for (std::string line; std::getline(lines, line);) names.insert(line.substr(line.rfind(' ') + 1));
  return names;
}

}  // namespace

TEST(LonePlugin, IsFoundAloneAndShown) {
  const TemporaryDirectory place;
  const std::string program = bare_program(place);
  EXPECT_EQ(run({program, "plugins", "list"}).out,
            "no plugins found; WEND_PLUGIN_PATH or --plugin-path says where to look\n");
  ASSERT_FALSE(shipped().empty());
  for (const std::string& name : shipped()) {
    const std::string folder = place / name;
    fs::create_directories(folder);
    fs::copy_file(plugin_path(name), folder + "/" + name + ".so");
    const Outcome outcome = run({program, "plugins", "list", "--json", "--plugin-path", folder});
    ASSERT_EQ(outcome.exit, 0) << outcome.err;
    const Json found = Json::parse(outcome.out);
    EXPECT_EQ(found["unusable"], Json::array()) << name;
    EXPECT_FALSE(found["components"].empty()) << name;
    for (const Json& component : found["components"]) {
      EXPECT_EQ(component["file"], folder + "/" + name + ".so");
      EXPECT_EQ(run({program, "plugins", "show", component["id"], "--plugin-path", folder + "/" + name + ".so"}).exit,
                0);
    }
  }
}

// Each in a folder of its own, so no plugin can lean on a neighbour; all of them are loaded, created and run.
TEST(LonePlugin, RunsAlone) {
  const TemporaryDirectory place;
  const std::string program = bare_program(place);
  std::string path;
  for (const std::string& name : shipped()) {
    fs::create_directories(place / name);
    fs::copy_file(plugin_path(name), place / (name + "/" + name + ".so"));
    path += (path.empty() ? "" : ":") + (place / name);
  }
  Json experiment = small_experiment(1);
  experiment["test"]["episodes"] = 1;
  experiment["seeds"] = 1;
  for (const char* policy : {"wend.goal_direct", "wend.dwa", "wend.potential_field_true"})
    experiment["arms"].push_back({{"id", std::string(policy).substr(5)}, {"robot", "simrobot"}, {"policy", policy}});
  experiment["arms"][3]["policy"] = {{"type", "wend.goal_direct"}};
  const std::string file = place.write("all.json", experiment.dump());
  Setting setting;
  setting.environment["WEND_PLUGIN_PATH"] = path;
  const Outcome outcome = run({program, "run", file, "--out", place / "run", "--no-pictures"}, setting);
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  const Outcome without = run({program, "validate", file});
  EXPECT_EQ(without.exit, 3);
  EXPECT_NE(without.err.find("wend.arena"), std::string::npos) << without.err;
}

TEST(LonePlugin, NeedsOnlyTheStandardLibrariesAndExactFunctions) {
  if (find_program({"nm"}).empty() || find_program({"readelf"}).empty())
    GTEST_SKIP() << "nm and readelf (binutils) are missing";
  const std::set<std::string> libraries = {"libc.so.6", "libstdc++.so.6", "libgcc_s.so.1", "libm.so.6",
                                           "ld-linux-x86-64.so.2"};
  const std::regex inexact(
      "^(a?(sin|cos|tan)h?|sincos|atan2|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|hypot|cbrt|[lt]gamma|erfc?|j[01n]"
      "|y[01n])[fl]?(@.*)?$");
  const std::regex needed("\\[([^\\]]+)\\]");
  ASSERT_TRUE(std::regex_match("pow@GLIBC_2.29", inexact));
  for (const std::string& name : shipped()) {
    for (const std::string& symbol : symbols(plugin_path(name), "--undefined-only"))
      EXPECT_FALSE(std::regex_match(symbol, inexact)) << name << " needs " << symbol;
    EXPECT_EQ(symbols(plugin_path(name), "--defined-only"), std::set<std::string>{"wend_plugin_1"}) << name;
    std::istringstream lines(run({"readelf", "-d", "-W", plugin_path(name)}).out);
    for (std::string line; std::getline(lines, line);) {
      std::smatch library;
      if (line.find("(NEEDED)") == std::string::npos || !std::regex_search(line, library, needed)) continue;
      EXPECT_TRUE(libraries.count(library[1])) << name << " needs " << library[1];
    }
  }
}
