#include "samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace lssvm {

constexpr double alone = std::numeric_limits<double>::max();

double Window::square(std::size_t i, std::size_t j) const noexcept {
  const double *a = states_.data() + i * features_, *b = states_.data() + j * features_;
  double sum = 0;
  for (std::size_t f = 0; f < features_; ++f) sum += (a[f] - b[f]) * (a[f] - b[f]);
  return sum;
}

void Window::find_neighbour(std::size_t place) noexcept {
  neighbour_[place] = place;
  apart_[place] = alone;
  for (std::size_t i = 0; i < size(); ++i) {
    if (i == place || actions_[i] != actions_[place]) continue;
    const double between = square(i, place);
    if (between < apart_[place]) {
      apart_[place] = between;
      neighbour_[place] = i;
    }
  }
}

// After the sample at this place was replaced: its neighbour, and who has it as a neighbour now or had what was there.
void Window::meet_neighbours(std::size_t place) noexcept {
  find_neighbour(place);
  for (std::size_t i = 0; i < size(); ++i) {
    if (i == place) continue;
    if (neighbour_[i] == place) find_neighbour(i);
    if (actions_[i] != actions_[place]) continue;
    const double between = square(i, place);
    if (between < apart_[i]) {
      apart_[i] = between;
      neighbour_[i] = place;
    }
  }
}

std::size_t Window::make_room() {
  if (size() < limit_) {
    states_.resize(states_.size() + features_);
    next_.resize(next_.size() + features_);
    rewards_.push_back(0);
    actions_.push_back(0);
    terminal_.push_back(0);
    ages_.push_back(0);
    neighbour_.push_back(size() - 1);
    apart_.push_back(alone);
    return size() - 1;
  }
  if (forget_ == Forget::redundant) {
    const auto closest = static_cast<std::size_t>(std::min_element(apart_.begin(), apart_.end()) - apart_.begin());
    const auto other = static_cast<std::size_t>(neighbour_[closest]);
    if (apart_[closest] < alone) return ages_[closest] < ages_[other] ? closest : other;
  }
  return static_cast<std::size_t>(std::min_element(ages_.begin(), ages_.end()) - ages_.begin());
}

void Window::add(std::span<const double> state, std::uint32_t action, double reward, std::span<const double> next,
                 bool terminal) {
  const std::size_t place = make_room();
  std::copy(state.begin(), state.end(), states_.begin() + static_cast<std::ptrdiff_t>(place * features_));
  std::copy(next.begin(), next.end(), next_.begin() + static_cast<std::ptrdiff_t>(place * features_));
  rewards_[place] = reward;
  actions_[place] = action;
  terminal_[place] = terminal ? 1 : 0;
  ages_[place] = count_++;
  if (forget_ == Forget::redundant) meet_neighbours(place);
}

void Window::save(wend::Writer& writer) const {
  writer.put(static_cast<std::uint8_t>(forget_));
  writer.put(count_);
  writer.put(std::span<const double>(states_));
  writer.put(std::span<const double>(next_));
  writer.put(std::span<const double>(rewards_));
  writer.put(std::span<const std::uint32_t>(actions_));
  writer.put(std::span<const std::uint8_t>(terminal_));
  writer.put(std::span<const std::uint64_t>(ages_));
  writer.put(std::span<const std::uint64_t>(neighbour_));
  writer.put(std::span<const double>(apart_));
}

void Window::load(wend::Reader& reader, std::uint32_t actions) {
  if (reader.get<std::uint8_t>() != static_cast<std::uint8_t>(forget_))
    throw wend::damaged_state("expected samples kept by the same rule `forget`, found the other");
  count_ = reader.get<std::uint64_t>();
  states_ = reader.get_all<double>();
  next_ = reader.get_all<double>();
  rewards_ = reader.get_all<double>();
  actions_ = reader.get_all<std::uint32_t>();
  terminal_ = reader.get_all<std::uint8_t>();
  ages_ = reader.get_all<std::uint64_t>();
  neighbour_ = reader.get_all<std::uint64_t>();
  apart_ = reader.get_all<double>();
  check(actions);
}

void Window::check(std::uint32_t actions) const {
  const std::size_t n = size();
  if (n > limit_)
    throw wend::damaged_state("expected at most the window's " + std::to_string(limit_) + " samples, found " +
                              std::to_string(n));
  if (states_.size() != n * features_ || next_.size() != n * features_ || rewards_.size() != n ||
      terminal_.size() != n || ages_.size() != n || neighbour_.size() != n || apart_.size() != n)
    throw wend::damaged_state("the samples' arrays have different lengths");
  for (const std::uint32_t action : actions_)
    if (action >= actions)
      throw wend::damaged_state("a sample has action " + std::to_string(action) + ", expected below " +
                                std::to_string(actions));
  for (std::size_t i = 0; i < n; ++i)
    if (neighbour_[i] >= n || ages_[i] >= count_)
      throw wend::damaged_state("a sample's neighbour or age is of no sample");
  for (const std::vector<double>* values : {&states_, &next_, &rewards_, &apart_})
    for (const double value : *values)
      if (!std::isfinite(value)) throw wend::damaged_state("a sample holds a number that is not finite");
}

}  // namespace lssvm
