// The fast loops against the plain ones, and each instruction set against the others.
#include "../loops.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "plain_loops.hpp"

using namespace hdp;

namespace {

struct Problem {
  Network actor, critic;
  std::vector<double> x, z, before, by_u;

  Problem(std::uint64_t seed, std::size_t inputs, std::size_t hidden, double bound)
      : actor(inputs, hidden), critic(inputs + 1, hidden), by_u(inputs + 1, 0) {
    wend::Random random(seed);
    actor.draw(random, bound), critic.draw(random, bound);
    for (std::size_t j = 0; j < inputs; ++j)
      x.push_back(random.uniform(-1, 1)), before.push_back(random.uniform(-1, 1));
    z = x, z.push_back(0), before.push_back(1);
    by_u.back() = 1;
  }
};

double largest_difference(const Network& net, const plain::Net& reference) {
  double most = 0;
  for (std::size_t i = 0; i < net.hidden; ++i) {
    for (std::size_t j = 0; j < net.inputs; ++j) {
      const double expected = reference.first[i][j];
      most = std::max(most, std::fabs(net.first[j * net.lanes + i] - expected) / std::max(1.0, std::fabs(expected)));
    }
    most =
        std::max(most, std::fabs(net.second[i] - reference.second[i]) / std::max(1.0, std::fabs(reference.second[i])));
  }
  return most;
}

}  // namespace

// Rates from the paper's, where the series follow the tanh, to Si & Wang's 0.3, where it is computed anew.
TEST(Loops, AreThePlainLoops) {
  for (const double rate : {1e-5, 1e-3, 1e-2, 0.3})
    for (const double gain : {1.0, 0.5})
      for (const std::size_t hidden : {1u, 6u, 8u, 13u, 32u})
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
          if (rate == 0.3 && hidden > 8) continue;  // steps so long that rounding errors grow in either
          Problem p(seed, 4 + seed % 3, hidden, 1);
          plain::Net actor(p.actor), critic(p.critic);
          const CriticTask critic_task{gain, seed % 2 ? 0.95 : 1, -2.5, rate, 1e-3, 80};
          EXPECT_EQ(critic_loop(p.critic, p.before, critic_task), plain::critic_loop(critic, p.before, critic_task));
          EXPECT_LT(largest_difference(p.critic, critic), 1e-9) << rate << ' ' << hidden << ' ' << seed;
          const ActorTask actor_task{gain, 0.5, rate, 1e-3, 100};
          const plain::Net held(p.critic);
          EXPECT_EQ(actor_loop(p.actor, p.critic, p.x, p.z, p.by_u, actor_task),
                    plain::actor_loop(actor, held, p.x, p.z, p.by_u, actor_task));
          EXPECT_LT(largest_difference(p.actor, actor), 1e-9) << rate << ' ' << hidden << ' ' << seed;
        }
}

TEST(Loops, GiveTheSameBitsWithEveryInstructionSet) {
  ASSERT_GE(every_loops().size(), 1u);
  for (const double rate : {1e-4, 1e-2, 0.3})
    for (const std::size_t hidden : {3u, 6u, 17u, 32u})
      for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Problem first(seed, 6, hidden, 1);
        std::vector<Network> results;
        for (const Loops& loops : every_loops()) {
          Problem p = first;
          critic_loop(p.critic, p.before, {1, 1, -3, rate, 0, 80}, loops);
          actor_loop(p.actor, p.critic, p.x, p.z, p.by_u, {1, 1, rate, 0, 100}, loops);
          for (const Network* net : {&p.actor, &p.critic}) results.push_back(*net);
        }
        for (std::size_t k = 2; k < results.size(); ++k) {
          const auto same = [&](const std::vector<double>& a, const std::vector<double>& b) {
            return std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
          };
          EXPECT_TRUE(same(results[k].first, results[k % 2].first)) << every_loops()[k / 2].name;
          EXPECT_TRUE(same(results[k].second, results[k % 2].second)) << every_loops()[k / 2].name;
        }
      }
}

TEST(Loops, StopAtTheToleranceAndAtTheCap) {
  Problem p(3, 6, 6, 0.3);
  const Network before = p.critic;
  EXPECT_EQ(critic_loop(p.critic, p.before, {1, 1, 0.2, 1e-3, 10, 80}), 0u);
  EXPECT_EQ(p.critic.first, before.first);
  EXPECT_EQ(critic_loop(p.critic, p.before, {1, 1, -50, 1e-4, 0.05, 7}), 7u);
  const std::uint32_t ran = critic_loop(p.critic, p.before, {1, 1, -0.6, 5e-2, 0.02, 80});
  EXPECT_GT(ran, 0u);
  EXPECT_LT(ran, 80u);
  const double e = p.critic.sum(p.before, 1) + 0.6;
  EXPECT_LE(e * e / 2, 0.02);
}
