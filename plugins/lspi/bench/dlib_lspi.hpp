// dlib's LSPI on samples of ours: the peer of the benchmark and an oracle of the tests.
#pragma once
#include <vector>

#include "solver.hpp"

namespace peer {

// Weights, K x m as ours.  It starts from zero, adds `lambda` to A's diagonal, and stops when an iteration moves the
// weights by no more than `still`, or after so many iterations.
std::vector<double> dlib_lspi(const lspi::Samples& samples, std::uint32_t actions, double discount, double lambda,
                              double still, unsigned iterations);

}  // namespace peer
