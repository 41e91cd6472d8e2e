// LS-SVRM: the state-action values Q(s, a), a regression over pairs of state and action.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lssvm.hpp"
#include "samples.hpp"

namespace lssvm {

struct CriticSettings {
  std::uint32_t actions = 0;
  Index features = 0;
  double discount = 0.95;        // gamma
  double sigma = 0.5, c = 100;   // of the kernel, of the errors
  double action_distance = 0.5;  // between different actions, beside the features
  bool ordinal = true;           // actions lie on a line, neighbours that far apart; else all as far from each other
  double caution = 0;            // actions are compared by q - caution * spread
};

// How well the last training went.
struct Training {
  double residual, condition;  // of the linear system
  double error;                // root mean square of target - Q
};

class Critic {
 public:
  Critic() = default;
  explicit Critic(const CriticSettings& settings);

  bool trained() const noexcept { return expansion_.outputs() > 0; }
  Index support() const noexcept { return expansion_.points().rows(); }

  // Q and spread of a state, for each action: 0 before any training.  The spread is the mean size of the errors
  // target - Q of the samples around (s, a), and towards their standard deviation where there are none.
  void values(std::span<const double> state, std::span<double> q, std::span<double> spread);
  // What actions are compared by.
  void worth(std::span<const double> state, std::span<double> out);

  // Targets r + gamma max Q(s', .) for the whole window, with the Q of before; one factor for all sweeps.
  void train(const Window& window, std::uint32_t sweeps);

  std::optional<Training> last_training();  // none before it, or where it was loaded

  void save(wend::Writer& writer) const;
  void load(wend::Reader& reader);  // throws where the bytes are of other settings

 private:
  double between(std::uint32_t a, std::uint32_t b) const noexcept;  // |a - b|
  Points pairs(const Window& window) const;
  void compare(std::span<const double> raw, std::span<double> out) const;
  void bootstrap(const Window& window, std::span<const double> values, Index padded,
                 std::vector<double>& targets) const;
  void adopt(const Window& window, const Dual& dual);

  CriticSettings settings_;
  std::vector<double> kernel_;  // between actions, K x K
  Expansion expansion_;         // of states: K values, K sums of sizes of errors, K sums of kernel values
  double deviation_ = 0;        // standard deviation of the last targets
  std::vector<double> raw_;
  std::optional<Lssvm> machine_;  // of the last training
  Dual dual_;
  std::vector<double> targets_;
  std::optional<Training> told_;
};

}  // namespace lssvm
