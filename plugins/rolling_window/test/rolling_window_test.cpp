// The component through its C tables: who acts, what a slot is told, what it refuses, and whole episodes.
#include <gtest/gtest.h>

#include "barn_like.hpp"

using rig::Outcome;
using rig::Rig;
using wend::testing::Bench;
using wend::testing::error_of;

namespace {

// A policy for the slot that always takes action 2, and notes what it is told.
struct Note {
  explicit Note(const wend::Config&) {}
  void begin(wend::Rows rows, wend::Episodes) { begun += rows.size(); }
  void act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) {
    for (std::size_t i = 0; i < rows.size(); ++i) asked.push_back({rows[i], observations[i][0]}), actions[i][0] = 2;
  }
  std::uint64_t learn(const wend::Batch& batch) {
    for (std::size_t i = 0; i < batch.size(); ++i)
      learned.push_back({batch.rows[i], batch.actions[i][0], batch.outcomes[i]});
    return 10 * batch.size();
  }
  void finish() { ++finished; }
  void save(wend::Writer&) const {}
  void load(wend::Reader&) {}
  struct Lesson {
    std::uint32_t row;
    double action;
    wend_outcome outcome;
  };
  std::size_t begun = 0, finished = 0;
  std::vector<std::pair<std::uint32_t, double>> asked;
  std::vector<Lesson> learned;
};
struct Mute : Note {  // the same, which learns nothing
  using Note::Note;
  bool answers(std::string_view id) const { return id != WEND_LEARNER; }
};

template <class T>
struct Slot : Bench {
  explicit Slot(Rig& rig) : Bench(wend::component<T>("test.slot")) {
    observation(rig.columns()).action(rig.plane()->actions());
    if (!create()) throw std::runtime_error(error());
    rig.bench().slot("avoid", ref());
  }
  T* operator->() { return &object<T>(); }
};

// An observation with every beam at `range`, the goal 50 m ahead and the robot at the origin.
std::vector<double> facing(const Rig& rig, double range) {
  std::vector<double> row(rig.columns().width(), 0);
  for (std::size_t i = 0; i < 42; ++i) row[i] = range;
  row[42] = 50, row[44] = 3;
  return row;
}
std::vector<double> both(std::vector<double> a, const std::vector<double>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
std::uint64_t learn(Bench& bench, const std::vector<std::uint32_t>& rows, const std::vector<double>& before,
                    const std::vector<double>& actions, const std::vector<double>& after,
                    const std::vector<wend_outcome>& outcomes) {
  const wend_batch batch{
      sizeof batch,   static_cast<std::uint32_t>(rows.size()), rows.data(), before.data(), actions.data(), after.data(),
      outcomes.data()};
  std::uint64_t used = 0;
  EXPECT_EQ(bench.table<wend_learner>(WEND_LEARNER)->learn(bench.ref().self, &batch, &used), WEND_OK) << bench.error();
  return used;
}

}  // namespace

TEST(RollingWindow, SeeksWhereNothingIsNearAndAsksTheSlotElsewhere) {
  Rig rig(rig::simrobot());
  Slot<Note> slot(rig);
  rig.bench().copies(2);
  ASSERT_TRUE(rig.bench().create()) << rig.bench().error();
  rig.bench().begin(1);
  EXPECT_EQ(slot->begun, 2u);
  auto far = facing(rig, 20), near = facing(rig, 3);
  near[0] = 3.5;  // told apart by the slot's first column
  EXPECT_EQ(rig.bench().act(both(far, near)), (std::vector<double>{0, 2}));
  ASSERT_EQ(slot->asked.size(), 1u);
  EXPECT_EQ(slot->asked[0], (std::pair<std::uint32_t, double>{1, 3.5}));
  EXPECT_EQ(rig.bench().telemetry(WEND_PER_EPISODE), (std::vector<double>{0, 0, 1, 0}));
  const auto step = rig.bench().telemetry(WEND_PER_STEP);
  EXPECT_EQ(step[0], 0);
  EXPECT_NEAR(step[1], 8, 1e-12);  // the rim towards the goal
  EXPECT_NEAR(step[2], 0, 1e-12);
  EXPECT_EQ(step[3], 1);
  EXPECT_EQ(rig.bench().explain(0), "seeks the subgoal: subgoal (8.00, 0.00) m; avoided in 0 of 1 steps");
}

TEST(RollingWindow, PassesOnOnlyWhatTheSlotDidAndSaysWhereItHandsOver) {
  Rig rig(rig::simrobot());
  Slot<Note> slot(rig);
  rig.bench().copies(4);
  ASSERT_TRUE(rig.bench().create()) << rig.bench().error();
  rig.bench().begin(1, WEND_TRAIN_EXPLORE);
  const auto far = facing(rig, 20), near = facing(rig, 3);
  const auto before = both(both(far, near), both(near, near));
  const auto after = both(both(near, near), both(far, far));
  const auto actions = rig.bench().act(before);
  EXPECT_EQ(actions, (std::vector<double>{0, 2, 2, 2}));
  const std::vector<wend_outcome> outcomes{
      {-1, 0, 0}, {-2, 0, 0}, {-3, 0, 0}, {-4, WEND_TERMINATED | WEND_COLLIDED, 0}};
  EXPECT_EQ(learn(rig.bench(), {0, 1, 2, 3}, before, actions, after, outcomes), 30u);
  ASSERT_EQ(slot->learned.size(), 3u);
  EXPECT_EQ(slot->learned[0].row, 1u);
  EXPECT_EQ(slot->learned[0].outcome.flags, 0u);  // the slot goes on
  EXPECT_EQ(slot->learned[1].row, 2u);
  EXPECT_EQ(slot->learned[1].outcome.flags, WEND_HANDED_OVER);
  EXPECT_EQ(slot->learned[1].outcome.reward, -3);
  EXPECT_EQ(slot->learned[2].outcome.flags, WEND_TERMINATED | WEND_COLLIDED);
  // The decisions that learn() took ahead are those of act(), and count once.
  EXPECT_EQ(rig.bench().act({0, 1, 2}, both(both(near, near), far)), (std::vector<double>{2, 2, 0}));
  const auto share = rig.bench().telemetry(WEND_PER_EPISODE);
  EXPECT_EQ(share[0], 0.5);
  EXPECT_EQ(share[2], 1);
  EXPECT_EQ(share[4], 0.5);
  rig.bench().table<wend_learner>(WEND_LEARNER)->finish(rig.bench().ref().self);
  EXPECT_EQ(slot->finished, 1u);
}

TEST(RollingWindow, LearnsIffItsSlotDoes) {
  Rig empty(rig::simrobot()), mute(rig::simrobot());
  ASSERT_TRUE(empty.bench().create());
  EXPECT_EQ(empty.bench().table<wend_learner>(WEND_LEARNER), nullptr);
  Slot<Mute> slot(mute);
  ASSERT_TRUE(mute.bench().create());
  EXPECT_EQ(mute.bench().table<wend_learner>(WEND_LEARNER), nullptr);
  EXPECT_NE(mute.bench().table<wend_policy>(WEND_POLICY), nullptr);
}

TEST(RollingWindow, WithoutASlotItDrivesOnItself) {
  Rig rig(rig::simrobot());
  ASSERT_TRUE(rig.bench().create());
  rig.bench().begin(1);
  rig.bench().act(facing(rig, 3));
  EXPECT_EQ(rig.bench().telemetry(WEND_PER_EPISODE)[0], 0);
}

TEST(RollingWindow, SavesNothingOfItsOwnAndKnowsForeignBytes) {
  Rig rig(rig::simrobot());
  ASSERT_TRUE(rig.bench().create());
  rig.bench().load(rig.bench().save());
  EXPECT_EQ(error_of([&] { rig.bench().load("abc"); }), "the state ends early");
}

TEST(RollingWindow, RefusesWhatCannotWork) {
  const auto refusal = [](auto&& change) {
    Rig rig(rig::simrobot());
    change(rig.bench());
    EXPECT_FALSE(rig.bench().create());
    return rig.bench().parameter() + ": " + rig.bench().error();
  };
  EXPECT_EQ(refusal([](Bench& b) { b.set("planner", "grid"); }),
            "planner: expected none or auto where memory is none, found grid; set memory to grid");
  EXPECT_EQ(refusal([](Bench& b) { b.set("memory", "grid").set("cell", 1e-3); }),
            "cell: expected at least a thousandth of the clearance that plans look at, 6.500000 m, found 0.001000");
  wend::Columns bare;
  bare.box("goal.distance", "m").box("goal.bearing", "rad").box("goal.radius", "m");
  EXPECT_EQ(refusal([&](Bench& b) { b.observation(bare); }),
            "window: no column fits \"window.range.*\" or \"sonar.range.*\" of sonar; the columns are goal.distance, "
            "goal.bearing, goal.radius");
  wend::Columns no_pose;
  no_pose.box("sonar.range.0", "m", 0, 5).box("goal.distance", "m").box("goal.bearing", "rad").box("goal.radius", "m");
  EXPECT_EQ(
      refusal([&](Bench& b) { b.observation(no_pose).set("memory", "grid"); }),
      "pose/0: no column fits \"pose.x\"; the columns are sonar.range.0, goal.distance, goal.bearing, goal.radius");
}

TEST(RollingWindow, NeedsNoPoseWithoutMemory) {
  Rig rig(rig::simrobot());
  wend::Columns columns;
  columns.box("sonar.range.0", "m", 0, 5).box("goal.distance", "m").box("goal.bearing", "rad").box("goal.radius", "m");
  ASSERT_TRUE(rig.bench().observation(columns).create()) << rig.bench().error();
  rig.bench().begin(1);
  EXPECT_EQ(rig.bench().act({5, 30, 0.5, 3}), std::vector<double>{1});
}

TEST(RollingWindow, NotANumberIsAnError) {
  Rig rig(rig::simrobot());
  ASSERT_TRUE(rig.bench().create());
  rig.bench().begin(1);
  auto row = facing(rig, 20);
  row[3] = std::nan("");
  EXPECT_EQ(error_of([&] { rig.bench().act(row); }),
            "observation \"window.range.3\": expected a finite number, found NaN");
}

// ---- whole episodes

TEST(RollingWindowEpisodes, MemoryEscapesTrapsThatTheWindowAloneDoesNot) {
  for (const auto& [width, depth] : {std::pair{10.0, 8.0}, {20.0, 15.0}, {40.0, 30.0}, {60.0, 50.0}}) {
    int with = 0, without = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const rig::Scene scene = rig::u_trap(width, depth, seed);
      Rig memory(rig::simrobot()), none(rig::simrobot());
      ASSERT_TRUE(memory.bench().set("memory", "grid").create()) << memory.bench().error();
      ASSERT_TRUE(none.bench().create());
      with += memory.run(scene, seed).arrived;
      without += none.run(scene, seed).arrived;
    }
    EXPECT_EQ(with, 4) << width << " x " << depth;
    EXPECT_LE(without, 1) << width << " x " << depth;
  }
}

TEST(RollingWindowEpisodes, CrossesFieldsOfDiscs) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Rig rig(rig::simrobot());
    ASSERT_TRUE(rig.bench().set("memory", "grid").create());
    EXPECT_TRUE(rig.run(rig::random_discs(seed % 2 ? 14 : 10, seed), seed).arrived) << seed;
  }
}

TEST(RollingWindowEpisodes, CrossesClutterWithSpeedAndTurnRate) {
  for (const bool hard : {false, true}) {
    Rig rig(rig::barn(hard));
    ASSERT_TRUE(rig.bench().set("memory", "grid").set("speed", 1.6).create()) << rig.bench().error();
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const rig::Scene scene = rig::barn_like(seed);
      const Outcome outcome = rig.run(scene, seed);
      EXPECT_TRUE(outcome.arrived) << seed << (hard ? " hard" : "");
      EXPECT_LT(outcome.seconds, 30) << seed;
    }
  }
}

TEST(RollingWindowEpisodes, RepeatToTheLastBitAndDoNotDependOnEarlierOnes) {
  const rig::Scene scene = rig::u_trap(20, 15, 9), other = rig::random_discs(14, 9);
  Rig first(rig::simrobot()), second(rig::simrobot());
  ASSERT_TRUE(first.bench().set("memory", "grid").create());
  ASSERT_TRUE(second.bench().set("memory", "grid").create());
  second.run(other, 3);
  const Outcome a = first.run(scene, 5), b = second.run(scene, 5);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.end.x, b.end.x);
  EXPECT_EQ(a.end.y, b.end.y);
  EXPECT_EQ(a.end.heading, b.end.heading);
}
