#include <core/run/driver.hpp>
#include <cstring>

#include "fixture.hpp"

namespace wend::core {
namespace {

class DriverTest : public RunTest {
 protected:
  // A driver of its own stage.
  struct Made {
    Made(DriverTest& test, const ComponentSpec& policy, const Json& world = Json::object())
        : cell(cell_of(counter(world), policy)),
          stage(cell.world, cell.driver, cell.stream, {&test.libraries_, &test.listener_, 1}),
          driver(cell.driver, stage) {}
    Cell cell;
    Stage stage;
    Driver driver;
  };
  std::string acting(const Json& world, const Json& policy) {
    return failure([&] { run(cell_of(counter(world), script(policy))); });
  }
};

TEST_F(DriverTest, RefusesActionsThatAreNotInTheSpace) {
  const Json turns = {{"actions", 3}}, speeds = {{"actions", 0}};
  const std::string act = "rule: policy (test.script): act: ";
  EXPECT_EQ(acting(turns, {{"script", {0, 1, 2}}}), "nothing");
  EXPECT_EQ(acting(turns, {{"script", {0, 0.5}}}), act + "expected a whole number 0..2 for turn, found 0.5");
  EXPECT_EQ(acting(turns, {{"script", {0, 3}}}), act + "expected a whole number 0..2 for turn, found 3");
  EXPECT_EQ(acting(turns, {{"script", {-1}}}), act + "expected a whole number 0..2 for turn, found -1");
  EXPECT_EQ(acting(turns, {{"nan_at", 1}}), act + "expected a whole number 0..2 for turn, found NaN");
  EXPECT_EQ(acting(turns, {{"forget_at", 1}}), act + "expected a whole number 0..2 for turn, found NaN");
  EXPECT_EQ(acting(speeds, {{"script", {-10, 10, 0.25}}}), "nothing");
  EXPECT_EQ(acting(speeds, {{"script", {10.5}}}), act + "expected a number in -10..10 for turn, found 10.5");
  EXPECT_EQ(acting(speeds, {{"nan_at", 2}}), act + "expected a number in -10..10 for turn, found NaN");
}

TEST_F(DriverTest, RefusesALearnerThatUsedMoreThanThereWas) {
  EXPECT_EQ(failure([&] {
              run(training_of(counter(), table({{"use", -1}}), {"samples", 10}));
            }),
            "rule: policy (test.table): learn: expected at most the batch's 1 samples to be used, found 2");
}

TEST_F(DriverTest, LoadsWhatItSaved) {
  const TrainingResult result = run(training_of(counter({{"pays", {0.25, 0.5, 0.125}}}), table(), {"episodes", 20}));
  const std::string bytes = file(result.final_state);
  Made made(*this, table());
  EXPECT_NE(made.driver.save(), bytes);
  made.driver.load(bytes, "w.state");
  EXPECT_EQ(made.driver.save(), bytes);
  EXPECT_TRUE(made.driver.learns());
}

TEST_F(DriverTest, RefusesAStateThatIsNotItsOwn) {
  Made root(*this, table()), two(*this, table(), {{"actions", 2}});
  ComponentSpec outer = script();
  outer.slots["inner"] = table();
  Made slot(*this, outer);
  const auto load = [&](const std::string& bytes) { return failure([&] { root.driver.load(bytes, "w.state"); }); };
  const std::string own = root.driver.save();

  EXPECT_EQ(load(slot.driver.save()),
            "state: w.state: expected the state of test.table at policy, found that of test.table at policy/inner");
  EXPECT_EQ(load(two.driver.save()),
            "state: w.state: policy (test.table): load: state error: expected a table of 3 actions, found 2");
  EXPECT_EQ(load(own + "x"), "state: w.state: the state has 1 bytes too many");
  const std::string garbage = "not a state";
  std::uint64_t count;
  std::memcpy(&count, garbage.data(), 8);
  EXPECT_EQ(load(garbage), "state: w.state: the state ends early: " + std::to_string(count) + " values announced");
  std::string other = own;
  other[8 + 11] = '2';
  EXPECT_EQ(load(other), "state: w.state: expected a state of wend state 1, found wend state 2");
  for (std::size_t n = 0; n < own.size(); ++n)
    EXPECT_EQ(load(own.substr(0, n)).find("state: w.state: the state ends early"), 0u) << n;
  EXPECT_EQ(root.driver.save(), own);
}

}  // namespace
}  // namespace wend::core
