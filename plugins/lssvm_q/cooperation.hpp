// Which of the two machines decides: the switch to the deep phase (step 4), and how often they agree.
#pragma once
#include <cstdint>
#include <vector>
#include <wend/bytes.hpp>

namespace lssvm {

struct Switching {
  enum class Kind { window, after_episodes, per_state } kind = Kind::after_episodes;
  double threshold = 0.4;       // window: share of agreeing decisions
  std::uint64_t n = 500;        // window: among so many
  std::uint64_t episodes = 30;  // after_episodes
};

class Cooperation {
 public:
  explicit Cooperation(const Switching& switching) : switching_(switching) {
    if (switching.kind == Switching::Kind::after_episodes && switching.episodes == 0) go_deep(0, 0);
  }

  // Before exploring episode number `index`.
  void begin_episode(std::uint64_t index, std::uint64_t steps);
  // Both were asked; `agree`: they name the same action.
  void compare(bool agree, std::uint64_t episode, std::uint64_t step);

  bool deep() const noexcept { return deep_; }           // for good
  bool needs_advice() const noexcept { return !deep_; }  // the classification still learns and is asked
  bool deep_in_state(bool agree) const noexcept {
    return deep_ || (switching_.kind == Switching::Kind::per_state && agree);
  }

  double agreement() const noexcept;  // share in the last episode that compared; NaN before one
  std::uint64_t switch_episode() const noexcept { return switch_episode_; }
  std::uint64_t switch_step() const noexcept { return switch_step_; }

  void save(wend::Writer& writer) const;
  void load(wend::Reader& reader);  // throws where the bytes are of another switch

 private:
  void go_deep(std::uint64_t episode, std::uint64_t step) noexcept {
    deep_ = true;
    switch_episode_ = episode;
    switch_step_ = step;
  }

  Switching switching_;
  bool deep_ = false;
  std::uint64_t switch_episode_ = 0, switch_step_ = 0;
  std::vector<std::uint8_t> agreed_;  // window: a ring of the last n comparisons
  std::uint64_t at_ = 0, alike_in_window_ = 0;
  std::uint64_t compared_ = 0, alike_ = 0;  // in this episode
};

}  // namespace lssvm
