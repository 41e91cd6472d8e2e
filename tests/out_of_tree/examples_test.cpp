// The same small policy in C, C++ with g++ and with clang and libc++, and Rust, and a plugin from the template: all
// built out of tree against an installed wend, and run in one experiment.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "installed.hpp"

using namespace wend::test;

namespace {

long lines(const std::string& file) {
  const std::string text = read_text(file);
  return std::count(text.begin(), text.end(), '\n');
}

}  // namespace

TEST(Examples, AreShort) {
  const std::string examples = WEND_SOURCE_DIR "/sdk/examples/";
  EXPECT_GT(lines(examples + "c/turn_to_goal.c"), 10);
  EXPECT_LE(lines(examples + "c/turn_to_goal.c"), 60);
  EXPECT_GT(lines(examples + "cpp/turn_to_goal.cpp"), 10);
  EXPECT_LE(lines(examples + "cpp/turn_to_goal.cpp"), 30);
}

TEST(Examples, OneExperimentOfManyToolchains) {
  const Installed wend;
  const std::string examples = wend / "share/wend/examples/";
  std::vector<std::string> paths, same = {"turn_to_goal_c", "turn_to_goal_cpp"};
  paths.push_back(wend.build(examples + "c"));
  paths.push_back(wend.build(examples + "cpp"));
  if (const auto path = wend.build_with_libcxx(wend.renamed("cpp", "turn_to_goal_cpp", "turn_to_goal_libcxx"))) {
    paths.push_back(*path);
    same.push_back("turn_to_goal_libcxx");
  } else {
    std::cout << "clang++ with libc++ is missing: left out\n";
  }
  if (const auto path = wend.build_rust(examples + "rust")) {
    paths.push_back(*path);
    same.push_back("turn_to_goal_rust");
  } else {
    std::cout << "rustc is missing: left out\n";
  }
  const Outcome made = run({wend.program(), "new", "plugin", "wall_follower", "--dir", wend.place() / "wall_follower"});
  ASSERT_EQ(made.exit, 0) << made.err;
  paths.push_back(wend.build(wend.place() / "wall_follower"));

  Json experiment = small_experiment(3);
  experiment["arms"] = {{{"id", "wall_follower"}, {"robot", "simrobot"}, {"policy", "my.wall_follower"}}};
  for (const std::string& id : same)
    experiment["arms"].push_back({{"id", id}, {"robot", "simrobot"}, {"policy", "example." + id}});
  const std::string file = wend.place().write("languages.json", experiment.dump()), out = wend.place() / "run";
  std::vector<std::string> command = {wend.program(), "run", file, "--out", out, "--no-pictures"};
  for (const std::string& path : paths) command.insert(command.end(), {"--plugin-path", path});
  const Outcome ran = run(command);
  ASSERT_EQ(ran.exit, 0) << ran.err;

  const auto hashes = episode_hashes(out);
  ASSERT_EQ(hashes.size(), same.size() + 1);
  EXPECT_EQ(hashes.at(same.front()).size(), 3u * 2 * 3);  // variants, seeds, episodes
  for (const std::string& id : same) EXPECT_EQ(hashes.at(id), hashes.at(same.front())) << id;
  EXPECT_NE(hashes.at("wall_follower"), hashes.at(same.front()));

  // The experiment that came with the template, too.
  const Outcome tried = run({wend.program(), "run", wend.place() / "wall_follower/try.json", "--out",
                             wend.place() / "try", "--plugin-path", wend.place() / "wall_follower/build"});
  EXPECT_EQ(tried.exit, 0) << tried.err;
  if (same.size() < 4) GTEST_SKIP() << "a toolchain is missing (clang++ with libc++, or rustc); the others agree";
}

TEST(Examples, ManifestIsCheckedAfterLinking) {
  const Installed wend;
  const std::string folder = wend.renamed("cpp", "turn_to_goal_cpp", "turn_to_goal_none");
  wend.place().write("renamed_turn_to_goal_none/manifest.json", "{\"wend\": 1}\n");
  const Outcome outcome =
      run({WEND_CMAKE, "-S", folder, "-B", folder + "/build", "-DCMAKE_PREFIX_PATH=" + (wend / "")});
  EXPECT_NE(outcome.exit, 0);
  EXPECT_NE(outcome.err.find("manifest.json"), std::string::npos) << outcome.err;
}
