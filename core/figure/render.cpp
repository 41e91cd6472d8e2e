#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <core/base/error.hpp>
#include <core/base/files.hpp>
#include <core/figure/render.hpp>
#include <cstring>
#include <filesystem>
#include <thread>

extern char** environ;

namespace wend::core {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(const std::string& message) {
  throw Error(Exit::data, message);
}

// wend-render, with one socket as its standard input and output.  Writing to a socket, unlike a pipe, raises no
// SIGPIPE.
class Renderer {
 public:
  Renderer(std::string program, int patience) : program_(std::move(program)), patience_(patience) {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      fail(std::string("cannot talk to wend-render: ") + std::strerror(errno));
    fd_ = ends[0];
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    char* arguments[] = {program_.data(), nullptr};
    const int error = ::posix_spawn(&pid_, program_.c_str(), &actions, &attributes, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    ::close(ends[1]);
    if (error == 0) return;
    pid_ = -1;
    ::close(fd_);
    fail("cannot run " + program_ + ": " + std::strerror(error) +
         "; it draws the pictures and stands beside the wend program");
  }
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;
  ~Renderer() {
    if (fd_ >= 0) ::close(fd_);
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    reap();
  }

  // One picture: a line there, a line back.
  void draw(const std::string& path, const Figure& figure, double scale) {
    deadline_ = Clock::now() + std::chrono::seconds(patience_);
    const Json job = {{"out", path}, {"scale", scale}, {"figure", to_json(figure)}};
    send(job.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n", path);
    const Json answer = Json::parse(receive(path), nullptr, false);
    if (!answer.is_object() || !answer.contains("ok") || !answer["ok"].is_boolean())
      fail("cannot draw " + path + ": " + program_ + " gave an answer that is not JSON");
    if (answer["ok"].get<bool>()) return;
    const bool reason = answer.contains("error") && answer["error"].is_string();
    fail("cannot draw " + path + ": " + (reason ? answer["error"].get<std::string>() : "no reason given"));
  }

  // Ends its input and waits until it has ended too.
  void finish() {
    ::close(fd_);
    fd_ = -1;
    reap();
  }

 private:
  // Waits until the socket can be read or written; throws when patience is over.
  void await(short events, const std::string& path) {
    for (;;) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - Clock::now()).count();
      pollfd wait{fd_, events, 0};
      const int ready = left > 0 ? ::poll(&wait, 1, static_cast<int>(left)) : 0;
      if (ready > 0) return;
      if (ready < 0 && errno != EINTR) ended(path);
      if (ready == 0)
        fail("cannot draw " + path + ": " + program_ + " took longer than " + std::to_string(patience_) + " s");
    }
  }
  void send(const std::string& line, const std::string& path) {
    for (std::size_t done = 0; done < line.size();) {
      await(POLLOUT, path);
      const ssize_t n = ::send(fd_, line.data() + done, line.size() - done, MSG_NOSIGNAL | MSG_DONTWAIT);
      if (n < 0 && errno != EINTR && errno != EAGAIN) ended(path);
      if (n > 0) done += static_cast<std::size_t>(n);
    }
  }
  std::string receive(const std::string& path) {
    std::string line;
    for (char buffer[4096];;) {
      await(POLLIN, path);
      const ssize_t n = ::recv(fd_, buffer, sizeof buffer, MSG_DONTWAIT);
      if (n == 0 || (n < 0 && errno != EINTR && errno != EAGAIN)) ended(path);
      if (n > 0) line.append(buffer, static_cast<std::size_t>(n));
      if (!line.empty() && line.back() == '\n') return line;
      if (line.size() > (std::size_t{1} << 20)) fail("cannot draw " + path + ": " + program_ + " answers without end");
    }
  }
  [[noreturn]] void ended(const std::string& path) {
    const int status = reap();
    const std::string how = WIFSIGNALED(status) ? std::string("was ended by ") + ::strsignal(WTERMSIG(status))
                                                : "ended with exit code " + std::to_string(WEXITSTATUS(status));
    fail("cannot draw " + path + ": " + program_ + " " + how + " before it answered");
  }
  // Its exit status; a program that has nothing more to read or say and does not end in 2 s is made to.
  int reap() {
    int status = 0;
    for (int waited = 0; pid_ > 0; waited += 5) {
      if (waited >= 2000) ::kill(pid_, SIGKILL);
      const pid_t done = ::waitpid(pid_, &status, waited >= 2000 ? 0 : WNOHANG);
      if (done == pid_ || (done < 0 && errno != EINTR)) break;
      if (done == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    pid_ = -1;
    return status;
  }

  std::string program_;
  int patience_, fd_ = -1;
  pid_t pid_ = -1;
  Clock::time_point deadline_;
};

}  // namespace

void render_png(const std::vector<std::pair<std::string, Figure>>& pictures, const RenderOptions& options) {
  if (pictures.empty()) return;
  Renderer renderer(options.program.empty() ? program_directory() + "/wend-render" : options.program, options.patience);
  for (const auto& [path, figure] : pictures) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    if (!folder.empty()) make_directories(folder);
    renderer.draw(path, figure, options.scale);
  }
  renderer.finish();
}

}  // namespace wend::core
