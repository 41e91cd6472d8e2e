// A thin owner of an SQLite connection and its statements; every failure is Error(Exit::data) with the file's name.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace wend::core {

class Statement;

class Database {
 public:
  enum class Access { write, read, read_unchanging };  // the last: nobody else writes, and the folder may be read-only
  Database(const std::string& path, Access access);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  void run(const char* sql);                  // one or several statements without result
  std::string value(const std::string& sql);  // first column of the first row as text, or empty
  std::int64_t last_row() const;
  bool in_transaction() const;
  const std::string& path() const { return path_; }
  [[noreturn]] void fail(const std::string& doing) const;

 private:
  friend class Statement;
  std::string path_;
  sqlite3* handle_ = nullptr;
};

// A prepared statement that is bound, stepped and used again.
class Statement {
 public:
  Statement(Database& database, const char* sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  // Binds the next parameter; NaN becomes NULL, as does an empty optional.
  Statement& bind(std::int64_t value);
  Statement& bind(double value);
  Statement& bind(std::string_view text);  // the text must live until the statement has run
  Statement& bind(std::nullptr_t);

  bool step();  // whether there is a row; without one the statement is ready to be bound again
  void run();   // to the end

  bool is_null(int column) const;
  std::int64_t integer(int column) const;
  double real(int column) const;  // NULL is NaN
  std::string text(int column) const;

 private:
  void check(int code);
  Database& database_;
  sqlite3_stmt* handle_ = nullptr;
  int bound_ = 0;
};

}  // namespace wend::core
