#include <gtest/gtest.h>

#include <core/base/sha256.hpp>
#include <tests/core/experiment/fixture.hpp>

namespace wend::core {
namespace {

using AssetsOfAnExperiment = ExperimentFolder;

Json with_maps(const std::string& pattern) {
  Json json = small_experiment();
  json["worlds"][0]["params"] = {{"map", pattern}};
  json["worlds"][0]["variants"] = 2;
  return json;
}

TEST_F(AssetsOfAnExperiment, AreFoundInOrderAndMultiplyTheVariants) {
  for (const char* name : {"b", "a", "c"}) write(std::string("maps/") + name + ".map", name);
  write("maps/ignored.txt", "");
  Options options;
  options.variables = {{"DATA", "maps"}};
  const auto experiment = load(with_maps("${DATA}/*.map"), options);
  ASSERT_TRUE(experiment) << complaints_;
  const WorldSpec world = experiment->cells()[0].world;
  const std::string maps = (folder_ / "maps").string();
  EXPECT_EQ(world.params["map"], Json({maps + "/a.map", maps + "/b.map", maps + "/c.map"}));
  EXPECT_EQ(world.files, 3u);
  EXPECT_EQ(world.variants, 6u);
  EXPECT_EQ(world.content[maps + "/b.map"], sha256("b"));
  EXPECT_EQ(experiment->resolved["worlds"][0]["variants"], 2);
}

TEST_F(AssetsOfAnExperiment, CountByTheirContent) {
  for (const char* name : {"one/a.map", "two/a.map"}) write(name, "same");
  const auto one = load(with_maps("one/*.map"));
  const auto two = load(with_maps((folder_ / "two/a.map").string()));
  ASSERT_TRUE(one && two) << complaints_;
  EXPECT_EQ(one->cells().id(0), two->cells().id(0));
  EXPECT_EQ(one->trainings().id(0), two->trainings().id(0));
  write("two/a.map", "changed");
  const auto changed = load(with_maps("two/a.map"));
  ASSERT_TRUE(changed);
  EXPECT_NE(changed->cells().id(0), one->cells().id(0));
  EXPECT_NE(changed->trainings().id(0), one->trainings().id(0));
}

TEST_F(AssetsOfAnExperiment, OfAComponentCountToo) {
  Json json = small_experiment();
  json["arms"][0]["policy"] = {{"type", "test.direct"}, {"params", {{"table", "t[1].json"}}}};
  write("t[1].json", "x");
  const auto before = load(json);
  ASSERT_TRUE(before) << complaints_;
  EXPECT_EQ(before->cells()[0].driver.policy.params["table"], (folder_ / "t[1].json").string());
  EXPECT_EQ(Json(before->cells()[0])["driver"]["policy"]["content"].begin().value(), sha256("x"));
  write("t[1].json", "y");
  const auto after = load(json);
  ASSERT_TRUE(after);
  EXPECT_NE(after->cells().id(0), before->cells().id(0));
  EXPECT_EQ(after->cells().id(9), before->cells().id(9));  // the arm without a table
}

TEST_F(AssetsOfAnExperiment, AreFoundAgainInTheResolvedFile) {
  write("maps/a[1].map", "a");
  write("maps/b.map", "b");
  const auto experiment = load(with_maps("maps/*"));
  ASSERT_TRUE(experiment) << complaints_;
  Diagnostics diagnostics;
  const auto again = load_experiment(write("elsewhere/r.json", experiment->resolved.dump()), catalog_, {}, diagnostics);
  ASSERT_TRUE(again) << diagnostics.text();
  EXPECT_EQ(again->cells().id(0), experiment->cells().id(0));
}

}  // namespace
}  // namespace wend::core
