// Kinematics against closed forms and against fine integration; tracks of things that move by themselves.
#include "../motion/kinematics.hpp"
#include "../motion/track.hpp"
#include "harness.hpp"

namespace arena {
namespace {

constexpr double pi = wend::math::pi;

Values simrobot() {
  Values values{{{"body/radius", 3}, {"kinematics/wheel_radius", 1}, {"kinematics/half_track", 3}},
                {{"kinematics/type", "differential"}}};
  const double rows[3][2] = {{0.5, 0.5}, {0, 0.5}, {0.5, 0}};
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 2; ++i) values.numbers["actions/" + std::to_string(k) + "/" + std::to_string(i)] = rows[k][i];
  return values;
}

struct Model {
  explicit Model(Values v, double dt = 1, double period = 1)
      : values(std::move(v)), table(values.table()), kinematics(wend::Params(table), dt, period) {}
  Values values;
  std::vector<wend_value> table;
  Kinematics kinematics;
};

TEST(Kinematics, DifferentialWheelsDriveCircles) {
  Model model(simrobot());
  ASSERT_TRUE(model.kinematics.discrete());
  // One wheel still: around it, at half the track, by R w / (2 l_a) = 1/12 rad/s.
  const double left[] = {1};
  wend_motion at = model.kinematics.predict({0, 0, 0, 0, 0}, left, 2 * pi * 12);
  EXPECT_NEAR(at.x, 0, 1e-12);
  EXPECT_NEAR(at.y, 0, 1e-12);
  at = model.kinematics.predict({0, 0, 0, 0, 0}, left, pi * 12);
  EXPECT_NEAR(at.x, 0, 1e-12);
  EXPECT_NEAR(at.y, 6, 1e-12);
  const double straight[] = {0};
  at = model.kinematics.predict({1, 2, pi / 2, 0, 0}, straight, 10);
  EXPECT_NEAR(at.x, 1, 1e-14);
  EXPECT_NEAR(at.y, 7, 1e-14);
  EXPECT_EQ(at.speed, 0.5);
  wend_limits limits{};
  model.kinematics.limits(limits);
  EXPECT_EQ(limits.speed_low, 0.25);
  EXPECT_EQ(limits.speed_high, 0.5);
  EXPECT_NEAR(limits.turn_rate, 1.0 / 12, 1e-15);
  EXPECT_NEAR(limits.turn_radius, 3, 1e-14);
}

TEST(Kinematics, OffsetPointFollowsTheEquationOfMotion) {
  Values values = simrobot();
  values.numbers["kinematics/offset"] = 0.7;
  Model model(values);
  const double left[] = {1};
  wend_motion fine{0, 0, 0.3, 0, 0};
  const int n = 200000;
  for (int k = 0; k < n; ++k) {  // midpoint rule on x' = v cos th - l_b w sin th, y' = v sin th + l_b w cos th
    const double dt = 5.0 / n, v = 0.25, w = 1.0 / 12, th = fine.heading + 0.5 * w * dt;
    fine.x += dt * (v * wend::math::cos(th) - 0.7 * w * wend::math::sin(th));
    fine.y += dt * (v * wend::math::sin(th) + 0.7 * w * wend::math::cos(th));
    fine.heading += w * dt;
  }
  const wend_motion at = model.kinematics.predict({0, 0, 0.3, 0, 0}, left, 5);
  EXPECT_NEAR(at.x, fine.x, 1e-9);
  EXPECT_NEAR(at.y, fine.y, 1e-9);
  EXPECT_NEAR(at.heading, fine.heading, 1e-9);
}

TEST(Kinematics, SmallTurnsJoinTheStraightLineSmoothly) {
  Model model(robot_values());
  for (const double rate : {1e-16, 1e-9, 1.99e-4, 2.01e-4, 1e-3}) {
    const double action[] = {2, rate};
    const wend_motion at = model.kinematics.predict({0, 0, 0, 0, 0}, action, 1);
    // 2 (1 - cos w)/w = w - w^3/12 + ...
    EXPECT_NEAR(at.y, rate - rate * rate * rate / 12, 4e-15 * rate + 1e-30) << rate;
    EXPECT_NEAR(at.x, 2 - rate * rate / 3, 1e-12) << rate;
  }
}

TEST(Kinematics, AccelerationActsOnceADt) {
  Model model(
      robot_values(1, {{"kinematics/acceleration", 2}, {"kinematics/turn_acceleration", 1}, {"kinematics/speed/1", 3}}),
      0.5, 0.5);
  const double go[] = {100, 0};
  // Speeds 1, 2, 3, 3 in steps of 0.5 s: 0.5 + 1 + 1.5 + 1.5.
  wend_motion at = model.kinematics.predict({0, 0, 0, 0, 0}, go, 2);
  EXPECT_NEAR(at.x, 4.5, 1e-14);
  EXPECT_EQ(at.speed, 3);
  const double turn[] = {0, 1};
  at = model.kinematics.predict({0, 0, 0, 0, 0}, turn, 1.5);  // 0.5, 1, 1 rad/s
  EXPECT_NEAR(at.heading, 1.25, 1e-14);
}

TEST(Kinematics, TurnThenAdvanceTurnsAtTheFirstInstant) {
  Values values{{{"body/radius", 0},
                 {"kinematics/step", 0.5},
                 {"actions/0/0", pi / 2},
                 {"actions/0/1", 0.5},
                 {"actions/1/0", pi / 18},
                 {"actions/1/1", 0}},
                {{"kinematics/type", "turn_then_advance"}}};
  Model model(values, 0.02, 0.5);
  const double left[] = {0};
  wend_motion at = model.kinematics.predict({0, 0, 0, 0, 0}, left, 0.25);
  EXPECT_NEAR(at.x, 0, 1e-15);
  EXPECT_NEAR(at.y, 0.25, 1e-15);
  at = model.kinematics.predict({0, 0, 0, 0, 0}, left, 2);  // a square
  EXPECT_NEAR(at.x, 0, 1e-14);
  EXPECT_NEAR(at.y, 0, 1e-14);
  wend_limits limits{};
  model.kinematics.limits(limits);
  EXPECT_EQ(limits.turn_radius, 0);
  EXPECT_EQ(limits.speed_high, 1);
}

TEST(Kinematics, ContinuousColumnsHaveNamesUnitsAndLimits) {
  Model unicycle(
      robot_values(1, {{"kinematics/speed/0", -0.5}, {"kinematics/speed/1", 2}, {"kinematics/turn_rate", 1.5}}));
  EXPECT_STREQ(unicycle.kinematics.columns()[0].name, "speed");
  EXPECT_EQ(unicycle.kinematics.columns()[0].low, -0.5);
  EXPECT_STREQ(unicycle.kinematics.columns()[1].unit, "rad/s");
  const double wild[] = {9, -9};
  EXPECT_EQ(unicycle.kinematics.command(wild).twist.speed, 2);
  EXPECT_EQ(unicycle.kinematics.command(wild).twist.turn_rate, -1.5);
  Values wheels{{{"kinematics/wheel_radius", 0.1}, {"kinematics/half_track", 0.2}, {"kinematics/wheel_speed", 5}},
                {{"kinematics/type", "differential"}}};
  Model differential(wheels);
  EXPECT_STREQ(differential.kinematics.columns()[1].name, "wheel_right");
  EXPECT_EQ(differential.kinematics.columns()[1].high, 5);
  wend_limits limits{};
  differential.kinematics.limits(limits);
  EXPECT_EQ(limits.turn_radius, 0);
  EXPECT_DOUBLE_EQ(limits.speed_high, 0.5);
  EXPECT_DOUBLE_EQ(limits.turn_rate, 2.5);
}

TEST(Track, PatrolsGoToAndFro) {
  const Track track({{0, 0}, {4, 0}, {4, 0}, {4, 3}}, 2, {0, 0});  // 7 m one way
  EXPECT_DOUBLE_EQ(track.cycle(), 7);
  const auto expect = [&](double t, double x, double y, double vx, double vy) {
    const Track::State at = track.at(t);
    EXPECT_NEAR(at.x, x, 1e-12) << t;
    EXPECT_NEAR(at.y, y, 1e-12) << t;
    EXPECT_NEAR(at.vx, vx, 1e-12) << t;
    EXPECT_NEAR(at.vy, vy, 1e-12) << t;
  };
  expect(0, 0, 0, 2, 0);
  expect(1.5, 3, 0, 2, 0);
  expect(3, 4, 2, 0, 2);
  expect(4, 4, 2, 0, -2);
  expect(6, 2, 0, -2, 0);
  expect(700 + 1.5, 3, 0, 2, 0);
}

TEST(Track, BouncesWithItsRim) {
  Scene scene;
  scene.x = 10, scene.width = 8, scene.height = 100;
  Mover mover;
  mover.radius = 1, mover.x = 12, mover.y = 50, mover.vx = -2;
  const Track track(mover, scene);  // its centre in 11..17
  EXPECT_DOUBLE_EQ(track.at(0.5).x, 11);
  EXPECT_DOUBLE_EQ(track.at(1.5).x, 13);
  EXPECT_DOUBLE_EQ(track.at(1.5).vx, 2);
  EXPECT_DOUBLE_EQ(track.at(4).x, 16);
  EXPECT_DOUBLE_EQ(track.at(4).vx, -2);
  EXPECT_DOUBLE_EQ(track.at(4).y, 50);
}

}  // namespace
}  // namespace arena
