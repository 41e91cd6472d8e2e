// wend run: trainings and cells on all cores, then the summary, the table and the pictures.
#include "command.hpp"
#include "outputs.hpp"
#include "progress.hpp"

#include <core/base/files.hpp>
#include <core/run/runner.hpp>

#include <csignal>
#include <iostream>
#include <thread>

namespace wend::app {
namespace {

volatile std::sig_atomic_t stop_signal = 0;

void on_signal(int signal) {
  stop_signal = signal;
  std::signal(signal, SIG_DFL);  // a second one ends the program at once; what is recorded stays
}

std::string command_line(const Arguments& arguments) {
  std::string text = "wend run";
  for (const std::string& argument : arguments) text += " " + argument;
  return text;
}

po::options_description run_options() {
  po::options_description options("options");
  options.add_options()("out", po::value<std::string>()->value_name("DIR"), "where the results go; the same DIR again resumes")(
      "jobs,j", po::value<std::uint32_t>()->value_name("N"), "worker processes (default: one per core)")(
      "batch", po::value<std::uint32_t>()->default_value(16)->value_name("N"), "episodes side by side in a cell; never changes a result")(
      "retry-failed", "try the cells again that failed")("fail-fast", "stop at the first failure")(
      "allow-mixed-builds", "go on in a directory that another build began")(
      "isolation", po::value<std::string>()->default_value("process")->value_name("process|none"), "none: plugins run in this process, for debugging and profiling")(
      "time-limit", po::value<std::uint64_t>()->default_value(3600)->value_name("SECONDS"), "wall time of one training or cell")("no-pictures", "leave the figures out");
  add_experiment_options(options);
  add_common(options);
  return options;
}

core::RunOptions options_of(const po::variables_map& values, const Arguments& arguments) {
  core::RunOptions options;
  options.directory = values["out"].as<std::string>();
  options.command = command_line(arguments);
  options.jobs = values.count("jobs") ? values["jobs"].as<std::uint32_t>() : std::max(1u, std::thread::hardware_concurrency());
  options.batch = values["batch"].as<std::uint32_t>();
  if (options.jobs < 1 || options.jobs > 4096) throw Usage("--jobs: expected 1..4096, found " + std::to_string(options.jobs));
  if (options.batch < 1 || options.batch > 4096) throw Usage("--batch: expected 1..4096, found " + std::to_string(options.batch));
  const std::string isolation = values["isolation"].as<std::string>();
  if (isolation != "process" && isolation != "none") throw Usage("--isolation: expected process or none, found \"" + isolation + "\"");
  options.isolated = isolation == "process";
  options.worker = worker_path();
  options.retry_failed = values.count("retry-failed") > 0;
  options.fail_fast = values.count("fail-fast") > 0;
  options.allow_mixed_builds = values.count("allow-mixed-builds") > 0;
  options.deadline_s = values["time-limit"].as<std::uint64_t>();
  return options;
}

}  // namespace

int run(const Arguments& arguments) {
  const auto values = parse(arguments, "run EXPERIMENT --out DIR [OPTIONS]", "Runs an experiment and writes results, summary and pictures to DIR.", run_options(), {"experiment"});
  if (!values.count("experiment") || values["experiment"].as<std::vector<std::string>>().size() != 1) throw Usage("expected one experiment file\nusage: wend run EXPERIMENT --out DIR");
  if (!values.count("out")) throw Usage("expected --out DIR\nusage: wend run EXPERIMENT --out DIR");
  const bool json = values.count("json") > 0;
  const core::RunOptions options = options_of(values, arguments);
  const core::Catalog catalog = catalog_of(values);
  const core::Experiment experiment = load(values["experiment"].as<std::vector<std::string>>().front(), catalog, values);

  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  ProgressReport progress(json);
  core::RunListener listener;
  listener.progress = [&](const core::Progress& now) { progress.show(now); };
  listener.failure = [&](const core::RunFailure& failure) { progress.tell(failure); };
  listener.stopping = [] { return stop_signal != 0; };
  const core::RunReport report = core::run_experiment(experiment, catalog, options, listener);
  progress.end(report);

  const Json summary = write_summary(experiment, options.directory);
  const auto pictures = values.count("no-pictures") || report.stopped ? std::vector<std::string>() : write_figures(experiment, summary, options.directory);
  if (json) std::cout << summary.dump(2) << "\n";
  else print_outcome(summary, pictures, options.directory);
  if (stop_signal) return 128 + stop_signal;
  return static_cast<int>(report.progress.failed || report.stopped ? Exit::cells_failed : Exit::ok);
}

}  // namespace wend::app
