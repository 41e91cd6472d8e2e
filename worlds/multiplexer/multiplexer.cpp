// wend.multiplexer: a question of n bits, an answer of one, and the episode is over.
//   S. W. Wilson: Classifier fitness based on accuracy, Evolutionary Computation 3 (1995) 149-175;
//   M. V. Butz, S. W. Wilson: An algorithmic description of XCS, Soft Computing 6 (2002) 144-153.
//
//   symbol   here           meaning
//   k        address_bits   bits that name a data bit
//   n        Function::size k + 2^k: 6, 11, 20 for k = 2, 3, 4
//   rho      payoff         reward of the right answer, 1000
//
// In exploring trials the answers are the explorer's, so `accuracy` is told of the others only.
#include <limits>
#include <string>
#include <vector>
#include <wend/plugin.hpp>

#include "function.hpp"

namespace multiplexer {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Trial {
  std::uint64_t input = 0, noise = 0;  // noise: key of the reward's stream
  bool exploring = false;
  double accuracy = none;
};

class Multiplexer {
 public:
  explicit Multiplexer(const wend::Config& config)
      : function_(static_cast<std::uint32_t>(config.params.count("address_bits"))),
        payoff_(config.params.number("payoff")),
        reward_noise_(config.params.number("reward_noise")),
        enumerate_(config.params.text("test") == "enumerate"),
        trials_(config.rows()) {
    if (config.robots() != 1)
      throw wend::unsupported("expected one robot at a multiplexer, found " + std::to_string(config.robots()));
    action_.discrete("answer", 2);
    for (std::uint32_t i = 0; i < function_.size(); ++i) seen_.discrete("bit." + std::to_string(i), 2);
    told_.box("accuracy", "1", 0, 1);
  }

  double period() const { return 1; }
  const wend::Columns& action(std::uint32_t) const { return action_; }

  void reset(wend::Rows copies, wend::Episodes episodes) {
    for (std::size_t i = 0; i < copies.size(); ++i) {
      const wend_episode& episode = episodes[i];
      Trial& trial = trials_[copies[i]];
      trial.input = enumerate_ && episode.mode == WEND_TEST
                        ? episode.index % function_.inputs()
                        : wend::Random(wend::stream(episode.seed, "input")).below(function_.inputs());
      trial.noise = reward_noise_ > 0 ? wend::stream(episode.seed, "reward") : 0;
      trial.exploring = episode.mode == WEND_TRAIN_EXPLORE;
      trial.accuracy = none;
    }
  }

  void step(wend::Rows copies, wend::Matrix<const double> actions, std::span<wend_outcome> outcomes) {
    for (std::size_t i = 0; i < copies.size(); ++i) {
      Trial& trial = trials_[copies[i]];
      const bool right = (actions[i][0] >= 0.5) == (function_.answer(trial.input) == 1);
      const double noise = reward_noise_ > 0 ? wend::Random(trial.noise).normal(0, reward_noise_) : 0;
      const std::uint32_t flags = right ? WEND_TERMINATED | WEND_ARRIVED : WEND_TERMINATED;
      outcomes[i] = {(right ? payoff_ : 0) + noise, flags, 0};
      trial.accuracy = trial.exploring ? none : right ? 1 : 0;
    }
  }

  const wend::Columns& columns() const { return seen_; }
  void sense(wend::Rows rows, wend::Matrix<double> out) const {
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::uint32_t b = 0; b < function_.size(); ++b) out[i][b] = function_.bit(trials_[rows[i]].input, b);
  }

  const wend::Columns* telemetry(std::uint32_t when) const { return when == WEND_PER_EPISODE ? &told_ : nullptr; }
  void read(std::uint32_t, wend::Rows rows, wend::Matrix<double> out) const {
    for (std::size_t i = 0; i < rows.size(); ++i) out[i][0] = trials_[rows[i]].accuracy;
  }

 private:
  Function function_;
  double payoff_, reward_noise_;
  bool enumerate_;
  std::vector<Trial> trials_;
  wend::Columns action_, seen_, told_;
};

}  // namespace
}  // namespace multiplexer

WEND_PLUGIN(wend::component<multiplexer::Multiplexer>("wend.multiplexer"))
