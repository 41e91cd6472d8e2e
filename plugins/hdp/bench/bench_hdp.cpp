// One decision's learning with both inner loops at their caps (80 + 100), 6-6-1 and 7-6-1, against the same loops
// written naively with dynamic-size Eigen matrices, in turns in the same process; and the error against plain doubles.
#include <Eigen/Dense>
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <wend/testing_time.hpp>

#include "../loops.hpp"
#include "../test/plain_loops.hpp"

namespace {

constexpr std::size_t inputs = 6, hidden = 6, decisions = 64, rounds = 25, slices = 60;
// The rates of the preset robust, a TD error of a few units, and thresholds of 0, so that both loops run to their caps.
constexpr double gain = 1;
constexpr hdp::CriticTask critic_task{gain, 1, -4, 1e-3, 0, 80};
constexpr hdp::ActorTask actor_task{gain, 4, 1e-4, 0, 100};

struct Eigen2 {  // hidden x inputs, and the row of output weights
  Eigen::MatrixXd first;
  Eigen::RowVectorXd second;
  explicit Eigen2(const hdp::Network& from) : first(from.hidden, from.inputs), second(from.hidden) {
    for (std::size_t i = 0; i < from.hidden; ++i) {
      for (std::size_t j = 0; j < from.inputs; ++j)
        first(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = from.first[j * from.lanes + i];
      second(static_cast<Eigen::Index>(i)) = from.second[i];
    }
  }
};

Eigen::VectorXd units(const Eigen2& net, const Eigen::VectorXd& x) {
  return (gain * (net.first * x)).array().tanh().matrix();
}

void eigen_decision(Eigen2& actor, Eigen2& critic, const Eigen::VectorXd& before, const Eigen::VectorXd& x) {
  for (std::uint32_t k = 0; k < critic_task.most; ++k) {
    const Eigen::VectorXd h = units(critic, before);
    const double e = critic.second.dot(h) - critic_task.target;
    if (!(e * e / 2 > critic_task.tolerance)) break;
    const Eigen::VectorXd by_a = (critic.second.transpose().array() * (1 - h.array().square()) * gain).matrix();
    critic.second -= critic_task.rate * e * h.transpose();
    critic.first -= critic_task.rate * e * by_a * before.transpose();
  }
  Eigen::VectorXd z(static_cast<Eigen::Index>(inputs + 1));
  z.head(static_cast<Eigen::Index>(inputs)) = x;
  for (std::uint32_t k = 0; k < actor_task.most; ++k) {
    const Eigen::VectorXd h = units(actor, x);
    const double u = std::tanh(gain * actor.second.dot(h));
    z(static_cast<Eigen::Index>(inputs)) = u;
    const Eigen::VectorXd c = units(critic, z);
    const double e = critic.second.dot(c) - actor_task.goal;
    if (!(e * e / 2 > actor_task.tolerance)) break;
    const Eigen::VectorXd by_a = (critic.second.transpose().array() * (1 - c.array().square()) * gain).matrix();
    const double by_u = by_a.dot(critic.first.col(static_cast<Eigen::Index>(inputs)));
    const double step = -actor_task.rate * e * by_u * gain * (1 - u * u);
    const Eigen::VectorXd by_b = (actor.second.transpose().array() * (1 - h.array().square()) * gain).matrix();
    actor.second += step * h.transpose();
    actor.first += step * by_b * x.transpose();
  }
}

struct Situation {
  std::vector<double> before, x;  // the critic's last input, and the state
};

std::vector<double> with_action(const std::vector<double>& x, double u) {
  std::vector<double> z = x;
  z.push_back(u);
  return z;
}

void fast_decision(hdp::Network& actor, hdp::Network& critic, const Situation& s, const std::vector<double>& z,
                   const std::vector<double>& by_u) {
  hdp::critic_loop(critic, s.before, critic_task);
  hdp::actor_loop(actor, critic, s.x, z, by_u, actor_task);
}

double largest_error(const hdp::Network& net, const hdp::plain::Net& reference) {
  double error = 0;
  for (std::size_t i = 0; i < hidden; ++i) {
    for (std::size_t j = 0; j < net.inputs; ++j)
      error = std::max(error, std::fabs(net.first[j * net.lanes + i] - reference.first[i][j]));
    error = std::max(error, std::fabs(net.second[i] - reference.second[i]));
  }
  return error;
}

}  // namespace

int main(int argc, char** argv) {
  const bool json = argc > 1 && std::strcmp(argv[1], "--json") == 0;
  wend::Random random(7);
  hdp::Network actor(inputs, hidden), critic(inputs + 1, hidden);
  actor.draw(random, 0.3), critic.draw(random, 0.3);
  std::vector<Situation> all(decisions);
  std::vector<double> by_u(inputs + 1, 0);
  by_u[inputs] = 1;
  for (Situation& s : all) {
    for (std::size_t j = 0; j < inputs; ++j)
      s.before.push_back(random.uniform(-1, 1)), s.x.push_back(random.uniform(-1, 1));
    s.before.push_back(random.chance(0.5) ? 1 : -1);
  }

  double fast = 1e9, naive = 1e9, error = 0, kept = 0;
  for (std::size_t slice = 0; slice < slices; ++slice) {
    const double start = wend::testing::thread_seconds();
    for (std::size_t round = 0; round < rounds; ++round)
      for (const Situation& s : all) {
        hdp::Network a = actor, c = critic;
        fast_decision(a, c, s, with_action(s.x, 0), by_u);
        kept += a.second[0] + c.second[0];
      }
    const double middle = wend::testing::thread_seconds();
    for (std::size_t round = 0; round < rounds; ++round)
      for (const Situation& s : all) {
        Eigen2 a(actor), c(critic);
        eigen_decision(a, c, Eigen::Map<const Eigen::VectorXd>(s.before.data(), static_cast<Eigen::Index>(inputs + 1)),
                       Eigen::Map<const Eigen::VectorXd>(s.x.data(), static_cast<Eigen::Index>(inputs)));
        kept += a.second(0) + c.second(0);
      }
    fast = std::min(fast, middle - start), naive = std::min(naive, wend::testing::thread_seconds() - middle);
  }
  asm volatile("" : : "g"(&kept) : "memory");
  for (const Situation& s : all) {
    hdp::Network a = actor, c = critic;
    hdp::plain::Net plain_actor(actor), plain_critic(critic);
    fast_decision(a, c, s, with_action(s.x, 0), by_u);
    hdp::plain::critic_loop(plain_critic, s.before, critic_task);
    hdp::plain::actor_loop(plain_actor, plain_critic, s.x, with_action(s.x, 0), by_u, actor_task);
    error = std::max({error, largest_error(a, plain_actor), largest_error(c, plain_critic)});
  }
  constexpr double per = 1e6 / (decisions * rounds);
  if (json)
    std::printf("{\"hdp_vs_naive_eigen\": %.3f, \"hdp_error_vs_double\": %.3g}\n", naive / fast, error);
  else
    std::printf(
        "a decision at the caps: %.2f us (%s), naive Eigen %.2f us, %.2f times; largest error of a weight %.2g\n",
        fast * per, hdp::every_loops().back().name, naive * per, naive / fast, error);
}
