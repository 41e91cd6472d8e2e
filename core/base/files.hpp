// Files that are whole or not there at all.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace wend::core {

// The whole file; throws Error(Exit::data) where it cannot be read, is not a regular file or is larger than `limit` bytes.
std::string read_file(const std::string& path, std::uint64_t limit = std::uint64_t{1} << 30);

// Writes path.tmp, fsync, rename, fsync of the directory: a reader sees the old file or the new one.
void write_file(const std::string& path, std::string_view bytes);

// The same for a file that somebody else wrote under another name on the same file system.
void publish_file(const std::string& from, const std::string& to);

void make_directories(const std::string& path);

// The folder of the running program, symbolic links resolved.
std::string program_directory();

}  // namespace wend::core
