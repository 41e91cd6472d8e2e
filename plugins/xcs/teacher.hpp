// A learner that goes before XCS and leaves it its policy as rules (the paper's section 3.3, step 1).
//
// At first the teacher acts and learns for `teacher_episodes` episodes.  Then it acts greedily for `teacher_collect`
// more, and the distinct strings that it visits are collected, each with a few of the observations behind it.  Then
// every string becomes a rule for each action: what the teacher expects on average, the spread of that as the error.
// From then on the teacher is silent.  One that arrives trained needs no episodes of its own but those of collecting.
#pragma once
#include <cstdint>
#include <map>
#include <vector>
#include <wend/bytes.hpp>
#include <wend/config.hpp>
#include <wend/refs.hpp>

#include "encoder.hpp"
#include "paper_operators.hpp"
#include "population.hpp"

namespace xcs {

struct TeacherOptions {
  std::uint64_t episodes = 0, collect = 0;
  bool all_strings = false;               // strings of its learning episodes too, not only of greedy ones
  std::uint64_t observations = 4;         // kept of a string
  double experience = 20, fitness = 0.5;  // of a seeded rule
  bool merges = true;
  double merge_tolerance = 0;
};

class Teacher {
 public:
  Teacher(const wend::Config& config, wend::Slot slot, const Encoder& encoder, std::uint32_t actions);

  bool acting() const noexcept { return !progress_.seeded; }
  // Its episodes are over and its strings wait to become rules.
  bool ready() const noexcept {
    return !progress_.seeded && progress_.taught >= options_.episodes && progress_.collected >= options_.collect;
  }

  void begin(wend::Rows rows, wend::Episodes episodes);
  void act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) const;
  // Returns how many transitions it learned from; keeps their strings where it is time.
  std::uint64_t learn(const wend::Batch& batch);

  // Makes the rules; `limit` is the population's N.
  void seed(Population& population, double limit, double stamp) const;
  void seeded() { progress_.seeded = true, progress_.strings.clear(); }
  std::size_t strings() const noexcept { return progress_.strings.size(); }

  using String = std::vector<std::uint64_t>;
  struct Progress {                           // how far it is, as a state keeps it
    std::uint64_t taught = 0, collected = 0;  // episodes
    bool seeded = false;
    std::map<String, std::vector<double>> strings;  // -> observations, n x width
  };
  void save(wend::Writer& writer) const;
  Progress read_progress(wend::Reader& reader) const;
  void restore(Progress progress) { progress_ = std::move(progress); }

 private:
  void keep(std::span<const double> observation);

  const Encoder& encoder_;
  std::uint32_t actions_, robots_;
  std::size_t width_;  // of an observation
  TeacherOptions options_;
  wend::PolicyRef policy_;
  wend::LearnerRef learner_;
  wend::ValuesRef values_;
  Progress progress_;
  bool greedy_ = false;  // this episode is one of collecting
  bool learns_ = false;  // this one is one of learning
  mutable String string_;
};

}  // namespace xcs
