// wend.lspi: least-squares policy iteration.
//   M. G. Lagoudakis, R. Parr: Least-Squares Policy Iteration, JMLR 4 (2003) 1107-1149;
//   Liu et al.: A reactive navigation method of mobile robots based on LSPI and rolling windows (2013), equations
//   (5)-(10).
//
//   symbol     here              meaning
//   phi(s)     Basis             state basis functions, m of them; phi(s, a) is phi(s) in block a      (5)
//   D, L       Memory            the samples (s, a, r, s') and their number                            (6)
//   w          weights_          Q(s, a) = phi(s, a)^T w                                               (5)
//   gamma      options_          discount factor
//   A, b       solver.cpp        A = Phi^T (Phi - gamma Phi'), b = Phi^T R                             (7)-(10)
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <wend/plugin.hpp>
#include <wend/reading.hpp>

#include "basis.hpp"
#include "samples.hpp"
#include "setup.hpp"
#include "solver.hpp"

namespace lspi {

constexpr double ill_conditioned = 1e12;

class Lspi {
 public:
  explicit Lspi(const wend::Config& config)
      : host_(config.host()),
        reading_(config.observation, config.params.texts("observe"), "observe"),
        most_samples_(config.params.count("most_samples")),
        hand_over_ends_(config.params.text("handed_over") == "terminal"),
        memory_(reading_.size()),
        keys_(config.rows()),
        steps_(config.rows()),
        modes_(config.rows()),
        state_(reading_.size()),
        next_(reading_.size()) {
    options_.actions = count_actions(config.action);
    options_.discount = config.params.number("gamma");
    options_.ridge = config.params.number("ridge");
    options_.iterations = static_cast<std::uint32_t>(config.params.count("iterations"));
    basis_ = make_basis(config.params, reading_, options_.actions);
    features_.resize(basis_->size());
    if (config.params.flag("mirror")) mirror_ = find_mirror(config.params, reading_, options_.actions);
    told_.box("samples", "1").box("iterations", "1").box("converged", "1");
    told_.box("residual", "1").box("condition", "1").box("rank", "1");
  }

  void begin(wend::Rows rows, wend::Episodes episodes) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      keys_[rows[i]] = wend::stream(episodes[i].seed, "lspi");
      steps_[rows[i]] = 0;
      modes_[rows[i]] = episodes[i].mode;
    }
  }

  // Greedy; at random while it explores, and as long as it has learned nothing.
  void act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::uint32_t row = rows[i];
      look(observations[i]);
      if (modes_[row] == WEND_TRAIN_EXPLORE || weights_.empty())
        actions[i][0] =
            static_cast<double>(wend::Random(wend::stream(keys_[row], steps_[row])).below(options_.actions));
      else
        actions[i][0] = greedy(features_, weights_, options_.actions);
      ++steps_[row];
    }
  }

  std::uint64_t learn(const wend::Batch& batch) {
    if (memory_.size() + batch.size() > most_samples_)
      throw wend::parameter_error(
          "most_samples", "expected at most " + std::to_string(most_samples_) + " samples, found " +
                              std::to_string(memory_.size() + batch.size()) + "; raise most_samples or train for less");
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const wend_outcome& outcome = batch.outcomes[i];
      const double action = batch.actions[i][0];
      if (!(action >= 0 && action < options_.actions))
        throw wend::Error(
            WEND_E_ARGUMENT, {},
            "an action: expected 0.." + std::to_string(options_.actions - 1) + ", found " + std::to_string(action));
      if (!std::isfinite(outcome.reward))
        throw wend::Error(WEND_E_ARGUMENT, {}, "a reward: expected a finite number, found NaN or infinity");
      pick(batch.observations[i], state_);
      pick(batch.next_observations[i], next_);
      const std::uint32_t ends = WEND_TERMINATED | (hand_over_ends_ ? std::uint32_t{WEND_HANDED_OVER} : 0u);
      memory_.add(state_, static_cast<std::uint32_t>(action), outcome.reward, next_, (outcome.flags & ends) != 0);
    }
    return batch.size();
  }

  void finish() {
    if (memory_.size() == 0) return;  // nothing learned: act() stays random
    Solution found = solve(memory_.samples(*basis_, mirror_ ? &*mirror_ : nullptr), options_);
    const std::string samples = "the " + std::to_string(memory_.size()) + " samples ";
    for (const double w : found.weights)
      if (!std::isfinite(w))
        throw wend::Error(samples + "have no finite solution: collect from more states or raise ridge");
    if (found.rank < found.weights.size())
      warn(samples + "determine " + std::to_string(found.rank) + " of " + std::to_string(found.weights.size()) +
           " weights: collect from more states, or take a smaller basis");
    else if (found.condition > ill_conditioned)
      warn(samples + "make an ill-conditioned system: collect from more states or raise ridge");
    weights_ = found.weights;
    solution_ = std::move(found);
  }

  void save(wend::Writer& writer) const {
    writer.put(signature());
    writer.put(std::span<const double>(basis_->constants()));
    memory_.save(writer);
    writer.put(std::span<const double>(weights_));
  }

  void load(wend::Reader& reader) {
    reader.expect(signature());
    if (reader.get_all<double>() != basis_->constants())
      throw wend::damaged_state(
          "expected a state learned with this observation's ranges and this basis' centres and width, " +
          std::string("found others"));
    Memory memory = Memory::load(reader, reading_.size(), options_.actions);
    std::vector<double> weights = reader.get_all<double>();
    reader.end();
    const std::size_t expected = basis_->size() * options_.actions;
    if (!weights.empty() && weights.size() != expected)
      throw wend::damaged_state("expected " + std::to_string(expected) + " weights, found " +
                                std::to_string(weights.size()));
    for (const double w : weights)
      if (!std::isfinite(w)) throw wend::damaged_state("a weight is not a finite number");
    memory_ = std::move(memory);
    weights_ = std::move(weights);
    solution_.reset();
  }

  std::uint32_t value_actions() const { return options_.actions; }
  void values(wend::Matrix<const double> observations, wend::Matrix<double> q, wend::Matrix<double> spread) {
    for (std::size_t i = 0; i < q.rows(); ++i) {
      look(observations[i]);
      for (std::uint32_t a = 0; a < options_.actions; ++a) {
        q[i][a] = weights_.empty() ? 0 : value(features_, weights_, a);
        spread[i][a] = 0;
      }
    }
  }

  // Of the last solve in this object; NaN before it.
  const wend::Columns* telemetry(std::uint32_t when) const { return when == WEND_PER_UPDATE ? &told_ : nullptr; }
  void read(std::uint32_t, wend::Rows, wend::Matrix<double> out) const {
    const auto row = out[0];
    std::fill(row.begin(), row.end(), std::numeric_limits<double>::quiet_NaN());
    row[0] = static_cast<double>(memory_.size());
    if (!solution_) return;
    row[1] = solution_->iterations;
    row[2] = solution_->converged;
    row[3] = solution_->residual;
    row[4] = solution_->condition;
    row[5] = solution_->rank;
  }

 private:
  void pick(std::span<const double> observation, std::vector<double>& state) const {
    for (std::size_t i = 0; i < state.size(); ++i) state[i] = reading_(observation, i);
  }
  void look(std::span<const double> observation) {
    pick(observation, state_);
    basis_->evaluate(state_, features_);
  }
  void warn(const std::string& message) const { host_->log(host_, 2, message.c_str()); }
  std::string signature() const {
    return "wend.lspi 1: " + basis_->name() + ", " + std::to_string(options_.actions) + " actions";
  }

  const wend_host* host_;
  wend::Reading reading_;
  std::uint64_t most_samples_;
  bool hand_over_ends_;
  SolverOptions options_;
  std::unique_ptr<Basis> basis_;
  Memory memory_;
  std::optional<Memory::Mirror> mirror_;
  std::vector<double> weights_;  // K x m; empty: nothing learned
  std::optional<Solution> solution_;
  std::vector<std::uint64_t> keys_, steps_;  // by row
  std::vector<std::uint32_t> modes_;
  std::vector<double> state_, next_, features_;
  wend::Columns told_;
};

}  // namespace lspi

WEND_PLUGIN(wend::component<lspi::Lspi>("wend.lspi"))
