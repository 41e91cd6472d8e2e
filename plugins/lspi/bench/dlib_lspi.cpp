#include "dlib_lspi.hpp"

#include <dlib/control.h>

#include <algorithm>

namespace peer {
namespace {

// phi(s, a) as dlib asks for it: K m numbers, zero outside block a.  The best action is found without the zeros, since
// the comparison is to be of the solvers.
struct Features {
  using state_type = const double*;  // phi(s); null: nothing follows
  using action_type = std::uint32_t;
  static constexpr bool force_last_weight_to_1 = false;

  std::size_t m = 0;
  std::uint32_t actions = 0;

  unsigned long num_features() const { return m * actions; }
  action_type find_best_action(const state_type& phi, const dlib::matrix<double, 0, 1>& w) const {
    return phi != nullptr ? lspi::greedy({phi, m}, {w.begin(), m * actions}, actions) : 0;
  }
  void get_features(const state_type& phi, const action_type& action, dlib::matrix<double, 0, 1>& into) const {
    into.set_size(static_cast<long>(num_features()));
    into = 0;
    if (phi != nullptr) std::copy_n(phi, m, into.begin() + static_cast<long>(action * m));
  }
};

}  // namespace

std::vector<double> dlib_lspi(const lspi::Samples& samples, std::uint32_t actions, double discount, double lambda,
                              double still, unsigned iterations) {
  std::vector<dlib::process_sample<Features>> all(samples.size());
  const std::size_t m = samples.features;
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = {samples.phi.data() + i * m, samples.actions[i],
              samples.terminal[i] != 0 ? nullptr : samples.next_phi.data() + i * m, samples.rewards[i]};
  dlib::lspi<Features> solver(Features{m, actions});
  solver.set_discount(discount);
  solver.set_lambda(lambda);
  solver.set_epsilon(still);
  solver.set_max_iterations(iterations);
  const auto policy = solver.train(all);
  return {policy.get_weights().begin(), policy.get_weights().end()};
}

}  // namespace peer
