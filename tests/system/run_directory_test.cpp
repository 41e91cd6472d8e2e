// Run directories in every state but the right one: damaged, in use, of another build.
#include <gtest/gtest.h>
#include <unistd.h>

#include <core/record/lock.hpp>
#include <filesystem>

#include "support/wend.hpp"

using namespace wend::test;

namespace {

struct Place {
  TemporaryDirectory place;
  std::string file = place.write("small.json", small_experiment(1).dump()), directory = place / "run";
  std::string only = "arm=field";

  Outcome go(std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--only", only});
    return run(run_command(file, directory, more));
  }
  std::string named(const std::string& text) const { return replaced(text, directory, "RUN"); }
};

}  // namespace

TEST(RunDirectory, DamagedResults) {
  const Place p;
  ASSERT_EQ(p.go().exit, 0);
  const std::string database = p.directory + "/results.sqlite", whole = read_text(database);
  std::filesystem::remove(database + "-wal");
  std::filesystem::remove(database + "-shm");
  std::string garbled = whole;
  for (std::size_t i = 4096; i < garbled.size(); ++i) garbled[i] = static_cast<char>(i * 31);
  for (const std::string& bytes :
       {std::string("these are no results\n"), std::string(4096, 'x'), whole.substr(0, whole.size() / 2), garbled}) {
    p.place.write("run/results.sqlite", bytes);
    for (const Outcome& outcome : {p.go(), run_wend({"status", p.directory}), run_wend({"render", p.directory})}) {
      EXPECT_EQ(outcome.exit, 5) << outcome.out << outcome.err;
      EXPECT_EQ(p.named(outcome.err).find("RUN/results.sqlite"), p.named(outcome.err).rfind("RUN/")) << outcome.err;
      EXPECT_EQ(outcome.signal, 0);
    }
  }
  p.place.write("run/results.sqlite", "these are no results\n");
  EXPECT_EQ(p.named(p.go().err),
            "error: cannot use RUN/results.sqlite: file is not a database; restore it from a copy, or give another "
            "directory\n");
}

TEST(RunDirectory, InUse) {
  const Place p;
  ASSERT_EQ(p.go().exit, 0);
  const wend::core::DirectoryLock lock(p.directory);
  const Outcome outcome = p.go();
  EXPECT_EQ(outcome.exit, 5);
  const std::string holder = "error: RUN is in use by process " + std::to_string(::getpid()) + " on ";
  EXPECT_EQ(p.named(outcome.err).substr(0, holder.size()), holder);
  EXPECT_NE(outcome.err.find("; wait for it, stop it, or give another directory\n"), std::string::npos) << outcome.err;
  EXPECT_EQ(run_wend({"status", p.directory}).exit, 0) << "reading beside a run is fine";
}

TEST(RunDirectory, OfAnotherBuild) {
  const TemporaryDirectory place;
  const std::string scene = place.write("room.json", empty_room()), directory = place / "run";
  const std::string file = place.write(
      "long.json",
      long_way(scene, {{"type", "test.flip"},
                       {"slots", {{"inner", {{"type", "wend.goal_direct"}, {"params", {{"speed", 0.9}}}}}}}})
          .dump());
  ASSERT_EQ(run(run_command(file, directory, {"--plugin-path", test_plugins() + "/flip_never"})).exit, 0);
  const std::string before = fingerprint(directory);
  const Outcome refused = run(run_command(file, directory, {"--plugin-path", test_plugins() + "/flip_500"}));
  EXPECT_EQ(refused.exit, 5);
  EXPECT_EQ(replaced(refused.err, directory, "RUN").rfind("error: RUN holds results of another build (", 0), 0u)
      << refused.err;
  EXPECT_NE(refused.err.find("): the program, a plugin or the compiler changed.  Use another directory, or "
                             "--allow-mixed-builds to go on here.\n"),
            std::string::npos);
  EXPECT_EQ(
      run(run_command(file, directory, {"--plugin-path", test_plugins() + "/flip_500", "--allow-mixed-builds"})).exit,
      0);
  EXPECT_EQ(fingerprint(directory), before) << "what is done stays done";
}

TEST(RunDirectory, NotADirectoryOrNotThere) {
  const Place p;
  p.place.write("file", "not a directory");
  const Outcome file = run(run_command(p.file, p.place / "file"));
  EXPECT_EQ(file.exit, 5) << file.err;
  EXPECT_NE(file.err.find(p.place / "file"), std::string::npos) << file.err;
  for (const char* command : {"status", "render"}) {
    const Outcome none = run_wend({command, p.place / "nowhere"});
    EXPECT_EQ(none.exit, 5) << command;
    EXPECT_NE(none.err.find(p.place / "nowhere"), std::string::npos) << none.err;
  }
}
