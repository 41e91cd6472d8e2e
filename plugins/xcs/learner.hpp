// What all three learners share: encoded observations, rule bases for the robots, exploration, states, telemetry.
#pragma once
#include <functional>
#include <memory>
#include <vector>
#include <wend/plugin.hpp>

#include "discovery.hpp"
#include "encoder.hpp"
#include "parameters.hpp"

namespace xcs {

class Learner {
 public:
  Learner(const wend::Config& config, const std::string& name);
  Learner(const Learner&) = delete;
  Learner& operator=(const Learner&) = delete;
  virtual ~Learner() = default;

  void begin(wend::Rows rows, wend::Episodes episodes);
  void save(wend::Writer& writer) const;
  void load(wend::Reader& reader);

  const wend::Columns* telemetry(std::uint32_t when) const;
  void read(std::uint32_t when, wend::Rows rows, wend::Matrix<double> out) const;
  // The row's last decision with the rules that took part, then the whole rule base, as a rule file or as JSON.
  void explain(std::uint32_t row, wend::Writer& writer) const;

 protected:
  struct Row {
    explicit Row(std::size_t words) : state(words), next(words) {}
    wend::Random random{0};  // all chance of its episode
    std::uint32_t mode = WEND_TEST;
    std::vector<std::uint64_t> state;  // the encoded observation of the last decision
    std::vector<std::uint64_t> next;   // scratch: the one that follows
    RuleSet acted;                     // [A], tracked by the population
    std::uint32_t action = 0;
    bool decided = false;   // state, acted and action belong together
    double prediction = 0;  // PA of the action
    double matching = 0;    // rules in [M]
  };
  struct Base {  // a rule base: one for all robots, or one for each
    Base(std::size_t bits, std::uint32_t actions) : population(bits, actions) {}
    Population population;
    std::unique_ptr<Discovery> discovery;  // none in ZCS
  };

  Base& base_of(std::uint32_t row) { return *bases_[bases_.size() == 1 ? 0 : row % bases_.size()]; }
  const Base& base_of(std::uint32_t row) const { return *bases_[bases_.size() == 1 ? 0 : row % bases_.size()]; }
  bool learns(const Row& row) const {
    return row.mode == WEND_TRAIN_EXPLORE || (row.mode == WEND_TRAIN_GREEDY && greedy_updates_);
  }
  // What a learner keeps besides its rule bases.  load_more() reads, and returns what takes it over.
  virtual void save_more(wend::Writer&) const {}
  virtual std::function<void()> load_more(wend::Reader&) {
    return [] {};
  }
  // New operators for one rule base; none where the learner has its own.
  virtual std::unique_ptr<Discovery> make_discovery() const = 0;

  std::uint32_t action_of(std::span<const double> action) const;
  // Greedy, or exploring as the parameters say; at random where [M] is empty.
  std::uint32_t choose(Row& row, const std::vector<double>& array);
  std::uint32_t draw_proportionally(Row& row, const std::vector<double>& array);
  static double checked_reward(double reward);
  void learned_one();  // counts, and publishes when it is time
  void tell_generation(const Population& population, double before) const;
  bool takes_nearest() const { return nearest_; }

  const wend_host* host_;
  std::string name_;
  Encoder encoder_;
  std::uint32_t actions_;
  Parameters parameters_;
  std::vector<std::unique_ptr<Base>> bases_;
  std::vector<Row> rows_;
  RuleSet match_;

 private:
  double exploration() const;
  void seed_from(const std::string& file);
  std::string signature() const;

  bool greedy_updates_, nearest_, proportional_, json_, published_;
  double exploration_, exploration_least_, exploration_episodes_;
  std::uint32_t robots_;
  std::uint64_t episodes_ = 0;  // exploring ones that began
  std::uint64_t publish_every_, series_every_, learned_ = 0;
  wend::Columns step_told_, update_told_;
};

// Mean over all micro-classifiers of their macro-classifier's fitness: near 1 where each niche has one accurate rule.
double mean_fitness(const Population& population);

std::uint32_t count_actions(const wend::Space& action);

}  // namespace xcs
