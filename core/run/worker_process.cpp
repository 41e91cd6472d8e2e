#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <core/base/error.hpp>
#include <core/run/worker_process.hpp>
#include <csignal>
#include <cstring>
#include <random>
#include <thread>

extern char** environ;

namespace wend::core {
namespace {

constexpr int child_fd = 3;
constexpr std::size_t most_words = 400;

// What the new process does before it runs the program: quiet streams, the descriptor, a group of its own.
struct Spawning {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;

  Spawning(const std::string& log, int descriptor) {
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0666);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    posix_spawn_file_actions_adddup2(&actions, descriptor, child_fd);
    posix_spawn_file_actions_addclosefrom_np(&actions, child_fd + 1);  // nor what the host itself inherited
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    posix_spawnattr_setpgroup(&attributes, 0);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes, &signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) sigaddset(&signals, signal);
    posix_spawnattr_setsigdefault(&attributes, &signals);
  }
  ~Spawning() {
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
  }
  Spawning(const Spawning&) = delete;
  Spawning& operator=(const Spawning&) = delete;
};

}  // namespace

WorkerProcess::~WorkerProcess() {
  if (running()) stop();
}

void WorkerProcess::start(const std::string& program, const std::string& log, std::uint64_t memory) {
  int pair[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair) != 0)
    throw Error(Exit::data, std::string("cannot make a socket pair for a worker: ") + std::strerror(errno));
  const int high = ::fcntl(pair[1], F_DUPFD_CLOEXEC, 10);  // dup2 onto itself would keep close-on-exec
  ::close(pair[1]);
  const timeval patience{60, 0};  // a worker that takes nothing in is given up, and does not hold the host up
  ::setsockopt(pair[0], SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  nonce_ = (std::uint64_t{std::random_device{}()} << 32) | std::random_device{}();  // no result depends on it
  log_ = log;

  const std::string fd = std::to_string(child_fd), nonce = std::to_string(nonce_), limit = std::to_string(memory);
  const char* arguments[] = {program.c_str(), fd.c_str(), nonce.c_str(), limit.c_str(), nullptr};
  const Spawning spawning(log, high);
  const int error = posix_spawn(&pid_, program.c_str(), &spawning.actions, &spawning.attributes,
                                const_cast<char**>(arguments), environ);
  if (high >= 0) ::close(high);
  if (error != 0) {
    ::close(pair[0]);
    pid_ = -1;
    throw Error(Exit::data, "cannot start " + program + " (its log: " + log + "): " + std::strerror(error));
  }
  fd_ = pair[0];
}

bool WorkerProcess::quiet() const noexcept {
  char byte;
  const ssize_t n = ::recv(fd_, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
  return n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
}

bool WorkerProcess::ended(std::chrono::milliseconds wait) const {
  const auto until = std::chrono::steady_clock::now() + wait;
  while (true) {
    siginfo_t info{};
    if (::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == pid_)
      return true;
    if (std::chrono::steady_clock::now() >= until) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

int WorkerProcess::stop() {
  ::kill(-pid_, SIGKILL);  // its group, while its own end still keeps the number from being given to another
  ::kill(pid_, SIGKILL);
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  ::close(fd_);
  fd_ = -1;
  ::unlink(log_.c_str());
  return status;
}

void WorkerProcess::forget_words() const {
  if (::truncate(log_.c_str(), 0) != 0) return;  // a plugin took the file away; then there is nothing to forget
}

std::string WorkerProcess::last_words() const {
  const int file = ::open(log_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return "";
  const off_t size = ::lseek(file, 0, SEEK_END);
  std::string text(std::min<std::size_t>(most_words + 1, static_cast<std::size_t>(std::max<off_t>(size, 0))), '\0');
  const ssize_t n = ::pread(file, text.data(), text.size(), size - static_cast<off_t>(text.size()));
  ::close(file);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
  const bool cut = text.size() > most_words;
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  if (text.empty()) return "";
  return "; it printed: " + (cut ? "..." + text.substr(1) : text);
}

}  // namespace wend::core
