// DIR/results.sqlite: everything a run found out, one record per attempt at a unit, appended and never changed.
// One process writes (DIR/lock), any number read beside it.  What flush() has returned from survives kill -9 and, as
// far as the disk keeps its word, power loss.
#pragma once
#include <chrono>
#include <core/base/json.hpp>
#include <core/experiment/unit.hpp>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace wend::core {

enum class UnitKind { training, cell };

struct DoneUnit {
  std::string build;          // id of the build that did it
  std::uint32_t attempt = 0;  // 1, 2, ...
};

struct FailedUnit {
  Failure failure;  // of the last attempt
  std::uint32_t attempts = 0;
};

class Store {
 public:
  // Opens or makes DIR/results.sqlite; read-only, it must be there.  Throws Error(Exit::data) with file and reason
  // where it is damaged, somebody else's, of another version, or in use by another run.
  explicit Store(const std::string& directory, bool read_only = false);
  ~Store();  // flushes; a failure to do so is lost here, so call flush() first
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  // Once before the first record: `build` names what computes ({"version", "compiler", "flags", "isa", "plugins", ...},
  // its SHA-256 is the build id), `session` this run of it ({"command", "started", "host", "cpu", ...}).
  std::string begin_session(const Json& build, const Json& session);

  // Appends an attempt and returns its number.  `status` is "ok", or "failed" with failure {"cause", "message"}; a
  // failed attempt's result is not kept.  `description` is the unit as JSON.  File names in the result are kept as
  // given.
  std::uint32_t record_training(const std::string& id, const Json& description, const std::string& status,
                                const Json& failure, const TrainingResult& result);
  std::uint32_t record_cell(const std::string& id, const Json& description, const std::string& status,
                            const Json& failure, const CellResult& result);
  std::uint32_t record_failure(UnitKind kind, const std::string& id, const Json& description, const Failure& failure);

  // Records are committed in groups: at 32 of them, or when tick() or a record comes 1 s after the group's first.
  void tick();
  void flush();
  std::uint64_t committed() const { return committed_; }  // records since the store was opened
  std::uint64_t pending() const { return pending_; }

  std::map<std::string, DoneUnit> done(UnitKind kind) const;            // has an attempt that is ok; the last such
  std::map<std::string, FailedUnit> failed(UnitKind kind) const;        // has attempts, none ok
  std::optional<TrainingResult> training(const std::string& id) const;  // of the last attempt that is ok
  std::optional<CellResult> cell(const std::string& id) const;
  std::optional<Json> description(const std::string& id) const;
  Json build() const;  // of the last session; empty object: none yet

  const std::string& path() const;

 private:
  void open_writing(const std::string& directory);
  void open_reading(const std::string& directory);
  void begin_record();
  template <class Insert>
  std::uint32_t record(Insert&& insert);

  struct Impl;
  std::unique_ptr<Impl> impl_;
  std::uint64_t committed_ = 0, pending_ = 0;
  std::chrono::steady_clock::time_point group_began_;
};

}  // namespace wend::core
