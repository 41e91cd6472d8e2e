// What became of the trials so far, and what that changes: noise, rates, and when all weights are drawn anew.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>
#include <wend/bytes.hpp>

#include "settings.hpp"

namespace hdp {

enum class Ending { success, crash, timeout, diverged };

class Trials {
 public:
  explicit Trials(const Settings& settings) : settings_(&settings) { start_over(); }

  // Counts a trial that ended; true where all weights are to be drawn anew.
  bool add(Ending ending, std::uint64_t steps) {
    ++count_;
    if (stopped()) return false;
    noise_ = std::max(noise_ * settings_->noise_decay, settings_->noise_floor);
    if (ending == Ending::success) return add_success(), false;
    row_ = 0;
    crashes_ += ending == Ending::crash, timeouts_ += ending == Ending::timeout,
        diverged_ += ending == Ending::diverged;
    if (ending == Ending::timeout) noise_ = std::max(noise_, settings_->timeout_noise);
    if (ending == Ending::crash && first_success_ == 0) ++crashes_before_;
    const bool stuck = add_length(steps);
    const Reinitialise when = settings_->reinitialise;
    return stuck || ending == Ending::diverged || when == Reinitialise::failure ||
           (ending == Ending::timeout && when == Reinitialise::timeout) ||
           (ending == Ending::crash && when == Reinitialise::crash);
  }

  // New weights are learned like the first ones.
  void start_over() {
    noise_ = settings_->noise;
    factor_a_ = factor_c_ = 1;
    lengths_.clear();
  }

  // A training that goes on from a saved state counts from its own beginning.
  void count_anew() {
    count_ = row_ = first_success_ = learned_at_ = 0;
    crashes_ = timeouts_ = diverged_ = crashes_before_ = 0;
    lengths_.clear();
  }

  bool learned() const noexcept { return learned_at_ != 0; }
  bool stopped() const noexcept { return settings_->stop_after != 0 && row_ >= settings_->stop_after; }
  std::uint64_t count() const noexcept { return count_; }
  std::uint64_t crashes() const noexcept { return crashes_; }
  std::uint64_t crashes_before_success() const noexcept { return crashes_before_; }
  std::uint64_t timeouts() const noexcept { return timeouts_; }
  std::uint64_t diverged() const noexcept { return diverged_; }
  std::uint64_t first_success() const noexcept { return first_success_; }  // number of that trial; 0: none yet
  std::uint64_t learned_at() const noexcept { return learned_at_; }        // of the trial that completed the criterion
  double noise() const noexcept { return noise_; }
  double factor_a() const noexcept { return factor_a_; }
  double factor_c() const noexcept { return factor_c_; }

  void save(wend::Writer& writer) const {
    for (const std::uint64_t n :
         {count_, row_, first_success_, learned_at_, crashes_, timeouts_, diverged_, crashes_before_})
      writer.put(n);
    for (const double value : {noise_, factor_a_, factor_c_}) writer.put(value);
    writer.put(std::span<const std::uint64_t>(lengths_));
  }
  void load(wend::Reader& reader) {
    for (std::uint64_t* n :
         {&count_, &row_, &first_success_, &learned_at_, &crashes_, &timeouts_, &diverged_, &crashes_before_})
      *n = reader.get<std::uint64_t>();
    for (double* value : {&noise_, &factor_a_, &factor_c_}) {
      *value = reader.get<double>();
      if (!(*value >= 0 && *value < 1e300)) throw wend::damaged_state("noise or rates are no numbers of 0 and more");
    }
    lengths_ = reader.get_all<std::uint64_t>();
  }

 private:
  void add_success() {
    if (first_success_ == 0) first_success_ = count_;
    if (++row_ >= settings_->criterion && learned_at_ == 0) learned_at_ = count_;
    noise_ = std::max(noise_ * settings_->success_noise, settings_->noise_floor);
    factor_a_ *= settings_->success_l_a, factor_c_ *= settings_->success_l_c;
    lengths_.clear();
  }

  // True where the last failed trials were all nearly as long.
  bool add_length(std::uint64_t steps) {
    if (settings_->similar_trials == 0) return false;
    lengths_.push_back(steps);
    if (lengths_.size() > settings_->similar_trials) lengths_.erase(lengths_.begin());
    const auto [least, most] = std::minmax_element(lengths_.begin(), lengths_.end());
    return lengths_.size() == settings_->similar_trials && *most - *least <= settings_->similar_steps;
  }

  const Settings* settings_;
  std::uint64_t count_ = 0, row_ = 0, first_success_ = 0, learned_at_ = 0;
  std::uint64_t crashes_ = 0, timeouts_ = 0, diverged_ = 0, crashes_before_ = 0;
  double noise_ = 0, factor_a_ = 1, factor_c_ = 1;
  std::vector<std::uint64_t> lengths_;  // of the last failed trials in a row
};

}  // namespace hdp
