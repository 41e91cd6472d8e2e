#include <elf.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <core/base/error.hpp>
#include <core/plugin/elf.hpp>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace wend::core {
namespace {

constexpr std::string_view section_name = ".wend.manifest", symbol_name = "wend_plugin_1";
constexpr std::uint64_t manifest_limit = 1 << 20, table_limit = 64 << 20;

[[noreturn]] void fail(const std::string& message) {
  throw Error(Exit::plugin, message);
}

// Nothing is read that the file does not have, whatever its tables say.
class File {
 public:
  explicit File(const std::string& path) : fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    struct stat status {};
    if (fd_ < 0) fail("cannot be opened: " + std::string(std::strerror(errno)));
    if (::fstat(fd_, &status) != 0) close_and_fail("cannot be read: " + std::string(std::strerror(errno)));
    if (S_ISDIR(status.st_mode)) close_and_fail("a directory, expected a shared object");
    if (!S_ISREG(status.st_mode)) close_and_fail("not a regular file");
    size_ = static_cast<std::uint64_t>(status.st_size);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() { ::close(fd_); }

  std::uint64_t size() const { return size_; }

  void read(std::uint64_t at, void* to, std::uint64_t n, const char* what) const {
    if (at > size_ || n > size_ - at)
      fail("damaged or truncated: " + std::string(what) + " lies beyond the end of the file (" + std::to_string(size_) +
           " bytes)");
    auto* bytes = static_cast<char*>(to);
    for (std::uint64_t done = 0; done < n;) {
      const ssize_t got = ::pread(fd_, bytes + done, n - done, static_cast<off_t>(at + done));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) fail("cannot be read: " + std::string(got == 0 ? "it has become shorter" : std::strerror(errno)));
      done += static_cast<std::uint64_t>(got);
    }
  }

  template <class T>
  std::vector<T> table(std::uint64_t at, std::uint64_t bytes, const char* what) const {
    if (bytes > table_limit) fail("damaged: " + std::string(what) + " has " + std::to_string(bytes) + " bytes");
    std::vector<T> all(bytes / sizeof(T));
    read(at, all.data(), all.size() * sizeof(T), what);
    return all;
  }

 private:
  [[noreturn]] void close_and_fail(const std::string& message) const {
    ::close(fd_);  // the destructor of an object that was not constructed does not run
    fail(message);
  }

  int fd_;
  std::uint64_t size_ = 0;
};

Elf64_Ehdr header_of(const File& file) {
  if (file.size() == 0) fail("an empty file, expected a shared object");
  Elf64_Ehdr header{};
  unsigned char start[EI_NIDENT] = {};
  file.read(0, start, std::min<std::uint64_t>(sizeof start, file.size()), "the ELF header");
  if (std::memcmp(start, ELFMAG, SELFMAG) != 0) fail("not an ELF file, expected a shared object");
  if (start[EI_CLASS] != ELFCLASS64) fail("a 32-bit ELF file, expected a 64-bit one");
  if (start[EI_DATA] != ELFDATA2LSB) fail("a big-endian ELF file, expected a little-endian one");
  file.read(0, &header, sizeof header, "the ELF header");
  if (header.e_machine != EM_X86_64)
    fail("built for another machine (ELF machine " + std::to_string(header.e_machine) + "), expected x86-64 (62)");
  if (header.e_type != ET_DYN)
    fail(header.e_type == ET_EXEC  ? "a program, expected a shared object"
         : header.e_type == ET_REL ? "an object file, expected a shared object: link it with -shared"
                                   : "ELF type " + std::to_string(header.e_type) + ", expected a shared object (3)");
  return header;
}

// dlopen maps the segments; one that runs past the end of the file kills the process with SIGBUS.
void check_segments(const File& file, const Elf64_Ehdr& header) {
  if (header.e_phnum == 0 || header.e_phnum == PN_XNUM || header.e_phentsize != sizeof(Elf64_Phdr))
    fail("damaged: no usable program header table");
  for (const Elf64_Phdr& segment :
       file.table<Elf64_Phdr>(header.e_phoff, header.e_phnum * sizeof(Elf64_Phdr), "the program header table")) {
    if (segment.p_type != PT_LOAD) continue;
    if (segment.p_offset > file.size() || segment.p_filesz > file.size() - segment.p_offset)
      fail("truncated: a segment of " + std::to_string(segment.p_filesz) + " bytes starts at byte " +
           std::to_string(segment.p_offset) + ", but the file has only " + std::to_string(file.size()));
  }
}

// The text in `table` from `at` on: ends at a NUL or with the table.
std::string_view text_at(const std::vector<char>& table, std::uint64_t at) {
  if (at >= table.size()) return {};
  return {table.data() + at, ::strnlen(table.data() + at, table.size() - at)};
}

std::string section_text(const File& file, const Elf64_Shdr& section) {
  if (section.sh_type == SHT_NOBITS || section.sh_size == 0) fail("its section .wend.manifest is empty");
  if ((section.sh_flags & SHF_COMPRESSED) != 0) fail("its section .wend.manifest is compressed");
  if (section.sh_size > manifest_limit)
    fail("its section .wend.manifest has " + std::to_string(section.sh_size) + " bytes, expected at most " +
         std::to_string(manifest_limit));
  std::string text(section.sh_size, '\0');
  file.read(section.sh_offset, text.data(), text.size(), "the section .wend.manifest");
  while (text.ends_with('\0')) text.pop_back();  // a C array of characters ends with one
  return text;
}

bool exports_plugin(const File& file, const std::vector<Elf64_Shdr>& sections) {
  for (const Elf64_Shdr& section : sections) {
    if (section.sh_type != SHT_DYNSYM || section.sh_link >= sections.size()) continue;
    const Elf64_Shdr& strings = sections[section.sh_link];
    const auto names = file.table<char>(strings.sh_offset, strings.sh_size, "the table of symbol names");
    for (const auto& symbol : file.table<Elf64_Sym>(section.sh_offset, section.sh_size, "the table of symbols")) {
      const auto visibility = ELF64_ST_VISIBILITY(symbol.st_other);
      if (text_at(names, symbol.st_name) == symbol_name && symbol.st_shndx != SHN_UNDEF &&
          ELF64_ST_BIND(symbol.st_info) != STB_LOCAL && (visibility == STV_DEFAULT || visibility == STV_PROTECTED))
        return true;
    }
  }
  return false;
}

}  // namespace

std::string manifest_section(const std::string& path) {
  const File file(path);
  const Elf64_Ehdr header = header_of(file);
  check_segments(file, header);
  if (header.e_shnum == 0) fail("no section table, so no manifest (was it stripped of it?)");
  if (header.e_shentsize != sizeof(Elf64_Shdr) || header.e_shstrndx >= header.e_shnum)
    fail("damaged: no usable section table");
  const auto sections =
      file.table<Elf64_Shdr>(header.e_shoff, header.e_shnum * sizeof(Elf64_Shdr), "the section table");
  const Elf64_Shdr& strings = sections[header.e_shstrndx];
  const auto names = file.table<char>(strings.sh_offset, strings.sh_size, "the table of section names");
  for (const Elf64_Shdr& section : sections) {
    if (text_at(names, section.sh_name) != section_name) continue;
    std::string text = section_text(file, section);
    if (!exports_plugin(file, sections))
      fail(
          "it does not export the symbol wend_plugin_1: WEND_PLUGIN(...) in C++, a WEND_EXPORT const wend_plugin in C");
    return text;
  }
  fail("no section .wend.manifest: not a wend plugin, or built without wend_add_plugin()");
}

}  // namespace wend::core
