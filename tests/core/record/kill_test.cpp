// kill -9 of the writer at random instants: what it acknowledged is there, whole, and the file is sound.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <core/record/sqlite.hpp>
#include <core/record/store.hpp>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>

namespace wend::core {
namespace {

CellResult result_of(std::uint64_t n) {
  CellResult result;
  result.metrics = {"value"};
  for (std::uint64_t e = 0; e <= n % 3; ++e)
    result.episodes.push_back({e, std::to_string(n), {{0, 0, n, 0, {static_cast<double>(n)}}}});
  return result;
}

// Records cells from `first` on, and tells the pipe how many are acknowledged.
[[noreturn]] void write_until_killed(const std::string& folder, std::uint64_t first, int pipe) {
  try {
    Store store(folder);
    store.begin_session({{"version", "test"}}, {});
    std::uint64_t told = 0;
    for (std::uint64_t n = first;; ++n) {
      store.record_cell(std::to_string(n), {{"point", {}}}, "ok", {}, result_of(n));
      if (n % 7 == 0) store.flush();
      if (store.committed() == told) continue;
      told = store.committed();
      const std::uint64_t acknowledged = first + told;
      if (::write(pipe, &acknowledged, sizeof acknowledged) != sizeof acknowledged) ::_exit(2);
    }
  } catch (const std::exception&) {
    ::_exit(3);
  }
}

TEST(Kill, NothingAcknowledgedIsLost) {
  char name[] = "/tmp/wend-kill-XXXXXX";
  const std::string folder = mkdtemp(name);
  std::mt19937 random(20260101);
  std::uint64_t acknowledged = 0, first = 0;
  for (int kill = 0; kill < 20; ++kill) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      ::close(ends[0]);
      write_until_killed(folder, first, ends[1]);
    }
    ::close(ends[1]);
    ::usleep(1000 + random() % 120000);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << status;
    for (std::uint64_t n; ::read(ends[0], &n, sizeof n) == sizeof n;) acknowledged = n;
    ::close(ends[0]);

    Store store(folder);  // the lock of the killed holder is free
    const auto done = store.done(UnitKind::cell);
    ASSERT_GE(done.size(), acknowledged) << "kill " << kill;
    for (std::uint64_t n = 0; n < done.size(); ++n) {
      ASSERT_EQ(done.count(std::to_string(n)), 1u) << n;
      if (n < first) continue;  // read back after an earlier kill
      const CellResult found = store.cell(std::to_string(n)).value(), expected = result_of(n);
      ASSERT_EQ(found.episodes.size(), expected.episodes.size()) << n;
      for (const Episode& episode : found.episodes) {
        EXPECT_EQ(episode.hash, std::to_string(n));
        EXPECT_EQ(episode.robots.at(0).metrics, expected.episodes[0].robots[0].metrics);
      }
    }
    first = done.size();
    acknowledged = first;
    Database db(folder + "/results.sqlite", Database::Access::read);
    EXPECT_EQ(db.value("PRAGMA integrity_check"), "ok");
  }
  EXPECT_GT(acknowledged, 100u);  // else the test has shown nothing
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace wend::core
