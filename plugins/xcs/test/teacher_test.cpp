// A teacher before XCS: who acts when, what becomes of its strings, and states in between.  The teacher here is a small
// learner whose values are known.
#include <gtest/gtest.h>

#include <wend/testing.hpp>

#include "xcs_learner.hpp"

using wend::testing::Bench;
using wend::testing::error_of;

namespace {

// Values q(s, a) = 100 s0 + 10 s1 + a, so that it always takes the last action; counts what it learns from.
class Known {
 public:
  explicit Known(const wend::Config& config) : modes_(config.rows(), WEND_TEST) {}
  void begin(wend::Rows rows, wend::Episodes episodes) {
    for (std::size_t i = 0; i < rows.size(); ++i) modes_[rows[i]] = episodes[i].mode;
  }
  void act(wend::Rows rows, wend::Matrix<const double>, wend::Matrix<double> actions) {
    for (std::size_t i = 0; i < rows.size(); ++i) actions[i][0] = modes_[rows[i]] == WEND_TRAIN_EXPLORE ? 0 : 2;
  }
  std::uint64_t learn(const wend::Batch& batch) { return learned += batch.size(), batch.size(); }
  void save(wend::Writer& writer) const { writer.put(learned); }
  void load(wend::Reader& reader) { learned = reader.get<std::uint64_t>(); }
  std::uint32_t value_actions() const { return 3; }
  void values(wend::Matrix<const double> observations, wend::Matrix<double> q, wend::Matrix<double> spread) {
    for (std::size_t i = 0; i < q.rows(); ++i)
      for (std::size_t a = 0; a < 3; ++a) {
        q[i][a] = 100 * observations[i][0] + 10 * observations[i][1] + static_cast<double>(a);
        spread[i][a] = 4;
      }
  }
  std::uint64_t learned = 0;

 private:
  std::vector<std::uint32_t> modes_;
};

constexpr wend_component known = wend::component<Known>("test.known");
constexpr wend_component xcs_component = wend::component<xcs::Xcs>("wend.xcs");

struct Rig {
  wend::Columns columns, table;
  Bench teacher{known}, learner{xcs_component};
  Rig() {
    columns.box("sonar.range.0", "m", 0, 3, 0).box("sonar.range.1", "m", 0, 3, 1);
    table.discrete("action", 3);
    teacher.observation(columns).action(table);
    EXPECT_TRUE(teacher.create()) << teacher.error();
    learner.observation(columns).action(table).slot("teacher", teacher.ref());
    learner.set("encoding/0/columns/0", "sonar.range.*").set("encoding/0/as", "thermometer");
    learner.set("encoding/0/thresholds/0", 1.0);
    for (const auto& [path, value] : std::initializer_list<std::pair<const char*, double>>{{"N", 100},
                                                                                           {"P_hash", 0},
                                                                                           {"beta", 0.2},
                                                                                           {"alpha", 0.1},
                                                                                           {"epsilon_0", 10},
                                                                                           {"nu", 5},
                                                                                           {"gamma", 0.9},
                                                                                           {"theta_GA", 1e9},
                                                                                           {"chi", 0.8},
                                                                                           {"mu", 0.04},
                                                                                           {"theta_del", 20},
                                                                                           {"delta", 0.1},
                                                                                           {"theta_sub", 20},
                                                                                           {"theta_mna", 0},
                                                                                           {"prediction_I", 0},
                                                                                           {"error_I", 0},
                                                                                           {"fitness_I", 0.01},
                                                                                           {"fitness_reduction", 0.1},
                                                                                           {"tournament", 0},
                                                                                           {"subsume_offspring", 0},
                                                                                           {"subsume_action_set", 0},
                                                                                           {"gradient", 0},
                                                                                           {"compact", 0},
                                                                                           {"greedy_updates", 1},
                                                                                           {"exploration", 0},
                                                                                           {"publish_every", 1000},
                                                                                           {"series_every", 0},
                                                                                           {"trace", 0},
                                                                                           {"safety_distance", 0},
                                                                                           {"merge_every", 0},
                                                                                           {"merge_tolerance", 0},
                                                                                           {"merge_experience", 0},
                                                                                           {"initial_rules", 0},
                                                                                           {"specialise", 0},
                                                                                           {"beta_least", 1},
                                                                                           {"inherited", 0},
                                                                                           {"seeded_beta", 0},
                                                                                           {"seeded_experience", 0},
                                                                                           {"teacher_episodes", 2},
                                                                                           {"teacher_collect", 1},
                                                                                           {"teacher_observations", 4},
                                                                                           {"seed_experience", 20},
                                                                                           {"seed_fitness", 0.5},
                                                                                           {"seed_merge", 0}})
      learner.set(path, value);
    for (const auto& [path, value] :
         std::initializer_list<std::pair<const char*, const char*>>{{"operators", "paper"},
                                                                    {"fitness", "accuracy"},
                                                                    {"crossover", "two_point"},
                                                                    {"unmatched", "nearest"},
                                                                    {"selection", "random"},
                                                                    {"rule_base", "shared"},
                                                                    {"explain", "text"},
                                                                    {"teacher_strings", "greedy"}})
      learner.set(path, value);
  }
  void create() { ASSERT_TRUE(learner.create()) << learner.error(); }

  // One episode of one step from (a, b); returns the action.
  double episode(double a, double b, std::uint32_t mode = WEND_TRAIN_EXPLORE) {
    learner.begin(3, mode);
    const std::vector<double> from{a, b}, to{3, 3};
    const std::vector<double> action = learner.act(from);
    const std::uint32_t row = 0;
    const wend_outcome outcome{1, WEND_TERMINATED, 0};
    const wend_batch batch{sizeof batch, 1, &row, from.data(), action.data(), to.data(), &outcome};
    std::uint64_t used = 0;
    if (mode != WEND_TEST) {
      EXPECT_EQ(learner.table<wend_learner>(WEND_LEARNER)->learn(learner.ref().self, &batch, &used), WEND_OK)
          << learner.error();
    }
    return action[0];
  }
  std::uint64_t taught() { return teacher.object<Known>().learned; }
  double rules() { return learner.telemetry(WEND_PER_UPDATE)[0]; }
};

}  // namespace

TEST(Teacher, LearnsFirstThenActsGreedilyThenIsSilent) {
  Rig rig;
  rig.create();
  EXPECT_EQ(rig.episode(2, 2), 0) << "the teacher explores";
  EXPECT_EQ(rig.episode(2, 2), 0);
  EXPECT_EQ(rig.taught(), 2u);
  EXPECT_EQ(rig.episode(0.5, 2), 2) << "it is greedy while strings are collected";
  EXPECT_EQ(rig.taught(), 2u) << "and learns no more";
  EXPECT_EQ(rig.rules(), 0);
  EXPECT_EQ(rig.episode(0.5, 2), 2) << "the rules do what it did";
  EXPECT_EQ(rig.taught(), 2u);
  EXPECT_EQ(rig.rules(), 3) << "one string, three actions";
}

TEST(Teacher, IsTestedWhileItTeaches) {
  Rig rig;
  rig.create();
  rig.episode(2, 2);
  EXPECT_EQ(rig.episode(2, 2, WEND_TEST), 2);
  EXPECT_EQ(rig.taught(), 1u);
}

TEST(Teacher, LeavesRulesWithItsMeanValueAndTheSpread) {
  Rig rig;
  rig.learner.set("teacher_collect", 3);
  rig.create();
  for (const double a : {2.0, 2.0, 0.2, 0.4, 0.6}) rig.episode(a, 2);
  EXPECT_EQ(rig.learner.table<wend_learner>(WEND_LEARNER)->finish(rig.learner.ref().self), WEND_OK);
  const std::string rules = rig.learner.explain();
  // Three observations of the string 10: q = 100 x 0.4 + 20 + a on average; spread sqrt(100^2 0.08 / 3 + 4^2)
  // = 16.8127.
  EXPECT_NE(rules.find("10"), std::string::npos) << rules;
  for (const char* prediction : {"60", "61", "62"}) EXPECT_NE(rules.find(prediction), std::string::npos) << rules;
  EXPECT_NE(rules.find("16.81"), std::string::npos) << rules;
}

TEST(Teacher, TakesTheStringsOfAllEpisodesWhereAskedTo) {
  Rig rig;
  rig.learner.set("teacher_strings", "all").set("teacher_collect", 0);
  rig.create();
  rig.episode(2, 2), rig.episode(0.5, 2);
  EXPECT_EQ(rig.learner.table<wend_learner>(WEND_LEARNER)->finish(rig.learner.ref().self), WEND_OK);
  EXPECT_EQ(rig.rules(), 6);
}

TEST(Teacher, MayArriveTrained) {
  Rig first;
  first.create();
  first.episode(2, 2), first.episode(2, 2);
  const std::string state = first.learner.save(), own = first.teacher.save();
  Rig second;
  second.learner.set("teacher_episodes", 0);
  second.create();
  second.teacher.load(own);
  second.learner.load(state);
  EXPECT_EQ(second.episode(0.5, 2), 2) << "it collects at once";
  EXPECT_EQ(second.taught(), 2u);
  second.episode(0.5, 2);
  EXPECT_EQ(second.rules(), 3);
}

TEST(Teacher, AStateKeepsTheStringsThatWait) {
  Rig first;
  first.create();
  for (int i = 0; i < 3; ++i) first.episode(0.5, 2);
  const std::string state = first.learner.save();
  Rig second;
  second.create();
  second.learner.load(state);
  second.episode(0.5, 2);
  EXPECT_EQ(second.rules(), 3);
  EXPECT_EQ(error_of([&] { second.learner.load(state.substr(0, state.size() - 3)); }),
            "the state ends early: 2 values announced");
  EXPECT_EQ(second.rules(), 3) << "nothing is lost";
}

TEST(Teacher, IsRefusedWithoutEpisodesToCollectIn) {
  Rig rig;
  rig.learner.set("teacher_collect", 0);
  EXPECT_FALSE(rig.learner.create());
  EXPECT_EQ(rig.learner.parameter(), "teacher_collect");
  EXPECT_EQ(rig.learner.error(),
            "expected greedy episodes to collect strings in, found none: ask for some, or take the strings of all "
            "episodes (teacher_strings)");
}
