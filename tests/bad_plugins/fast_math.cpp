// Sets flush-to-zero and upward rounding while it is loaded, as -ffast-math at link does for the former.
#include <wend/abi.h>

#include <cfenv>

namespace {
struct AtLoad {
  AtLoad() {
    __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040u);
    std::fesetround(FE_UPWARD);
  }
} at_load;
}  // namespace

extern "C" WEND_EXPORT constexpr wend_plugin wend_plugin_1{sizeof(wend_plugin), WEND_ABI_MAJOR, WEND_ABI_MINOR, 0,
                                                           nullptr};
