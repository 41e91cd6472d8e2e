#include <core/base/files.hpp>
#include <core/experiment/streams.hpp>
#include <core/run/curves.hpp>
#include <core/run/failure.hpp>
#include <core/run/rollout.hpp>
#include <core/run/selection.hpp>
#include <core/run/telemetry.hpp>
#include <core/run/tracer.hpp>
#include <core/run/training.hpp>

#include <cstring>
#include <limits>

namespace wend::core {
namespace {

constexpr std::uint64_t fruitless_episodes = 2000;  // a budget in samples that no episode adds to is never spent

class TrainingRun : public Rollout::Observer {
 public:
  TrainingRun(const Training& training, const std::string& initial, const std::string& initial_name, const WorkOptions& options)
      : training_(training), options_(options), listener_(listening(options)) {
    if (training.worlds.empty()) throw UnitFailed("training", "expected at least one training world, found none");
    for (std::size_t i = 0; i < training.worlds.size(); ++i)
      stages_.push_back(std::make_unique<Stage>(training.worlds[i], training.driver, training.streams[i], stage_options()));
    driver_ = std::make_unique<Driver>(training.driver, *stages_.front());
    if (!driver_->learns()) throw UnitFailed("rule", "policy (" + training.driver.policy.type + "): expected the interface wend.learner/1, found none");
    if (!initial.empty()) driver_->load(initial, initial_name);
    for (auto& stage : stages_) {
      require_same_spaces(*stage);
      rollouts_.push_back(std::make_unique<Rollout>(*stage, *driver_, *this));
      metrics_.push_back(std::make_unique<Telemetry>(WEND_PER_EPISODE, stage.get(), driver_.get()));
      tracers_.push_back(std::make_unique<Tracer>(*stage, *driver_, training.traced_episodes, about(training, tracers_.size())));
    }
    updates_ = std::make_unique<Telemetry>(WEND_PER_UPDATE, nullptr, driver_.get());
    until_ = until();
  }

  TrainingResult run() {
    const double before = thread_seconds();
    while (pending_ < training_.snapshots.size() && training_.snapshots[pending_] == 0) snapshot(training_.snapshots[pending_++]);
    while (goes_on()) {
      episode(WEND_TRAIN_EXPLORE);
      const std::uint32_t every = training_.greedy_every;
      if (every && result_.episodes % every == 0 && goes_on()) episode(WEND_TRAIN_GREEDY);
    }
    while (pending_ < training_.snapshots.size()) snapshot(training_.snapshots[pending_++]);  // that it ended before
    result_.final_state = file_name("final");
    write_file(options_.scratch + "/" + result_.final_state, final_state());
    result_.train_s = thread_seconds() - before;
    result_.hash = chain_.digest();
    result_.curves = book_.take();
    return std::move(result_);
  }

  void started(std::uint32_t copy) override { tracers_[world_]->started(copy, driven_ - 1); }
  void stepped(const Rollout& rollout) override { tracers_[world_]->stepped(rollout); }

  void ended(const Rollout& rollout, const std::vector<std::uint32_t>& rows) override {
    const Telemetry& metrics = *metrics_[world_];
    const std::vector<double> values = metrics.names().empty() ? std::vector<double>() : metrics.read(rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const RowRecord& record = rollout.record(rows[i]);
      std::optional<std::uint32_t> robot;
      if (rollout.stage().robots() > 1) robot = rows[i] % rollout.stage().robots();
      const bool greedy = mode_ == WEND_TRAIN_GREEDY;
      const auto x = static_cast<double>(result_.episodes + (greedy ? 0 : 1));
      const auto add = [&](const std::string& name, double y) { book_.add(name, "train_episodes", robot, x, y); };
      add(greedy ? "greedy_return" : "return", record.reward);
      add(greedy ? "greedy_episode_steps" : "episode_steps", static_cast<double>(record.steps));
      add(greedy ? "greedy_success" : "train_success", record.flags & WEND_ARRIVED ? 1 : 0);
      for (std::size_t k = 0; k < metrics.names().size(); ++k) add(metrics.names()[k], values[i * metrics.names().size() + k]);
    }
  }

 private:
  StageOptions stage_options() const { return {options_.libraries, &listener_, 1}; }

  Listener listening(const WorkOptions& options) {
    Listener listener = options.listener ? *options.listener : Listener{};
    listener.series = [this](const std::string&, const char* x_name, double x, const char* y_name, double y) {
      if (x_name && y_name) book_.add(y_name, x_name, std::nullopt, x, y);
    };
    return listener;
  }

  // One driver serves all training worlds, so they must show it the same columns and take the same actions.
  void require_same_spaces(const Stage& stage) const {
    const auto same = [](const wend_space& a, const wend_space& b) {
      if (a.width != b.width) return false;
      for (std::uint32_t i = 0; i < a.width; ++i)
        if (std::strcmp(a.columns[i].name, b.columns[i].name) != 0 || a.columns[i].count != b.columns[i].count) return false;
      return true;
    };
    if (!same(stage.observation(), stages_.front()->observation()) || !same(stage.action(), stages_.front()->action()))
      throw UnitFailed("rule", "training worlds: expected the same observation and action columns in all of them, found others in " + stage.world().type());
  }

  // The x of curves against what was spent: a budget in episodes counts what other curves count.
  std::string counter() const { return training_.budget.unit == "episodes" ? "train_episodes" : training_.budget.unit; }

  std::uint64_t spent() const {
    if (training_.budget.unit == "samples") return result_.samples;
    return training_.budget.unit == "steps" ? result_.steps : result_.episodes;
  }

  // A greedy episode shows what was learned so far; it is not one of the budget.
  void episode(std::uint32_t mode) {
    const std::uint64_t index = driven_++;
    // Each kind visits all worlds and variants in turn, whatever the other one does between.
    const std::uint64_t turn = mode == WEND_TRAIN_GREEDY ? greedy_++ : result_.episodes;
    mode_ = mode;
    world_ = turn % training_.worlds.size();
    const WorldSpec& world = training_.worlds[world_];
    const auto variant = static_cast<std::uint32_t>(turn / training_.worlds.size() % world.variants);
    Rollout& rollout = *rollouts_[world_];
    rollout.start({0}, {episode_of(training_.streams[world_], world, variant, index, mode)});
    const std::uint64_t before = result_.samples;
    bool stopped = false;
    while (!rollout.idle()) {
      result_.samples += rollout.step(true);
      result_.steps += rollout.rows().size();
      if (training_.budget.unit == "episodes") continue;
      take_due_snapshots();
      if (spent() >= training_.budget.amount) {
        stopped = true;
        break;
      }
    }
    const std::string digest = rollout.digest(0);
    chain_.add(digest.data(), digest.size());
    if (stopped && !rollout.idle()) return;  // an episode that ended with the budget counts
    if (auto trace = tracers_[world_]->finish(0)) keep_trace(std::move(*trace), index, variant);
    if (mode == WEND_TRAIN_GREEDY) return;
    ++result_.episodes;
    report_updates();
    take_due_snapshots();
    fruitless_ = result_.samples > before ? 0 : fruitless_ + 1;
    if (training_.budget.unit == "samples" && fruitless_ >= fruitless_episodes)
      throw UnitFailed("training", "policy (" + training_.driver.policy.type + "): a budget of " + std::to_string(training_.budget.amount) +
                                       " samples, but " + std::to_string(fruitless_) + " episodes on end brought none; found " +
                                       std::to_string(result_.samples) + " so far");
  }

  void report_updates() {
    if (updates_->names().empty()) return;
    const std::vector<double> values = updates_->read();
    for (std::size_t i = 0; i < values.size(); ++i) {
      book_.add(updates_->names()[i], "train_episodes", std::nullopt, static_cast<double>(result_.episodes), values[i]);
      if (i == until_ && values[i] >= 1) reached_ = true;
    }
  }

  bool goes_on() const { return !reached_ && spent() < training_.budget.amount; }

  // The place of the value that ends the training, told by the policy or by what stands in its slots ("avoid.learned").
  std::size_t until() const {
    if (training_.until.empty()) return none;
    const auto& names = updates_->names();
    std::string known;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == training_.until || names[i].ends_with("." + training_.until)) return i;
      known += (i ? ", " : "") + names[i];
    }
    throw UnitFailed("training", "until: expected the name of a value that the policy tells after an episode, found \"" + training_.until +
                                     "\"; it tells " + (known.empty() ? "none" : known));
  }

  void take_due_snapshots() {
    while (pending_ < training_.snapshots.size() && spent() >= training_.snapshots[pending_]) snapshot(training_.snapshots[pending_++]);
  }

  // What a test would use at this point: the learner's state, finished in a copy, so that learning itself goes on unchanged.
  std::string finished() {
    Driver copy(training_.driver, *stages_.front());
    copy.load(driver_->save(), "the learner's own state");
    copy.finish();
    const Telemetry told(WEND_PER_UPDATE, nullptr, &copy);
    if (!told.names().empty()) {
      const std::vector<double> values = told.read();
      for (std::size_t i = 0; i < values.size(); ++i)
        book_.add(told.names()[i], counter(), std::nullopt, static_cast<double>(spent()), values[i]);
    }
    return copy.save();
  }

  void snapshot(std::uint64_t at) {
    const std::string bytes = finished();
    const std::string file = file_name(std::to_string(at));
    write_file(options_.scratch + "/" + file, bytes);
    result_.snapshots[at] = file;
    chain_.add(bytes.data(), bytes.size());
    if (training_.keep == "best") kept_.consider(bytes, training_, options_);
  }

  std::string final_state() {
    const std::string bytes = finished();
    chain_.add(bytes.data(), bytes.size());
    if (training_.keep != "best") return bytes;
    kept_.consider(bytes, training_, options_);
    return kept_.best();
  }

  static Json about(const Training& training, std::size_t world) {
    return {{"arm", training.driver.arm}, {"world", training.worlds[world].id}, {"seed", training.streams[world].seed},
            {"point", training.point}, {"training", true}};
  }

  void keep_trace(Trace trace, std::uint64_t index, std::uint32_t variant) {
    trace.about["variant"] = variant;
    const std::string file = training_.id.substr(0, 24) + "-t" + std::to_string(index) + ".npz";
    write_trace(options_.scratch + "/" + file, trace);
    result_.traces[index] = file;
  }

  std::string file_name(const std::string& at) const { return training_.id.substr(0, 24) + "-" + at + ".state"; }

  const Training& training_;
  const WorkOptions& options_;
  Listener listener_;
  CurveBook book_;
  std::vector<std::unique_ptr<Stage>> stages_;
  std::unique_ptr<Driver> driver_;
  std::vector<std::unique_ptr<Rollout>> rollouts_;
  std::vector<std::unique_ptr<Telemetry>> metrics_;
  std::vector<std::unique_ptr<Tracer>> tracers_;
  std::unique_ptr<Telemetry> updates_;
  Selection kept_;
  TrainingResult result_;
  Chain chain_;
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::size_t pending_ = 0, world_ = 0, until_ = none;
  bool reached_ = false;  // what `until` waits for
  std::uint32_t mode_ = WEND_TRAIN_EXPLORE;  // of the episode that runs
  std::uint64_t driven_ = 0, greedy_ = 0, fruitless_ = 0;  // episodes: all; of them greedy; the last ones without a sample
};

}  // namespace

TrainingResult run_training(const Training& training, const std::string& initial, const std::string& initial_name,
                            const WorkOptions& options) {
  TrainingRun run(training, initial, initial_name, options);
  return run.run();
}

}  // namespace wend::core
