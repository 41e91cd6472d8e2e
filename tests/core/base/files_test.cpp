#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <core/base/error.hpp>
#include <core/base/files.hpp>
#include <cstdlib>
#include <filesystem>

namespace wend::core {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  Files() {
    std::string name = testing::TempDir() + "wend_files_XXXXXX";
    directory_ = ::mkdtemp(name.data());
  }
  ~Files() override { fs::remove_all(directory_); }

  std::string path(const std::string& name) const { return directory_ + "/" + name; }

  // What went wrong, and that it leads to the exit code of I/O.
  template <class F>
  static std::string error(F&& f) {
    try {
      f();
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::data);
      return error.what();
    }
    return "no error";
  }

  std::string directory_;
};

TEST_F(Files, WholeOrNotAtAll) {
  const std::string bytes("a\0b\n\xff", 5);
  write_file(path("x"), bytes);
  EXPECT_EQ(read_file(path("x")), bytes);
  write_file(path("x"), "shorter");
  EXPECT_EQ(read_file(path("x")), "shorter");
  write_file(path("x"), "");
  EXPECT_EQ(read_file(path("x")), "");
  EXPECT_FALSE(fs::exists(path("x.tmp")));
}

TEST_F(Files, AReaderOfTheOldFileKeepsIt) {
  write_file(path("x"), "old");
  fs::create_hard_link(path("x"), path("held"));
  write_file(path("x"), "new");
  EXPECT_EQ(read_file(path("held")), "old");  // replaced by rename, not written over
}

TEST_F(Files, PublishRenames) {
  write_file(path("a"), "1");
  write_file(path("b"), "2");
  publish_file(path("a"), path("b"));
  EXPECT_EQ(read_file(path("b")), "1");
  EXPECT_FALSE(fs::exists(path("a")));
  EXPECT_EQ(error([&] { publish_file(path("a"), path("b")); }),
            "cannot write " + path("a") + ": No such file or directory");
}

TEST_F(Files, UnreadableOnesAreExplained) {
  EXPECT_EQ(error([&] { read_file(path("none")); }), "cannot read " + path("none") + ": No such file or directory");
  EXPECT_EQ(error([&] { read_file(directory_); }), "cannot read " + directory_ + ": not a regular file");
  ASSERT_EQ(::mkfifo(path("fifo").c_str(), 0600), 0);
  EXPECT_EQ(error([&] { read_file(path("fifo")); }),
            "cannot read " + path("fifo") + ": not a regular file");  // at once
  write_file(path("x"), "12345");
  EXPECT_EQ(read_file(path("x"), 5), "12345");
  EXPECT_EQ(error([&] { read_file(path("x"), 4); }), "cannot read " + path("x") + ": 5 bytes, expected at most 4");
  fs::create_symlink("loop", path("loop"));
  EXPECT_EQ(error([&] { read_file(path("loop")); }),
            "cannot read " + path("loop") + ": Too many levels of symbolic links");
}

TEST_F(Files, UnwritableOnesAreExplained) {
  EXPECT_EQ(error([&] { write_file(path("none/x"), "1"); }),
            "cannot write " + path("none/x.tmp") + ": No such file or directory");
  fs::create_directory(path("d"));
  EXPECT_EQ(error([&] { write_file(path("d"), "1"); }),
            "cannot rename " + path("d.tmp") + " to " + path("d") + ": Is a directory");
}

TEST_F(Files, DirectoriesAreMadeWithTheirParents) {
  make_directories(path("a/b/c"));
  make_directories(path("a/b/c"));
  EXPECT_TRUE(fs::is_directory(path("a/b/c")));
  write_file(path("x"), "1");
  EXPECT_EQ(error([&] { make_directories(path("x/y")); }),
            "cannot make the directory " + path("x/y") + ": Not a directory");
}

TEST_F(Files, TheProgramKnowsItsFolder) {
  EXPECT_EQ(fs::path(program_directory()), fs::canonical("/proc/self/exe").parent_path());
}

}  // namespace
}  // namespace wend::core
