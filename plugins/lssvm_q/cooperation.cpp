#include "cooperation.hpp"

#include <limits>
#include <numeric>
#include <string>

namespace lssvm {

void Cooperation::begin_episode(std::uint64_t index, std::uint64_t steps) {
  compared_ = alike_ = 0;
  if (!deep_ && switching_.kind == Switching::Kind::after_episodes && index >= switching_.episodes)
    go_deep(index, steps);
}

void Cooperation::compare(bool agree, std::uint64_t episode, std::uint64_t step) {
  ++compared_;
  alike_ += agree;
  if (deep_ || switching_.kind != Switching::Kind::window) return;
  if (agreed_.size() < switching_.n) {
    agreed_.push_back(agree);
  } else {
    std::uint8_t& oldest = agreed_[at_ % switching_.n];
    alike_in_window_ -= oldest;
    oldest = agree;
  }
  ++at_;
  alike_in_window_ += agree;
  if (agreed_.size() == switching_.n &&
      static_cast<double>(alike_in_window_) >= switching_.threshold * static_cast<double>(switching_.n))
    go_deep(episode, step);
}

double Cooperation::agreement() const noexcept {
  if (compared_ == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(alike_) / static_cast<double>(compared_);
}

void Cooperation::save(wend::Writer& writer) const {
  writer.put(static_cast<std::uint8_t>(deep_));
  for (const std::uint64_t value : {switch_episode_, switch_step_, at_, compared_, alike_}) writer.put(value);
  writer.put(std::span<const std::uint8_t>(agreed_));
}

void Cooperation::load(wend::Reader& reader) {
  const bool deep = reader.get<std::uint8_t>() != 0;
  std::uint64_t numbers[5];
  for (std::uint64_t& value : numbers) value = reader.get<std::uint64_t>();
  std::vector<std::uint8_t> agreed = reader.get_all<std::uint8_t>();
  const std::uint64_t most = switching_.kind == Switching::Kind::window ? switching_.n : 0;
  if (agreed.size() > most)
    throw wend::damaged_state("expected at most " + std::to_string(most) + " comparisons for this switch, found " +
                              std::to_string(agreed.size()));
  for (const std::uint8_t agree : agreed)
    if (agree > 1) throw wend::damaged_state("a comparison is neither 0 nor 1");
  deep_ = deep;
  switch_episode_ = numbers[0], switch_step_ = numbers[1];
  at_ = numbers[2], compared_ = numbers[3], alike_ = numbers[4];
  agreed_ = std::move(agreed);
  alike_in_window_ = std::accumulate(agreed_.begin(), agreed_.end(), std::uint64_t{0});
}

}  // namespace lssvm
