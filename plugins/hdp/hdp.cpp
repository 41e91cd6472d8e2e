// wend.hdp: action-dependent heuristic dynamic programming for path finding and obstacle avoidance.
//   The paper: see README.md; equation numbers are its own.  The method: J. Si, Y.-T. Wang, On-line learning control by
//   association and reinforcement, IEEE Transactions on Neural Networks 12(2), 2001, 264-276.
//
//   symbol         here                     meaning
//   X(t)           Navigation::look()       state: x_1..x_5, theta                            (14)-(17)
//   u(t)           Agent::u()               the actor's output; its sign is the action         (18)
//   J(t)           Agent::J()               the critic's output                                (1), (2)
//   r(t)           wend.seek_and_avoid      reinforcement                                      (19)-(21)
//   e_a, l_a, N_a  ActorTask                the actor's error, rate and iterations             (3)-(7)
//   e_c, l_c, N_c  CriticTask               the critic's error, rate and iterations            (9)-(13)
//   alpha, U_c     Settings                 discount factor; what J is driven to
#include <limits>
#include <optional>
#include <wend/plugin.hpp>

#include "actions.hpp"
#include "agent.hpp"
#include "reward.hpp"
#include "trials.hpp"

namespace hdp {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// The sensor that each sensor becomes in the mirror.
std::vector<std::size_t> mirror_of(const Navigation& navigation) {
  std::vector<std::size_t> image(navigation.sensors(), navigation.sensors());
  for (std::size_t i = 0; i < image.size(); ++i)
    for (std::size_t k = 0; k < image.size(); ++k)
      if (std::fabs(navigation.bearing(i) + navigation.bearing(k)) < 1e-9) image[i] = k;
  for (std::size_t i = 0; i < image.size(); ++i)
    if (image[i] == image.size())
      throw wend::parameter_error(
          "fold", "range column " + std::to_string(i) + ": expected another at the opposite bearing, found none");
  return image;
}

// The state X(t) from an observation: that of navigation, or columns divided by their scales.
class Inputs {
 public:
  Inputs(const wend::Config& config, const Settings& settings) {
    const std::vector<std::string> observe = config.params.texts("observe");
    if (observe.empty()) {
      if (!config.params.numbers("scales").empty())
        throw wend::parameter_error("scales", "expected none beside the navigation state, found " +
                                                  std::to_string(config.params.numbers("scales").size()) +
                                                  "; they divide the columns of observe");
      navigation_.emplace(config.observation, config.params, settings.theta);
      if (settings.fold) image_ = mirror_of(*navigation_);
      return;
    }
    if (settings.fold) throw wend::parameter_error("fold", "expected the navigation state, found observed columns");
    columns_ = wend::Reading(config.observation, observe, "observe");
    scales_ = config.params.numbers("scales");
    if (scales_.empty()) scales_.assign(columns_.size(), 1);
    if (scales_.size() != columns_.size())
      throw wend::parameter_error("scales", "expected one for each of the " + std::to_string(columns_.size()) +
                                                " observed columns, found " + std::to_string(scales_.size()));
  }

  std::size_t size() const noexcept { return navigation_ ? navigation_->size() : columns_.size(); }
  const Navigation* navigation() const noexcept { return navigation_ ? &*navigation_ : nullptr; }
  // Returns the side that u is meant for: -1 where x is the mirror image of what is seen, else 1.
  double look(std::span<const double> observation, std::span<double> x) const {
    if (!navigation_) {
      for (std::size_t i = 0; i < x.size(); ++i) x[i] = columns_(observation, i) / scales_[i];
      return 1;
    }
    navigation_->look(observation, x);
    if (image_.empty() || x.back() >= 0) return 1;
    for (std::size_t i = 0; i < image_.size(); ++i)
      if (image_[i] > i) std::swap(x[i], x[image_[i]]);
    x.back() = -x.back();
    return -1;
  }

 private:
  std::optional<Navigation> navigation_;
  wend::Reading columns_;
  std::vector<double> scales_;
  std::vector<std::size_t> image_;  // empty: nothing is seen in a mirror
};

struct Row {
  std::uint32_t mode = WEND_TEST;
  std::uint64_t noise_key = 0, steps = 0;
  bool diverged = false;
  double u = 0, J = none, r = none;  // of the last decision; u as if from the side that x is seen from
  double side = 1;
  std::vector<double> x;
};

class Hdp {
 public:
  explicit Hdp(const wend::Config& config)
      : host_(config.host()),
        settings_(settings_from(config.params)),
        tie_(tie_of(config.params.text("tie"))),
        inputs_(config, settings_),
        agent_(inputs_.size(), settings_),
        trials_(settings_),
        weights_key_(wend::stream(config.seed(), "weights")),
        rows_(config.rows()),
        next_(inputs_.size()) {
    read_actions(config, actions_);
    for (Row& row : rows_) row.x.resize(inputs_.size());
    draw();
    step_.box("J", "1").box("r", "1").box("u", "1", -1, 1);
    episode_.box("trials_to_success", "1", 1).box("trials_to_learn", "1", 1).box("crashes_before_success", "1", 0);
    for (const char* name :
         {"learned", "trials", "crashes", "timeouts", "diverged", "redraws", "actor_norm", "critic_norm"})
      update_.box(name, "1", 0);
  }

  void begin(wend::Rows rows, wend::Episodes episodes) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Row& row = rows_[rows[i]];
      row.mode = episodes[i].mode;
      row.noise_key = wend::stream(episodes[i].seed, "hdp");
      row.steps = 0;
      row.diverged = false;
      row.J = row.r = none;
      if (loaded_ && row.mode == WEND_TRAIN_EXPLORE) loaded_ = false, trials_.count_anew();
    }
  }

  void act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Row& row = rows_[rows[i]];
      row.side = inputs_.look(observations[i], row.x);
      row.u = agent_.u(row.x);
      if (learns(row)) {
        if (row.steps == 0) row.J = agent_.J(row.x, agent_.seen(row.u));
        row.u += noise(row, row.steps);
      }
      actions[i][0] = action_of(row.side * row.u, actions_);
    }
  }

  std::uint64_t learn(const wend::Batch& batch) {
    std::uint64_t used = 0;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      Row& row = rows_[batch.rows[i]];
      if (row.mode != WEND_TRAIN_EXPLORE) continue;
      const wend_outcome& outcome = batch.outcomes[i];
      if (!std::isfinite(outcome.reward))
        throw wend::Error(WEND_E_ARGUMENT, {}, "a reward: expected a finite number, found NaN or infinity");
      row.r = outcome.reward;
      ++row.steps;
      if (learns(row)) {
        inputs_.look(batch.next_observations[i], next_);
        learn(row, outcome);
        ++used;
      }
      if (outcome.flags & (WEND_TERMINATED | WEND_TRUNCATED)) end_trial(row, outcome.flags);
    }
    return used;
  }

  void save(wend::Writer& writer) const {
    writer.put(signature());
    writer.put(std::uint64_t{redraws_});
    trials_.save(writer);
    for (const Network* network : {&agent_.actor, &agent_.critic}) {
      writer.put(std::span<const double>(network->first));
      writer.put(std::span<const double>(network->second));
    }
  }

  void load(wend::Reader& reader) {
    reader.expect(signature());
    const auto redraws = reader.get<std::uint64_t>();
    Trials trials = trials_;
    trials.load(reader);
    Network actor = agent_.actor, critic = agent_.critic;
    for (auto& [network, name] : {std::pair{&actor, "actor"}, std::pair{&critic, "critic"}}) {
      for (std::vector<double>* layer : {&network->first, &network->second}) {
        const std::vector<double> weights = reader.get_all<double>();
        if (weights.size() != layer->size())
          throw wend::damaged_state(std::string(name) + ": expected " + std::to_string(layer->size()) +
                                    " weights of a layer, found " + std::to_string(weights.size()));
        *layer = weights;
      }
      if (!network->padded_with_zeros())
        throw wend::damaged_state(std::string(name) + ": expected zeros beyond the hidden units, found others");
      if (!network->finite())
        throw wend::damaged_state(std::string(name) + ": expected finite weights, found another " +
                                  network->where_not_finite());
    }
    reader.end();
    agent_.actor = std::move(actor), agent_.critic = std::move(critic);
    trials_ = std::move(trials);
    redraws_ = redraws;
    loaded_ = true;
  }

  const wend::Columns* telemetry(std::uint32_t when) const {
    return when == WEND_PER_STEP ? &step_ : when == WEND_PER_EPISODE ? &episode_ : &update_;
  }

  void read(std::uint32_t when, wend::Rows rows, wend::Matrix<double> out) {
    if (when == WEND_PER_UPDATE) return tell(out[0]);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Row& row = rows_[rows[i]];
      if (when == WEND_PER_STEP) {
        out[i][0] = agent_.J(row.x, agent_.seen(row.u));
        out[i][1] = row.mode == WEND_TRAIN_EXPLORE ? row.r
                    : inputs_.navigation()         ? reinforcement(row.x, tie_, usual_beta)
                                                   : none;
        out[i][2] = row.side * row.u;
      } else {
        out[i][0] = or_none(trials_.first_success());
        out[i][1] = or_none(trials_.learned_at());
        out[i][2] = trials_.first_success() ? static_cast<double>(trials_.crashes_before_success()) : none;
      }
    }
  }

 private:
  static double or_none(std::uint64_t n) noexcept { return n ? static_cast<double>(n) : none; }
  std::string signature() const {
    return "wend.hdp 1: " + std::to_string(inputs_.size()) + " inputs, " + std::to_string(settings_.hidden) +
           " hidden units" + (settings_.critic_products ? ", critic with products" : "") +
           (settings_.critic_bias ? ", critic with a bias" : "");
  }

  bool learns(const Row& row) const noexcept {
    return row.mode == WEND_TRAIN_EXPLORE && !row.diverged && !trials_.stopped();
  }
  // Of decision `step` of this row's trial, whatever was drawn before.
  double noise(const Row& row, std::uint64_t step) const {
    return trials_.noise() > 0 ? trials_.noise() * wend::Random(row.noise_key, step).normal() : 0;
  }
  double rate(double base, const Row& row) const noexcept {
    if (settings_.rate_drop == 0) return base;
    const auto drops = static_cast<double>((row.steps - 1) / settings_.rate_every);
    return std::max(base - settings_.rate_drop * drops, std::min(base, settings_.rate_floor));
  }

  void learn(Row& row, const wend_outcome& outcome) {
    Step step{row.x,
              agent_.seen(row.u),
              outcome.reward,
              next_,
              noise(row, row.steps),
              row.J,
              (outcome.flags & WEND_COLLIDED) != 0,
              (outcome.flags & WEND_ARRIVED) != 0,
              rate(settings_.l_a * trials_.factor_a(), row),
              rate(settings_.l_c * trials_.factor_c(), row)};
    row.J = agent_.learn(step);
    if (!agent_.actor.finite() || !agent_.critic.finite()) diverge(row);
  }

  // Says where, and lets nothing more be learned in this trial.
  void diverge(Row& row) {
    const bool by_actor = !agent_.actor.finite();
    const std::string where = "trial " + std::to_string(trials_.count() + 1) + ", step " + std::to_string(row.steps) +
                              ": " + (by_actor ? "the actor's " : "the critic's ") +
                              (by_actor ? agent_.actor : agent_.critic).where_not_finite() +
                              " is no longer a finite number";
    if (settings_.divergence_is_error)
      throw wend::parameter_error(by_actor ? "l_a" : "l_c",
                                  where + "; lower l_a and l_c, or set clip, normalise or on_divergence: redraw");
    host_->log(host_, 2, (where + "; the trial counts as failed and all weights are drawn anew").c_str());
    row.diverged = true;
    draw();
  }

  void end_trial(const Row& row, std::uint32_t flags) {
    const Ending ending = row.diverged              ? Ending::diverged
                          : flags & WEND_ARRIVED    ? Ending::success
                          : flags & WEND_COLLIDED   ? Ending::crash
                          : flags & WEND_TERMINATED ? Ending::crash
                                                    : Ending::timeout;
    if (!trials_.add(ending, row.steps)) return;
    if (ending != Ending::diverged) draw();
    trials_.start_over();
  }

  void draw() {
    wend::Random random(wend::stream(weights_key_, redraws_++));
    agent_.draw(random);
  }

  void tell(std::span<double> out) const {
    std::size_t i = 0;
    for (const std::uint64_t n : {std::uint64_t{trials_.learned()}, trials_.count(), trials_.crashes(),
                                  trials_.timeouts(), trials_.diverged(), redraws_ - 1})
      out[i++] = static_cast<double>(n);
    out[i++] = agent_.actor.norm();
    out[i] = agent_.critic.norm();
  }

  const wend_host* host_;
  Settings settings_;
  Tie tie_;
  Inputs inputs_;
  Agent agent_;
  Trials trials_;
  double actions_[3] = {0, 1, 2};  // for u > 0, u = 0, u < 0
  std::uint64_t weights_key_, redraws_ = 0;
  bool loaded_ = false;
  std::vector<Row> rows_;
  std::vector<double> next_;
  wend::Columns step_, episode_, update_;
};

}  // namespace
}  // namespace hdp

WEND_PLUGIN(wend::component<hdp::Hdp>("wend.hdp"), wend::component<hdp::SeekAndAvoid>("wend.seek_and_avoid"))
