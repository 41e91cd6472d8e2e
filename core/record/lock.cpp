#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <cerrno>
#include <core/base/error.hpp>
#include <core/record/json_text.hpp>
#include <core/record/lock.hpp>
#include <cstring>
#include <ctime>

namespace wend::core {
namespace {

std::string host_name() {
  char name[256] = "";
  ::gethostname(name, sizeof name - 1);
  return name;
}

std::string now() {
  const std::time_t seconds = std::time(nullptr);
  std::tm date{};
  ::gmtime_r(&seconds, &date);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S UTC", &date);
  return text;
}

// "process 123 on host, since 2026-01-01 12:00:00 UTC"
std::string holder(const std::string& text) {
  const auto json = parse_recorded(text);
  if (!json || !json->is_object() || !json->contains("pid")) return "another process";
  const auto entry = [&](const char* key) {
    const Json value = json->value(key, Json("?"));
    return value.is_string() ? value.get<std::string>() : value.dump();
  };
  return "process " + entry("pid") + " on " + entry("host") + ", since " + entry("since");
}

std::string content(int descriptor) {
  char text[1024];
  const ssize_t n = ::pread(descriptor, text, sizeof text, 0);
  return n > 0 ? std::string(text, static_cast<std::size_t>(n)) : "";
}

}  // namespace

bool is_on_network(const std::string& path) {
  struct statfs status {};
  if (::statfs(path.c_str(), &status) != 0) return false;
  switch (static_cast<std::uint32_t>(status.f_type)) {
    case 0x6969:      // NFS
    case 0x517b:      // SMB
    case 0xff534d42:  // CIFS
    case 0xfe534d42:  // SMB2
    case 0x0bd00bd0:  // Lustre
    case 0x47504653:  // GPFS
    case 0x00c36400:  // Ceph
    case 0x5346414f:  // AFS
    case 0x19830326:  // BeeGFS
    case 0x01021997:  // 9p
    case 0x65735546:  // FUSE: sshfs and the like
      return true;
    default:
      return false;
  }
}

std::string DirectoryLock::objection(const std::string& path, const std::string& text, const std::string& host,
                                     bool on_network) {
  if (text.empty() || !on_network) return "";
  const auto json = parse_recorded(text);
  if (json && json->is_object() && json->value("host", Json()) == host) return "";
  return path + " was left by " + holder(text) + "; if that process is gone, remove the file and start again";
}

DirectoryLock::DirectoryLock(const std::string& directory) {
  const std::string path = directory + "/lock";
  descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (descriptor_ < 0) throw Error(Exit::data, "cannot write " + path + ": " + std::strerror(errno));
  std::string reason;
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    reason = errno == EWOULDBLOCK ? directory + " is in use by " + holder(content(descriptor_)) +
                                        "; wait for it, stop it, or give another directory"
                                  : "cannot lock " + path + ": " + std::strerror(errno);
  } else {
    reason = objection(path, content(descriptor_), host_name(), is_on_network(directory));
    const std::string mine = Json{{"pid", ::getpid()}, {"host", host_name()}, {"since", now()}}.dump() + "\n";
    if (reason.empty() && (::ftruncate(descriptor_, 0) != 0 ||
                           ::pwrite(descriptor_, mine.data(), mine.size(), 0) != static_cast<ssize_t>(mine.size())))
      reason = "cannot write " + path + ": " + std::strerror(errno);
  }
  if (reason.empty()) return;
  ::close(descriptor_);
  throw Error(Exit::data, reason);
}

DirectoryLock::~DirectoryLock() {
  // The file stays: removing it could take another process's fresh lock away.  Empty, it names nobody.
  if (::ftruncate(descriptor_, 0) != 0) {
  }
  ::close(descriptor_);
}

}  // namespace wend::core
