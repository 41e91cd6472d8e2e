// What a policy told, or was rewarded, at each step of recorded episodes, as curves over time.
#pragma once
#include <core/figure/curve_figure.hpp>
#include <core/record/trace.hpp>
#include <string>
#include <vector>

namespace wend::core {

// Of robot 0: "reward", or the telemetry of that name, also of one that a component in a slot told ("avoid.J" for
// "J").  Several episodes follow each other with a gap between them.  Empty where there is no such finite value.
std::vector<CurvePoint> step_series(const std::vector<const Trace*>& episodes, const std::string& name);

}  // namespace wend::core
