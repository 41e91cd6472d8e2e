// Keeps two runs off one directory, on one host or two, and names who holds it.
#pragma once
#include <string>

namespace wend::core {

class DirectoryLock {
 public:
  // Takes DIR/lock.  Throws Error(Exit::data) that names the holder: process, host and since when.
  explicit DirectoryLock(const std::string& directory);
  ~DirectoryLock();
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;

  // What `text`, the content of a lock file, means for a process of `host` that got the lock: an empty string, or why
  // it must not go on.  A killed holder leaves its name behind.  On a file system of this host its flock is gone with
  // it; on a network's, a flock may not reach across hosts, so a name of another host counts.
  static std::string objection(const std::string& path, const std::string& text, const std::string& host,
                               bool on_network);

 private:
  int descriptor_ = -1;
};

// Whether the file system of `path` is a network's, where SQLite's shared memory does not work.
bool is_on_network(const std::string& path);

}  // namespace wend::core
