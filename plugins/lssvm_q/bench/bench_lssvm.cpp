// Training one LS-SVM of 2,000 samples of 10 features, beside dlib's kernel ridge regression with the same kernel, a
// fixed lambda and all samples as its basis: thread CPU time in one process, interleaved, the least of several slices.
//   bench_lssvm [--json]      one JSON object; else a line for a person
#include <dlfcn.h>
#include <dlib/svm.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>
#include <wend/random.hpp>
#include <wend/testing_time.hpp>

#include "../lssvm.hpp"

namespace {

constexpr lssvm::Index n = 2000, d = 10;
constexpr double sigma = 2, c = 10;
constexpr int slices = 2, ours_per_slice = 8;

using Sample = dlib::matrix<double, 10, 1>;
using Kernel = dlib::radial_basis_kernel<Sample>;

volatile double sink;  // or the compiler would drop what nobody reads

template <class Work>
double seconds(Work&& work) {
  const double start = wend::testing::thread_seconds();
  work();
  return wend::testing::thread_seconds() - start;
}

struct Problem {
  std::vector<double> x, y;
  std::vector<Sample> samples;
  Problem() : x(n * d), y(n), samples(n) {
    wend::Random random(2014);
    for (lssvm::Index i = 0; i < n; ++i) {
      double sum = 0;
      for (lssvm::Index f = 0; f < d; ++f) {
        x[i * d + f] = samples[i](static_cast<long>(f)) = random.normal();
        sum += x[i * d + f];
      }
      y[i] = std::sin(sum) + random.normal(0, 0.1);
    }
  }
};

// The library that dlib's matrix products come from.
std::string blas() {
  Dl_info info{};
  void* symbol = dlsym(RTLD_DEFAULT, "cblas_dgemm");
  return symbol && dladdr(symbol, &info) && info.dli_fname ? info.dli_fname : "dlib's own";
}

}  // namespace

int main(int count, char** arguments) {
  const bool json = count > 1 && std::strcmp(arguments[1], "--json") == 0;
  const Problem problem;
  double ours = 1e9, peer = 1e9, residual = 0, condition = 0;
  for (int slice = 0; slice < slices; ++slice) {
    dlib::krr_trainer<Kernel> trainer;
    trainer.set_kernel(Kernel(0.5 / (sigma * sigma)));
    trainer.set_lambda(1 / c);
    trainer.set_basis(problem.samples);
    peer = std::min(peer, seconds([&] { sink = trainer.train(problem.samples, problem.y).b; }));
    for (int k = 0; k < ours_per_slice; ++k)
      ours = std::min(ours, seconds([&] {
                        const lssvm::Lssvm machine(lssvm::Points(problem.x, d), sigma, c);
                        sink = machine.fit(problem.y, 1).front().b;
                      }));
  }
  const lssvm::Lssvm machine(lssvm::Points(problem.x, d), sigma, c);
  const lssvm::Dual solution = machine.fit(problem.y, 1).front();
  residual = machine.residual(solution, problem.y);
  condition = machine.condition();
  if (json)
    std::printf(
        "{\"lssvm_vs_dlib_2000\": %.2f, \"lssvm_residual_2000\": %.3g, \"lssvm_condition_2000\": %.4g, "
        "\"lssvm_ms_2000\": %.2f, \"lssvm_dlib_ms_2000\": %.1f}\n",
        peer / ours, residual, condition, 1e3 * ours, 1e3 * peer);
  else
    std::printf(
        "LS-SVM of %zu samples: ours %.1f ms (%s), dlib krr_trainer %.0f ms (%s), ratio %.1f; residual %.2g, "
        "condition %.3g\n",
        n, 1e3 * ours, lssvm::loops().name, 1e3 * peer, blas().c_str(), peer / ours, residual, condition);
  std::fprintf(stderr, "dlib's BLAS: %s\n", blas().c_str());
}
