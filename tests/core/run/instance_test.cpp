#include <core/run/driver.hpp>

#include "fixture.hpp"

namespace wend::core {
namespace {

using InstanceTest = RunTest;

ComponentSpec nested(ComponentSpec inner, int depth) {
  for (int i = 0; i < depth; ++i) {
    ComponentSpec outer = script();
    outer.slots["inner"] = std::move(inner);
    inner = std::move(outer);
  }
  return inner;
}

TEST_F(InstanceTest, TellsTheMessageOfTheOneThatFailed) {
  const ComponentSpec failing = script({{"fail_at", 0}, {"message", "it is raining"}});
  EXPECT_EQ(failure([&] { run(cell_of(counter(), failing)); }),
            "plugin: policy (test.script): act: internal error: it is raining");
  EXPECT_EQ(failure([&] { run(cell_of(counter(), nested(failing, 1))); }),
            "plugin: policy/inner (test.script): act: internal error: it is raining");
  EXPECT_EQ(failure([&] { run(cell_of(counter(), nested(failing, 3))); }),
            "plugin: policy/inner/inner/inner (test.script): act: internal error: it is raining");
}

TEST_F(InstanceTest, TellsWhyItWasNotCreated) {
  EXPECT_EQ(failure([&] {
              run(cell_of(counter(), nested(script({{"message", "at create"}}), 2)));
            }),
            "plugin: policy/inner/inner (test.script): create: parameter error: message: expected another one, found "
            "\"at create\"");
}

TEST_F(InstanceTest, RequiresTheInterfacesOfItsPlace) {
  EXPECT_EQ(
      failure([&] { run(cell_of(counter(), pay())); }),
      "rule: policy (test.pay): expected the interface wend.policy/1, which its manifest names; query() found none");
}

TEST_F(InstanceTest, VisitsSlotsBeforeOwners) {
  const Cell cell = cell_of(counter(), nested(script(), 2));
  Stage stage(cell.world, cell.driver, cell.stream, {&libraries_, &listener_, 1});
  Driver driver(cell.driver, stage);
  std::vector<std::string> paths;
  driver.root().visit([&](Instance& instance) { paths.push_back(instance.path()); });
  EXPECT_EQ(paths, (std::vector<std::string>{"policy/inner/inner", "policy/inner", "policy"}));
}

}  // namespace
}  // namespace wend::core
