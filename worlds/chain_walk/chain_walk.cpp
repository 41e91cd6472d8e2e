// wend.chain_walk: a walk in a line of states, the first test of least-squares policy iteration.
//   M. G. Lagoudakis, R. Parr: Least-Squares Policy Iteration, JMLR 4 (2003) 1107-1149, section 9.1;
//   4 states: D. Koller, R. Parr: Policy iteration for factored MDPs, UAI 2000.
//
//   symbol     here             meaning
//   s          state            1..states, the one column
//   L, R       left, right      actions 0 and 1: go that way with probability `success`, else the other way
//   R(s)       reward_states    1 for coming to (or staying in) these states
//   V*, Q*     chain.cpp        by policy iteration, exactly but for rounding
//
// A survey is a test episode that asks the policy about every state in turn.
#include <algorithm>
#include <limits>
#include <string>
#include <wend/plugin.hpp>

#include "chain.hpp"

namespace chain_walk {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Chain chain_of(const wend::Params& params) {
  std::vector<double> rewards(params.count("states"));
  const std::vector<double> states = params.numbers("reward_states");
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!(states[i] >= 1 && states[i] <= static_cast<double>(rewards.size())))
      throw wend::parameter_error(wend::Params::element("reward_states", i),
                                  "expected a state 1.." + std::to_string(rewards.size()) + ", found " +
                                      std::to_string(static_cast<long long>(states[i])));
    rewards[static_cast<std::size_t>(states[i]) - 1] = 1;
  }
  return Chain(std::move(rewards), params.number("success"), params.number("gamma"));
}

struct Walker {
  std::uint64_t key = 0, step = 0;
  std::size_t state = 0;
  bool survey = false;
  std::uint64_t agreed = 0;  // steps whose action was optimal
  double value_loss = none;
  std::vector<std::uint8_t> answers;  // of a survey, by state
};

class ChainWalk {
 public:
  explicit ChainWalk(const wend::Config& config)
      : chain_(chain_of(config.params)),
        best_(chain_.optimal_values()),
        survey_(config.params.text("test") == "survey"),
        limit_(config.params.count("time_limit")),
        walkers_(config.rows()),
        values_(chain_.size()),
        scratch_(chain_.size()) {
    if (config.robots() != 1)
      throw wend::unsupported("expected one robot in a chain, found " + std::to_string(config.robots()));
    for (Walker& walker : walkers_) walker.answers.resize(survey_ ? chain_.size() : 0);
    action_.discrete("direction", 2);
    seen_.box("state", "1", 1, static_cast<double>(chain_.size()));
    told_.box("agreement", "1", 0, 1).box("optimal", "1", 0, 1).box("value_loss", "1", 0);
  }

  double period() const { return 1; }
  const wend::Columns& action(std::uint32_t) const { return action_; }

  void reset(wend::Rows copies, wend::Episodes episodes) {
    for (std::size_t i = 0; i < copies.size(); ++i) {
      Walker& walker = walkers_[copies[i]];
      walker.key = wend::stream(episodes[i].seed, "steps");
      walker.survey = survey_ && episodes[i].mode == WEND_TEST;
      walker.state = walker.survey ? 0 : wend::Random(wend::stream(episodes[i].seed, "start")).below(chain_.size());
      walker.step = walker.agreed = 0;
      walker.value_loss = none;
    }
  }

  void step(wend::Rows copies, wend::Matrix<const double> actions, std::span<wend_outcome> outcomes) {
    for (std::size_t i = 0; i < copies.size(); ++i)
      outcomes[i] = step(walkers_[copies[i]], actions[i][0] >= 0.5 ? right : left);
  }

  const wend::Columns& columns() const { return seen_; }
  void sense(wend::Rows rows, wend::Matrix<double> out) const {
    for (std::size_t i = 0; i < rows.size(); ++i) out[i][0] = static_cast<double>(walkers_[rows[i]].state + 1);
  }

  const wend::Columns* telemetry(std::uint32_t when) const { return when == WEND_PER_EPISODE ? &told_ : nullptr; }
  void read(std::uint32_t, wend::Rows rows, wend::Matrix<double> out) const {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Walker& walker = walkers_[rows[i]];
      const auto steps = static_cast<double>(walker.step);
      out[i][0] = walker.step ? static_cast<double>(walker.agreed) / steps : none;
      out[i][1] = walker.survey ? (walker.agreed == chain_.size() ? 1 : 0) : none;
      out[i][2] = walker.value_loss;
    }
  }

 private:
  wend_outcome step(Walker& walker, Action action) {
    const auto q = chain_.action_values(walker.state, best_);
    if (q[action] >= q[1 - action] - tie) ++walker.agreed;
    const bool succeeds = wend::Random(walker.key, walker.step).uniform() < chain_.success();
    const Action way = succeeds ? action : Action(1 - action);
    const std::size_t next = chain_.neighbour(walker.state, way);
    wend_outcome outcome{chain_.reward(next), 0, 0};
    ++walker.step;
    if (walker.survey) {
      walker.answers[walker.state] = static_cast<std::uint8_t>(action);
      if (walker.step == chain_.size()) outcome.flags = judge(walker);
      else ++walker.state;
    } else {
      walker.state = next;
      if (walker.step == limit_) outcome.flags = WEND_TRUNCATED;
    }
    return outcome;
  }

  // All answers are there: the policy's values are known exactly.
  std::uint32_t judge(Walker& walker) {
    chain_.evaluate(walker.answers, values_, scratch_);
    double loss = 0, scale = 0;
    for (std::size_t s = 0; s < chain_.size(); ++s) {
      loss = std::max(loss, best_[s] - values_[s]);
      scale = std::max(scale, best_[s]);
    }
    walker.value_loss = scale > 0 ? loss / scale : 0;
    return walker.agreed == chain_.size() ? WEND_TERMINATED | WEND_ARRIVED : WEND_TERMINATED;
  }

  Chain chain_;
  std::vector<double> best_;  // V*
  bool survey_;
  std::uint64_t limit_;
  std::vector<Walker> walkers_;
  std::vector<double> values_, scratch_;
  wend::Columns action_, seen_, told_;
};

}  // namespace
}  // namespace chain_walk

WEND_PLUGIN(wend::component<chain_walk::ChainWalk>("wend.chain_walk"))
