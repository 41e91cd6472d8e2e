// Crashes, throws or hangs before its first function is called; a plugin of that kind never comes to its symbol.
#include <wend/abi.h>

#include <cstdlib>
#include <stdexcept>

namespace {
struct AtLoad {
  AtLoad() {
#if defined(AT_LOAD_THROW)
    throw std::runtime_error("thrown by a static constructor");
#else
    std::abort();
#endif
  }
} at_load;
}  // namespace

extern "C" WEND_EXPORT constexpr wend_plugin wend_plugin_1{sizeof(wend_plugin), WEND_ABI_MAJOR, WEND_ABI_MINOR, 0,
                                                           nullptr};
