// LS-SVCM: which action a state advises, a classification of states, one action against the rest.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "lssvm.hpp"
#include "samples.hpp"

namespace lssvm {

class Adviser {
 public:
  Adviser() = default;
  Adviser(std::uint32_t actions, Index features, double sigma, double c)
      : actions_(actions), features_(features), sigma_(sigma), c_(c), scores_(actions) {}

  bool trained() const noexcept { return expansion_.outputs() > 0; }

  // The class of the largest decision value, the first of equals.
  std::uint32_t advise(std::span<const double> state);

  void train(const Window& window);

  void save(wend::Writer& writer) const { expansion_.save(writer); }
  void load(wend::Reader& reader) { expansion_ = Expansion::load(reader, features_, sigma_, actions_); }

 private:
  std::uint32_t actions_ = 0;
  Index features_ = 0;
  double sigma_ = 1, c_ = 1;
  Expansion expansion_;
  std::vector<double> scores_;
};

}  // namespace lssvm
