// The worker's side: takes requests off a descriptor, does them, answers.
#pragma once
#include <cstdint>

namespace wend::core {

struct WorkerLimits {
  std::uint64_t memory = std::uint64_t{8} << 30;  // bytes of address space; 0: no limit
  std::uint64_t file = std::uint64_t{2} << 30;    // bytes of any file it writes
};

// Exit code of a worker that cannot reach its host: a plugin closed its descriptor, or wrote to it or read from it.
constexpr int worker_lost_host = 105;

// Until the host closes the descriptor.  Returns the process's exit code.
int serve(int descriptor, std::uint64_t nonce, const WorkerLimits& limits);

}  // namespace wend::core
