#include <cmath>
#include <core/base/error.hpp>
#include <core/base/files.hpp>
#include <core/base/sha256.hpp>
#include <core/record/schema.hpp>
#include <core/record/store_impl.hpp>
#include <filesystem>
#include <stdexcept>

namespace wend::core {
namespace {

constexpr std::uint64_t group_size = 32;
constexpr std::chrono::seconds group_age{1};
constexpr std::uintmax_t checked_size = 256u << 20;  // larger files are checked as they are read: 1 s a gigabyte

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Names and messages come from plugins: what is no UTF-8 in them is replaced, as it could never be written as JSON
// again.
std::string utf8(const std::string& text) {
  return Json::parse(text_of(text)).get<std::string>();
}

// The value of a description at `pointer` as a column: texts as they are, objects as JSON.
void bind_part(Statement& statement, const Json& description, const char* pointer, std::string& keep) {
  const Json::json_pointer at(pointer);
  if (!description.is_object() || !description.contains(at) || description.at(at).is_null()) {
    statement.bind(nullptr);
    return;
  }
  const Json& value = description.at(at);
  if (value.is_number_integer()) {
    statement.bind(value.get<std::int64_t>());
    return;
  }
  keep = value.is_string() ? value.get<std::string>() : text_of(value);
  statement.bind(keep);
}

// Whether the file is wend's and of this version; false: it is empty.
bool check_identity(Database& db) {
  const std::string application = db.value("PRAGMA application_id"), version = db.value("PRAGMA user_version");
  if (application == "0" && version == "0" && db.value("SELECT count(*) FROM sqlite_master") == "0") return false;
  if (application != std::to_string(schema_application))
    throw Error(Exit::data, db.path() + " is a database, but not a record of wend's: expected application id " +
                                std::to_string(schema_application) + ", found " + application +
                                "; give another directory");
  if (version != std::to_string(schema_version))
    throw Error(Exit::data, db.path() + " has format " + version + ", expected " + std::to_string(schema_version) +
                                ": use the wend that wrote it, or give another directory");
  std::error_code error;
  if (std::filesystem::file_size(db.path(), error) <= checked_size && !error)
    if (const std::string found = db.value("PRAGMA quick_check(1)"); found != "ok")
      throw Error(Exit::data, db.path() + " is damaged: " + found);
  return true;
}

std::string attempts_of(const char* table) {
  return std::string("SELECT COALESCE(MAX(attempt), 0) + 1 FROM ") + table + " WHERE id = ?";
}

}  // namespace

InsertStatements::InsertStatements(Database& db)
    : training_attempts(db, attempts_of("trainings").c_str()),
      cell_attempts(db, attempts_of("cells").c_str()),
      training(db,
               "INSERT INTO trainings(id, attempt, status, cause, message, session, arm, point, seed, hash, "
               "final_state, snapshots, traces, samples, steps, episodes, train_s, description) "
               "VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)"),
      cell(db,
           "INSERT INTO cells(id, attempt, status, cause, message, session, arm, point, seed, world, variant, at, "
           "training, metrics, traces, decision_us, description) VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)"),
      episode(db, "INSERT INTO episodes(cell, episode, robot, flags, steps, reward, hash) VALUES(?,?,?,?,?,?,?)"),
      metric(db, "INSERT INTO metrics(cell, episode, robot, name, value) VALUES(?,?,?,?,?)"),
      curve(db, "INSERT INTO curves(training, curve, point, metric, robot, x_name, x, y) VALUES(?,?,?,?,?,?,?,?)"),
      cell_curve(db, "INSERT INTO cell_curves(cell, curve, point, metric, robot, x_name, x, y) VALUES(?,?,?,?,?,?,?,?)") {}

// ----------------------------------------------------------------------------------------------------------- opening

Store::Store(const std::string& directory, bool read_only) : impl_(std::make_unique<Impl>()) {
  if (read_only) {
    open_reading(directory);
  } else {
    open_writing(directory);
  }
  impl_->query.emplace(*impl_->db);
}

void Store::open_writing(const std::string& directory) {
  make_directories(directory);
  impl_->lock.emplace(directory);
  Database& db = impl_->db.emplace(directory + "/results.sqlite", Database::Access::write);
  db.run("PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON");
  const bool filled = check_identity(db);
  // Write-ahead logging needs memory that all processes of one host share; elsewhere the rollback journal.
  if (is_on_network(directory) || db.value("PRAGMA journal_mode = WAL") != "wal")
    db.value("PRAGMA journal_mode = DELETE");
  db.run("PRAGMA synchronous = FULL");
  if (!filled) {
    const std::string mark = "; PRAGMA application_id = " + std::to_string(schema_application) +
                             "; PRAGMA user_version = " + std::to_string(schema_version) + "; COMMIT";
    db.run(("BEGIN IMMEDIATE; " + std::string(schema) + mark).c_str());
  }
  impl_->insert.emplace(db);
}

void Store::open_reading(const std::string& directory) {
  const std::string path = directory + "/results.sqlite";
  if (!std::filesystem::exists(path))
    throw Error(Exit::data, "no results in " + directory + ": " + path + " is missing");
  bool filled = false;
  try {
    filled = check_identity(impl_->db.emplace(path, Database::Access::read));
  } catch (const Error&) {
    // A log that was given up cleanly leaves a file that can be read from a folder that cannot be written.
    std::error_code error;
    if (std::filesystem::file_size(path + "-wal", error) > 0 && !error) throw;
    filled = check_identity(impl_->db.emplace(path, Database::Access::read_unchanging));
  }
  if (!filled) throw Error(Exit::data, "no results in " + directory + ": " + path + " is empty");
}

Store::~Store() {
  try {
    flush();
  } catch (const std::exception&) {  // a destructor has nobody to tell: who must know calls flush()
  }
}

const std::string& Store::path() const {
  return impl_->db->path();
}

// --------------------------------------------------------------------------------------------------------- recording

std::string Store::begin_session(const Json& build, const Json& session) {
  flush();
  const std::string text = text_of(build), details = text_of(session), id = sha256(text);
  Statement insert(*impl_->db, "INSERT INTO provenance(build_id, build, details) VALUES(?,?,?)");
  insert.bind(id).bind(text).bind(details).run();
  impl_->session = impl_->db->last_row();
  return id;
}

void Store::begin_record() {
  if (!impl_->insert || impl_->session == 0)
    throw std::logic_error("Store: begin_session() on a store opened for writing comes before the first record");
  if (pending_ == 0) {
    impl_->db->run("BEGIN IMMEDIATE");
    group_began_ = std::chrono::steady_clock::now();
  }
}

// A record is in the group whole or not at all.
template <class Insert>
std::uint32_t Store::record(Insert&& insert) {
  begin_record();
  std::uint32_t attempt = 0;
  ++pending_;
  try {
    impl_->db->run("SAVEPOINT record");
    attempt = insert();
    impl_->db->run("RELEASE record");
  } catch (...) {
    --pending_;
    if (!impl_->db->in_transaction()) {  // a full disk has rolled the whole group back
      pending_ = 0;
    } else {
      impl_->db->run(pending_ > 0 ? "ROLLBACK TO record; RELEASE record" : "ROLLBACK");
    }
    throw;
  }
  if (pending_ >= group_size) flush();
  tick();
  return attempt;
}

void Store::tick() {
  if (pending_ > 0 && std::chrono::steady_clock::now() - group_began_ >= group_age) flush();
}

void Store::flush() {
  if (pending_ == 0) return;
  try {
    impl_->db->run("COMMIT");
  } catch (const Error&) {
    if (!impl_->db->in_transaction()) pending_ = 0;  // a full disk may have rolled the group back
    throw;
  }
  committed_ += pending_;
  pending_ = 0;
}

namespace {

struct Attempt {
  const std::string& id;
  const Json& description;
  const std::string& status;
  Failure failure;
  std::int64_t session;
  std::string arm, point, text;
};

Attempt attempt_of(const std::string& id, const Json& description, const std::string& status, const Json& failure,
                   std::int64_t session) {
  if (status != "ok" && status != "failed")
    throw std::invalid_argument("Store: expected status \"ok\" or \"failed\", found \"" + status + "\"");
  Failure why;
  if (failure.is_object()) {
    const Json cause = failure.value("cause", Json()), message = failure.value("message", Json());
    if (cause.is_string()) why.cause = utf8(cause.get<std::string>());
    if (message.is_string()) why.message = utf8(message.get<std::string>());
  }
  return {id, description, status, std::move(why), session, {}, {}, text_of(description)};
}

// The columns that trainings and cells share, up to the seed; returns the attempt's number.
std::uint32_t bind_attempt(Statement& count, Statement& insert, Attempt& attempt, const char* seed) {
  count.bind(attempt.id).step();
  const std::int64_t number = count.integer(0);
  count.run();
  insert.bind(attempt.id).bind(number).bind(attempt.status);
  if (attempt.status == "ok") {
    insert.bind(nullptr).bind(nullptr);
  } else {
    insert.bind(attempt.failure.cause).bind(attempt.failure.message);
  }
  insert.bind(attempt.session);
  bind_part(insert, attempt.description, "/driver/arm", attempt.arm);
  bind_part(insert, attempt.description, "/point", attempt.point);
  std::string none;
  bind_part(insert, attempt.description, seed, none);
  return static_cast<std::uint32_t>(number);
}

template <class T>
Json numbered(const std::map<std::uint64_t, T>& values) {
  Json json = Json::object();
  for (const auto& [number, value] : values) json[std::to_string(number)] = value;
  return json;
}

void add_curves(Statement& insert, std::int64_t row, const std::vector<Curve>& curves) {
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const Curve& curve = curves[c];
    const std::string metric = utf8(curve.metric), x_name = utf8(curve.x);
    for (std::size_t p = 0; p < curve.points.size(); ++p) {
      insert.bind(row).bind(static_cast<std::int64_t>(c)).bind(static_cast<std::int64_t>(p)).bind(metric);
      if (curve.robot) {
        insert.bind(static_cast<std::int64_t>(*curve.robot));
      } else {
        insert.bind(nullptr);
      }
      insert.bind(x_name).bind(curve.points[p].first).bind(curve.points[p].second).run();
    }
  }
}

void add_episodes(InsertStatements& insert, std::int64_t row, const CellResult& result) {
  std::vector<std::string> names;
  for (const std::string& name : result.metrics) names.push_back(utf8(name));
  for (const Episode& episode : result.episodes) {
    const auto index = static_cast<std::int64_t>(episode.index);
    for (const RobotEpisode& robot : episode.robots) {
      if (robot.metrics.size() != result.metrics.size())
        throw std::invalid_argument("Store: expected " + std::to_string(result.metrics.size()) + " metrics of robot " +
                                    std::to_string(robot.robot) + " in episode " + std::to_string(episode.index) +
                                    ", found " + std::to_string(robot.metrics.size()));
      insert.episode.bind(row).bind(index).bind(static_cast<std::int64_t>(robot.robot));
      insert.episode.bind(static_cast<std::int64_t>(robot.flags)).bind(static_cast<std::int64_t>(robot.steps));
      insert.episode.bind(robot.reward).bind(episode.hash).run();
      for (std::size_t m = 0; m < result.metrics.size(); ++m) {
        if (std::isnan(robot.metrics[m])) continue;  // does not apply: no row
        insert.metric.bind(row).bind(index).bind(static_cast<std::int64_t>(robot.robot));
        insert.metric.bind(names[m]).bind(robot.metrics[m]).run();
      }
    }
  }
}

}  // namespace

std::uint32_t Store::record_training(const std::string& id, const Json& description, const std::string& status,
                                     const Json& failure, const TrainingResult& result) {
  Attempt attempt = attempt_of(id, description, status, failure, impl_->session);
  return record([&] {
    InsertStatements& insert = *impl_->insert;
    const std::uint32_t number = bind_attempt(insert.training_attempts, insert.training, attempt, "/streams/0/seed");
    const std::string snapshots = text_of(numbered(result.snapshots)), traces = text_of(numbered(result.traces));
    if (status == "ok") {
      insert.training.bind(result.hash).bind(result.final_state).bind(snapshots).bind(traces);
      for (const std::uint64_t n : {result.samples, result.steps, result.episodes})
        insert.training.bind(static_cast<std::int64_t>(n));
      insert.training.bind(result.train_s);
    } else {
      for (int i = 0; i < 8; ++i) insert.training.bind(nullptr);
    }
    insert.training.bind(attempt.text).run();
    if (status == "ok") add_curves(insert.curve, impl_->db->last_row(), result.curves);
    return number;
  });
}

std::uint32_t Store::record_cell(const std::string& id, const Json& description, const std::string& status,
                                 const Json& failure, const CellResult& result) {
  Attempt attempt = attempt_of(id, description, status, failure, impl_->session);
  return record([&] {
    InsertStatements& insert = *impl_->insert;
    const std::uint32_t number = bind_attempt(insert.cell_attempts, insert.cell, attempt, "/stream/seed");
    std::string world, at, training, none;
    bind_part(insert.cell, description, "/world/id", world);
    bind_part(insert.cell, description, "/variant", none);
    bind_part(insert.cell, description, "/at", at);
    bind_part(insert.cell, description, "/training", training);
    const std::string metrics = text_of(result.metrics), traces = text_of(numbered(result.traces));
    if (status == "ok") {
      insert.cell.bind(metrics).bind(traces).bind(result.decision_us);
    } else {
      insert.cell.bind(nullptr).bind(nullptr).bind(nullptr);
    }
    insert.cell.bind(attempt.text).run();
    if (status != "ok") return number;
    const std::int64_t row = impl_->db->last_row();
    add_episodes(insert, row, result);
    add_curves(insert.cell_curve, row, result.curves);
    return number;
  });
}

std::uint32_t Store::record_failure(UnitKind kind, const std::string& id, const Json& description,
                                    const Failure& failure) {
  const Json why = {{"cause", failure.cause}, {"message", failure.message}};
  return kind == UnitKind::training ? record_training(id, description, "failed", why, {})
                                    : record_cell(id, description, "failed", why, {});
}

}  // namespace wend::core
