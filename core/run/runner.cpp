#include <core/base/error.hpp>
#include <core/base/files.hpp>
#include <core/record/store.hpp>
#include <core/run/build_id.hpp>
#include <core/run/runner.hpp>

#include <algorithm>
#include <chrono>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

namespace wend::core {
namespace {

namespace fs = std::filesystem;

std::string describe(const DriverSpec& driver, const std::string& world, std::uint64_t seed, const Json& point) {
  return driver.arm + " @ " + world + ", seed " + std::to_string(seed) + (point.empty() ? "" : ", " + point.dump());
}
std::string describe(const Cell& cell) {
  std::string text = describe(cell.driver, cell.world.id, cell.stream.seed, cell.point) + ", variant " + std::to_string(cell.variant);
  if (cell.at) text += ", at " + std::to_string(cell.at->amount) + " " + cell.at->unit;
  return text;
}
std::string describe(const Training& training) {
  return describe(training.driver, training.worlds.front().id, training.streams.front().seed, training.point);
}

void add_files(const Catalog& catalog, const ComponentSpec& spec, std::map<std::string, std::string>& files) {
  files[spec.type] = catalog.file_of(spec.type);
  for (const auto& [name, slot] : spec.slots) add_files(catalog, slot, files);
}

class Run {
 public:
  Run(const Experiment& experiment, const Catalog& catalog, const RunOptions& options, const RunListener& listener)
      : experiment_(experiment), trainings_(experiment.trainings()), cells_(experiment.cells()), catalog_(catalog), options_(options), listener_(listener) {
    for (const char* folder : {"", "/states", "/traces", "/scratch"}) make_directories(options.directory + folder);
    store_ = std::make_unique<Store>(options.directory);
    clear_scratch();
    write_file(options.directory + "/experiment.resolved.json", experiment.resolved.dump(2) + "\n");
    begin_session();
    plan();
    PoolOptions pool;
    pool.jobs = options.jobs;
    pool.worker = options.worker;
    pool.logs = options.directory + "/scratch";
    pool.deadline = std::chrono::seconds(options.deadline_s);
    pool.isolated = options.isolated;
    pool_ = std::make_unique<Pool>(pool);
  }

  RunReport go() {
    const auto began = std::chrono::steady_clock::now();
    while (true) {
      report_.progress.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
      if (listener_.progress) listener_.progress(report_.progress);
      if (!report_.stopped && listener_.stopping && listener_.stopping()) stop();
      feed();
      if (pool_->pending() == 0) break;
      if (const auto completion = pool_->next(std::chrono::milliseconds(200))) take(*completion);
      store_->tick();
    }
    store_->flush();
    pool_.reset();
    std::error_code ignored;
    fs::remove_all(options_.directory + "/scratch", ignored);
    if (listener_.progress) listener_.progress(report_.progress);
    return std::move(report_);
  }

 private:
  void clear_scratch() const {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(options_.directory + "/scratch", ignored)) fs::remove_all(entry.path(), ignored);
  }

  void begin_session() {
    std::map<std::string, std::string> files;
    for (const Cell& cell : experiment_.plan.compositions()) files.merge(plugin_files(catalog_, cell.driver, {cell.world}));
    for (const Training& training : trainings_) {
      files.merge(plugin_files(catalog_, training.driver, training.worlds));
      files.merge(plugin_files(catalog_, training.driver, training.selection_worlds));
    }
    build_ = store_->begin_session(build_description(files, options_.worker), session_description(options_.command));
  }

  // What is done stays done; what failed is tried again only when asked; cells wait for their training.
  void plan() {
    const auto trained = store_->done(UnitKind::training), tested = store_->done(UnitKind::cell);
    const auto untrained = store_->failed(UnitKind::training), untested = store_->failed(UnitKind::cell);
    require_same_build(trained);
    require_same_build(tested);
    Progress& progress = report_.progress;
    progress.planned = cells_.size();
    progress.trainings = trainings_.size();
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const std::string& id = cells_.id(i);
      const auto failed = untested.find(id);
      if (tested.count(id)) {
        ++progress.done;
        ++progress.resumed;
      } else if (failed != untested.end() && !options_.retry_failed) {
        ++progress.failed;
        if (report_.failures.size() < 100) report_.failures.push_back({"cell", describe(cells_[i]), failed->second.failure});
      } else {
        const std::string training = cells_[i].training;
        if (training.empty() || states_ready(training, trained)) ready_.push_back(i);
        else waiting_[training].push_back(i);
      }
    }
    // A training is done for the cells that wait for it, and for its own curves; one that failed only if a cell retries it.
    // Whatever one starts from stands before it in the plan, so the way back finds all that is missing.
    std::map<std::string, std::vector<std::size_t>> followers;
    std::vector<std::size_t> chosen;
    for (std::size_t i = trainings_.size(); i-- > 0;) {
      const std::string& id = trainings_.id(i);
      if (!waiting_.count(id) && !followers.count(id) && (trained.count(id) || untrained.count(id))) continue;
      chosen.push_back(i);
      const std::string source = trainings_[i].initial_training;
      if (!source.empty() && !states_ready(source, trained)) followers[source].push_back(i);
    }
    progress.trainings_done = progress.trainings - chosen.size();
    std::set<std::size_t> later;
    for (auto& [source, list] : followers) later.insert(list.begin(), list.end());
    for (auto i = chosen.rbegin(); i != chosen.rend(); ++i)
      if (!later.count(*i)) to_train_.push_back(*i);
    for (auto& [source, list] : followers) followers_[source].assign(list.rbegin(), list.rend());
  }

  void require_same_build(const std::map<std::string, DoneUnit>& done) const {
    if (options_.allow_mixed_builds) return;
    for (std::size_t i = 0; i < cells_.size(); ++i)
      if (const auto at = done.find(cells_.id(i)); at != done.end() && at->second.build != build_) refuse(at->second.build);
    for (std::size_t i = 0; i < trainings_.size(); ++i)
      if (const auto at = done.find(trainings_.id(i)); at != done.end() && at->second.build != build_) refuse(at->second.build);
  }
  [[noreturn]] void refuse(const std::string& other) const {
    throw Error(Exit::data, options_.directory + " holds results of another build (" + other.substr(0, 12) + ", this one is " + build_.substr(0, 12) +
                                "): the program, a plugin or the compiler changed.  Use another directory, or --allow-mixed-builds to go on here.");
  }

  // The state files of a training that is done, if they are all there.
  bool states_ready(const std::string& id, const std::map<std::string, DoneUnit>& trained) {
    if (states_.count(id)) return true;
    if (!trained.count(id)) return false;
    const auto result = store_->training(id);
    if (!result || !fs::exists(state_path(result->final_state))) return false;
    for (const auto& [at, file] : result->snapshots)
      if (!fs::exists(state_path(file))) return false;
    states_[id] = {result->snapshots, result->final_state};
    return true;
  }

  std::string state_path(const std::string& file) const { return options_.directory + "/states/" + file; }

  void stop() {
    report_.stopped = true;
    pool_->drop_queue();
    to_train_.clear();
    ready_.clear();
    waiting_.clear();
    followers_.clear();
  }

  // A few more than there are workers, so that none waits, and no more, so that a plan of millions costs no memory.
  void feed() {
    while (pool_->pending() < 2 * options_.jobs + 2) {
      Request request;
      request.scratch = options_.directory + "/scratch";
      request.batch = options_.batch;
      if (!to_train_.empty()) {
        const std::size_t i = to_train_.front();
        const Training training = trainings_[i];
        to_train_.pop_front();
        request.kind = Request::Kind::training;
        request.unit = training;
        request.plugins = plugin_files(catalog_, training.driver, training.worlds);
        for (const auto& world : training.selection_worlds) request.plugins[world.type] = catalog_.file_of(world.type);
        set_foreign_state(request, training.initial_state);
        if (!training.initial_training.empty()) set_final_state(request, training.initial_training);
        running_trainings_[training.id] = i;
        pool_->submit(training.id, std::move(request));
      } else if (!ready_.empty()) {
        const std::size_t i = ready_.front();
        const Cell cell = cells_[i];
        ready_.pop_front();
        request.kind = Request::Kind::cell;
        request.unit = cell;
        request.plugins = plugin_files(catalog_, cell.driver, {cell.world});
        set_state(request, cell);
        running_cells_[cell.id] = i;
        pool_->submit(cell.id, std::move(request));
      } else {
        return;
      }
    }
  }

  void set_foreign_state(Request& request, const std::string& hash) const {
    if (hash.empty()) return;
    request.state = experiment_.state_files.at(hash);
    request.state_name = request.state;
  }

  void set_final_state(Request& request, const std::string& training) const {
    const std::string& file = states_.at(training).final_state;
    request.state = state_path(file);
    request.state_name = "states/" + file;
  }

  void set_state(Request& request, const Cell& cell) const {
    set_foreign_state(request, cell.state);
    if (cell.training.empty()) return;
    const States& states = states_.at(cell.training);
    std::string file = states.final_state;
    if (cell.at) {
      const auto at = states.snapshots.find(cell.at->amount);
      if (at == states.snapshots.end()) throw Error(Exit::data, "the training of " + describe(cell) + " kept no such snapshot");
      file = at->second;
    }
    request.state = state_path(file);
    request.state_name = "states/" + file;
  }

  void take(const Completion& completion) {
    for (const std::string& warning : completion.answer.warnings)
      if (report_.warnings.size() < 50 && std::find(report_.warnings.begin(), report_.warnings.end(), warning) == report_.warnings.end())
        report_.warnings.push_back(warning);
    if (const auto at = running_trainings_.find(completion.id); at != running_trainings_.end()) {
      const Training training = trainings_[at->second];
      running_trainings_.erase(at);
      if (completion.answer.ok) trained(training, completion.answer.result.get<TrainingResult>());
      else training_failed(training, completion.answer.failure);
    } else if (const auto cell = running_cells_.find(completion.id); cell != running_cells_.end()) {
      const Cell done = cells_[cell->second];
      running_cells_.erase(cell);
      if (completion.answer.ok) tested(done, completion.answer.result.get<CellResult>());
      else cell_failed(done, completion.answer.failure);
    }
  }

  // Of the files that a unit says it wrote, the failure that one is gone: a plugin may have taken it away.
  std::optional<Failure> lost(const std::map<std::uint64_t, std::string>& files, const std::string& last) const {
    std::vector<std::string> all = last.empty() ? std::vector<std::string>() : std::vector<std::string>{last};
    for (const auto& [at, file] : files) all.push_back(file);
    for (const std::string& file : all)
      if (!fs::is_regular_file(options_.directory + "/scratch/" + file)) return Failure{"files", "expected the file scratch/" + file + " that it wrote, found none"};
    return std::nullopt;
  }

  void trained(const Training& training, const TrainingResult& result) {
    for (const auto* files : {&result.snapshots, &result.traces})
      if (const auto failure = lost(*files, result.final_state)) return training_failed(training, *failure);
    const auto publish = [&](const std::string& file) { publish_file(options_.directory + "/scratch/" + file, state_path(file)); };
    for (const auto& [at, file] : result.snapshots) publish(file);
    publish(result.final_state);
    publish_traces(result.traces);
    store_->record_training(training.id, training, "ok", Json::object(), result);
    states_[training.id] = {result.snapshots, result.final_state};
    report_.progress.steps += result.steps;
    ++report_.progress.trainings_done;
    if (const auto at = followers_.find(training.id); at != followers_.end()) {
      to_train_.insert(to_train_.end(), at->second.begin(), at->second.end());
      followers_.erase(at);
    }
    const auto waiting = waiting_.find(training.id);
    if (waiting == waiting_.end()) return;
    ready_.insert(ready_.end(), waiting->second.begin(), waiting->second.end());
    waiting_.erase(waiting);
  }

  void training_failed(const Training& training, const Failure& failure) {
    training_failed(training, failure, failure.cause + ": " + failure.message);
  }

  // `why` the first one failed, of all that start from each other.
  void training_failed(const Training& training, const Failure& failure, const std::string& why) {
    store_->record_failure(UnitKind::training, training.id, training, failure);
    tell({"training", describe(training), failure});
    if (const auto at = followers_.find(training.id); at != followers_.end()) {
      const std::vector<std::size_t> lost_ones = std::move(at->second);
      followers_.erase(at);
      for (const std::size_t i : lost_ones)
        training_failed(trainings_[i], {"training", "the training it starts from failed: " + why}, why);
    }
    const auto waiting = waiting_.find(training.id);
    if (waiting == waiting_.end()) return;
    const Failure inherited{"training", "its training failed: " + failure.cause + ": " + failure.message};
    for (const std::size_t i : waiting->second) {
      store_->record_failure(UnitKind::cell, cells_.id(i), cells_[i], inherited);
      ++report_.progress.failed;
    }
    waiting_.erase(waiting);
  }

  void publish_traces(const std::map<std::uint64_t, std::string>& traces) const {
    for (const auto& [episode, file] : traces) publish_file(options_.directory + "/scratch/" + file, options_.directory + "/traces/" + file);
  }

  void tested(const Cell& cell, const CellResult& result) {
    if (const auto failure = lost(result.traces, "")) return cell_failed(cell, *failure);
    publish_traces(result.traces);
    store_->record_cell(cell.id, cell, "ok", Json::object(), result);
    for (const Episode& episode : result.episodes)
      for (const RobotEpisode& robot : episode.robots) report_.progress.steps += robot.steps;
    ++report_.progress.done;
  }

  void cell_failed(const Cell& cell, const Failure& failure) {
    store_->record_failure(UnitKind::cell, cell.id, cell, failure);
    ++report_.progress.failed;
    tell({"cell", describe(cell), failure});
  }

  void tell(RunFailure failure) {
    if (listener_.failure) listener_.failure(failure);
    report_.failures.push_back(std::move(failure));
    if (options_.fail_fast) stop();
  }

  struct States {
    std::map<std::uint64_t, std::string> snapshots;
    std::string final_state;
  };

  const Experiment& experiment_;
  const Units<Training> trainings_;
  const Units<Cell> cells_;
  const Catalog& catalog_;
  const RunOptions& options_;
  const RunListener& listener_;
  std::unique_ptr<Store> store_;
  std::unique_ptr<Pool> pool_;
  std::string build_;
  std::map<std::string, States> states_;  // by training
  // Units by their place in the plan.
  std::deque<std::size_t> to_train_, ready_;
  std::map<std::string, std::vector<std::size_t>> waiting_, followers_;  // cells and trainings that wait for a training
  std::map<std::string, std::size_t> running_trainings_, running_cells_;
  RunReport report_;
};

}  // namespace

std::map<std::string, std::string> plugin_files(const Catalog& catalog, const DriverSpec& driver, const std::vector<WorldSpec>& worlds) {
  std::map<std::string, std::string> files;
  for (const WorldSpec& world : worlds) files[world.type] = catalog.file_of(world.type);
  for (const SensorSpec& sensor : driver.robot.sensors) add_files(catalog, sensor.component, files);
  add_files(catalog, driver.policy, files);
  if (driver.reward) add_files(catalog, *driver.reward, files);
  return files;
}

RunReport run_experiment(const Experiment& experiment, const Catalog& catalog, const RunOptions& options, const RunListener& listener) {
  return Run(experiment, catalog, options, listener).go();
}

}  // namespace wend::core
