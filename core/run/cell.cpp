#include <core/experiment/streams.hpp>
#include <core/run/cell.hpp>
#include <core/run/curves.hpp>
#include <core/run/failure.hpp>
#include <core/run/rollout.hpp>
#include <core/run/telemetry.hpp>
#include <core/run/tracer.hpp>

#include <algorithm>
#include <map>

namespace wend::core {
namespace {

// Collects the episodes of a cell, whatever order they end in.
class CellRun : public Rollout::Observer {
 public:
  CellRun(const Cell& cell, const Stage& stage, const Driver& driver, const WorkOptions& options)
      : cell_(cell), options_(options), metrics_(WEND_PER_EPISODE, &stage, &driver),
        tracer_(stage, driver, cell.traced_episodes, about()), episode_of_copy_(stage.copies()) {
    result_.metrics = metrics_.names();
    result_.episodes.resize(cell.episodes);
  }

  void assign(std::uint32_t copy, std::uint64_t episode) { episode_of_copy_[copy] = episode; }

  void started(std::uint32_t copy) override { tracer_.started(copy, episode_of_copy_[copy]); }
  void stepped(const Rollout& rollout) override { tracer_.stepped(rollout); }

  void ended(const Rollout& rollout, const std::vector<std::uint32_t>& rows) override {
    const std::vector<double> values = metrics_.names().empty() ? std::vector<double>() : metrics_.read(rows);
    const std::size_t width = metrics_.names().size();
    const std::uint32_t robots = cell_.world.robots;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::uint32_t copy = rows[i] / robots;
      Episode& episode = result_.episodes[episode_of_copy_[copy]];
      const RowRecord& record = rollout.record(rows[i]);
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(i * width);
      episode.robots.push_back({rows[i] % robots, record.flags, record.steps, record.reward, {first, first + static_cast<std::ptrdiff_t>(width)}});
      if (episode.robots.size() == robots) finish(rollout, copy, episode);
    }
  }

  CellResult take(const Rollout& rollout) {
    result_.decision_us = rollout.decision_us();
    return std::move(result_);
  }

 private:
  void finish(const Rollout& rollout, std::uint32_t copy, Episode& episode) {
    std::sort(episode.robots.begin(), episode.robots.end(), [](const auto& a, const auto& b) { return a.robot < b.robot; });
    episode.index = episode_of_copy_[copy];
    episode.hash = rollout.digest(copy);
    if (const auto trace = tracer_.finish(copy)) {
      const std::string file = cell_.id.substr(0, 24) + "-" + std::to_string(episode.index) + ".npz";
      write_trace(options_.scratch + "/" + file, *trace);
      result_.traces[episode.index] = file;
    }
  }

  Json about() const {
    Json about = {{"arm", cell_.driver.arm}, {"world", cell_.world.id}, {"variant", cell_.variant}, {"seed", cell_.stream.seed},
                  {"point", cell_.point}, {"privileged", cell_.privileged}};
    if (cell_.at) about["at"] = {{cell_.at->unit, cell_.at->amount}};
    return about;
  }

  const Cell& cell_;
  const WorkOptions& options_;
  Telemetry metrics_;
  Tracer tracer_;
  std::vector<std::uint64_t> episode_of_copy_;
  CellResult result_;
};

}  // namespace

CellResult run_cell(const Cell& cell, const std::string& state, const std::string& state_name, const WorkOptions& options) {
  const std::uint32_t copies = std::max(1u, std::min(options.batch, cell.episodes));
  SeriesBook series;
  Listener listener = options.listener ? *options.listener : Listener{};
  listener.series = [&](const std::string&, const char* x_name, double x, const char* y_name, double y) {
    if (x_name && y_name) series.add(y_name, x_name, x, y);
  };
  Stage stage(cell.world, cell.driver, cell.stream, {options.libraries, &listener, copies});
  Driver driver(cell.driver, stage);
  if (!state.empty()) driver.load(state, state_name);
  CellRun run(cell, stage, driver, options);
  Rollout rollout(stage, driver, run);

  std::uint64_t next = 0;
  do {  // idle copies take the next episodes
    std::vector<std::uint32_t> idle;
    std::vector<wend_episode> episodes;
    for (std::uint32_t copy = 0; copy < copies && next < cell.episodes; ++copy) {
      if (!rollout.idle(copy)) continue;
      idle.push_back(copy);
      run.assign(copy, next);
      episodes.push_back(episode_of(cell.stream, cell.world, cell.variant, next++, WEND_TEST));
    }
    if (!idle.empty()) rollout.start(idle, episodes);
    if (!rollout.idle()) rollout.step(false);
  } while (!rollout.idle() || next < cell.episodes);
  CellResult result = run.take(rollout);
  result.curves = series.take();
  return result;
}

void check_cell(const Cell& cell, const WorkOptions& options) {
  Stage stage(cell.world, cell.driver, cell.stream, {options.libraries, options.listener, 1});
  Driver driver(cell.driver, stage);
  const wend_episode episode = episode_of(cell.stream, cell.world, cell.variant, 0, WEND_TEST);
  std::vector<std::uint32_t> rows;
  std::vector<wend_episode> episodes;
  for (std::uint32_t robot = 0; robot < stage.robots(); ++robot) {
    rows.push_back(robot);
    episodes.push_back(robot_episode(episode, robot));
  }
  stage.reset({0}, {episode}, rows, episodes);
}

}  // namespace wend::core
