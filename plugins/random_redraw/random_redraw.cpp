// wend.random_redraw: what wend.hdp has to beat.  The same actor on the same state, which never learns: after a failed
// trial its weights are drawn anew, after a success they stay.
#include <limits>
#include <wend/plugin.hpp>

#include "../hdp/actions.hpp"
#include "../hdp/navigation.hpp"
#include "../hdp/network.hpp"

namespace random_redraw {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

class RandomRedraw {
 public:
  explicit RandomRedraw(const wend::Config& config)
      : navigation_(config.observation, config.params, hdp::theta_of(config.params.text("theta"))),
        gain_(config.params.number("gain")),
        bound_(config.params.number("weights")),
        criterion_(config.params.count("criterion")),
        stop_after_(config.params.count("stop_after")),
        key_(wend::stream(config.seed(), "weights")),
        actor_(navigation_.size(), config.params.count("hidden")),
        modes_(config.rows()),
        x_(navigation_.size()) {
    hdp::read_actions(config, actions_);
    hdp::check_criterion(criterion_, stop_after_);
    draw();
    episode_.box("trials_to_success", "1", 1).box("trials_to_learn", "1", 1).box("crashes_before_success", "1", 0);
    for (const char* name : {"learned", "trials", "crashes", "redraws"}) update_.box(name, "1", 0);
  }

  void begin(wend::Rows rows, wend::Episodes episodes) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      modes_[rows[i]] = episodes[i].mode;
      if (loaded_ && episodes[i].mode == WEND_TRAIN_EXPLORE) loaded_ = false, counts_ = {};
    }
  }

  void act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      navigation_.look(observations[i], x_);
      actions[i][0] = hdp::action_of(hdp::actor_output(actor_, x_, gain_), actions_);
    }
  }

  // Sees how trials end, and learns from nothing.
  std::uint64_t learn(const wend::Batch& batch) {
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const std::uint32_t flags = batch.outcomes[i].flags;
      if (modes_[batch.rows[i]] == WEND_TRAIN_EXPLORE && (flags & (WEND_TERMINATED | WEND_TRUNCATED))) end_trial(flags);
    }
    return 0;
  }

  void save(wend::Writer& writer) const {
    writer.put(signature());
    for (const std::uint64_t n : {counts_.trials, counts_.row, counts_.first, counts_.learned_at, counts_.crashes,
                                  counts_.crashes_before, redraws_})
      writer.put(n);
    writer.put(std::span<const double>(actor_.first));
    writer.put(std::span<const double>(actor_.second));
  }

  void load(wend::Reader& reader) {
    reader.expect(signature());
    Counts counts;
    std::uint64_t redraws = 0;
    for (std::uint64_t* n : {&counts.trials, &counts.row, &counts.first, &counts.learned_at, &counts.crashes,
                             &counts.crashes_before, &redraws})
      *n = reader.get<std::uint64_t>();
    hdp::Network actor = actor_;
    for (std::vector<double>* layer : {&actor.first, &actor.second}) {
      const std::vector<double> weights = reader.get_all<double>();
      if (weights.size() != layer->size())
        throw wend::damaged_state("expected " + std::to_string(layer->size()) + " weights of a layer, found " +
                                  std::to_string(weights.size()));
      *layer = weights;
    }
    reader.end();
    if (!actor.padded_with_zeros()) throw wend::damaged_state("expected zeros beyond the hidden units, found others");
    if (!actor.finite())
      throw wend::damaged_state("expected finite weights, found another " + actor.where_not_finite());
    actor_ = std::move(actor);
    counts_ = counts;
    redraws_ = redraws;
    loaded_ = true;
  }

  const wend::Columns* telemetry(std::uint32_t when) const {
    return when == WEND_PER_EPISODE ? &episode_ : when == WEND_PER_UPDATE ? &update_ : nullptr;
  }
  void read(std::uint32_t when, wend::Rows rows, wend::Matrix<double> out) const {
    if (when == WEND_PER_UPDATE) {
      out[0][0] = counts_.learned_at != 0;
      out[0][1] = static_cast<double>(counts_.trials);
      out[0][2] = static_cast<double>(counts_.crashes);
      out[0][3] = static_cast<double>(redraws_ - 1);
      return;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      out[i][0] = counts_.first ? static_cast<double>(counts_.first) : none;
      out[i][1] = counts_.learned_at ? static_cast<double>(counts_.learned_at) : none;
      out[i][2] = counts_.first ? static_cast<double>(counts_.crashes_before) : none;
    }
  }

 private:
  struct Counts {  // of trials; `first` and `learned_at` are numbers of trials, 0: none yet
    std::uint64_t trials = 0, row = 0, first = 0, learned_at = 0, crashes = 0, crashes_before = 0;
  };

  std::string signature() const {
    return "wend.random_redraw 1: " + std::to_string(actor_.inputs) + " inputs, " + std::to_string(actor_.hidden) +
           " hidden units";
  }

  void end_trial(std::uint32_t flags) {
    ++counts_.trials;
    if (stop_after_ != 0 && counts_.row >= stop_after_) return;
    if (flags & WEND_ARRIVED) {
      if (counts_.first == 0) counts_.first = counts_.trials;
      if (++counts_.row >= criterion_ && counts_.learned_at == 0) counts_.learned_at = counts_.trials;
      return;
    }
    counts_.row = 0;
    if (flags & WEND_COLLIDED) {
      ++counts_.crashes;
      counts_.crashes_before += counts_.first == 0;
    }
    draw();
  }

  void draw() {
    wend::Random random(wend::stream(key_, redraws_++));
    actor_.draw(random, bound_);
  }

  hdp::Navigation navigation_;
  double gain_, bound_;
  double actions_[3] = {0, 1, 2};
  std::uint64_t criterion_, stop_after_, key_, redraws_ = 0;
  hdp::Network actor_;
  Counts counts_;
  bool loaded_ = false;
  std::vector<std::uint32_t> modes_;
  std::vector<double> x_;
  wend::Columns episode_, update_;
};

}  // namespace
}  // namespace random_redraw

WEND_PLUGIN(wend::component<random_redraw::RandomRedraw>("wend.random_redraw"))
