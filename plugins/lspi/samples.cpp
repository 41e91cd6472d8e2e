#include "samples.hpp"

#include <cmath>

namespace lspi {

void Memory::add(std::span<const double> state, std::uint32_t action, double reward, std::span<const double> next,
                 bool terminal) {
  states_.insert(states_.end(), state.begin(), state.end());
  next_.insert(next_.end(), next.begin(), next.end());
  rewards_.push_back(reward);
  actions_.push_back(action);
  terminal_.push_back(terminal ? 1 : 0);
}

Samples Memory::samples(const Basis& basis, const Mirror* mirror) const {
  Samples out;
  out.features = basis.size();
  const std::size_t copies = mirror ? 2 : 1, n = size() * copies;
  out.phi.resize(n * out.features);
  out.next_phi.resize(n * out.features);
  std::vector<double> reflected(width_);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = i / copies;
    const bool reflect = i % copies == 1;
    const auto through = [&](const std::vector<double>& from, std::vector<double>& to) {
      std::span<const double> state(from.data() + k * width_, width_);
      if (reflect) {
        for (std::size_t c = 0; c < width_; ++c) reflected[c] = state[mirror->columns[c]];
        state = reflected;
      }
      basis.evaluate(state, {to.data() + i * out.features, out.features});
    };
    through(states_, out.phi);
    through(next_, out.next_phi);
    out.actions.push_back(reflect ? mirror->actions[actions_[k]] : actions_[k]);
    out.rewards.push_back(rewards_[k]);
    out.terminal.push_back(terminal_[k]);
  }
  return out;
}

void Memory::save(wend::Writer& writer) const {
  writer.put(std::span<const double>(states_));
  writer.put(std::span<const double>(next_));
  writer.put(std::span<const double>(rewards_));
  writer.put(std::span<const std::uint32_t>(actions_));
  writer.put(std::span<const std::uint8_t>(terminal_));
}

Memory Memory::load(wend::Reader& reader, std::size_t width, std::uint32_t actions) {
  Memory memory(width);
  memory.states_ = reader.get_all<double>();
  memory.next_ = reader.get_all<double>();
  memory.rewards_ = reader.get_all<double>();
  memory.actions_ = reader.get_all<std::uint32_t>();
  memory.terminal_ = reader.get_all<std::uint8_t>();
  const std::size_t n = memory.actions_.size();
  if (memory.states_.size() != n * width || memory.next_.size() != n * width || memory.rewards_.size() != n ||
      memory.terminal_.size() != n)
    throw wend::damaged_state("the samples' arrays have different lengths");
  for (const std::uint32_t action : memory.actions_)
    if (action >= actions)
      throw wend::damaged_state("a sample has action " + std::to_string(action) + ", expected below " +
                                std::to_string(actions));
  for (const std::vector<double>* values : {&memory.states_, &memory.next_, &memory.rewards_})
    for (const double value : *values)
      if (!std::isfinite(value)) throw wend::damaged_state("a sample holds a number that is not finite");
  return memory;
}

}  // namespace lspi
