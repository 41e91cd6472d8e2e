#include "reader.hpp"

#include <algorithm>
#include <wend/math.hpp>

namespace rolling_window {
namespace {

bool offers(const wend::Space& space, const std::vector<std::string>& patterns) {
  return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
    return std::any_of(space.columns().begin(), space.columns().end(),
                       [&](const wend_column& column) { return wend::matches(pattern, column.name); });
  });
}

}  // namespace

Reader::Reader(const wend::Config& config, double body, bool needs_pose) : body_(body) {
  const wend::Space& space = config.observation;
  const auto window = config.params.texts("window"), sonar = config.params.texts("sonar");
  const bool has_window = offers(space, window);
  own_sonar_ = offers(space, sonar);
  if (!has_window && !own_sonar_)
    throw wend::parameter_error("window", "no column fits \"" + window.front() + "\" or \"" + sonar.front() +
                                              "\" of sonar; the columns are " + space.names());
  window_ = has_window ? wend::Reading(space, window, "window") : wend::Reading(space, sonar, "sonar");
  if (own_sonar_) sonar_ = wend::Reading(space, sonar, "sonar");
  const std::string goal = config.params.text("goal"), pose = config.params.text("pose");
  distance_ = wend::Reading(space, goal + ".distance", "goal");
  bearing_ = wend::Reading(space, goal + ".bearing", "goal");
  radius_ = wend::Reading(space, goal + ".radius", "goal");
  if (!needs_pose && !offers(space, {pose + ".x"})) return;
  for (const char* name : {".x", ".y", ".heading", ".speed", ".turn_rate"})
    pose_.emplace_back(space, pose + name, "pose");
}

void Reader::read_beams(const wend::Reading& from, std::span<const double> observation, double heading,
                        std::vector<Beam>& beams) {
  beams.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    Beam& beam = beams[i];
    beam.bearing = from.bearing(i);
    beam.range = from(observation, i);
    beam.hit = beam.range < from.column(i).high * (1 - 1e-9);
    wend::math::sincos(heading + beam.bearing, beam.sine, beam.cosine);
  }
}

void Reader::read(std::span<const double> observation, Percept& percept) const {
  percept.body = body_;
  percept.motion = {};
  if (!pose_.empty())
    percept.motion = {pose_[0](observation), pose_[1](observation), pose_[2](observation), pose_[3](observation),
                      pose_[4](observation)};
  const wend_motion& motion = percept.motion;
  percept.goal_distance = distance_(observation);
  percept.goal_bearing = bearing_(observation);
  percept.goal_radius = radius_(observation);
  double sine, cosine;
  wend::math::sincos(motion.heading + percept.goal_bearing, sine, cosine);
  percept.goal = {motion.x + percept.goal_distance * cosine, motion.y + percept.goal_distance * sine};
  read_beams(window_, observation, motion.heading, percept.window);
  read_beams(own_sonar_ ? sonar_ : window_, observation, motion.heading, percept.sonar);
  percept.surface.clear();
  for (const Beam& beam : percept.window)
    if (beam.hit)
      percept.surface.push_back(
          {motion.x + (body_ + beam.range) * beam.cosine, motion.y + (body_ + beam.range) * beam.sine});
}

}  // namespace rolling_window
