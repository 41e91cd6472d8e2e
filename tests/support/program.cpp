#include "program.hpp"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace wend::test {

namespace fs = std::filesystem;

TemporaryDirectory::TemporaryDirectory() {
  path_ = fs::canonical(fs::temp_directory_path()) / "wend-test-XXXXXX";
  if (::mkdtemp(path_.data()) == nullptr) throw std::runtime_error("no temporary directory");
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string TemporaryDirectory::write(const std::string& name, const std::string& text) const {
  const std::string path = path_ + "/" + name;
  fs::create_directories(fs::path(path).parent_path());
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

Program::Program(const std::vector<std::string>& arguments, const Setting& setting) : patience_(setting.patience) {
  out_ = ::memfd_create("out", MFD_CLOEXEC);
  err_ = ::memfd_create("err", MFD_CLOEXEC);
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  id_ = ::fork();
  if (id_ < 0) throw std::runtime_error("cannot fork");
  if (id_ > 0) return;
  ::dup2(out_, 1);
  ::dup2(err_, 2);
  ::unsetenv("WEND_PLUGIN_PATH");
  ::setenv("XDG_DATA_HOME", "/nonexistent", 1);
  for (const auto& [name, value] : setting.environment) ::setenv(name.c_str(), value.c_str(), 1);
  if (!setting.directory.empty() && ::chdir(setting.directory.c_str()) != 0) ::_exit(126);
  ::execvp(argv[0], argv.data());
  ::_exit(127);
}

Program::~Program() {
  if (!ended()) {
    signal(SIGKILL);
    wait();
  }
  ::close(out_);
  ::close(err_);
}

void Program::signal(int number) const {
  if (!ended_) ::kill(id_, number);
}

bool Program::ended() {
  if (!ended_) ended_ = ::waitpid(id_, &status_, WNOHANG) == id_;
  return ended_;
}

Outcome Program::wait() {
  const auto until = std::chrono::steady_clock::now() + patience_;
  while (!ended()) {
    if (std::chrono::steady_clock::now() > until) signal(SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  Outcome outcome;
  if (WIFSIGNALED(status_))
    outcome.signal = WTERMSIG(status_);
  else
    outcome.exit = WEXITSTATUS(status_);
  outcome.out = take(out_);
  outcome.err = take(err_);
  return outcome;
}

std::string Program::take(int descriptor) const {
  std::string text(static_cast<std::size_t>(::lseek(descriptor, 0, SEEK_END)), '\0');
  const ssize_t n = ::pread(descriptor, text.data(), text.size(), 0);
  text.resize(static_cast<std::size_t>(n < 0 ? 0 : n));
  return text;
}

Outcome run(const std::vector<std::string>& arguments, const Setting& setting) {
  return Program(arguments, setting).wait();
}

std::string find_program(const std::vector<std::string>& names) {
  const char* path = std::getenv("PATH");
  for (const std::string& name : names) {
    if (name.find('/') != std::string::npos && ::access(name.c_str(), X_OK) == 0) return name;
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
      if (const std::string file = folder + "/" + name; ::access(file.c_str(), X_OK) == 0) return file;
  }
  return "";
}

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, what.size(), with);
  return text;
}

}  // namespace wend::test
