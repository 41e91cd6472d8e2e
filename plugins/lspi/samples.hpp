// What LSPI remembers: every transition it was shown, as the state's columns, so that it can be saved and solved again.
#pragma once
#include <cstdint>
#include <span>
#include <vector>
#include <wend/bytes.hpp>

#include "basis.hpp"
#include "solver.hpp"

namespace lspi {

class Memory {
 public:
  explicit Memory(std::size_t width = 0) : width_(width) {}

  void add(std::span<const double> state, std::uint32_t action, double reward, std::span<const double> next,
           bool terminal);
  std::size_t size() const noexcept { return actions_.size(); }
  std::size_t width() const noexcept { return width_; }

  // How a transition looks in the mirror: column i becomes columns[i], action a becomes actions[a].
  struct Mirror {
    std::vector<std::uint32_t> columns, actions;
  };

  // All of it through the basis, and, given a mirror, each transition's reflection after it.
  Samples samples(const Basis& basis, const Mirror* mirror) const;

  void save(wend::Writer& writer) const;
  static Memory load(wend::Reader& reader, std::size_t width, std::uint32_t actions);

 private:
  std::size_t width_;
  std::vector<double> states_, next_, rewards_;
  std::vector<std::uint32_t> actions_;
  std::vector<std::uint8_t> terminal_;
};

}  // namespace lspi
