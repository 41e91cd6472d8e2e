// Records traces of the first episodes of a cell while it runs.
#pragma once
#include <core/record/trace.hpp>
#include <core/run/rollout.hpp>
#include <core/run/telemetry.hpp>

#include <map>
#include <optional>
#include <vector>

namespace wend::core {

class Tracer {
 public:
  // Traces the episodes below `episodes`; a world without geometry leaves poses and shapes empty.
  Tracer(const Stage& stage, const Driver& driver, std::uint32_t episodes, Json about);

  void started(std::uint32_t copy, std::uint64_t episode);
  void stepped(const Rollout& rollout);
  // The finished trace of the copy, if it was one.
  std::optional<Trace> finish(std::uint32_t copy);

 private:
  void look(std::uint32_t copy, Trace& trace);
  void read_shapes(std::uint32_t copy, Trace& trace, bool fixed);

  const Stage& stage_;
  std::uint32_t episodes_;
  Json about_;
  Telemetry telemetry_;
  std::map<std::uint32_t, Trace> open_;  // by copy
};

}  // namespace wend::core
