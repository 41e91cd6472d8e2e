// The learners on a bench: a robot with a few bits and a few actions, with the manifest's defaults.
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <wend/testing.hpp>

#include "xcs_learner.hpp"
#include "zcs_learner.hpp"

namespace xcs::testing {

using wend::testing::Bench;
using wend::testing::error_of;

struct Rig : Bench {
  wend::Columns seen, table;

  explicit Rig(const wend_component& component, std::uint32_t bits = 4, std::uint32_t actions = 2) : Bench(component) {
    for (std::uint32_t i = 0; i < bits; ++i) seen.discrete("bit." + std::to_string(i), 2);
    table.discrete("action", actions);
    observation(seen).action(table);
    set("encoding/0/as", "binary").set("encoding/0/columns", {"bit.*"});
    set("N", 100).set("P_hash", 0.33).set("beta", 0.2).set("gamma", 0.71).set("chi", 0.8).set("mu", 0.04);
    set("crossover", "two_point").set("prediction_I", 10).set("greedy_updates", 1).set("unmatched", "random");
    set("rule_base", "shared").set("publish_every", 1000).set("explain", "text").set("series_every", 0);
  }

  std::uint64_t learn(const std::vector<double>& from, const std::vector<double>& action,
                      const std::vector<double>& rewards, const std::vector<double>& to, std::uint32_t flags) {
    const auto rows = all_rows();
    std::vector<wend_outcome> outcomes;
    for (const double reward : rewards) outcomes.push_back({reward, flags, 0});
    const wend_batch batch{
        sizeof batch,   static_cast<std::uint32_t>(rewards.size()), rows.data(), from.data(), action.data(), to.data(),
        outcomes.data()};
    std::uint64_t used = 0;
    if (learner()->learn(ref().self, &batch, &used) != WEND_OK) throw std::runtime_error(error());
    return used;
  }
  void finish() {
    if (learner()->finish(ref().self) != WEND_OK) throw std::runtime_error(error());
  }
  const wend_learner* learner() const { return Bench::table<wend_learner>(WEND_LEARNER); }
  // The lines of the explanation that are rules.
  std::vector<std::string> rules(std::uint32_t row = 0) {
    std::vector<std::string> all;
    std::istringstream text(explain(row));
    for (std::string line; std::getline(text, line);)
      if (line.find_first_of("01#") == 0) all.push_back(line);
    return all;
  }
};

struct XcsRig : Rig {
  explicit XcsRig(std::uint32_t bits = 4, std::uint32_t actions = 2, const char* id = "wend.xcs")
      : Rig(id == std::string("wend.lcs") ? wend::component<Lcs>("wend.lcs") : wend::component<Xcs>("wend.xcs"), bits,
            actions) {
    set("operators", "canonical").set("compact", 0).set("selection", "random").set("exploration", 1);
    set("exploration_least", 1).set("exploration_episodes", 1000).set("trace", 0);
  }
};

struct ZcsRig : Rig {
  explicit ZcsRig(std::uint32_t bits = 4, std::uint32_t actions = 2)
      : Rig(wend::component<Zcs>("wend.zcs"), bits, actions) {
    set("tau", 0.1).set("phi", 0.5).set("rho", 0.0).set("test_selection", "greedy").set("prediction_I", 20);
  }
};

// A file that is gone with the test.
struct TemporaryFile {
  std::string path;
  explicit TemporaryFile(const std::string& text)
      : path(::testing::TempDir() + "wend_rules_" + std::to_string(::getpid())) {
    std::ofstream(path) << text;
  }
  ~TemporaryFile() { std::remove(path.c_str()); }
};

}  // namespace xcs::testing
