// The plant against an independent integration, and the world's rules.
#include <gtest/gtest.h>

#include <cmath>
#include <wend/math.hpp>
#include <wend/testing.hpp>

#include "../plant.hpp"

extern "C" const wend_plugin wend_plugin_1;

using namespace cart_pole;

namespace {

constexpr Plant usual{9.8, 1, 0.1, 0.5, 5e-4, 2e-6};

// With the manifest's defaults.
class World : public wend::testing::Bench {
 public:
  explicit World(std::uint32_t copies = 1) : Bench(*wend_plugin_1.components[0]) {
    this->copies(copies);
    set("gravity", 9.8).set("cart_mass", 1).set("pole_mass", 0.1).set("half_length", 0.5).set("cart_friction", 5e-4);
    set("pole_friction", 2e-6).set("force", 10).set("dt", 0.02).set("integrator", "rk4").set("angle_limit_deg", 12);
    set("track", 2.4).set("steps", 6000);
    for (const char* zero :
         {"start_angle_deg", "start_position", "sensor_uniform", "sensor_gaussian", "actuator_uniform"})
      set(zero, 0);
  }
  void reset(std::uint64_t seed = 1) {
    std::vector<wend_episode> episodes;
    for (const std::uint32_t row : all_rows())
      episodes.push_back({0, wend::stream(seed, std::uint64_t{row}), 0, 0, WEND_TEST});
    const auto rows = all_rows();
    ASSERT_EQ(table<wend_world>(WEND_WORLD)->reset(ref().self, rows.data(), this->rows(), episodes.data()), WEND_OK);
  }
  wend_outcome step(double action) {
    const std::uint32_t copy = 0;
    wend_outcome outcome{};
    table<wend_world>(WEND_WORLD)->step(ref().self, &copy, 1, &action, &outcome);
    return outcome;
  }
};

}  // namespace

// Reference: the same equations written down again in Python, 2,000 steps of fourth order in each 0.02 s.  The cart
// stops and turns within a step, where friction jumps: hence 1e-7.
TEST(Plant, MovesAsAFineIntegrationDoes) {
  const double forces[] = {10, 10, -10, 10, -10, -10};
  State fourth{0.05, -0.3, 0.2, 0.4}, first = fourth;
  for (const double force : forces) {
    fourth = advance_rk4(usual, fourth, force, 0.02);
    first = advance_euler(usual, first, force, 0.02);
  }
  EXPECT_NEAR(fourth.theta, -0.023932311468547202, 1e-7);
  EXPECT_NEAR(fourth.theta_dot, -0.275334844183821, 1e-6);
  EXPECT_NEAR(fourth.x, 0.27517646303953497, 1e-7);
  EXPECT_NEAR(fourth.x_dot, 0.3988377690932363, 1e-6);
  EXPECT_NEAR(first.theta, fourth.theta, 0.02);
  EXPECT_GT(std::fabs(first.theta - fourth.theta), 1e-4) << "Euler's is of first order";
}

TEST(Plant, FallsTheWayItLeansAndTheCartPushesItBack) {
  EXPECT_GT(derivatives(usual, {0.1, 0, 0, 0}, 0)[1], 0);
  EXPECT_LT(derivatives(usual, {0.1, 0, 0, 0}, 10)[1], 0) << "a push to where it leans";
  const auto left = derivatives(usual, {-0.1, 0.2, 0, -0.5}, 10), right = derivatives(usual, {0.1, -0.2, 0, 0.5}, -10);
  EXPECT_DOUBLE_EQ(left[1], -right[1]);
  EXPECT_DOUBLE_EQ(left[3], -right[3]);
}

TEST(CartPole, FailsBeyondTheAngleAndTellsHowLongItStood) {
  World world;
  ASSERT_TRUE(world.create()) << world.error();
  world.reset();
  EXPECT_EQ(world.sense(), (std::vector<double>{0, 0, 0, 0}));
  int steps = 1;
  wend_outcome last = world.step(1);
  for (; !last.flags; ++steps) {
    EXPECT_EQ(last.reward, 0);
    last = world.step(1);
  }
  EXPECT_EQ(last.reward, -1);
  EXPECT_EQ(last.flags, std::uint32_t{WEND_TERMINATED | WEND_COLLIDED});
  EXPECT_GT(std::fabs(world.sense()[0]), 12 * wend::math::degree);
  EXPECT_EQ(world.telemetry(WEND_PER_EPISODE)[0], steps);
  EXPECT_LT(steps, 20);
}

// A linear feedback that is known to balance: the pole's angle first, the cart's place last.
TEST(CartPole, SucceedsAfterAllSteps) {
  World world;
  ASSERT_TRUE(world.create());
  world.reset();
  for (int i = 1; i <= 6000; ++i) {
    const auto s = world.sense();
    const wend_outcome outcome = world.step(20 * s[0] + 4 * s[1] + 0.3 * s[2] + 0.8 * s[3] >= 0);
    ASSERT_EQ(outcome.flags, i == 6000 ? std::uint32_t{WEND_TERMINATED | WEND_ARRIVED} : 0u) << i;
    ASSERT_EQ(outcome.reward, 0);
  }
}

TEST(CartPole, NoiseIsDrawnFromTheEpisodeAlone) {
  World world(400), again(400);
  for (World* w : {&world, &again}) {
    w->set("start_angle_deg", 6).set("sensor_uniform", 0.1);
    ASSERT_TRUE(w->create());
    w->reset(5);
  }
  EXPECT_EQ(world.sense(), again.sense());
  again.reset(6);
  EXPECT_NE(world.sense(), again.sense());
  World exact(400);
  exact.set("start_angle_deg", 6);
  ASSERT_TRUE(exact.create());
  exact.reset(5);
  double mean = 0, most = 0;
  for (std::uint32_t row = 0; row < 400; ++row) {
    const double error = world.sense({row})[0] / exact.sense({row})[0] - 1;
    mean += error / 400, most = std::max(most, std::fabs(error));
  }
  EXPECT_NEAR(mean, 0, 0.01);
  EXPECT_LE(most, 0.1 + 1e-12);
  EXPECT_GT(most, 0.095);
}

TEST(CartPole, GaussianReadingsHaveTheirVarianceAndForcesVary) {
  World world(2000), exact(2000);
  world.set("sensor_gaussian", 0.2), world.set("start_angle_deg", 6), exact.set("start_angle_deg", 6);
  ASSERT_TRUE(world.create() && exact.create());
  world.reset(3), exact.reset(3);
  const auto noisy = world.sense(), clean = exact.sense();
  double variance = 0;
  for (std::size_t i = 0; i < noisy.size(); i += 4) variance += std::pow(noisy[i] / clean[i] - 1, 2) / 2000;
  EXPECT_NEAR(variance, 0.2, 0.03);
  World weak;
  weak.set("actuator_uniform", 0.5);
  ASSERT_TRUE(weak.create());
  weak.reset();
  weak.step(1);
  World usual_force;
  ASSERT_TRUE(usual_force.create());
  usual_force.reset();
  usual_force.step(1);
  const double share = weak.sense()[3] / usual_force.sense()[3];
  EXPECT_NE(share, 1);
  EXPECT_NEAR(share, 1, 0.51);
}

TEST(CartPole, RefusesAStartThatHasFailed) {
  World world;
  world.set("start_angle_deg", 13);
  EXPECT_FALSE(world.create());
  EXPECT_EQ(world.parameter(), "start_angle_deg");
  EXPECT_EQ(world.error(), "expected at most angle_limit_deg = 12, found 13");
  World far;
  far.set("start_position", 2.5);
  EXPECT_FALSE(far.create());
  EXPECT_EQ(far.parameter(), "start_position");
  EXPECT_EQ(far.error(), "expected at most track = 2.4, found 2.5");
  World two;
  two.robots(2);
  EXPECT_FALSE(two.create());
  EXPECT_EQ(two.error(), "expected one cart in a world, found 2 robots");
}

TEST(CartPole, SaysWhereAStateStopsBeingNumbers) {
  World world;
  ASSERT_TRUE(world.set("force", 1e300).create());
  world.reset();
  world.step(1);
  EXPECT_EQ(world.parameter(), "dt");
  EXPECT_EQ(world.error(),
            "step 1: the state is no longer finite; take a smaller dt, or less extreme masses and forces");
}
