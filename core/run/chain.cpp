#define XXH_INLINE_ALL
#include <core/run/rollout.hpp>

#include <xxhash.h>

#include <cstdio>
#include <ctime>
#include <utility>

namespace wend::core {

struct Chain::State {
  XXH3_state_t hash;
};

Chain::Chain() : state_(new State) { reset(); }
Chain::~Chain() { delete state_; }
Chain::Chain(Chain&& other) noexcept : state_(std::exchange(other.state_, nullptr)) {}
Chain& Chain::operator=(Chain&& other) noexcept {
  std::swap(state_, other.state_);
  return *this;
}
void Chain::reset() { XXH3_128bits_reset(&state_->hash); }
void Chain::add(const void* bytes, std::size_t n) { XXH3_128bits_update(&state_->hash, bytes, n); }
std::string Chain::digest() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(&state_->hash);
  char text[33];
  std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high64), static_cast<unsigned long long>(hash.low64));
  return text;
}

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace wend::core
