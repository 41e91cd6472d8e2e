// What a Store owns: the lock, the connection and its statements.  Only for store.cpp and store_read.cpp.
#pragma once
#include <core/record/lock.hpp>
#include <core/record/sqlite.hpp>
#include <core/record/store.hpp>
#include <optional>

namespace wend::core {

struct InsertStatements {
  explicit InsertStatements(Database& db);
  Statement training_attempts, cell_attempts, training, cell, episode, metric, curve, cell_curve;
};

struct QueryStatements {
  explicit QueryStatements(Database& db);
  Statement training, curves, cell, episodes, metrics, cell_curves;
};

struct Store::Impl {
  std::optional<DirectoryLock> lock;  // the writer's; given back after the connection is closed
  std::optional<Database> db;
  std::optional<InsertStatements> insert;
  std::optional<QueryStatements> query;
  std::int64_t session = 0;

  Json parse(const std::string& text, const char* what) const;  // Error(Exit::data) where it is not JSON
};

}  // namespace wend::core
