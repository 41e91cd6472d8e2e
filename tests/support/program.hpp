// Programs started as a user starts them: arguments, environment, folder; their exit, what they printed, and signals.
#pragma once
#include <sys/types.h>

#include <chrono>
#include <map>
#include <string>
#include <vector>

namespace wend::test {

// A folder that is gone when the test is over.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::string& path() const { return path_; }
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  // Writes a file in it and returns its path.
  std::string write(const std::string& name, const std::string& text) const;

 private:
  std::string path_;
};

struct Setting {
  std::map<std::string, std::string> environment;  // on top of this process's; plugins of the user's are never found
  std::string directory;                           // where it runs; empty: here
  std::chrono::seconds patience{120};              // then it is killed, and ends by SIGKILL
};

struct Outcome {
  int exit = -1;   // or -1 where a signal ended it
  int signal = 0;  // that signal
  std::string out, err;
};

class Program {
 public:
  explicit Program(const std::vector<std::string>& arguments, const Setting& setting = {});
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void signal(int number) const;  // to it alone, not to what it started
  bool ended();
  Outcome wait();
  pid_t id() const { return id_; }

 private:
  std::string take(int descriptor) const;

  pid_t id_ = -1;
  int out_ = -1, err_ = -1, status_ = 0;
  bool ended_ = false;
  std::chrono::seconds patience_;
};

Outcome run(const std::vector<std::string>& arguments, const Setting& setting = {});

// The first of these programs that is installed, or "".
std::string find_program(const std::vector<std::string>& names);

std::string read_text(const std::string& path);

// `text` with every `what` replaced, so that messages can be compared whole though they name temporary folders.
std::string replaced(std::string text, const std::string& what, const std::string& with);

}  // namespace wend::test
