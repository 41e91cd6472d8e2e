// summary.json: what came out of an experiment, for people, tables and pictures.
#pragma once
#include <core/base/json.hpp>
#include <core/experiment/unit.hpp>
#include <core/record/store.hpp>
#include <string>
#include <vector>

namespace wend::core {

// {"wend", "experiment", "fingerprint", "cells": {"planned", "done", "failed"}, "results": [...], "curves": [...]}
//
// A result is a row (arm, world, point, at), in the order of the plan, over all variants and seeds that are done:
//   "success", "collision", "timeout"
//       {"rate", "low", "high", "n"} of episodes.  Of several robots: all arrived; any collided; any ran out of time
//       and none collided.  Absent in a world where nothing ever arrives or collides.
//   "worst_seed_success"
//       the lowest success rate of a seed
//   "metrics"
//       {"mean", "iqm", "low", "high", "n"} of steps (successful episodes only), the cells' own metrics (NaN left out),
//       decision_us (a value a cell) and train_s (a value a training).  Of several robots also "<metric>_robot_<k>",
//       and success_robot_<k>, collision_robot_<k>, timeout_robot_<k> without iqm.
//   "failed"
//       cells that failed, if any did
// Low and high: 95 %.  A rate: Wilson's or, where the seed trains and it is wider, the bootstrap over seeds.  A metric:
// the bootstrap of its iqm over seeds where the seed trains, else over episodes within the variants: 10,000
// repetitions, fewer (down to 1,000) above 200 episodes a row; see BootstrapOptions.
//
// A curve is [[x, mean, low, high], ...] over seeds: each training's own curves, named by the world it is tested in,
// and success, collision and spl of snapshots against the budget's unit.  Curves whose x differ are taken at the union
// of them, each with the last value it has; the band is a bootstrap over seeds, or Wilson's where all values are
// 0 or 1.
//
// The fingerprint is SHA-256 over the sorted ids and hashes of what is done; no time is in it.
Json summarize(const std::string& experiment, const std::vector<Training>& trainings, const std::vector<Cell>& cells,
               const Store& store);

}  // namespace wend::core
