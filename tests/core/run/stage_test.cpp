#include <core/run/stage.hpp>

#include "fixture.hpp"

namespace wend::core {
namespace {

using StageTest = RunTest;

TEST_F(StageTest, NamesTheColumnsByTheirSensor) {
  Cell cell = cell_of(counter(), script());
  const auto names = [&] {
    const Stage stage(cell.world, cell.driver, cell.stream, {&libraries_, &listener_, 4});
    EXPECT_EQ(stage.rows(), 4 * cell.world.robots);
    EXPECT_EQ(stage.period(), 0.5);
    std::vector<std::string> all;
    for (std::uint32_t i = 0; i < stage.observation().width; ++i) all.emplace_back(stage.observation().columns[i].name);
    return all;
  };
  EXPECT_EQ(names(), (std::vector<std::string>{"world.x", "world.t"}));
  cell.world.robots = 3;
  cell.driver.robot.sensors = {{"b", eye()}, {"a", eye()}};
  EXPECT_EQ(names(), (std::vector<std::string>{"b.x", "b.t", "a.x", "a.t"}));
}

TEST_F(StageTest, RefusesWhatIsNotInItsColumn) {
  const auto broken = [&](const char* how) {
    return failure([&] { run(cell_of(counter({{"break", how}}), script())); });
  };
  EXPECT_EQ(broken("none"), "nothing");
  EXPECT_EQ(broken("observation"),
            "rule: world (test.counter): sense: expected a number from 0 for world.t, found infinity");
  EXPECT_EQ(broken("range"), "rule: world (test.counter): sense: expected a number from 0 for world.t, found -1");
  EXPECT_EQ(broken("forget"), "rule: world (test.counter): sense: expected a number from 0 for world.t, found NaN");
  EXPECT_EQ(broken("reward"), "rule: world (test.counter): step: expected a finite reward, found NaN");
  EXPECT_EQ(broken("period"), "rule: world (test.counter): expected a period above 0 s, found 0");
}

TEST_F(StageTest, NamesTheSensorThatBrokeTheRule) {
  Cell cell = cell_of(counter(), script());
  cell.driver.robot.sensors = {{"first", eye()}, {"second", eye({{"noise", 1e308}})}};
  cell.driver.policy = script({{"script", {10.0}}});
  cell.world = counter({{"actions", 0}, {"break", "forget"}});
  EXPECT_EQ(failure([&] { run(cell); }),
            "rule: sensor/first (test.eye): sense: expected a finite number for first.t, found NaN");
}

TEST_F(StageTest, RefusesARewardThatIsNotFinite) {
  Cell cell = cell_of(counter(), script());
  cell.driver.reward = pay({{"nan", true}});
  EXPECT_EQ(failure([&] { run(cell); }), "rule: reward (test.pay): score: expected a finite reward, found -infinity");
}

}  // namespace
}  // namespace wend::core
