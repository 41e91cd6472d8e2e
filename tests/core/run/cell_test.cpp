#include <core/record/trace.hpp>

#include "fixture.hpp"

namespace wend::core {
namespace {

class CellTest : public RunTest {
 protected:
  static Json without_time(const CellResult& result) {
    Json json = result;
    json.erase("decision_us");
    return json;
  }
};

// Every robot's own end: x is the sum of its script, and what it brought is what the world paid.
TEST_F(CellTest, TellsWhatEachRobotBroughtHome) {
  const Cell cell = cell_of(counter({{"ends", {4, 1, 3}}, {"pays", {0, 0.5, 2}}, {"arrive", 1}}, 2),
                            script({{"script", {2, 1, 0}}}), 3);
  for (const std::uint32_t batch : {1, 2, 3, 64}) {
    const CellResult result = run(cell, batch);
    EXPECT_EQ(result.metrics, (std::vector<std::string>{"last_x", "step"}));
    ASSERT_EQ(result.episodes.size(), 3u);
    const double ends[] = {4, 1, 3}, x_at[] = {0, 2, 3, 3, 5}, paid_at[] = {0, 2, 2.5, 2.5, 4.5};
    for (std::uint64_t index = 0; index < 3; ++index) {
      const Episode& episode = result.episodes[index];
      EXPECT_EQ(episode.index, index);
      ASSERT_EQ(episode.robots.size(), 2u);
      for (std::uint32_t robot = 0; robot < 2; ++robot) {
        const RobotEpisode& one = episode.robots[robot];
        const auto end = static_cast<std::size_t>(ends[(index + robot) % 3]);
        EXPECT_EQ(one.robot, robot);
        EXPECT_EQ(one.steps, end);
        EXPECT_EQ(one.reward, paid_at[end]);
        EXPECT_EQ(one.metrics, (std::vector<double>{x_at[end], static_cast<double>(end)}));
        EXPECT_EQ(one.flags, std::uint32_t{WEND_TERMINATED});  // no last action is 1
      }
    }
  }
}

TEST_F(CellTest, KeepsTheSeriesThatPluginsTell) {
  const CellResult result = run(cell_of(counter(), table(), 5), 2);
  ASSERT_EQ(result.curves.size(), 1u);
  EXPECT_EQ(result.curves[0].metric, "plan");
  EXPECT_EQ(result.curves[0].x, "round");
  EXPECT_EQ(result.curves[0].points, (std::vector<std::pair<double, double>>{{0, 0}, {1, 2}}));  // the mean of 0 to 4
}

TEST_F(CellTest, TheBatchChangesNothing) {
  Cell cell = cell_of(counter({{"ends", {3, 17, 2, 9, 5, 1}}}, 3), script({{"random", true}}), 70);
  cell.driver.robot.sensors = {{"eye", eye({{"noise", 0.5}})}, {"other", eye({{"noise", 2}})}};
  cell.driver.reward = pay();
  const Json one = without_time(run(cell, 1));
  EXPECT_EQ(one.at("episodes").size(), 70u);
  EXPECT_EQ(one, without_time(run(cell, 2)));
  EXPECT_EQ(one, without_time(run(cell, 7)));
  EXPECT_EQ(one, without_time(run(cell, 64)));
  EXPECT_EQ(one, without_time(run(cell, 1000)));
  EXPECT_EQ(one, without_time(run(cell, 0)));
  cell.stream.root = 8;
  EXPECT_NE(one, without_time(run(cell, 1)));
}

TEST_F(CellTest, TheLastBitOfOneActionChangesTheHash) {
  const auto hash = [&](int flip_at) {
    return run(cell_of(counter({{"actions", 0}, {"ends", {600}}}), script({{"flip_at", flip_at}}))).episodes.at(0).hash;
  };
  const std::string untouched = hash(-1);
  EXPECT_EQ(untouched.size(), 32u);
  EXPECT_EQ(hash(-1), untouched);
  EXPECT_EQ(hash(600), untouched);  // a step that is never taken
  EXPECT_NE(hash(500), untouched);
  EXPECT_NE(hash(599), untouched);
  EXPECT_NE(hash(500), hash(501));
}

TEST_F(CellTest, EveryEpisodeHasItsOwnChance) {
  Cell cell = cell_of(counter({{"ends", {40}}}, 2), script({{"random", true}}), 2);
  const CellResult result = run(cell);
  EXPECT_NE(result.episodes[0].hash, result.episodes[1].hash);
  EXPECT_NE(result.episodes[0].robots[0].metrics, result.episodes[0].robots[1].metrics);
  cell.driver.arm = "another";  // meets the same episodes
  EXPECT_EQ(without_time(run(cell)), without_time(result));
}

TEST_F(CellTest, WritesTheTracesThatAreAskedFor) {
  Cell cell = cell_of(counter({{"ends", {4, 2, 3}}}, 2), script(), 5);
  cell.traced_episodes = 2;
  for (const std::uint32_t batch : {1, 4}) {
    const CellResult result = run(cell, batch);
    EXPECT_EQ(result.traces, (std::map<std::uint64_t, std::string>{{0, std::string(24, 'c') + "-0.npz"},
                                                                   {1, std::string(24, 'c') + "-1.npz"}}));
    const Trace trace = read_trace(folder_ + "/" + result.traces.at(0));
    EXPECT_EQ(trace.time, (std::vector<double>{0, 0.5, 1, 1.5, 2}));
    EXPECT_EQ(trace.robots, 2u);
    EXPECT_EQ(trace.action, (std::vector<double>{1, 1, 1, 1, 1, 0, 1, 0}));  // robot 1 ended after two steps
    EXPECT_EQ(trace.reward, (std::vector<double>{1, 1, 1, 1, 1, 0, 1, 0}));
    EXPECT_EQ(trace.telemetry, (std::vector<double>{1, 1, 2, 2, 3, 0, 4, 0}));
    constexpr std::uint32_t done = WEND_TERMINATED | WEND_ARRIVED;
    EXPECT_EQ(std::vector<std::uint32_t>(trace.flags.begin(), trace.flags.end()),
              (std::vector<std::uint32_t>{0, 0, 0, done, 0, done, done, done}));
  }
}

TEST_F(CellTest, ChecksWithoutDriving) {
  EXPECT_EQ(failure([&] {
              check_cell(cell_of(counter({{"log", true}}, 2), script({{"fail_at", 0}})), options());
            }),
            "nothing");
  EXPECT_EQ(told_, (std::vector<std::string>{"world: reset 0 #0 test"}));
  EXPECT_EQ(
      failure([&] {
        check_cell(cell_of(counter(), script({{"message", "at create"}})), options());
      }),
      "plugin: policy (test.script): create: parameter error: message: expected another one, found \"at create\"");
}

}  // namespace
}  // namespace wend::core
