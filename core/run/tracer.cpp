#include <core/run/failure.hpp>
#include <core/run/tracer.hpp>

#include <numeric>

namespace wend::core {
namespace {

TraceShape copy_of(const wend_shape& shape) {
  TraceShape own;
  own.form = shape.form;
  own.kind = shape.kind;
  own.radius = shape.radius;
  if (shape.form == WEND_SHAPE_GRID) {
    own.columns = static_cast<std::uint32_t>(shape.count >> 32);
    own.rows = static_cast<std::uint32_t>(shape.count);
    own.xy.assign(shape.xy, shape.xy + 3);
    own.cells.assign(shape.cells, shape.cells + std::size_t{own.columns} * own.rows);
  } else {
    own.xy.assign(shape.xy, shape.xy + 2 * shape.count);
  }
  return own;
}

}  // namespace

Tracer::Tracer(const Stage& stage, const Driver& driver, std::uint32_t episodes, Json about)
    : stage_(stage), episodes_(episodes), about_(std::move(about)), telemetry_(WEND_PER_STEP, nullptr, &driver) {}

void Tracer::started(std::uint32_t copy, std::uint64_t episode) {
  if (episode >= episodes_) return;
  Trace& trace = open_[copy];
  trace = {};
  trace.about = about_;
  trace.about["episode"] = episode;
  trace.robots = stage_.robots();
  trace.action_width = stage_.action().width;
  trace.telemetry_names = telemetry_.names();
  if (stage_.geometry()) read_shapes(copy, trace, true);
  else trace.body_radius.resize(trace.robots);
  look(copy, trace);
}

// Movers every time, the other shapes once.
void Tracer::read_shapes(std::uint32_t copy, Trace& trace, bool fixed) {
  const wend_shape* shapes = nullptr;
  std::uint32_t n = 0, movers = 0;
  stage_.world().check(stage_.geometry()->shapes(stage_.world().self(), copy, &shapes, &n), "shapes");
  for (std::uint32_t i = 0; i < n; ++i) {
    if (shapes[i].kind == WEND_MOVER) {
      ++movers;
      if (!fixed) trace.mover.insert(trace.mover.end(), {shapes[i].xy[0], shapes[i].xy[1], shapes[i].radius});
    } else if (fixed) {
      trace.shapes.push_back(copy_of(shapes[i]));
    }
  }
  if (fixed) trace.movers = movers;
  else if (movers != trace.movers)
    throw UnitFailed("rule", "world (" + stage_.world().type() + "): shapes: expected " + std::to_string(trace.movers) +
                                 " movers as at the episode's start, found " + std::to_string(movers));
}

void Tracer::look(std::uint32_t copy, Trace& trace) {
  trace.time.push_back(static_cast<double>(trace.time.size()) * stage_.period());
  const wend_geometry2d* geometry = stage_.geometry();
  if (geometry == nullptr) return;
  std::vector<std::uint32_t> rows(trace.robots);
  std::iota(rows.begin(), rows.end(), copy * trace.robots);
  std::vector<wend_pose> poses(rows.size());
  std::vector<wend_disc> bodies(rows.size()), goals(rows.size());
  stage_.world().check(geometry->poses(stage_.world().self(), rows.data(), trace.robots, poses.data()), "poses");
  stage_.world().check(geometry->bodies(stage_.world().self(), rows.data(), trace.robots, bodies.data(), goals.data()), "bodies");
  const bool first = trace.body_radius.empty();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    trace.pose.insert(trace.pose.end(), {poses[i].x, poses[i].y, poses[i].heading});
    trace.goal.insert(trace.goal.end(), {goals[i].x, goals[i].y, goals[i].radius});
    if (first) trace.body_radius.push_back(bodies[i].radius);
  }
  read_shapes(copy, trace, false);
}

void Tracer::stepped(const Rollout& rollout) {
  if (open_.empty()) return;
  const std::vector<std::uint32_t>& rows = rollout.rows();
  const std::vector<double> told = telemetry_.names().empty() ? std::vector<double>() : telemetry_.read(rows);
  for (auto& [copy, trace] : open_) {
    const std::size_t action_at = trace.action.size(), reward_at = trace.reward.size(), told_at = trace.telemetry.size();
    bool any = false;
    trace.action.resize(action_at + std::size_t{trace.robots} * trace.action_width);
    trace.reward.resize(reward_at + trace.robots);
    trace.flags.resize(reward_at + trace.robots);
    trace.telemetry.resize(told_at + trace.robots * telemetry_.names().size());
    for (std::uint32_t robot = 0; robot < trace.robots; ++robot)
      trace.flags[reward_at + robot] = rollout.record(copy * trace.robots + robot).flags;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i] / trace.robots != copy) continue;
      any = true;
      const std::size_t robot = rows[i] % trace.robots;
      std::copy_n(rollout.actions() + i * trace.action_width, trace.action_width, trace.action.begin() + static_cast<std::ptrdiff_t>(action_at + robot * trace.action_width));
      trace.reward[reward_at + robot] = rollout.outcomes()[i].reward;
      const std::size_t width = telemetry_.names().size();
      std::copy_n(told.begin() + static_cast<std::ptrdiff_t>(i * width), width, trace.telemetry.begin() + static_cast<std::ptrdiff_t>(told_at + robot * width));
    }
    if (any) {
      look(copy, trace);
    } else {
      trace.action.resize(action_at);
      trace.reward.resize(reward_at);
      trace.flags.resize(reward_at);
      trace.telemetry.resize(told_at);
    }
  }
}

std::optional<Trace> Tracer::finish(std::uint32_t copy) {
  const auto at = open_.find(copy);
  if (at == open_.end()) return std::nullopt;
  Trace trace = std::move(at->second);
  open_.erase(at);
  return trace;
}

}  // namespace wend::core
