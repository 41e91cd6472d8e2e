// wend-worker: does units of work for the host.  It is started by wend, not by people.
#include <core/run/worker.hpp>

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: wend-worker DESCRIPTOR NONCE MEMORY (wend starts it)\n");
    return 2;
  }
  wend::core::WorkerLimits limits;
  limits.memory = std::strtoull(argv[3], nullptr, 10);
  return wend::core::serve(static_cast<int>(std::strtol(argv[1], nullptr, 10)), std::strtoull(argv[2], nullptr, 10), limits);
}
