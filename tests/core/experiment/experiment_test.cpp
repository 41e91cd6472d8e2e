#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tests/core/experiment/fixture.hpp>

namespace wend::core {
namespace {

using ExperimentFile = ExperimentFolder;

std::vector<std::string> ids(const Experiment& experiment) {
  std::vector<std::string> all;
  for (const Cell& cell : experiment.cells()) all.push_back(cell.id);
  return all;
}

std::set<std::string> id_set(const Experiment& experiment) {
  const auto all = ids(experiment);
  return {all.begin(), all.end()};
}

std::map<std::string, Training> trainings_by_id(const Experiment& experiment) {
  std::map<std::string, Training> all;
  for (const Training& training : experiment.trainings()) all[training.id] = training;
  return all;
}

TEST_F(ExperimentFile, BecomesCellsInTheOrderOfArmsWorldsSeedsVariantsAndSnapshots) {
  const auto experiment = load(small_experiment());
  ASSERT_TRUE(experiment);
  std::vector<std::string> rows;
  for (const Cell& cell : experiment->cells())
    rows.push_back(cell.driver.arm + " " + cell.world.id + " " + std::to_string(cell.stream.seed) + "." +
                   std::to_string(cell.variant) + (cell.at ? " at " + std::to_string(cell.at->amount) : "") + " x" +
                   std::to_string(cell.episodes) + " t" + std::to_string(cell.traced_episodes));
  ASSERT_EQ(rows.size(), 3u * (2 + 1) + 3u * (2 + 1) * 3);
  EXPECT_EQ(rows[0], "plain open 0.0 x5 t1");
  EXPECT_EQ(rows[1], "plain open 0.1 x5 t1");
  EXPECT_EQ(rows[2], "plain open 1.0 x5 t0");
  EXPECT_EQ(rows[6], "plain tight 0.0 x5 t1");
  EXPECT_EQ(rows[9], "learns open 0.0 at 0 x3 t1");
  EXPECT_EQ(rows[10], "learns open 0.0 at 500 x3 t1");
  EXPECT_EQ(rows[11], "learns open 0.0 x5 t1");
  EXPECT_EQ(rows[12], "learns open 0.1 at 0 x3 t1");
  EXPECT_EQ(rows.back(), "learns tight 2.0 x5 t0");
  EXPECT_EQ(id_set(*experiment).size(), rows.size());
  EXPECT_EQ(experiment->arm_ids, (std::vector<std::string>{"plain", "learns"}));
  EXPECT_EQ(experiment->world_ids, (std::vector<std::string>{"open", "tight"}));
  for (const Cell& cell : experiment->cells()) EXPECT_EQ(identify(cell), cell.id);
  EXPECT_EQ(experiment->plan.compositions().size(), 4u);
}

TEST_F(ExperimentFile, TrainsOncePerTestedWorldAndSeed) {
  const auto experiment = load(small_experiment());
  ASSERT_TRUE(experiment);
  const auto trainings = trainings_by_id(*experiment);
  EXPECT_EQ(trainings.size(), 6u);
  for (const auto& [id, training] : trainings) {
    EXPECT_EQ(identify(training), id);
    ASSERT_EQ(training.streams.size(), 1u);
    EXPECT_TRUE(training.streams[0].train);
    EXPECT_EQ(training.streams[0].root, 7u);
    EXPECT_EQ(training.snapshots, (std::vector<std::uint64_t>{0, 500}));
  }
  for (const Cell& cell : experiment->cells()) {
    EXPECT_FALSE(cell.stream.train);
    if (cell.driver.arm == "plain") {
      EXPECT_EQ(cell.training, "");
      continue;
    }
    const Training& training = trainings.at(cell.training);
    EXPECT_EQ(training.worlds.at(0).id, cell.world.id);
    EXPECT_EQ(training.streams[0].seed, cell.stream.seed);
  }
}

TEST_F(ExperimentFile, SharesATrainingThatNamesItsWorlds) {
  Json json = small_experiment();
  json["arms"][1]["train"]["worlds"] = {"open:train", "tight"};
  const auto experiment = load(json);
  ASSERT_TRUE(experiment);
  EXPECT_EQ(experiment->trainings().size(), 3u);
  const Training training = experiment->trainings()[1];
  EXPECT_EQ(training.worlds.at(1).id, "tight");
  EXPECT_TRUE(training.streams.at(0).train);
  EXPECT_FALSE(training.streams.at(1).train);
  EXPECT_EQ(training.streams.at(1).seed, 1u);
}

TEST_F(ExperimentFile, TestsTheFinalBudgetOnce) {
  Json json = small_experiment();
  json["arms"][1]["train"]["evaluate"]["at"] = {1000, 0, 1000};
  const auto last = load(json);
  ASSERT_TRUE(last);
  EXPECT_EQ(last->cells().size(), 9u + 9u * 2);
  const Cell cell = last->cells()[10];
  EXPECT_EQ(cell.at->amount, 1000u);
  EXPECT_EQ(cell.episodes, 5u);

  json["arms"][1]["train"]["keep"] = "best";  // the best need not be the last
  const auto best = load(json);
  ASSERT_TRUE(best);
  EXPECT_EQ(best->cells().size(), 9u + 9u * 3);
  const Training training = best->trainings()[0];
  EXPECT_EQ(training.snapshots, (std::vector<std::uint64_t>{0, 1000}));
  EXPECT_EQ(training.selection_episodes, 3u);
  EXPECT_EQ(training.selection_worlds.at(0).id, "open");
  EXPECT_TRUE(training.selection_streams.at(0).train);
}

TEST_F(ExperimentFile, IdsDoNotDependOnNameOrderOrNeighbours) {
  const auto whole = load(small_experiment());
  ASSERT_TRUE(whole);
  Json json = small_experiment();
  json["name"] = "renamed";
  json["description"] = "another";
  json["figures"] = {{"title", "T"}};
  std::swap(json["arms"][0], json["arms"][1]);
  std::swap(json["worlds"][0], json["worlds"][1]);
  const auto swapped = load(json);
  ASSERT_TRUE(swapped);
  EXPECT_EQ(id_set(*swapped), id_set(*whole));
  EXPECT_EQ(swapped->figures.at("title"), "T");

  json = small_experiment();
  json["arms"].erase(0);
  json["seeds"] = 2;
  const auto part = load(json);
  ASSERT_TRUE(part);
  const auto all = id_set(*whole);
  for (const std::string& id : ids(*part)) EXPECT_TRUE(all.contains(id));
  EXPECT_EQ(ids(*part).size(), 18u);
}

TEST_F(ExperimentFile, DefaultsWrittenOutAreTheSameExperiment) {
  const auto experiment = load(small_experiment());
  ASSERT_TRUE(experiment);
  const auto again = load(experiment->resolved);
  ASSERT_TRUE(again) << complaints_;
  EXPECT_EQ(ids(*again), ids(*experiment));
  EXPECT_EQ(again->resolved, experiment->resolved);
  EXPECT_EQ(experiment->resolved["robots"]["disc"]["stop_distance"], 0.0);
  EXPECT_EQ(experiment->resolved["arms"][1]["policy"]["slots"]["avoid"]["params"]["gamma"], 0.9);
}

TEST_F(ExperimentFile, IdsAreWhatTheyWere) {  // a change here orphans every run directory
  const auto experiment = load(small_experiment());
  ASSERT_TRUE(experiment);
  EXPECT_EQ(experiment->cells().id(0), "595e16b24e6db68961a543e02791a624d0feefd906f31eec6f6ead81b96e655a");
  EXPECT_EQ(experiment->trainings().id(0), "e9610dcfcf19172d2f16e13b705944e41df10e5e9a9500a7fac99c2e6aa40e98");
}

TEST_F(ExperimentFile, SweepsOverAllCombinationsInTheOrderOfTheFile) {
  std::string text = small_experiment().dump();
  text.pop_back();
  text += R"(, "sweep": {"/seed": [1, 2], "/arms/1/policy/slots/avoid/params/gamma": [0.5, 0.8, 0.9]}})";
  const auto experiment = load(text);
  ASSERT_TRUE(experiment) << complaints_;
  ASSERT_EQ(experiment->points.size(), 6u);
  EXPECT_EQ(experiment->points[1], Json::parse(R"({"/seed": 1, "/arms/1/policy/slots/avoid/params/gamma": 0.8})"));
  EXPECT_EQ(experiment->points[3], Json::parse(R"({"/seed": 2, "/arms/1/policy/slots/avoid/params/gamma": 0.5})"));
  EXPECT_EQ(experiment->cells().size(), 6u * 36);
  EXPECT_EQ(experiment->trainings().size(), 6u * 6);
  const Cell cell = experiment->cells()[36 * 4 + 35];
  EXPECT_EQ(cell.point, experiment->points[4]);
  EXPECT_EQ(cell.stream.root, 2u);
  EXPECT_EQ(cell.driver.policy.slots.at("avoid").params["gamma"], 0.8);
  EXPECT_EQ(trainings_by_id(*experiment).at(cell.training).driver.policy.slots.at("avoid").params["gamma"], 0.8);
  EXPECT_EQ(id_set(*experiment).size(), 6u * 36);
}

TEST_F(ExperimentFile, SweepsOverWhatHasNoDefault) {
  Json json = small_experiment();
  json["sweep"] = {{"/arms/0/policy", {"test.direct", "test.oracle"}}, {"/arms/1/train/steps", Json::array({5})}};
  json["arms"][1]["train"] = Json{{"worlds", {"open:train"}}, {"samples", 10}};
  EXPECT_FALSE(load(json));  // two budgets at each point
  EXPECT_NE(complaints_.find("several budgets"), std::string::npos);
  json["sweep"].erase("/arms/1/train/steps");
  const auto experiment = load(json);
  ASSERT_TRUE(experiment) << complaints_;
  EXPECT_FALSE(experiment->cells()[0].privileged);
  EXPECT_TRUE(experiment->cells()[18].privileged);
}

TEST_F(ExperimentFile, IsChangedBySet) {
  Options options;
  options.set = {"/seed=99", "/arms/0/policy=test.oracle", "/worlds/1/params={\"size\": 3}", "/record/seeds=0"};
  const auto experiment = load(small_experiment(), options);
  ASSERT_TRUE(experiment) << complaints_;
  EXPECT_EQ(experiment->resolved["seed"], 99);
  EXPECT_EQ(experiment->cells()[0].stream.root, 99u);
  EXPECT_EQ(experiment->cells()[0].driver.policy.type, "test.oracle");
  EXPECT_EQ(experiment->cells()[8].world.params["size"], 3.0);
  EXPECT_EQ(experiment->cells()[0].traced_episodes, 0u);
}

TEST_F(ExperimentFile, BadOptionsAreExplained) {
  const auto complaint = [&](const Options& options) {
    EXPECT_FALSE(load(small_experiment(), options));
    return complaints_;
  };
  Options options;
  options.set = {"seed=5"};
  EXPECT_EQ(complaint(options), "error: --set \"seed=5\": expected /pointer=value\n   = such as --set /seed=7\n");
  options.set = {"/arms/2/id=x"};
  EXPECT_EQ(complaint(options),
            "error: --set \"/arms/2/id=x\": \"/arms\" has 2 elements, numbered from 0, found \"2\"\n");
  options.set = {"/name/x=1"};
  EXPECT_EQ(complaint(options), "error: --set \"/name/x=1\": \"/name\" is \"small\", which has nothing below it\n");
  options.set = {"/seeds=many"};
  EXPECT_EQ(complaint(options),
            "error: key \"seeds\" of the experiment: expected integer in [1, 1000000], found \"many\"\n"
            "  --> DIR/e.json:1:1  (/seeds)\n   1 |  {\n     |  ^ a number has no quotes\n"
            "   = the value comes from --set /seeds=many\n");
  options.set = {};
  options.only = {"arm=plian", "world=open,seed=1"};
  EXPECT_EQ(complaint(options),
            "error: --only: unknown arm \"plian\"\n   = did you mean \"plain\"?\n"
            "error: --only \"seed=1\": expected arm=ID or world=ID\n   = such as --only arm=a,world=b\n");
  options.only = {};
  options.seeds = {4, 4};
  EXPECT_EQ(complaint(options),
            "error: --seeds 4:4 is empty\n   = the first seed and the one behind the last: 0:10 are ten seeds\n");
}

TEST_F(ExperimentFile, OnlyAndSeedsChooseAPartWithTheSameIds) {
  const auto whole = load(small_experiment());
  ASSERT_TRUE(whole);
  Options options;
  options.only = {"arm=learns,world=open"};
  options.seeds = {1, 3};
  const auto part = load(small_experiment(), options);
  ASSERT_TRUE(part) << complaints_;
  EXPECT_EQ(part->cells().size(), 2u * 2 * 3);
  EXPECT_EQ(part->trainings().size(), 2u);
  EXPECT_EQ(part->resolved, whole->resolved);
  const auto all = id_set(*whole);
  for (const std::string& id : ids(*part)) EXPECT_TRUE(all.contains(id));
  options.seeds = {100, 102};  // another block than the file's
  const auto block = load(small_experiment(), options);
  ASSERT_TRUE(block) << complaints_;
  EXPECT_EQ(block->cells()[0].stream.seed, 100u);

  Json json = small_experiment();
  json["arms"][0]["worlds"] = {"open"};
  options.only = {"arm=plain,world=tight"};
  EXPECT_FALSE(load(json, options));
  EXPECT_EQ(complaints_,
            "error: --only leaves nothing to run: no arm that it names is tested in a world that it names\n");
}

TEST_F(ExperimentFile, ChoosesARobotForEachWorld) {
  Json json = small_experiment();
  json["worlds"].push_back({{"id", "chain"}, {"type", "test.chain"}, {"draw", "once"}, {"robots", 3}});
  json["worlds"][1]["robot"] = "big";
  json["robots"]["big"] = {{"radius", 2}};
  json["arms"][0].erase("robot");
  json["arms"][0]["robot"] = {{"open", "disc"}};
  json["arms"][1]["worlds"] = {"open"};
  const auto experiment = load(json);
  ASSERT_TRUE(experiment) << complaints_;
  const auto robot = [&](const std::string& world) {
    for (const Cell& cell : experiment->cells())
      if (cell.world.id == world) return cell.driver.robot.name;
    return std::string("no such cell");
  };
  EXPECT_EQ(robot("open"), "disc");
  EXPECT_EQ(robot("tight"), "big");
  EXPECT_EQ(robot("chain"), "");
  const Cell cell = experiment->cells()[9];
  EXPECT_EQ(cell.world.id, "chain");
  EXPECT_TRUE(cell.world.one_scene);
  EXPECT_EQ(cell.world.robots, 3u);
}

TEST_F(ExperimentFile, HandsOverAStateOfAnotherExperiment) {
  write("w.state", "weights");
  Json json = small_experiment();
  json["arms"][1]["train"] = {{"state", "w.state"}};
  const auto frozen = load(json);
  ASSERT_TRUE(frozen) << complaints_;
  EXPECT_TRUE(frozen->trainings().empty());
  const std::string hash = frozen->cells()[9].state;
  EXPECT_EQ(hash.size(), 64u);
  EXPECT_EQ(frozen->state_files.at(hash), (folder_ / "w.state").string());
  json["arms"][1]["train"]["episodes"] = 5;
  const auto goes_on = load(json);
  ASSERT_TRUE(goes_on) << complaints_;
  EXPECT_EQ(goes_on->trainings()[0].initial_state, hash);
  EXPECT_EQ(goes_on->cells()[9].state, "");
}

// "expert" goes on, seed by seed, from what "learns" has learned; "frozen" tests just that.
TEST_F(ExperimentFile, HandsOverTheStateOfAnotherArm) {
  Json json = small_experiment();
  json["arms"][1]["train"]["worlds"] = {"open:train"};
  for (const char* id : {"expert", "frozen"}) {
    json["arms"].insert(json["arms"].begin(), json["arms"].back());
    json["arms"][0]["id"] = id;
    json["arms"][0]["train"] = {{"state", {{"arm", "learns"}}}};
  }
  json["arms"][1]["train"]["episodes"] = 5;
  const auto experiment = load(json);
  ASSERT_TRUE(experiment) << complaints_;
  std::map<std::string, std::vector<Training>> trainings;
  std::vector<std::string> order;
  for (const Training& training : experiment->trainings()) {
    trainings[training.driver.arm].push_back(training);
    order.push_back(training.driver.arm);
  }
  ASSERT_EQ(trainings["learns"].size(), 3u);  // once for both arms and its own tests
  ASSERT_EQ(trainings["expert"].size(), 6u);  // trained in each world that is tested
  EXPECT_EQ(order.front(), "learns");         // what others start from comes first
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(trainings["expert"][i].initial_training, trainings["learns"][i % 3].id) << i;
  EXPECT_EQ(trainings["learns"][0].initial_training, "");
  for (const Cell& cell : experiment->cells()) {
    if (cell.driver.arm == "frozen") {
      EXPECT_EQ(cell.training, trainings["learns"][cell.stream.seed].id);
    }
  }
}

// Whatever an arm starts from, by way of others too, was neither chosen by what the arm is tested on nor is it a training
// that no test of its own arm shows.
TEST_F(ExperimentFile, RefusesAStateThatDoesNotFitTheTestedWorlds) {
  Json json = small_experiment();
  json["arms"][1]["worlds"] = {"open"};
  for (const char* id : {"more", "frozen"}) {
    json["arms"].push_back(json["arms"][1]);
    json["arms"].back()["id"] = id;
  }
  Json& source = json["arms"][1]["train"];
  json["arms"][2]["train"] = {{"worlds", {"open:train"}}, {"samples", 9}, {"state", {{"arm", "learns"}}}};
  json["arms"][3]["train"] = {{"state", {{"arm", "more"}}}};
  EXPECT_TRUE(load(json)) << complaints_;
  json["arms"][3]["worlds"] = {"tight"};
  EXPECT_FALSE(load(json));
  EXPECT_NE(complaints_.find("arm \"frozen\" starts from arm \"learns\", which is not trained for world \"tight\""), std::string::npos)
      << complaints_;
  source["worlds"] = {"open:train"};
  EXPECT_TRUE(load(json)) << complaints_;
  source["keep"] = "best";
  EXPECT_TRUE(load(json)) << complaints_;
  source["evaluate"]["worlds"] = {"tight:train"};
  EXPECT_TRUE(load(json)) << complaints_;
  source["evaluate"]["worlds"] = {"tight"};
  EXPECT_FALSE(load(json));
  EXPECT_NE(complaints_.find("arm \"frozen\" starts from arm \"learns\", whose best snapshot is chosen in world \"tight\", which is tested"),
            std::string::npos)
      << complaints_;
}

TEST_F(ExperimentFile, TracesTheTrainingsOfTheFirstSeeds) {
  Json json = small_experiment();
  json["record"] = {{"training", 7}, {"seeds", 2}};
  const auto experiment = load(json);
  ASSERT_TRUE(experiment) << complaints_;
  for (const Training& training : experiment->trainings())
    EXPECT_EQ(training.traced_episodes, training.streams[0].seed < 2 ? 7u : 0u);
}

}  // namespace
}  // namespace wend::core
