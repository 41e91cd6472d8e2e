// The same experiment, seed and build give the same fingerprint, however the work is cut up and however often it is cut
// short.
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <set>
#include <thread>

#include "support/wend.hpp"

using namespace wend::test;

namespace {

const Json slow_driver = {{"type", "wend.goal_direct"},
                          {"params", {{"speed", 0.9}}}};  // below the limit, to leave room for a bit

using Clock = std::chrono::steady_clock;

std::string ok(const std::string& file, const std::string& directory, const std::vector<std::string>& more = {}) {
  const Outcome outcome = run(run_command(file, directory, more));
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  return outcome.exit == 0 ? fingerprint(directory) : "";
}

// Waits for the children of a killed child, which this process inherits, to end by themselves; how many did not.
int orphans_left() {
  const auto until = Clock::now() + std::chrono::seconds(10);
  while (Clock::now() < until) {
    const pid_t ended = ::waitpid(-1, nullptr, WNOHANG);
    if (ended < 0) return 0;
    if (ended == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return 1;
}

}  // namespace

TEST(Determinism, JobsAndBatchesDoNotMatter) {
  const TemporaryDirectory place;
  const std::string file = place.write("small.json", small_experiment(2).dump());
  std::set<std::string> fingerprints;
  fingerprints.insert(ok(file, place / "jobs_1", {"--jobs", "1", "--batch", "1"}));
  fingerprints.insert(ok(file, place / "jobs_2", {"--jobs", "2", "--batch", "1"}));
  fingerprints.insert(ok(file, place / "batch_64", {"--jobs", "1", "--batch", "64"}));
  fingerprints.insert(ok(file, place / "in_process", {"--isolation", "none"}));
  EXPECT_EQ(fingerprints.size(), 1u);
  EXPECT_EQ(fingerprints.begin()->size(), 64u);
  EXPECT_NE(ok(file, place / "seed_8", {"--set", "/seed=8"}), *fingerprints.begin());
}

TEST(Determinism, KilledAnywhereAndStartedAgain) {
  ASSERT_EQ(::prctl(PR_SET_CHILD_SUBREAPER, 1), 0);  // its workers come to this process when it dies
  const TemporaryDirectory place;
  const std::string file = place.write("small.json", small_experiment(16).dump());
  const std::string whole = ok(file, place / "whole", {"--jobs", "2"});
  const std::size_t planned = read_json(place / "whole/summary.json")["cells"]["planned"];
  ASSERT_GE(planned, 96u);

  const std::string directory = place / "killed";
  std::size_t killed = 0, partly = 0, before = 0;
  const auto kill_when = [&](const std::function<bool(Clock::duration)>& due) {
    Program program(run_command(file, directory, {"--jobs", "2"}));
    const auto began = Clock::now();
    while (!program.ended() && !due(Clock::now() - began)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    program.signal(SIGKILL);
    const Outcome outcome = program.wait();
    EXPECT_EQ(orphans_left(), 0) << "workers outlive the host";
    killed += outcome.signal == SIGKILL;
    const std::size_t now = committed_cells(directory);
    EXPECT_GE(now, before) << "what was committed is gone";
    before = now;
    partly += now > 0 && now < planned;
  };
  for (const int ms : {3, 20, 60, 150}) kill_when([&](Clock::duration t) { return t > std::chrono::milliseconds(ms); });
  for (const std::size_t more : {1u, 30u, 60u})
    kill_when([&, from = before](Clock::duration) { return committed_cells(directory) >= from + more; });
  EXPECT_GE(killed, 5u);
  EXPECT_GE(partly, 1u);
  EXPECT_EQ(ok(file, directory, {"--jobs", "2"}), whole);
  EXPECT_EQ(episode_hashes(directory), episode_hashes(place / "whole"));
  EXPECT_FALSE(std::filesystem::exists(directory + "/scratch"));
}

TEST(Determinism, StoppedBySignalsAndStartedAgain) {
  const TemporaryDirectory place;
  const std::string file = place.write("small.json", small_experiment(16).dump()), directory = place / "stopped";
  for (const int number : {SIGINT, SIGTERM}) {
    Program program(run_command(file, directory, {"--jobs", "2"}));
    while (!program.ended() && !std::filesystem::exists(directory + "/results.sqlite"))
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    program.signal(number);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.exit, 128 + number) << outcome.err;
    EXPECT_NE(outcome.err.find("stopped"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(ok(file, directory), ok(file, place / "whole"));
}

TEST(Determinism, AFinishedRunIsNotDoneAgain) {
  const TemporaryDirectory place;
  const std::string file = place.write("small.json", small_experiment(1).dump());
  const std::string first = ok(file, place / "run");
  const Outcome again = run(run_command(file, place / "run", {"--json"}));
  ASSERT_EQ(again.exit, 0) << again.err;
  EXPECT_EQ(Json::parse(again.out).at("fingerprint"), first);
  const Json last = Json::parse(again.err.substr(again.err.rfind('\n', again.err.size() - 2) + 1));
  EXPECT_EQ(last.at("progress").at("steps"), 0) << "decisions were made again";
}

// The last bit of one action among hundreds: everything behind it may look the same, the fingerprint may not.
TEST(Determinism, OneBitOfOneActionShows) {
  const TemporaryDirectory place;
  const std::string scene = place.write("room.json", empty_room());
  const Json policy = {{"type", "test.flip"}, {"slots", {{"inner", slow_driver}}}};
  const std::string file = place.write("long.json", long_way(scene, policy).dump());
  const std::string never = ok(file, place / "never", {"--plugin-path", test_plugins() + "/flip_never"});
  const std::string again =
      ok(file, place / "again", {"--plugin-path", test_plugins() + "/flip_never", "--batch", "64"});
  const std::string once = ok(file, place / "once", {"--plugin-path", test_plugins() + "/flip_500"});
  EXPECT_EQ(never, again);
  EXPECT_NE(never, once);

  const Json result = read_json(place / "once/summary.json")["results"][0];
  EXPECT_EQ(result["success"]["rate"], 1.0) << "it should have got there";
  EXPECT_GT(result["metrics"]["steps"]["mean"].get<double>(), 500);
  EXPECT_EQ(cell_ids(place / "never"), cell_ids(place / "once"))
      << "the fingerprint must differ by what happened alone";
  EXPECT_NE(episode_hashes(place / "never"), episode_hashes(place / "once"));
}
