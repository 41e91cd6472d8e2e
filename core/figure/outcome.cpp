#include <wend/abi.h>

#include <algorithm>
#include <cmath>
#include <core/figure/outcome.hpp>

namespace wend::core {
namespace {

Ending ending_of(std::uint32_t flags) {
  if (flags & WEND_COLLIDED) return Ending::collided;
  if (flags & WEND_ARRIVED) return Ending::arrived;
  if (flags & WEND_TRUNCATED) return Ending::timeout;
  return flags & WEND_TERMINATED ? Ending::ended : Ending::unfinished;
}

int badness(Ending ending) {
  switch (ending) {
    case Ending::arrived:
      return 0;
    case Ending::ended:
      return 1;
    case Ending::unfinished:
      return 2;
    case Ending::timeout:
      return 3;
    case Ending::collided:
      break;
  }
  return 4;
}

}  // namespace

Outcome outcome(const Trace& trace, std::uint32_t robot) {
  Outcome result;
  if (robot >= trace.robots) return result;
  const std::size_t robots = trace.robots, steps = trace.flags.size() / robots,
                    poses = trace.pose.size() / (3 * robots);
  for (std::size_t t = 0; t < steps; ++t) {
    ++result.steps;
    const std::uint32_t flags = trace.flags[t * robots + robot];
    result.ending = ending_of(flags);
    if (flags & (WEND_TERMINATED | WEND_TRUNCATED)) break;
  }
  for (std::size_t t = 0; t < result.steps && t + 1 < poses; ++t) {
    const double* from = &trace.pose[(t * robots + robot) * 3];
    const double* to = from + 3 * robots;
    const double moved = std::hypot(to[0] - from[0], to[1] - from[1]);
    if (std::isfinite(moved)) result.length += moved;
  }
  return result;
}

Outcome outcome(const Trace& trace) {
  Outcome all = outcome(trace, 0);
  for (std::uint32_t robot = 1; robot < trace.robots; ++robot) {
    const Outcome one = outcome(trace, robot);
    if (badness(one.ending) > badness(all.ending)) all.ending = one.ending;
    all.steps = std::max(all.steps, one.steps);
    all.length += one.length;
  }
  return all;
}

std::string verdict(const Trace& trace) {
  const Outcome all = outcome(trace);
  if (trace.robots < 2 || all.ending == Ending::arrived) return name(all.ending);
  std::uint32_t arrived = 0;
  for (std::uint32_t robot = 0; robot < trace.robots; ++robot)
    arrived += outcome(trace, robot).ending == Ending::arrived;
  return std::to_string(arrived) + " of " + std::to_string(trace.robots) + " arrived";
}

std::string effort(const Outcome& outcome) {
  return grouped(outcome.steps) + (outcome.steps == 1 ? " step, " : " steps, ") +
         grouped(outcome.length, outcome.length < 10 ? 2 : 1) + " m";
}

}  // namespace wend::core
