#include <unistd.h>

#include <core/run/process_state.hpp>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include <climits>
#include <clocale>

namespace wend::core {
namespace {

unsigned vector_mode() {
#if defined(__SSE__)
  return _mm_getcsr() & ~0x3fu;  // without the flags that every inexact sum raises
#else
  return 0;
#endif
}

std::string directory() {
  char path[PATH_MAX];
  return ::getcwd(path, sizeof path) ? path : "";
}

std::string locale() {
  const char* name = std::setlocale(LC_ALL, nullptr);
  return name ? name : "C";
}

}  // namespace

ProcessState::ProcessState()
    : rounding_(std::fegetround()), mode_(vector_mode()), locale_(locale()), directory_(directory()) {
  std::fegetenv(&environment_);
}

std::string ProcessState::restore() const {
  std::string changed;
  const auto note = [&](const char* what) { changed += (changed.empty() ? "" : ", ") + std::string(what); };
  if (std::fegetround() != rounding_ || vector_mode() != mode_) {
    note("floating-point rounding");
    std::fesetenv(&environment_);
  }
  if (locale() != locale_) {
    note("locale");
    std::setlocale(LC_ALL, locale_.c_str());
  }
  if (directory() != directory_) {
    note("working directory");
    if (::chdir(directory_.c_str()) != 0) changed += " (which cannot be put back)";
  }
  return changed;
}

}  // namespace wend::core
