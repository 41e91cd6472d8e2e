#include <core/run/frame.hpp>
#include <core/run/work.hpp>
#include <core/run/worker.hpp>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace wend::core {
namespace {

void limit(int resource, std::uint64_t value) {
  if (value == 0) return;
  const rlimit limits{value, value};
  setrlimit(static_cast<__rlimit_resource_t>(resource), &limits);
}

void confine(const WorkerLimits& limits) {
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // no worker outlives its host
#if !defined(__SANITIZE_ADDRESS__)  // whose shadow alone is 16 TB of address space
  limit(RLIMIT_AS, limits.memory);
#endif
  limit(RLIMIT_FSIZE, limits.file);
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
}

}  // namespace

int serve(int descriptor, std::uint64_t nonce, const WorkerLimits& limits) {
  confine(limits);
  const int own = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 400);  // out of the way of plugins that close or write small numbers
  if (own >= 0) ::close(descriptor);
  const int fd = own >= 0 ? own : descriptor;
  Libraries libraries;
  try {
    while (const auto payload = read_frame(fd, nonce)) {
      const Answer answer = perform(Json::parse(*payload).get<Request>(), libraries);
      write_frame(fd, Json(answer).dump(-1, ' ', false, Json::error_handler_t::replace), nonce);
    }
  } catch (const FrameError& error) {
    std::fprintf(stderr, "wend-worker: %s\n", error.message.c_str());
    return worker_lost_host;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "wend-worker: %s\n", error.what());
    return 5;
  }
  return 0;
}

}  // namespace wend::core
