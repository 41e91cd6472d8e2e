// Which pictures a run directory gets.
#pragma once
#include <core/figure/display.hpp>
#include <core/record/trace.hpp>
#include <string>
#include <vector>

namespace wend::core {

struct NamedFigure {
  std::string name;  // a file name without folder or suffix: "map_ordinary_3"
  Figure figure;
};

// From summary.json and the recorded episodes, of which the first seed's first episode is drawn:
//   map_<world>_<variant>    all arms on one map, each at its final state; of many maps some, evenly spread
//   maps                     the first map of each world, where there are several
//   learning_<world>_<arm>   the same map at each snapshot of a training
//   trials_<world>_<arm>     recorded episodes of a training on one map
//   steps_<name>_<world>     reward or telemetry over the time of an episode, an arm each; trial_steps_<name>_<world>_<arm>:
//                            of the recorded episodes of a training, one after the other
//   curve_<metric>_<world>   a curve with its band, an arm each
//   success, metric_<name>   estimates with intervals, arm by world
// Options, all of which may be missing: "title" (string), "worlds" (ids, in this order), "variants" (maps per world,
// 4), "metrics" (names, for metric_<name>), "steps" (names, for steps_<name>_<world>), "curves" (names, for curve_<name>_<world>; default success,
// collision and spl), "log_x" (names of x axes that are logarithmic). Throws Error(Exit::data)
// where the summary has not the form that summary.json has.
std::vector<NamedFigure> figures_of(const Json& summary, const std::vector<Trace>& traces, const Json& options);

// Letters, digits, '-', '_' and '.' stay; all else becomes '_'.
std::string file_name(const std::string& text);

}  // namespace wend::core
