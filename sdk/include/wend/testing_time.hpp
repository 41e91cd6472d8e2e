// wend/testing_time.hpp -- how long code takes, for benchmarks: CPU time of the calling thread, which a busy machine
// stretches less than the time of the clock on the wall.
#pragma once
#include <ctime>

namespace wend::testing {

inline double thread_seconds() noexcept {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// The time of one call of `work`, whose result the compiler must take for used.
template <class Work>
double seconds_of(Work&& work) {
  const double begin = thread_seconds();
  const auto result = work();
  asm volatile("" : : "r"(&result) : "memory");
  return thread_seconds() - begin;
}

}  // namespace wend::testing
