#include <core/base/error.hpp>
#include <core/base/files.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace wend::core {
namespace {

[[noreturn]] void fail(const std::string& what, const std::string& path) {
  throw Error(Exit::data, what + " " + path + ": " + std::strerror(errno));
}

struct Descriptor {
  int fd;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
};

void sync_directory(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  const Descriptor directory{::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
  if (directory.fd >= 0) ::fsync(directory.fd);  // some network file systems refuse it; the rename still stands
}

void rename_durably(const std::string& from, const std::string& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) fail("cannot rename " + from + " to", to);
  sync_directory(to);
}

}  // namespace

std::string read_file(const std::string& path, std::uint64_t limit) {
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
  struct stat status {};
  if (file.fd < 0 || ::fstat(file.fd, &status) != 0) fail("cannot read", path);
  if (!S_ISREG(status.st_mode)) throw Error(Exit::data, "cannot read " + path + ": not a regular file");
  if (static_cast<std::uint64_t>(status.st_size) > limit)
    throw Error(Exit::data, "cannot read " + path + ": " + std::to_string(status.st_size) + " bytes, expected at most " +
                                std::to_string(limit));
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n = ::read(file.fd, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail("cannot read", path);
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  bytes.resize(done);
  return bytes;
}

void write_file(const std::string& path, std::string_view bytes) {
  const std::string temporary = path + ".tmp";
  {
    const Descriptor file{::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)};
    if (file.fd < 0) fail("cannot write", temporary);
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t n = ::write(file.fd, bytes.data() + done, bytes.size() - done);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) fail("cannot write", temporary);
      done += static_cast<std::size_t>(n);
    }
    if (::fsync(file.fd) != 0) fail("cannot write", temporary);
  }
  rename_durably(temporary, path);
}

void publish_file(const std::string& from, const std::string& to) {
  {
    const Descriptor file{::open(from.c_str(), O_RDONLY | O_CLOEXEC)};
    if (file.fd < 0 || ::fsync(file.fd) != 0) fail("cannot write", from);
  }
  rename_durably(from, to);
}

void make_directories(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw Error(Exit::data, "cannot make the directory " + path + ": " + error.message());
}

std::string program_directory() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) throw Error(Exit::data, "cannot find the running program: " + error.message());
  return program.parent_path().string();
}

}  // namespace wend::core
