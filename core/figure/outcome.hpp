// How an episode went for one robot, read off its trace.
#pragma once
#include <core/figure/style.hpp>
#include <core/record/trace.hpp>
#include <cstdint>
#include <string>

namespace wend::core {

struct Outcome {
  Ending ending = Ending::unfinished;
  std::uint32_t steps = 0;  // until this robot ended
  double length = 0;        // m, driven until then
};

Outcome outcome(const Trace& trace, std::uint32_t robot);

// The worst of its robots' endings, the steps of the last and the length of all.
Outcome outcome(const Trace& trace);

// "arrived", or for several robots "2 of 3 arrived".
std::string verdict(const Trace& trace);

// "312 steps, 162.4 m"
std::string effort(const Outcome& outcome);

}  // namespace wend::core
