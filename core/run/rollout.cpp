#include <core/experiment/streams.hpp>
#include <core/run/failure.hpp>
#include <core/run/rollout.hpp>

#include <algorithm>
#include <cstring>

namespace wend::core {
namespace {

constexpr std::uint64_t timed_every = 16;  // reading the CPU clock costs more than many a policy

}  // namespace

Rollout::Rollout(Stage& stage, Driver& driver, Observer& observer)
    : stage_(stage),
      driver_(driver),
      observer_(observer),
      robots_(stage.robots()),
      width_(stage.observation().width),
      action_width_(stage.action().width),
      records_(stage.rows()),
      chains_(stage.copies()),
      seen_(stage.rows() * width_),
      observations_(stage.rows() * width_),
      next_(stage.rows() * width_),
      actions_(stage.rows() * action_width_),
      copy_actions_(stage.rows() * action_width_),
      outcomes_(stage.rows()),
      copy_outcomes_(stage.rows()),
      place_(stage.rows()) {
  active_.reserve(stage.rows());
  rows_.reserve(stage.rows());
  copies_.reserve(stage.copies());
  ended_.reserve(stage.rows());
}

bool Rollout::idle(std::uint32_t copy) const noexcept {
  for (std::uint32_t robot = 0; robot < robots_; ++robot)
    if (records_[copy * robots_ + robot].active) return false;
  return true;
}

void Rollout::start(const std::vector<std::uint32_t>& copies, const std::vector<wend_episode>& episodes) {
  std::vector<std::uint32_t> rows;
  std::vector<wend_episode> row_episodes;
  for (std::size_t i = 0; i < copies.size(); ++i) {
    chains_[copies[i]].reset();
    for (std::uint32_t robot = 0; robot < robots_; ++robot) {
      const std::uint32_t row = copies[i] * robots_ + robot;
      rows.push_back(row);
      row_episodes.push_back(robot_episode(episodes[i], robot));
      records_[row] = {row_episodes.back(), 0, 0, 0, true};
    }
  }
  stage_.reset(copies, episodes, rows, row_episodes);
  driver_.begin(rows, row_episodes);
  stage_.sense(rows, next_.data());
  chain_observations(rows, next_.data());
  for (std::size_t i = 0; i < rows.size(); ++i)
    std::memcpy(&seen_[rows[i] * width_], &next_[i * width_], width_ * sizeof(double));
  active_.insert(active_.end(), rows.begin(), rows.end());
  std::sort(active_.begin(), active_.end());
  for (const std::uint32_t copy : copies) observer_.started(copy);
}

void Rollout::chain_observations(const std::vector<std::uint32_t>& rows, const double* packed) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    chains_[rows[i] / robots_].add(packed + i * width_, width_ * sizeof(double));
}

// The rows of this step, their copies, and what each row sees, packed.
void Rollout::gather() {
  rows_ = active_;
  copies_.clear();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const std::uint32_t copy = rows_[i] / robots_;
    if (copies_.empty() || copies_.back() != copy) copies_.push_back(copy);
    place_[i] = (copies_.size() - 1) * robots_ + rows_[i] % robots_;
    std::memcpy(&observations_[i * width_], &seen_[rows_[i] * width_], width_ * sizeof(double));
  }
}

void Rollout::act() {
  const bool timed = decisions_++ % timed_every == 0;
  const double before = timed ? thread_seconds() : 0;
  driver_.act(rows_, observations_.data(), actions_.data());
  if (timed) {
    act_seconds_ += thread_seconds() - before;
    timed_decisions_ += rows_.size();
  }
}

void Rollout::step_world() {
  const std::size_t all = copies_.size() * robots_;
  if (all != rows_.size())  // rows that ended are named with their copy and get some allowed action
    for (std::size_t i = 0; i < all; ++i)
      for (std::size_t k = 0; k < action_width_; ++k) copy_actions_[i * action_width_ + k] = driver_.bounds().any(k);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    chains_[rows_[i] / robots_].add(&actions_[i * action_width_], action_width_ * sizeof(double));
    std::memcpy(&copy_actions_[place_[i] * action_width_], &actions_[i * action_width_], action_width_ * sizeof(double));
  }
  std::fill_n(copy_outcomes_.begin(), all, wend_outcome{});
  stage_.step(copies_, copy_actions_.data(), copy_outcomes_.data());
  for (std::size_t i = 0; i < rows_.size(); ++i) outcomes_[i] = copy_outcomes_[place_[i]];
}

std::uint64_t Rollout::step(bool learn) {
  gather();
  act();
  step_world();
  stage_.sense(rows_, next_.data());

  wend_batch batch{sizeof(wend_batch), static_cast<std::uint32_t>(rows_.size()), rows_.data(), observations_.data(), actions_.data(),
                   next_.data(), outcomes_.data()};
  constexpr std::uint32_t facts = WEND_TRUNCATED | WEND_COLLIDED | WEND_ARRIVED;
  for (std::size_t i = 0; i < rows_.size(); ++i) records_[rows_[i]].flags = outcomes_[i].flags;
  stage_.score(batch, outcomes_.data());
  for (std::size_t i = 0; i < rows_.size(); ++i) {  // a reward may end a training episode; the facts stay the world's
    RowRecord& record = records_[rows_[i]];
    const bool may_end = learn && (outcomes_[i].flags & WEND_TERMINATED);
    record.flags = (record.flags & facts) | (record.flags & WEND_TERMINATED) | (may_end ? std::uint32_t{WEND_TERMINATED} : 0u);
    outcomes_[i].flags = record.flags;
    outcomes_[i].reserved = 0;
    record.reward += outcomes_[i].reward;
    ++record.steps;
    chains_[rows_[i] / robots_].add(&outcomes_[i], sizeof(wend_outcome));
  }
  chain_observations(rows_, next_.data());
  const std::uint64_t used = learn ? driver_.learn(batch) : 0;
  observer_.stepped(*this);
  settle();
  return used;
}

// Ends what has ended, and keeps what the others see for their next decision.
void Rollout::settle() {
  ended_.clear();
  active_.clear();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    RowRecord& record = records_[rows_[i]];
    if (record.flags & (WEND_TERMINATED | WEND_TRUNCATED)) {
      record.active = false;
      ended_.push_back(rows_[i]);
    } else {
      active_.push_back(rows_[i]);
      std::memcpy(&seen_[rows_[i] * width_], &next_[i * width_], width_ * sizeof(double));
    }
  }
  if (!ended_.empty()) observer_.ended(*this, ended_);
}

}  // namespace wend::core
