#include <gtest/gtest.h>

#include <core/base/error.hpp>
#include <core/base/files.hpp>
#include <core/record/lock.hpp>
#include <filesystem>
#include <string>

namespace wend::core {
namespace {

const std::string left = R"({"host": "a", "pid": 12, "since": "2026-01-01 10:00:00 UTC"})";

TEST(DirectoryLock, ANameLeftBehindCountsOnlyOnANetworkAndFromAnotherHost) {
  EXPECT_EQ(DirectoryLock::objection("d/lock", "", "b", true), "");
  EXPECT_EQ(DirectoryLock::objection("d/lock", left, "a", true), "");
  EXPECT_EQ(DirectoryLock::objection("d/lock", left, "b", false), "");
  EXPECT_EQ(DirectoryLock::objection("d/lock", left, "b", true),
            "d/lock was left by process 12 on a, since 2026-01-01 10:00:00 UTC; if that process is gone, remove the "
            "file and start again");
  EXPECT_EQ(DirectoryLock::objection("d/lock", "???", "b", true),
            "d/lock was left by another process; if that process is gone, remove the file and start again");
}

TEST(DirectoryLock, IsFreeAgainAndNamesNobodyThen) {
  char name[] = "/tmp/wend-lock-XXXXXX";
  const std::string folder = mkdtemp(name);
  {
    const DirectoryLock lock(folder);
    EXPECT_THROW(DirectoryLock second(folder), Error);
    EXPECT_NE(read_file(folder + "/lock").find("\"pid\":"), std::string::npos);
  }
  EXPECT_EQ(read_file(folder + "/lock"), "");
  write_file(folder + "/lock", left);  // of a holder that was killed
  EXPECT_NO_THROW(DirectoryLock third(folder));
  std::filesystem::remove_all(folder);
}

TEST(DirectoryLock, SaysWhereItCannotBe) {
  try {
    DirectoryLock lock("/nowhere");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "cannot write /nowhere/lock: No such file or directory");
  }
}

}  // namespace
}  // namespace wend::core
