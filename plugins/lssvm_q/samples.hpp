// The samples that the two machines learn from: bounded windows of transitions (s, a, r, s').
#pragma once
#include <cstdint>
#include <span>
#include <vector>
#include <wend/bytes.hpp>

namespace lssvm {

// Who gives way in a full window: the oldest sample; or, of the two samples of one action whose states are nearest to
// each other, the older one, so that what is rare stays.
enum class Forget { oldest, redundant };

class Window {
 public:
  Window() = default;
  Window(std::size_t features, std::size_t limit, Forget forget)
      : features_(features), limit_(limit), forget_(forget) {}

  void add(std::span<const double> state, std::uint32_t action, double reward, std::span<const double> next,
           bool terminal);

  std::size_t size() const noexcept { return actions_.size(); }
  std::span<const double> state(std::size_t i) const noexcept { return {states_.data() + i * features_, features_}; }
  std::span<const double> next(std::size_t i) const noexcept { return {next_.data() + i * features_, features_}; }
  std::uint32_t action(std::size_t i) const noexcept { return actions_[i]; }
  double reward(std::size_t i) const noexcept { return rewards_[i]; }
  bool terminal(std::size_t i) const noexcept { return terminal_[i] != 0; }
  std::span<const double> states() const noexcept { return states_; }

  void save(wend::Writer& writer) const;
  // Into an empty window of the same settings; throws where the bytes are not of one.
  void load(wend::Reader& reader, std::uint32_t actions);

 private:
  std::size_t make_room();
  double square(std::size_t i, std::size_t j) const noexcept;
  void find_neighbour(std::size_t place) noexcept;
  void meet_neighbours(std::size_t place) noexcept;
  void check(std::uint32_t actions) const;

  std::size_t features_ = 0, limit_ = 0;
  Forget forget_ = Forget::oldest;
  std::vector<double> states_, next_, rewards_;
  std::vector<std::uint32_t> actions_;
  std::vector<std::uint8_t> terminal_;
  std::vector<std::uint64_t> ages_;  // which sample of all this one was
  std::uint64_t count_ = 0;          // of all
  // Forget::redundant: the place of the nearest state among those of the same action, its own where there is none, and
  // its squared distance.
  std::vector<std::uint64_t> neighbour_;
  std::vector<double> apart_;
};

}  // namespace lssvm
