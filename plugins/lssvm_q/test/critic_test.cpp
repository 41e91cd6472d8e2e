// The values against dense systems and small tasks whose values are known; the advice; the switch.
#include "critic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <wend/testing.hpp>

#include "adviser.hpp"
#include "cooperation.hpp"
#include "dense.hpp"

using lssvm::Adviser;
using lssvm::Cooperation;
using lssvm::Critic;
using lssvm::CriticSettings;
using lssvm::Forget;
using lssvm::Switching;
using lssvm::Window;

namespace {

// A walk on 0..4 with steps to the left (0) and to the right (1) that ends at 4 with a reward of 10.
Window chain() {
  Window window(1, 100, Forget::oldest);
  for (int s = 0; s < 4; ++s)
    for (const std::uint32_t a : {0u, 1u}) {
      const double next = a == 1 ? s + 1 : std::max(s - 1, 0);
      window.add(std::vector<double>{static_cast<double>(s)}, a, next == 4 ? 10 : -1, std::vector<double>{next},
                 next == 4);
    }
  return window;
}

CriticSettings chain_settings() {
  CriticSettings settings;
  settings.actions = 2;
  settings.features = 1;
  settings.discount = 0.9;
  settings.sigma = 0.2;  // states 1 apart and actions 2 apart know nothing of each other
  settings.c = 1e8;
  settings.action_distance = 2;
  return settings;
}

std::vector<double> values_of(Critic& critic, double state, std::size_t actions = 2) {
  std::vector<double> q(actions), spread(actions);
  critic.values(std::vector<double>{state}, q, spread);
  return q;
}

Window random_window(std::size_t n, std::size_t d, std::uint32_t actions) {
  wend::Random random(7);
  Window window(d, n, Forget::oldest);
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<double> from(d), to(d);
    for (std::size_t f = 0; f < d; ++f) from[f] = random.normal(), to[f] = random.normal();
    window.add(from, static_cast<std::uint32_t>(random.below(actions)), random.normal(), to, true);
  }
  return window;
}

}  // namespace

TEST(Critic, KnowsNothingBeforeItIsTrained) {
  Critic critic(chain_settings());
  std::vector<double> q(2, 7), spread(2, 7);
  critic.values(std::vector<double>{1}, q, spread);
  EXPECT_EQ(q, (std::vector<double>{0, 0}));
  EXPECT_EQ(spread, (std::vector<double>{0, 0}));
  EXPECT_FALSE(critic.trained());
  EXPECT_FALSE(critic.last_training());
}

TEST(Critic, OneSweepIsOneStepOfValueIteration) {
  Critic critic(chain_settings());
  const Window window = chain();
  critic.train(window, 1);
  EXPECT_NEAR(values_of(critic, 3)[1], 10, 1e-4);
  EXPECT_NEAR(values_of(critic, 2)[1], -1, 1e-4);
  critic.train(window, 1);  // the targets of the whole window are taken anew
  EXPECT_NEAR(values_of(critic, 2)[1], -1 + 0.9 * 10, 1e-4);
  EXPECT_NEAR(values_of(critic, 1)[1], -1 - 0.9, 1e-4);
}

TEST(Critic, SweepsConvergeToTheValuesOfTheTask) {
  Critic critic(chain_settings());
  critic.train(chain(), 60);
  double best = 10;
  for (int s = 3; s >= 0; --s) {
    EXPECT_NEAR(values_of(critic, s)[1], best, 1e-3) << s;
    best = -1 + 0.9 * best;
  }
  EXPECT_NEAR(values_of(critic, 3)[0], -1 + 0.9 * values_of(critic, 2)[1], 1e-3);
  EXPECT_LT(critic.last_training()->residual, 1e-9);
  EXPECT_GE(critic.last_training()->condition, 1);
  EXPECT_LT(critic.last_training()->error, 1e-4);
}

// Q over pairs is the dense LS-SVM whose inputs are the state and a coordinate (or a corner of a simplex) of the
// action.
TEST(Critic, IsTheDenseMachineOverPairs) {
  for (const bool ordinal : {true, false}) {
    CriticSettings settings;
    settings.actions = 3, settings.features = 2, settings.sigma = 0.8, settings.c = 20, settings.action_distance = 0.7;
    settings.ordinal = ordinal;
    const Window window = random_window(70, 2, 3);
    const auto place = [&](std::uint32_t a) {
      std::vector<double> at(ordinal ? 1 : 3, 0.0);
      if (ordinal)
        at[0] = 0.7 * a;
      else
        at[a] = 0.7 / std::sqrt(2.0);
      return at;
    };
    std::vector<double> x, y;
    for (std::size_t i = 0; i < window.size(); ++i) {
      const auto at = place(window.action(i));
      x.insert(x.end(), window.state(i).begin(), window.state(i).end());
      x.insert(x.end(), at.begin(), at.end());
      y.push_back(window.reward(i));
    }
    const std::size_t d = 2 + place(0).size();
    const std::vector<double> solution = dense::lssvm(x, d, 0.8, 20, y);
    Critic critic(settings);
    critic.train(window, 5);  // all terminal: sweeps change nothing
    std::vector<double> q(3), spread(3);
    const std::vector<double> state{0.3, -0.2};
    critic.values(state, q, spread);
    double squares = 0;
    for (std::size_t i = 0; i < y.size(); ++i) squares += solution[i + 1] * solution[i + 1] / 400;
    EXPECT_NEAR(critic.last_training()->error, std::sqrt(squares / 70), 1e-10);
    for (std::uint32_t a = 0; a < 3; ++a) {
      std::vector<double> point = state;
      for (const double value : place(a)) point.push_back(value);
      double expected = solution[0], off = 0, mass = 0;
      for (std::size_t i = 0; i < y.size(); ++i) {
        const double k = dense::gauss(point.data(), &x[i * d], d, 0.8);
        expected += solution[i + 1] * k;
        off += std::fabs(solution[i + 1]) / 20 * k;
        mass += k;
      }
      EXPECT_NEAR(q[a], expected, 1e-10) << ordinal << a;
      EXPECT_NEAR(spread[a], off / mass, 0.05) << "the errors around it";
    }
  }
}

TEST(Critic, TheSpreadIsTheTargetsDeviationWhereThereAreNoSamples) {
  Critic critic(chain_settings());
  critic.train(chain(), 1);
  std::vector<double> q(2), far(2), near(2);
  critic.values(std::vector<double>{1e3}, q, far);
  critic.values(std::vector<double>{1}, q, near);
  // seven targets of -1 and one of 10
  EXPECT_NEAR(far[0], 11 * std::sqrt(1.0 / 8 * 7 / 8), 1e-6);
  EXPECT_LT(near[0], 0.06 * far[0]);
}

TEST(Critic, CautionComparesByQLessTheSpread) {
  CriticSettings settings = chain_settings();
  settings.caution = 2;
  Critic critic(settings);
  critic.train(chain(), 1);
  std::vector<double> q(2), spread(2), worth(2);
  critic.values(std::vector<double>{1.4}, q, spread);
  critic.worth(std::vector<double>{1.4}, worth);
  for (std::size_t a = 0; a < 2; ++a) EXPECT_NEAR(worth[a], q[a] - 2 * spread[a], 1e-12);
}

TEST(Critic, RefusesTargetsWhoseSpreadIsNotFinite) {
  Window window(1, 10, Forget::oldest);
  for (const double reward : {1e200, -1e200})
    window.add(std::vector<double>{reward > 0 ? 0.0 : 1.0}, 0, reward, std::vector<double>{0}, true);
  Critic critic(chain_settings());
  EXPECT_EQ(wend::testing::error_of([&] { critic.train(window, 1); }),
            "training: expected finite values Q, found NaN or infinity; lower gamma, caution or the rewards");
}

TEST(Adviser, NamesTheActionOfItsSurroundings) {
  Window window(1, 100, Forget::oldest);
  for (int i = 0; i < 30; ++i)
    window.add(std::vector<double>{i / 10.0}, static_cast<std::uint32_t>(i / 10), 0, std::vector<double>{0}, false);
  Adviser adviser(3, 1, 0.3, 10);
  EXPECT_FALSE(adviser.trained());
  adviser.train(window);
  EXPECT_EQ(adviser.advise(std::vector<double>{0.4}), 0u);
  EXPECT_EQ(adviser.advise(std::vector<double>{1.5}), 1u);
  EXPECT_EQ(adviser.advise(std::vector<double>{2.7}), 2u);
}

TEST(Cooperation, GoesDeepAfterEpisodes) {
  Cooperation one({Switching::Kind::after_episodes, 0, 0, 2}), none({Switching::Kind::after_episodes, 0, 0, 0});
  EXPECT_TRUE(none.deep());
  one.begin_episode(0, 0), one.begin_episode(1, 50);
  EXPECT_FALSE(one.deep());
  one.begin_episode(2, 90);
  EXPECT_TRUE(one.deep());
  EXPECT_EQ(one.switch_episode(), 2u);
  EXPECT_EQ(one.switch_step(), 90u);
}

TEST(Cooperation, GoesDeepOnceTheyAgreeInAWindow) {
  Cooperation cooperation({Switching::Kind::window, 0.75, 4, 0});
  cooperation.begin_episode(0, 0);
  EXPECT_TRUE(std::isnan(cooperation.agreement()));
  for (const bool agree : {true, true, false, false, true, true}) cooperation.compare(agree, 1, 1);
  EXPECT_FALSE(cooperation.deep());  // of the last four only two
  EXPECT_NEAR(cooperation.agreement(), 4.0 / 6, 1e-15);
  cooperation.compare(true, 1, 8);
  EXPECT_TRUE(cooperation.deep());  // false, true, true, true
  EXPECT_EQ(cooperation.switch_step(), 8u);
}

TEST(Cooperation, PerStateIsDeepWhereTheyAgree) {
  Cooperation cooperation({Switching::Kind::per_state, 0, 0, 0});
  EXPECT_TRUE(cooperation.deep_in_state(true));
  EXPECT_FALSE(cooperation.deep_in_state(false));
  for (int i = 0; i < 100; ++i) cooperation.compare(true, 1, 1);
  EXPECT_FALSE(cooperation.deep());
  EXPECT_TRUE(cooperation.needs_advice());
}
