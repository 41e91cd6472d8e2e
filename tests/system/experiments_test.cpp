// Every experiment that ships can be run: its file is valid, and all that it names can be created.  And a state that one
// experiment saved is what another one starts from.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "support/wend.hpp"

using namespace wend::test;

namespace {

std::string data() {
  const char* named = std::getenv("WEND_DATA");
  return named ? named : WEND_SOURCE_DIR "/../shared/data";
}

}  // namespace

TEST(Experiments, AreValid) {
  std::size_t seen = 0;
  std::vector<std::string> unseen;
  for (const auto& entry : std::filesystem::directory_iterator(WEND_SOURCE_DIR "/experiments")) {
    const std::string path = entry.path().string();
    if (!path.ends_with(".json")) continue;
    if (read_text(path).find("${WEND_DATA}") != std::string::npos && !std::filesystem::exists(data())) {
      unseen.push_back(entry.path().filename().string());
      continue;
    }
    const Outcome outcome = run_wend({"validate", path}, {{{"WEND_DATA", data()}}, "", std::chrono::seconds(120)});
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    ++seen;
  }
  EXPECT_GE(seen, 8u);
  for (const std::string& name : unseen) std::cout << name << " needs the maps of WEND_DATA\n";
}

TEST(Experiments, AStateOfOneIsTheStartOfAnother) {
  const TemporaryDirectory place;
  Json json = small_experiment(1);
  const std::size_t arm = [&] {
    for (std::size_t i = 0; i < json["arms"].size(); ++i)
      if (json["arms"][i].contains("train")) return i;
    return json["arms"].size();
  }();
  ASSERT_LT(arm, json["arms"].size());
  const std::string id = json["arms"][arm]["id"];
  json["arms"][arm]["train"].erase("evaluate");
  json["seeds"] = 1;
  const std::string file = place.write("small.json", json.dump());
  const auto only = [&](const std::string& directory, std::vector<std::string> more) {
    more.insert(more.end(), {"--only", "arm=" + id});
    return run(run_command(file, directory, more));
  };
  ASSERT_EQ(only(place / "first", {}).exit, 0);
  std::string state;
  for (const auto& entry : std::filesystem::directory_iterator(place / "first/states"))
    if (entry.path().string().ends_with("-final.state")) state = entry.path().string();
  ASSERT_NE(state, "");
  const std::string train = "/arms/" + std::to_string(arm) + "/train=";
  const Outcome outcome = only(place / "second", {"--set", train + Json{{"state", state}}.dump()});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_EQ(episode_hashes(place / "first").at(id), episode_hashes(place / "second").at(id));

  place.write("broken.state", "this is no state");
  const Outcome refused = only(place / "third", {"--set", train + Json{{"state", place / "broken.state"}}.dump()});
  EXPECT_EQ(refused.exit, 1);
  EXPECT_NE(refused.err.find("broken.state"), std::string::npos) << refused.err;
}

TEST(Experiments, RunInTheirOwnFolder) {
  const TemporaryDirectory place;
  Json json = small_experiment(1);
  json["arms"] = Json::array({json["arms"][0]});
  place.write("small.json", json.dump());
  place.write("here/state", "");
  const Outcome outcome = run_wend({"validate", "small.json"}, {{}, place / "", std::chrono::seconds(60)});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  json["arms"][0]["train"] = {{"state", "here/none"}};
  place.write("small.json", json.dump());
  const Outcome missing = run_wend({"validate", "small.json"}, {{}, place / "", std::chrono::seconds(60)});
  EXPECT_EQ(missing.exit, 3);
  EXPECT_NE(missing.err.find("there is no file \"here/none\""), std::string::npos) << missing.err;
}

TEST(Explain, SaysWhatAPolicyHasToSay) {
  const TemporaryDirectory place;
  Json json = small_experiment(1);
  for (Json& arm : json["arms"])
    if (arm.contains("train")) arm["train"].erase("evaluate");
  const std::string file = place.write("small.json", json.dump()), directory = place / "run";
  ASSERT_EQ(run(run_command(file, directory)).exit, 0);
  std::string learner;
  for (const Json& arm : json["arms"])
    if (arm.contains("train")) learner = arm["id"];
  const auto ask = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"explain", directory});
    return run_wend(more);
  };
  const Outcome start = ask({"--arm", learner}), later = ask({"--arm", learner, "--decisions", "5"});
  EXPECT_EQ(start.exit, 0) << start.err;
  EXPECT_EQ(start.out.rfind("# policy (wend.rolling_window)\n", 0), 0u) << start.out;
  EXPECT_EQ(later.exit, 0) << later.err;
  EXPECT_NE(later.out, start.out);
  EXPECT_EQ(later.out, ask({"--arm", learner, "--decisions", "5"}).out);
  const Json told = Json::parse(ask({"--arm", learner, "--decisions", "5", "--json"}).out);
  EXPECT_EQ(told["decisions"], 5);
  EXPECT_EQ(told["components"].back()["path"], "policy");

  EXPECT_EQ(ask({"--arm", learner.substr(1)}).err.rfind("error: the experiment has no arm ", 0), 0u);
  EXPECT_EQ(ask({"--arm", learner, "--seed", "99"}).exit, 2);
  EXPECT_EQ(ask({"--arm", learner, "--robot", "3"}).err, "error: --robot: expected less than the world's 1, found 3\n");
  for (const auto& entry : std::filesystem::directory_iterator(directory + "/states")) std::ofstream(entry.path()) << "damaged";
  EXPECT_EQ(ask({"--arm", learner}).exit, 5);
  std::filesystem::remove_all(directory + "/states");
  const Outcome gone = ask({"--arm", learner});
  EXPECT_EQ(gone.exit, 5);
  EXPECT_NE(gone.err.find("expected the state file "), std::string::npos) << gone.err;

  const std::string later_seed = place / "later";
  json["seeds"] = 3;
  place.write("small.json", json.dump());
  ASSERT_EQ(run(run_command(file, later_seed, {"--seeds", "2:3", "--only", "arm=" + learner})).exit, 0);
  const Outcome first = run_wend({"explain", later_seed, "--arm", learner});
  EXPECT_EQ(first.exit, 0) << first.err;
  EXPECT_EQ(first.out, run_wend({"explain", later_seed, "--arm", learner, "--seed", "2"}).out);
  EXPECT_EQ(run_wend({"explain", later_seed, "--arm", learner, "--seed", "0"}).err,
            "error: " + later_seed + " has no finished training for arm \"" + learner + "\" with seed 0; run it first\n");
}
