// The loop that all of wend turns in: sense, act, step, sense, score, learn, for every row that has not ended.
#pragma once
#include <core/run/driver.hpp>
#include <core/run/stage.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace wend::core {

// Chains the bits of what one episode showed, did and brought; two runs agree iff the digests do.
class Chain {
 public:
  Chain();
  ~Chain();
  Chain(Chain&&) noexcept;
  Chain& operator=(Chain&&) noexcept;
  void reset();
  void add(const void* bytes, std::size_t n);
  std::string digest() const;  // 32 hexadecimal digits

 private:
  struct State;
  State* state_;
};

// What a rollout tells of one row.
struct RowRecord {
  wend_episode episode{};   // of the row
  std::uint64_t steps = 0;  // decisions
  double reward = 0;        // undiscounted sum
  std::uint32_t flags = 0;
  bool active = false;
};

class Rollout {
 public:
  struct Observer {
    virtual ~Observer() = default;
    virtual void started(std::uint32_t copy) { (void)copy; }
    virtual void stepped(const Rollout&) {}               // after learn; rows() are those that took the step
    virtual void ended(const Rollout&, const std::vector<std::uint32_t>& rows) { (void)rows; }
  };

  Rollout(Stage& stage, Driver& driver, Observer& observer);

  // Starts an episode in each of the copies, which must be idle.
  void start(const std::vector<std::uint32_t>& copies, const std::vector<wend_episode>& episodes);

  // One decision of every active row.  With `learn`, the driver learns from it.  Returns the samples it used.
  std::uint64_t step(bool learn);

  bool idle() const noexcept { return active_.empty(); }
  bool idle(std::uint32_t copy) const noexcept;

  Stage& stage() const noexcept { return stage_; }
  Driver& driver() const noexcept { return driver_; }
  const RowRecord& record(std::uint32_t row) const noexcept { return records_[row]; }
  std::string digest(std::uint32_t copy) const { return chains_[copy].digest(); }
  // Of the last step, packed: row i of each belongs to rows()[i].
  const std::vector<std::uint32_t>& rows() const noexcept { return rows_; }
  const double* actions() const noexcept { return actions_.data(); }
  const wend_outcome* outcomes() const noexcept { return outcomes_.data(); }
  // CPU time that act() took per decision, sampled, in microseconds.
  double decision_us() const noexcept { return timed_decisions_ ? act_seconds_ * 1e6 / static_cast<double>(timed_decisions_) : 0; }

 private:
  void gather();
  void act();
  void step_world();
  void chain_observations(const std::vector<std::uint32_t>& rows, const double* packed);
  void settle();

  Stage& stage_;
  Driver& driver_;
  Observer& observer_;
  std::uint32_t robots_;
  std::size_t width_, action_width_;

  std::vector<RowRecord> records_;      // by row
  std::vector<Chain> chains_;           // by copy
  std::vector<double> seen_;            // by row: the observation that the next decision is made on
  std::vector<std::uint32_t> active_;   // ascending
  std::vector<std::uint32_t> rows_, copies_, ended_;
  std::vector<double> observations_, next_, actions_, copy_actions_;
  std::vector<wend_outcome> outcomes_, copy_outcomes_;
  std::vector<std::size_t> place_;      // of rows_[i] in the arrays by copy
  std::uint64_t decisions_ = 0, timed_decisions_ = 0;
  double act_seconds_ = 0;
};

// CPU seconds of this thread.
double thread_seconds();

}  // namespace wend::core
