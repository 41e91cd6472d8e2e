// XCS: an accuracy-based classifier system (Wilson 1995; Butz & Wilson 2002) with exchangeable operators.
#pragma once
#include <functional>

#include "learner.hpp"
#include "teacher.hpp"

namespace xcs {

class Xcs : public Learner {
 public:
  explicit Xcs(const wend::Config& config) : Xcs(config, "wend.xcs") {}
  void begin(wend::Rows rows, wend::Episodes episodes);
  void act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions);
  std::uint64_t learn(const wend::Batch& batch);
  void finish();

 protected:
  Xcs(const wend::Config& config, const std::string& name);

 private:
  std::unique_ptr<Discovery> make_discovery() const override { return make_(); }
  void decide(std::uint32_t index, std::span<const double> observation);
  bool find_acted(Row& row, Base& base, std::span<const double> observation, std::uint32_t action);
  double best_after(Row& row, Base& base, std::span<const double> next);
  struct Transition {  // one of an episode that is learned from when it is over
    std::vector<double> observation, next;
    std::uint32_t action;
    double reward;
    std::uint32_t flags;
  };
  bool take(std::uint32_t index, const Transition& transition, double& after);
  void replay(std::uint32_t index);
  void seed_from_teacher();
  void save_more(wend::Writer& writer) const override;
  std::function<void()> load_more(wend::Reader& reader) override;

  std::function<std::unique_ptr<Discovery>()> make_;
  Predictions predictions_;
  double trace_;  // lambda
  // [M] of the transition learned from last: in a replay, that of the next one's s'.  Good while no rule has come or
  // gone.
  struct Held {
    const Base* base = nullptr;
    std::uint64_t version = 0;  // of the population then
    std::vector<std::uint64_t> state;
    RuleSet match;
  } held_;
  std::vector<std::vector<Transition>> course_;  // by row
  std::unique_ptr<Teacher> teacher_;
};

// The same with the paper's operators by default: a manifest entry of its own, and states of its own.
class Lcs : public Xcs {
 public:
  explicit Lcs(const wend::Config& config) : Xcs(config, "wend.lcs") {}
};

}  // namespace xcs
