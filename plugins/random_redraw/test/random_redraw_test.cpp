// The control: never learns, draws anew after failures, keeps what succeeds.
#include "../../hdp/test/harness.hpp"

using namespace hdp_test;

namespace {

class Control : public Bench {
 public:
  Control() {
    set("theta", "clipped")
        .set("actions", {0, 1, 2})
        .set("hidden", 6)
        .set("gain", 1)
        .set("weights", 0.3)
        .set("criterion", 3);
    set("stop_after", 3);
  }
  std::string weights() {  // the end of a state
    const std::string all = save();
    return all.substr(all.size() - (6 * 8 + 8 + 1) * 8);
  }
  void trial(std::uint32_t flags) {
    begin(++trial_, WEND_TRAIN_EXPLORE);
    const auto seen = sees({10, 10, 4, 10, 10}, {0, 0, 1, 0, 0}, 0.5);
    for (int i = 0; i < 4; ++i) {
      const std::vector<double> action = act(seen);
      const std::uint32_t row = 0;
      const wend_outcome outcome{-1, i == 3 ? flags : 0, 0};
      const wend_batch batch{sizeof batch, 1, &row, seen.data(), action.data(), seen.data(), &outcome};
      std::uint64_t used = 1;
      ASSERT_EQ(table<wend_learner>(WEND_LEARNER)->learn(ref().self, &batch, &used), WEND_OK);
      EXPECT_EQ(used, 0u);
    }
  }

 private:
  std::uint64_t trial_ = 0;
};

}  // namespace

TEST(RandomRedraw, DrawsAnewAfterFailuresOnly) {
  Control control;
  ASSERT_TRUE(control.create()) << control.error();
  std::string before = control.weights();
  control.trial(arrived);
  EXPECT_EQ(control.weights(), before);
  for (const std::uint32_t failure : {crashed, std::uint32_t{WEND_TRUNCATED}}) {
    control.trial(failure);
    EXPECT_NE(control.weights(), before);
    before = control.weights();
  }
  for (int i = 0; i < 3; ++i) control.trial(arrived);
  EXPECT_EQ(control.telemetry(WEND_PER_UPDATE), (std::vector<double>{1, 6, 1, 2}));
  EXPECT_EQ(control.telemetry(WEND_PER_EPISODE), (std::vector<double>{1, 6, 0}));
  control.trial(crashed);
  EXPECT_EQ(control.weights(), before) << "three successes in a row: they stay";
}

TEST(RandomRedraw, AStateGoesOn) {
  Control one, other;
  ASSERT_TRUE(one.create() && other.seed(9).create());
  one.trial(crashed), one.trial(arrived);
  other.load(one.save());
  EXPECT_EQ(other.save(), one.save());
  one.trial(crashed), other.trial(crashed);
  EXPECT_EQ(other.telemetry(WEND_PER_UPDATE)[1], 1) << "counts its own training";
  EXPECT_EQ(wend::testing::error_of([&] { other.load("short"); }), "the state ends early");
}

TEST(RandomRedraw, RefusesWhatItCannotUse) {
  Control hasty;
  hasty.set("criterion", 4);
  EXPECT_FALSE(hasty.create());
  EXPECT_EQ(hasty.parameter(), "stop_after");
  EXPECT_EQ(hasty.error(), "expected at least criterion = 4, or 0 for never, found 3");
  Control two;
  two.set("actions", {0, 1, 3});
  EXPECT_FALSE(two.create());
  EXPECT_EQ(two.parameter(), "actions/2");
  EXPECT_EQ(two.error(), "expected an action 0..2, found 3");
  Control wide, own;
  ASSERT_TRUE(wide.set("hidden", 8).create() && own.create());
  const std::string before = own.save();
  EXPECT_EQ(wend::testing::error_of([&] { own.load(wide.save()); }),
            "expected a state of wend.random_redraw 1: 6 inputs, 6 hidden units, found wend.random_redraw 1: 6 inputs, "
            "8 hidden units");
  EXPECT_EQ(own.save(), before);
}
