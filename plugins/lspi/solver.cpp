#include "solver.hpp"

#define EIGEN_DONT_PARALLELIZE
#include <Eigen/Dense>
#include <algorithm>

#include "products.hpp"

namespace lspi {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Vector = Eigen::VectorXd;
using Rows = Eigen::Map<const Matrix>;
using Eigen::Index;
using Chosen = std::vector<std::uint32_t>;  // numbers of samples

constexpr double negligible = 1e-12;   // beside the largest pivot: rounding error; as 1 / condition number: singular
constexpr std::uint32_t settling = 2;  // iterations whose weights still remember those that it started from

// A and b of LSTDQ.  phi(s, a) is phi(s) in block a and zero elsewhere, so A falls into K x K blocks of m x m.  Phi^T
// Phi is block-diagonal and, like b = Phi^T R, stays what it is; block (a, a') of Phi^T Phi' sums over the samples of
// action a whose successor's greedy action is a'.  Few of these change from one iteration to the next, and only they
// are moved.
class System {
 public:
  System(const Samples& samples, const SolverOptions& options)
      : samples_(samples),
        discount_(options.discount),
        m_(static_cast<Index>(samples.features)),
        k_(options.actions),
        by_action_(k_),
        followed_(samples.size(), k_),
        moves_((k_ + 1) * k_),
        products_(samples.features),
        a_(Matrix::Zero(k_ * m_, k_ * m_)),
        b_(Vector::Zero(k_ * m_)) {
    for (std::uint32_t i = 0; i < samples.size(); ++i) by_action_[samples.actions[i]].push_back(i);
    for (std::uint32_t action = 0; action < k_; ++action) start(action);
    const double mean = a_.trace() / static_cast<double>(k_ * m_);
    a_.diagonal().array() += options.ridge * (mean > 0 ? mean : 1);
  }

  const Matrix& a() const { return a_; }
  const Vector& b() const { return b_; }
  std::uint32_t rank() const { return rank_; }  // of Phi

  // Makes greedy[i] what follows sample i.
  void follow(const std::vector<std::uint32_t>& greedy) {
    for (std::uint32_t action = 0; action < k_; ++action) {
      for (Chosen& move : moves_) move.clear();
      for (const std::uint32_t i : by_action_[action])
        if (!samples_.terminal[i] && greedy[i] != followed_[i]) moves_[followed_[i] * k_ + greedy[i]].push_back(i);
      for (std::uint32_t from = 0; from <= k_; ++from)
        for (std::uint32_t to = 0; to < k_; ++to) move(action, from, to);
    }
    followed_ = greedy;
  }

 private:
  auto block(std::uint32_t row, std::uint32_t column) { return a_.block(row * m_, column * m_, m_, m_); }

  // The part of Phi^T Phi and b that belongs to an action.
  void start(std::uint32_t action) {
    Matrix gram = Matrix::Zero(m_, m_);
    products_.add_square(samples_.phi.data(), by_action_[action], gram.data());
    for (const std::uint32_t i : by_action_[action])
      b_.segment(action * m_, m_) +=
          samples_.rewards[i] * Eigen::Map<const Vector>(&samples_.phi[i * samples_.features], m_);
    block(action, action) = gram.selfadjointView<Eigen::Lower>();
    const Vector pivots = gram.ldlt().vectorD().cwiseAbs();
    rank_ += static_cast<std::uint32_t>((pivots.array() > negligible * pivots.maxCoeff()).count());
  }

  // Takes the samples of a move from the block of what followed them (none in the beginning) to that of what does now.
  void move(std::uint32_t action, std::uint32_t from, std::uint32_t to) {
    const Chosen& moved = moves_[from * k_ + to];
    if (moved.empty()) return;
    Matrix sum = Matrix::Zero(m_, m_);
    products_.add(samples_.phi.data(), samples_.next_phi.data(), moved, sum.data());
    block(action, to) -= discount_ * sum;
    if (from < k_) block(action, from) += discount_ * sum;
  }

  const Samples& samples_;
  double discount_;
  Index m_;
  std::uint32_t k_;
  std::vector<Chosen> by_action_;
  std::vector<std::uint32_t> followed_;  // the action that A takes to follow a sample; k_: none yet
  std::vector<Chosen> moves_;
  Products products_;
  Matrix a_;
  Vector b_;
  std::uint32_t rank_ = 0;
};

// The greedy action in every s', the first of equals.
void improve(const Samples& samples, const Vector& w, std::vector<std::uint32_t>& greedy) {
  const auto m = static_cast<Index>(samples.features);
  const Rows next(samples.next_phi.data(), static_cast<Index>(samples.size()), m);
  const Rows weights(w.data(), w.size() / m, m);
  const Matrix q = next * weights.transpose();
  for (Index i = 0; i < q.rows(); ++i) {
    const double* row = q.data() + i * q.cols();
    greedy[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(std::max_element(row, row + q.cols()) - row);
  }
}

std::size_t different(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < a.size(); ++i) n += a[i] != b[i];
  return n;
}

// LU; where A is singular within rounding, the shortest of the least-squares solutions.
void solve_system(const System& system, Vector& w, Solution& solution) {
  const Eigen::PartialPivLU<Matrix> lu(system.a());
  const double reciprocal = lu.rcond();
  solution.condition = reciprocal > 0 ? 1 / reciprocal : 1e300;
  if (reciprocal > negligible) {
    w = lu.solve(system.b());
  } else {
    Eigen::CompleteOrthogonalDecomposition<Matrix> qr(system.a().rows(), system.a().cols());
    qr.setThreshold(negligible);
    w = qr.compute(system.a()).solve(system.b());
  }
  const double norm = system.b().norm();
  solution.residual = norm > 0 ? (system.a() * w - system.b()).norm() / norm : 0;
}

}  // namespace

std::uint32_t greedy(std::span<const double> features, std::span<const double> weights,
                     std::uint32_t actions) noexcept {
  std::uint32_t best = 0;
  double best_q = 0;
  for (std::uint32_t a = 0; a < actions; ++a) {
    const double q = value(features, weights, a);
    if (a == 0 || q > best_q) {
      best = a;
      best_q = q;
    }
  }
  return best;
}

// Figure 8 of Lagoudakis & Parr.  Where the policies run into a cycle, none is its own improvement: kept are the
// weights whose improvement changed the policy in the fewest samples, the first of equals.
Solution solve(const Samples& samples, const SolverOptions& options, std::vector<double> weights) {
  // Eigen's blocking, and with it the order of additions, would depend on the cache sizes of the CPU.
  [[maybe_unused]] static const bool pinned = (Eigen::setCpuCacheSizes(32 << 10, 512 << 10, 4 << 20), true);
  weights.resize(samples.features * options.actions);
  Vector w = Eigen::Map<const Vector>(weights.data(), static_cast<Index>(weights.size()));
  System system(samples, options);
  std::vector<std::uint32_t> successors(samples.size()), before;
  improve(samples, w, successors);
  Solution solution, kept;
  std::size_t fewest = samples.size() + 1;
  solution.rank = system.rank();
  for (; solution.iterations < options.iterations && !solution.converged; ++solution.iterations) {
    system.follow(successors);
    solve_system(system, w, solution);
    before = successors;
    improve(samples, w, successors);
    const std::size_t changes = different(successors, before);
    solution.converged = changes == 0;
    const bool settled = solution.iterations >= settling || options.iterations <= settling;
    if (solution.converged || (settled && changes < fewest)) {
      fewest = changes;
      kept = solution;
      kept.weights.assign(w.data(), w.data() + w.size());
    }
  }
  kept.iterations = solution.iterations;
  return kept;
}

}  // namespace lspi
