// Real workers and plugins that misbehave in them: each fails its own request with the right cause, and nothing else.
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <core/run/pool.hpp>
#include <thread>

#include "fixture.hpp"

namespace wend::core {
namespace {

using namespace std::chrono_literals;

class PoolTest : public RunTest {
 protected:
  PoolOptions options(std::uint32_t jobs = 1) const {
    PoolOptions options;
    options.jobs = jobs;
    options.worker = WEND_TEST_WORKER;
    options.logs = folder_;
    options.deadline = 60s;
    return options;
  }
  Request request(const ComponentSpec& policy, std::uint32_t episodes = 1, const Json& world = Json::object()) {
    Request request;
    request.unit = cell_of(counter(world), policy, episodes);
    request.plugins = test_plugins();
    request.scratch = folder_;
    return request;
  }
  // Runs all that is in the pool; id -> "ok" or "cause: message".
  static std::map<std::string, std::string> drain(Pool& pool) {
    std::map<std::string, std::string> outcomes;
    while (pool.pending() > 0)
      if (const auto done = pool.next(1s)) {
        const bool first =
            outcomes
                .emplace(done->id,
                         done->answer.ok ? "ok" : done->answer.failure.cause + ": " + done->answer.failure.message)
                .second;
        EXPECT_TRUE(first) << done->id << " came twice";
      }
    return outcomes;
  }
  static std::size_t descriptors() {
    const std::filesystem::directory_iterator all("/proc/self/fd");
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }
  static bool childless() { return ::waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD; }
};

constexpr const char* segv = "crash: the worker died of signal 11 (Segmentation fault)";
constexpr const char* aborted = "crash: the worker died of signal 6 (Aborted)";
constexpr const char* lost = "protocol: it closed or disturbed the private descriptor";

// Good requests stand between all the others; one pool serves them all.
TEST_F(PoolTest, EachMisdeedFailsItsOwnRequest) {
  int inherited[2];  // as from a shell: whoever writes to every descriptor must not reach it
  ASSERT_EQ(::pipe(inherited), 0);
  ::close(inherited[0]);
  const std::map<std::string, std::string> deeds = {
      {"segv", segv},
      {"abort", aborted},
      {"throw", "rule: a plugin let an exception out, expected a status: thrown across"},
      {"throw_int", "rule: a plugin let an exception out, expected a status: it is no std::exception"},
      {"exit", "exit: the worker left with exit code 0 and no answer"},
      {"_exit", "exit: the worker left with exit code 0 and no answer"},
      {"exit_7", "exit: the worker left with exit code 7 and no answer"},
      {"bad_alloc", "memory: out of memory"},
      {"reserve", "memory: out of memory"},
      {"stack", segv},
      {"garbage", "protocol: it wrote to the private descriptor: expected a frame, found other bytes"},
      {"short_garbage", "protocol: it wrote to the private descriptor: expected a frame, found other bytes"},
      {"close", lost},
      {"close_and_loop", lost},
      {"rounding", "rule: a plugin changed the process's floating-point rounding and did not put it back"},
      {"flush", "rule: a plugin changed the process's floating-point rounding and did not put it back"},
      {"locale", "rule: a plugin changed the process's locale and did not put it back"},
      {"chdir", "rule: a plugin changed the process's working directory and did not put it back"},
      {"double_free", std::string(aborted) + "; it printed: free(): double free detected in tcache 2"},
      {"big_file", "crash: the worker died of signal 25 (File size limit exceeded)"},
      {"child", aborted},
      {"kill_group", "crash: the worker died of signal 9 (Killed)"},
      {"last_words", std::string(aborted) + "; it printed: ..." + std::string(400 - 12, '.') + "\nI am dying"},
      {"print", "ok"},
      {"nothing", "ok"}};
  const std::size_t before = descriptors();
  {
    Pool pool(options(2));
    for (const auto& [deed, expected] : deeds) {
      pool.submit("before " + deed, request(script()));
      pool.submit(deed, request(bad(deed, "act", folder_ + "/big")));
      pool.submit("after " + deed, request(script()));
    }
    const auto outcomes = drain(pool);
    EXPECT_EQ(outcomes.size(), 3 * deeds.size());
    for (const auto& [deed, expected] : deeds) {
      EXPECT_EQ(outcomes.at(deed), expected) << deed;
      EXPECT_EQ(outcomes.at("before " + deed), "ok") << deed;
      EXPECT_EQ(outcomes.at("after " + deed), "ok") << deed;
    }
    EXPECT_LE(descriptors(), before + 2);
  }
  EXPECT_EQ(descriptors(), before);
  EXPECT_TRUE(childless());
  ::close(inherited[1]);
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/worker-0.log"));
}

TEST_F(PoolTest, AtCreationAndAtTheEnd) {
  Pool pool(options());
  for (const char* when : {"create", "destroy"})
    for (const char* deed : {"segv", "exit", "close"})
      pool.submit(std::string(deed) + " at " + when, request(bad(deed, when)));
  pool.submit("good", request(script()));
  const std::string exited = "exit: the worker left with exit code 0 and no answer";
  EXPECT_EQ(drain(pool), (std::map<std::string, std::string>{{"segv at create", segv},
                                                             {"exit at create", exited},
                                                             {"close at create", lost},
                                                             {"segv at destroy", segv},
                                                             {"exit at destroy", exited},
                                                             {"close at destroy", lost},
                                                             {"good", "ok"}}));
}

TEST_F(PoolTest, FilesThatCannotBeLoaded) {
  Pool pool(options());
  const std::string folder = WEND_TEST_PLUGINS "/bad/";
  for (const char* file : {"static_crash", "static_throw", "no_symbol", "wrong_abi", "unresolved"}) {
    Request one = request(script());
    one.plugins["test.script"] = folder + file + ".so";
    pool.submit(file, one);
    pool.submit("after " + std::string(file), request(script()));
  }
  auto outcomes = drain(pool);
  EXPECT_EQ(outcomes.at("static_crash"), aborted);
  EXPECT_EQ(outcomes.at("static_throw"),
            std::string(aborted) +
                "; it printed: terminate called after throwing an instance of 'std::runtime_error'\n"
                "  what():  thrown by a static constructor");
  EXPECT_EQ(outcomes.at("no_symbol"),
            "load: " + folder + "no_symbol.so: expected the exported symbol wend_plugin_1, found none");
  EXPECT_EQ(outcomes.at("wrong_abi"),
            "load: " + folder + "wrong_abi.so: expected ABI 1.x, found 2.7; build it against this wend's headers");
  EXPECT_NE(outcomes.at("unresolved").find("undefined symbol: nobody_has_this"), std::string::npos)
      << outcomes.at("unresolved");
  for (const auto& [id, outcome] : outcomes) EXPECT_EQ(outcome == "ok", id.rfind("after", 0) == 0) << id;
}

TEST_F(PoolTest, EndsWhatRunsPastItsDeadline) {
  PoolOptions short_lived = options();
  short_lived.deadline = 2s;
  Pool pool(short_lived);
  pool.submit("first", request(script()));
  pool.submit("loop", request(bad("deaf_loop")));
  pool.submit("last", request(script()));
  EXPECT_EQ(drain(pool), (std::map<std::string, std::string>{
                             {"first", "ok"}, {"loop", "timeout: no answer within 2 s"}, {"last", "ok"}}));
}

// What is left of an earlier request must not be blamed on the next one.
TEST_F(PoolTest, AWorkerInDisorderIsReplaced) {
  for (const char* deed : {"crash_later", "garbage_later"}) {
    Pool pool(options());
    pool.submit("deed", request(bad(deed)));
    EXPECT_EQ(drain(pool).at("deed"), "ok");
    std::this_thread::sleep_for(300ms);  // now it is idle and out of order
    pool.submit("next", request(script()));
    EXPECT_EQ(drain(pool).at("next"), "ok") << deed;

    pool.submit("deed", request(bad(deed)));
    pool.submit("hit while it runs", request(script(), 400, {{"ends", {4000}}}));  // about half a second
    const auto outcomes = drain(pool);
    EXPECT_EQ(outcomes.at("deed"), "ok") << deed;
    EXPECT_EQ(outcomes.at("hit while it runs"), "ok") << deed;
  }
}

TEST_F(PoolTest, FiftyFailuresLeaveNothingBehind) {
  const std::size_t before = descriptors();
  {
    Pool pool(options(2));
    for (int i = 0; i < 50; ++i) pool.submit(std::to_string(i), request(bad(i % 2 ? "_exit" : "segv", "create")));
    for (int i = 0; i < 50; ++i) {
      std::optional<Completion> done;
      while (!(done = pool.next(1s))) {
      }
      EXPECT_FALSE(done->answer.ok);
      EXPECT_LE(descriptors(), before + 2);
    }
    EXPECT_EQ(pool.pending(), 0u);
    EXPECT_TRUE(childless());
  }
  EXPECT_EQ(descriptors(), before);
}

TEST_F(PoolTest, WorkersAreReusedAndRetired) {
  PoolOptions two_each = options();
  two_each.requests_per_worker = 2;
  Pool pool(two_each);
  for (int i = 0; i < 5; ++i) pool.submit(std::to_string(i), request(script()));
  const auto outcomes = drain(pool);
  EXPECT_EQ(outcomes.size(), 5u);
  for (const auto& [id, outcome] : outcomes) EXPECT_EQ(outcome, "ok") << id;
}

TEST_F(PoolTest, InThisProcessGivesTheSameResults) {
  PoolOptions here = options();
  here.isolated = false;
  const auto result_of = [&](PoolOptions chosen) {
    Pool pool(std::move(chosen));
    pool.submit("cell", request(script({{"random", true}}), 20, {{"ends", {3, 9, 5}}}));
    Json result = pool.next(60s).value().answer.result;
    result.erase("decision_us");
    return result;
  };
  const Json result = result_of(here);
  EXPECT_EQ(result.at("episodes").size(), 20u);
  EXPECT_EQ(result, result_of(options()));
}

TEST_F(PoolTest, DropsWhatIsQueuedAndSaysWhereAWorkerCannotStart) {
  Pool pool(options());
  pool.submit("a", request(script()));
  pool.submit("b", request(script()));
  EXPECT_EQ(pool.next(60s).value().id, "a");  // and b is with the worker
  pool.submit("c", request(script()));
  pool.drop_queue();
  EXPECT_EQ(drain(pool), (std::map<std::string, std::string>{{"b", "ok"}}));
  EXPECT_FALSE(pool.next(1s).has_value());

  PoolOptions wrong = options();
  wrong.worker = folder_ + "/absent";
  Pool none(wrong);
  none.submit("a", request(script()));
  try {
    none.next(1s);
    FAIL();
  } catch (const std::exception& error) {
    EXPECT_EQ(std::string(error.what()),
              "cannot start " + folder_ + "/absent (its log: " + folder_ + "/worker-0.log): No such file or directory");
  }
}

}  // namespace
}  // namespace wend::core
