// Steering with every kind of action, and the small headers beside it.
#include <gtest/gtest.h>

#include <cmath>
#include <wend/reading.hpp>
#include <wend/steer.hpp>
#include <wend/testing_plane.hpp>

using wend::Steer;
using wend::testing::Plane;

namespace {

Steer steer_of(Plane& plane, const wend::Columns& actions) {
  return Steer(wend::Space(actions.table()), wend::BodyRef(plane.ref()), plane->dt);
}
std::vector<double> towards(const Steer& steer, double bearing, double speed) {
  std::vector<double> action(steer.discrete() ? 1 : 2);
  steer.towards(bearing, speed, action);
  return action;
}

}  // namespace

TEST(Steer, OfATableTakesWhatLeavesTheLeastError) {
  Plane plane;
  plane->dt = 1;
  plane->action_table({{0.5, 0}, {0.25, 1.0 / 12}, {0.25, -1.0 / 12}});
  const Steer steer = steer_of(plane, plane->actions());
  EXPECT_EQ(towards(steer, 0, 1)[0], 0);
  EXPECT_EQ(towards(steer, 0.04, 1)[0], 0) << "a turn would leave more";
  EXPECT_EQ(towards(steer, 0.05, 1)[0], 1);
  EXPECT_EQ(towards(steer, -0.05, 1)[0], 2);
  EXPECT_EQ(towards(steer, 1.0 / 24, 1)[0], 0) << "a tie goes straight";
  EXPECT_EQ(towards(steer, 3, 1)[0], 1);
  EXPECT_EQ(towards(steer, 2 * wend::math::pi - 1, 1)[0], 2) << "bearings are wrapped";
}

TEST(Steer, OfATableTakesTheSpeedNearestToTheWanted) {
  Plane plane;
  plane->body.speed_low = -1;
  plane->action_table({{0, 0}, {0.5, 0}, {1, 0}, {-0.5, 0}, {0, 1}, {0, -1}});
  const Steer steer = steer_of(plane, plane->actions());
  EXPECT_EQ(towards(steer, 0, 0.6)[0], 1);
  EXPECT_EQ(towards(steer, 0, 0)[0], 0);
  EXPECT_EQ(towards(steer, 0, Steer::as_fast_as_possible)[0], 2);
  EXPECT_EQ(towards(steer, 1, 1)[0], 4);
}

TEST(Steer, ByTurnRateTurnsOnTheSpotForLargeErrors) {
  Plane plane;
  plane->body.turn_rate = 1;
  plane->speed_and_turn_rate();
  const Steer steer = steer_of(plane, plane->actions());
  EXPECT_EQ(towards(steer, 2, 0.8), (std::vector<double>{0, 1}));
  const auto slight = towards(steer, -0.05, 0.8);
  EXPECT_NEAR(slight[0], 0.8 * std::cos(0.05), 1e-15);
  EXPECT_NEAR(slight[1], -0.5, 1e-12) << "aligned after one period";
  EXPECT_EQ(towards(steer, 0, Steer::as_fast_as_possible)[0], 1) << "the body's limit";
}

TEST(Steer, BrakesATurnInTime) {
  Plane plane;
  plane->body.turn_acceleration = 2;
  const Steer steer = steer_of(plane, plane->actions());
  for (const double bearing : {0.01, 0.3, 1.5}) {
    const double w = towards(steer, bearing, 0)[1];
    EXPECT_LE(w * 0.1 + w * w / 4, bearing + 1e-12);
  }
  EXPECT_GT(towards(steer, 1.5, 0)[1], 2);
}

TEST(Steer, ABodyThatCannotTurnOnTheSpotKeepsItsSpeed) {
  Plane plane;
  plane->body.turn_radius = 0.5;
  const Steer steer = steer_of(plane, plane->actions());
  EXPECT_EQ(towards(steer, 3, 1), (std::vector<double>{1, 2}));
}

TEST(Steer, OfATurnAndAnAdvance) {
  Plane plane;
  wend::Columns actions;
  actions.box("turn", "rad", -0.5, 0.5).box("advance", "m", 0, 0.05);
  const Steer steer = steer_of(plane, actions);
  EXPECT_DOUBLE_EQ(steer.top_speed(), 0.5);
  const auto slight = towards(steer, 0.1, 0.4);
  EXPECT_NEAR(slight[0], 0.1, 1e-15);
  EXPECT_NEAR(slight[1], 0.04 * std::cos(0.1), 1e-15);
}

// A world whose actions are wheel speeds; only what steering asks for.
struct Wheels : wend::testing::PlaneWorld {
  using PlaneWorld::PlaneWorld;
  void predict(std::uint32_t, std::span<const wend_motion> from, wend::Matrix<const double> actions, double,
               std::span<wend_motion> to) const {
    for (std::size_t i = 0; i < from.size(); ++i) {
      to[i] = from[i];
      to[i].speed = 0.5 * 0.1 * (actions[i][0] + actions[i][1]);
      to[i].turn_rate = 0.1 / (2 * 0.2) * (actions[i][1] - actions[i][0]);
    }
  }
};

TEST(Steer, FindsOutWhatWheelSpeedsDo) {
  wend::testing::Bench world(wend::component<Wheels>("test.wheels"));
  ASSERT_TRUE(world.create());
  wend::Columns actions;
  actions.box("wheel_left", "rad/s", -10, 10).box("wheel_right", "rad/s", -10, 10);
  world.object<Wheels>().body.speed_low = -1;
  const Steer steer(wend::Space(actions.table()), wend::BodyRef(world.ref()), 0.1);
  double action[2];
  steer.drive(0.5, 0.4, action);
  EXPECT_NEAR(action[0], 5 - 0.8, 1e-9);
  EXPECT_NEAR(action[1], 5 + 0.8, 1e-9);
}

TEST(Steer, RefusesActionsThatItCannotSteerWith) {
  Plane plane;
  wend::Columns force;
  force.box("force", "N", -1, 1);
  EXPECT_EQ(
      wend::testing::error_of([&] { steer_of(plane, force); }),
      "cannot steer with the actions force: expected one discrete action, or two numbers such as speed and turn_rate");
}

TEST(Reading, TellsWhichColumnIsNotANumber) {
  wend::Columns columns;
  columns.box("a", "m").box("b.0", "m").box("b.1", "m", 0, 1, 0.5);
  const wend::Reading reading(wend::Space(columns.table()), std::vector<std::string>{"b.*"}, "observe");
  EXPECT_EQ(reading.size(), 2u);
  EXPECT_EQ(reading.bearing(1), 0.5);
  const double row[] = {1, 2, -INFINITY};
  EXPECT_EQ(reading(row), 2);
  EXPECT_EQ(wend::testing::error_of([&] { reading(row, 1); }),
            "observation \"b.1\": expected a finite number, found -infinity");
}
