// Lambda-returns: an episode of two steps whose only reward comes last.
#include <gtest/gtest.h>

#include "rig.hpp"

using xcs::testing::XcsRig;

namespace {

// The prediction of the rule for the first state after one episode 00 -> 11 -> end with reward 100 (gamma 0.5).
double first_prediction(double trace) {
  XcsRig rig(2, 2);
  rig.set("operators", "paper").set("fitness", "accuracy").set("P_hash", 0).set("gamma", 0.5).set("trace", trace);
  rig.set("prediction_I", 0).set("beta", 0.5).set("merge_every", 0).set("exploration", 0);
  for (const char* path : {"safety_distance", "merge_tolerance", "merge_experience", "initial_rules", "specialise",
                           "inherited", "seeded_beta", "seeded_experience"})
    rig.set(path, 0);
  rig.set("beta_least", 1);
  EXPECT_TRUE(rig.create()) << rig.error();
  rig.begin(1, WEND_TRAIN_EXPLORE);
  const std::vector<double> first{0, 0}, second{1, 1};
  const auto a = rig.act(first);
  EXPECT_EQ(rig.learn(first, a, {0}, second, 0), 1u);
  const auto b = rig.act(second);
  EXPECT_EQ(rig.learn(second, b, {100}, second, WEND_TERMINATED), 1u);
  rig.begin(1);
  rig.act(first);
  return rig.telemetry(WEND_PER_STEP)[0];
}

}  // namespace

TEST(Trace, CarriesTheReturnBackInOneEpisode) {
  EXPECT_EQ(first_prediction(0), 0) << "one step: the second state was worth nothing yet";
  // Backwards, the second state is worth 100 by then whatever lambda is: its only rule with experience predicts it.
  EXPECT_DOUBLE_EQ(first_prediction(1), 50);
  EXPECT_DOUBLE_EQ(first_prediction(0.5), 50);
}
