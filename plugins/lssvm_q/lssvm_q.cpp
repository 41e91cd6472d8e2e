// wend.lssvm_q: Q-learning with cooperating least-squares support vector machines.
//   Wang X., Tian X., Cheng Y.: cooperative LS-SVM Q-learning; as cited and used by Li et al., "Path obstacle avoidance
//   planning of an ALV in narrow environments, based on XCS and LS-SVM" (in Chinese), section 2.2, equations (8)-(11).
//
//   symbol          here             meaning
//   LS-SVRM, D1     Critic, d1_      regression S x A -> Q and its samples (s, a, r, s')          steps 1-3
//   LS-SVCM, D2     Adviser, d2_     classification S -> A and its samples (s, a)                 steps 1-3
//   theta           theta_           least |s' - s| of a sample of D1, in scaled features         (8)
//   |s - s_d|       goal_distance()  m, to the goal; must shrink in a sample of D2                (9)
//   T, T_min, T_max temperature_, coldest_, hottest_                                              (10), (11)
//   beta            annealing_                                                                    (11)
//   deep learning   deep_            phase in which the regression decides alone                  step 4
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <wend/math.hpp>
#include <wend/plugin.hpp>

#include "adviser.hpp"
#include "cooperation.hpp"
#include "critic.hpp"
#include "features.hpp"
#include "samples.hpp"
#include "settings.hpp"

namespace lssvm {

class LssvmQ {
 public:
  explicit LssvmQ(const wend::Config& config)
      : features_(config),
        settings_(read_settings(config, features_)),
        robots_(config.robots()),
        d1_(features_.size(), settings_.window, settings_.forget),
        d2_(features_.size(), settings_.advice_window, Forget::oldest),
        critic_(settings_.critic),
        adviser_(settings_.critic.actions, features_.size(), settings_.critic.sigma, settings_.advice_c),
        cooperation_(settings_.switching),
        temperature_(settings_.hottest),
        rows_(config.rows()),
        state_(features_.size()),
        next_(features_.size()),
        worth_(settings_.critic.actions) {
    for (const char* name : {"samples", "advice_samples", "trainings", "temperature", "agreement", "deep"})
      told_.box(name, "1");
    for (const char* name : {"switch_episode", "switch_step", "residual", "condition", "bellman_error"})
      told_.box(name, "1");
  }

  void begin(wend::Rows rows, wend::Episodes episodes) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows_[rows[i]] = {wend::stream(episodes[i].seed, "lssvm_q"), 0, episodes[i].mode};
      if (episodes[i].mode == WEND_TRAIN_EXPLORE && rows[i] % robots_ == 0) begin_exploring();
    }
  }

  void act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Row& row = rows_[rows[i]];
      wend::Random random(wend::stream(row.key, row.step++));
      features_.read(observations[i], state_);
      critic_.worth(state_, worth_);
      actions[i][0] = row.mode == WEND_TRAIN_EXPLORE ? explore(random) : decide(random);
    }
  }

  std::uint64_t learn(const wend::Batch& batch) {
    std::uint64_t used = 0;
    for (std::size_t i = 0; i < batch.size(); ++i)
      if (rows_[batch.rows[i]].mode == WEND_TRAIN_EXPLORE) used += take(batch, i);
    return used;
  }

  void finish() {
    if (d1_.size() > 0) train(settings_.final_sweeps);
  }

  void save(wend::Writer& writer) const {
    writer.put(signature());
    writer.put(std::span<const double>(constants()));
    writer.put(temperature_);
    writer.put(episodes_);
    writer.put(steps_);
    writer.put(fresh_);
    writer.put(trainings_);
    cooperation_.save(writer);
    d1_.save(writer);
    d2_.save(writer);
    critic_.save(writer);
    adviser_.save(writer);
  }

  void load(wend::Reader& reader) {
    reader.expect(signature());
    if (reader.get_all<double>() != constants())
      throw wend::damaged_state(
          "expected a state learned with this observation's ranges and these weights of features, sigma, C and "
          "action_distance, found others");
    const auto temperature = reader.get<double>();
    if (!(temperature > 0 && temperature <= std::numeric_limits<double>::max()))
      throw wend::damaged_state("expected a temperature above 0, found " + std::to_string(temperature));
    const auto episodes = reader.get<std::uint64_t>(), steps = reader.get<std::uint64_t>(),
               fresh = reader.get<std::uint64_t>(), trainings = reader.get<std::uint64_t>();
    Cooperation cooperation(settings_.switching);
    cooperation.load(reader);
    Window d1(features_.size(), settings_.window, settings_.forget);
    Window d2(features_.size(), settings_.advice_window, Forget::oldest);
    d1.load(reader, settings_.critic.actions);
    d2.load(reader, settings_.critic.actions);
    Critic critic(settings_.critic);
    critic.load(reader);
    Adviser adviser(settings_.critic.actions, features_.size(), settings_.critic.sigma, settings_.advice_c);
    adviser.load(reader);
    reader.end();
    temperature_ = temperature, episodes_ = episodes, steps_ = steps, fresh_ = fresh, trainings_ = trainings;
    cooperation_ = std::move(cooperation);
    d1_ = std::move(d1), d2_ = std::move(d2);
    critic_ = std::move(critic), adviser_ = std::move(adviser);
  }

  std::uint32_t value_actions() const { return settings_.critic.actions; }
  void values(wend::Matrix<const double> observations, wend::Matrix<double> q, wend::Matrix<double> spread) {
    for (std::size_t i = 0; i < q.rows(); ++i) {
      features_.read(observations[i], state_);
      critic_.values(state_, q[i], spread[i]);
    }
  }

  const wend::Columns* telemetry(std::uint32_t when) const { return when == WEND_PER_UPDATE ? &told_ : nullptr; }
  void read(std::uint32_t, wend::Rows, wend::Matrix<double> out) {
    const auto row = out[0];
    std::fill(row.begin(), row.end(), std::numeric_limits<double>::quiet_NaN());
    row[0] = static_cast<double>(d1_.size());
    row[1] = static_cast<double>(d2_.size());
    row[2] = static_cast<double>(trainings_);
    row[3] = temperature_;
    row[4] = cooperation_.agreement();
    row[5] = cooperation_.deep();
    if (cooperation_.deep()) {
      row[6] = static_cast<double>(cooperation_.switch_episode());
      row[7] = static_cast<double>(cooperation_.switch_step());
    }
    const std::optional<Training> last = critic_.last_training();
    if (!last) return;
    row[8] = last->residual;
    row[9] = last->condition;
    row[10] = last->error;
  }

 private:
  struct Row {
    std::uint64_t key = 0, step = 0;
    std::uint32_t mode = WEND_TEST;
  };

  // (11), once for every exploring episode after the first.
  void begin_exploring() {
    if (episodes_ > 0) temperature_ = settings_.coldest + settings_.annealing * (temperature_ - settings_.coldest);
    cooperation_.begin_episode(episodes_, steps_);
    ++episodes_;
  }

  std::uint32_t greedy() const {
    return static_cast<std::uint32_t>(std::max_element(worth_.begin(), worth_.end()) - worth_.begin());
  }

  // Without exploring: the best of the regression, or of the classification as long as there is no regression.
  std::uint32_t decide(wend::Random& random) {
    if (critic_.trained()) return greedy();
    return adviser_.trained() ? adviser_.advise(state_) : draw(random);
  }

  // Steps 1 and 4.
  std::uint32_t explore(wend::Random& random) {
    ++steps_;
    if (!cooperation_.needs_advice() || !adviser_.trained()) return draw(random);
    const std::uint32_t advised = adviser_.advise(state_);
    const bool agree = critic_.trained() && advised == greedy();
    if (critic_.trained()) cooperation_.compare(agree, episodes_, steps_);
    if (cooperation_.deep_in_state(agree)) return draw(random);
    return random.chance(settings_.advice) ? advised : draw(random);
  }

  // (10); every action alike before the first training.
  std::uint32_t draw(wend::Random& random) {
    const double best = *std::max_element(worth_.begin(), worth_.end());
    for (double& w : worth_) w = wend::math::exp((w - best) / temperature_);
    const std::size_t drawn = random.weighted(worth_);
    if (drawn >= worth_.size())
      throw wend::Error(
          WEND_E_PARAMETER, {},
          "the actions' worth: expected finite values, found NaN or infinity; lower gamma, caution or the "
          "rewards");
    return static_cast<std::uint32_t>(drawn);
  }

  // Step 3: one transition becomes a sample of D1 under (8), of D2 under (9).
  std::uint64_t take(const wend::Batch& batch, std::size_t i) {
    const wend_outcome& outcome = batch.outcomes[i];
    const double action = batch.actions[i][0];
    const std::uint32_t actions = settings_.critic.actions;
    if (!(action >= 0 && action < actions))
      throw wend::Error(WEND_E_ARGUMENT, {},
                        "an action: expected 0.." + std::to_string(actions - 1) + ", found " + std::to_string(action));
    if (!std::isfinite(outcome.reward))
      throw wend::Error(WEND_E_ARGUMENT, {}, "a reward: expected a finite number, found NaN or infinity");
    features_.read(batch.observations[i], state_);
    features_.read(batch.next_observations[i], next_);
    const auto a = static_cast<std::uint32_t>(action);
    const bool collided = (outcome.flags & WEND_COLLIDED) != 0;
    if (cooperation_.needs_advice() && !collided &&
        features_.goal_distance(batch.next_observations[i]) < features_.goal_distance(batch.observations[i]))
      d2_.add(state_, a, outcome.reward, next_, false);
    double square = 0;
    for (std::size_t f = 0; f < state_.size(); ++f) square += (next_[f] - state_[f]) * (next_[f] - state_[f]);
    const bool ended = (outcome.flags & WEND_TERMINATED) != 0;
    if (collided ? settings_.reject_collisions : !ended && !(std::sqrt(square) > settings_.theta)) return 0;
    d1_.add(state_, a, outcome.reward, next_, ended);
    if (++fresh_ >= settings_.retrain_every) train(settings_.sweeps);
    return 1;
  }

  // Step 2.
  void train(std::uint32_t sweeps) {
    critic_.train(d1_, sweeps);
    if (cooperation_.needs_advice()) adviser_.train(d2_);
    fresh_ = 0;
    ++trainings_;
  }

  std::string signature() const {
    return "wend.lssvm_q 1: " + std::to_string(features_.size()) + " features, " +
           std::to_string(settings_.critic.actions) + " actions";
  }
  std::vector<double> constants() const {
    std::vector<double> all = features_.constants();
    const CriticSettings& c = settings_.critic;
    all.insert(all.end(), {c.sigma, c.c, c.action_distance, c.ordinal ? 1.0 : 0.0, settings_.advice_c});
    return all;
  }

  Features features_;
  Settings settings_;
  std::uint32_t robots_;
  Window d1_, d2_;
  Critic critic_;
  Adviser adviser_;
  Cooperation cooperation_;
  double temperature_;
  std::uint64_t episodes_ = 0, steps_ = 0;   // exploring ones: begun, decisions taken
  std::uint64_t fresh_ = 0, trainings_ = 0;  // samples since the last training
  std::vector<Row> rows_;
  std::vector<double> state_, next_, worth_;
  wend::Columns told_;
};

}  // namespace lssvm

WEND_PLUGIN(wend::component<lssvm::LssvmQ>("wend.lssvm_q"))
