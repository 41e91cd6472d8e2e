// One worker process, as the host holds it: the private descriptor, what it prints, and its end.
#pragma once
#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <string>

namespace wend::core {

class WorkerProcess {
 public:
  WorkerProcess() = default;
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  // Throws Error where it cannot be started.  It gets a process group of its own: what a plugin starts ends with it,
  // and the terminal's Ctrl-C reaches the host alone.
  void start(const std::string& program, const std::string& log, std::uint64_t memory);
  bool running() const noexcept { return pid_ > 0; }
  int fd() const noexcept { return fd_; }
  std::uint64_t nonce() const noexcept { return nonce_; }

  // An idle worker is, unless it is gone or what it served last still writes to its descriptor.
  bool quiet() const noexcept;
  // True once its process has ended, which it may take `wait` for.
  bool ended(std::chrono::milliseconds wait) const;
  // Kills it, if it runs, and all that it started.  Returns its wait status.
  int stop();

  void forget_words() const;  // what it printed so far
  // The end of what it printed, for a person to see what it died of.
  std::string last_words() const;

 private:
  pid_t pid_ = -1;
  int fd_ = -1;
  std::uint64_t nonce_ = 0;
  std::string log_;
};

}  // namespace wend::core
