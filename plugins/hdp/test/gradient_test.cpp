// Equations (4), (7), (10) and (13): one step of either loop against finite differences of E.
#include <gtest/gtest.h>

#include <functional>

#include "../agent.hpp"

using namespace hdp;

namespace {

constexpr double difference = 1e-3, rate = 1;

// Every weight of `net`, its change over one step of the loop at rate 1 against minus dE/dw by central differences.
void expect_gradient(const Network& net, const Network& after, const std::function<double(const Network&)>& E) {
  double scale = 0;
  std::vector<std::pair<double, double>> all;
  for (const bool second : {false, true}) {
    const std::vector<double>& layer = second ? net.second : net.first;
    for (std::size_t k = 0; k < layer.size(); ++k) {
      if (k % net.lanes >= net.hidden) continue;
      const auto moved = [&](double by) {
        Network copy = net;
        (second ? copy.second : copy.first)[k] += by;
        return E(copy);
      };
      // Richardson's extrapolation: error of the order of difference^4.
      const double wide = (moved(2 * difference) - moved(-2 * difference)) / (4 * difference);
      const double narrow = (moved(difference) - moved(-difference)) / (2 * difference);
      const double step = (second ? after.second : after.first)[k] - layer[k];
      all.push_back({-step / rate, (4 * narrow - wide) / 3});
      scale = std::max(scale, std::fabs(all.back().second));
    }
  }
  EXPECT_GT(scale, 1e-5);
  for (const auto& [analytic, numeric] : all) EXPECT_NEAR(analytic, numeric, 1e-6 * scale);
}

class Gradients : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  Gradients() : agent(6, settings) {
    wend::Random random(GetParam());
    agent.draw(random);
    for (int j = 0; j < 6; ++j) x.push_back(random.uniform(-1, 1));
    J_before = random.uniform(-2, 2), r = random.uniform(-1, 0);
  }
  static std::vector<double> with(std::vector<double> x, double u) {
    x.push_back(u);
    return x;
  }

  Settings settings;  // as the preset `paper` has them
  Agent agent;
  std::vector<double> x;
  double J_before = 0, r = 0;
};

}  // namespace

TEST_P(Gradients, CriticFollowsItsError) {
  const std::vector<double> z = with(x, agent.u(x));
  Network after = agent.critic;
  critic_loop(after, z, {settings.gain, settings.alpha, J_before - r, rate, 0, 1});
  expect_gradient(agent.critic, after, [&](const Network& critic) {
    const double e = settings.alpha * critic.sum(z, settings.gain) - (J_before - r);
    return e * e / 2;
  });
}

TEST_P(Gradients, ActorFollowsItsErrorThroughTheCritic) {
  std::vector<double> by_u(7, 0);
  by_u[6] = 1;
  Network after = agent.actor;
  actor_loop(after, agent.critic, x, with(x, 0), by_u, {settings.gain, settings.U_c, rate, 0, 1});
  expect_gradient(agent.actor, after, [&](const Network& actor) {
    const double u = actor_output(actor, x, settings.gain);
    const double e = agent.critic.sum(with(x, u), settings.gain) - settings.U_c;
    return e * e / 2;
  });
}

// A whole decision of the preset: with caps of 1 and a rate of 1, what Agent::learn does is one step along -dE/dw.
TEST_P(Gradients, ADecisionOfThePresetPaperDescendsBoth) {
  Settings one = settings;
  one.N_c = one.N_a = 1, one.T_c = one.T_a = 0;
  Agent learner(6, one);
  learner.actor = agent.actor, learner.critic = agent.critic;
  const std::vector<double> before(6, 0.1);
  learner.learn({before, 0, r, x, 0, J_before, false, false, rate, rate});
  const std::vector<double> z = with(x, agent.u(x));
  expect_gradient(agent.critic, learner.critic, [&](const Network& critic) {
    const double e = settings.alpha * critic.sum(z, settings.gain) - (J_before - r);
    return e * e / 2;
  });
  const Network moved = learner.critic;
  expect_gradient(agent.actor, learner.actor, [&](const Network& actor) {
    const double e = moved.sum(with(x, actor_output(actor, x, settings.gain)), settings.gain);
    return e * e / 2;
  });
}

// td: the gradient goes through J(t - 1), its target is held.
TEST_P(Gradients, TdMovesTheLastValueTowardsItsTarget) {
  Settings td = settings;
  td.td = true, td.N_c = 1, td.N_a = 0, td.T_c = 0;
  Agent learner(6, td);
  learner.actor = agent.actor, learner.critic = agent.critic;
  std::vector<double> before = x;
  before[2] = -before[2], before[5] = 0.3;
  const double target = r + td.alpha * agent.J(x, agent.u(x));
  learner.learn({before, -1, r, x, 0, J_before, false, false, rate, rate});
  expect_gradient(agent.critic, learner.critic, [&](const Network& critic) {
    const double e = critic.sum(with(before, -1), td.gain) - target;
    return e * e / 2;
  });
}

INSTANTIATE_TEST_SUITE_P(Seeds, Gradients, ::testing::Range(std::uint64_t{0}, std::uint64_t{20}));
