// A plugin compiled from the header of ABI 1.0 does all it could do then in today's host.
#include <gtest/gtest.h>

#include "support/wend.hpp"

using namespace wend::test;

TEST(OldPlugin, LoadsLearnsAndIsTested) {
  const TemporaryDirectory place;
  const std::string file = place.write("line.json", R"({"name": "line", "seed": 1,
    "worlds": [{"id": "line", "type": "test.line", "params": {"cells": 20}}],
    "arms": [{"id": "bandit", "policy": {"type": "test.bandit", "params": {"rate": 0.2}}, "train": {"samples": 500, "evaluate": {"at": [0], "episodes": 2}}}],
    "test": {"episodes": 5}, "seeds": 2})");
  const std::vector<std::string> plugins = {"--plugin-path", WEND_BINARY_DIR "/tests/abi/plugin"};
  const Outcome ran = run(run_command(file, place / "run", plugins));
  ASSERT_EQ(ran.exit, 0) << ran.err;
  const Json results = read_json(place / "run/summary.json")["results"];
  ASSERT_EQ(results.size(), 2u);
  for (const Json& row : results) {
    const bool untrained = row.contains("at") && !row["at"].is_null() && row["at"].value("samples", 1) == 0;
    EXPECT_EQ(row["success"]["rate"], untrained ? 0.0 : 1.0) << row.dump(1);
    if (!untrained) {
      EXPECT_GE(row["metrics"]["best_q"]["mean"].get<double>(), 0.1) << row["metrics"].dump(1);
    }
  }
}
