// A plugin that needs a function which nobody has.
#include <wend/abi.h>

extern "C" int nobody_has_this();
int call_it() {
  return nobody_has_this();
}
extern "C" WEND_EXPORT constexpr wend_plugin wend_plugin_1{sizeof(wend_plugin), WEND_ABI_MAJOR, WEND_ABI_MINOR, 0,
                                                           nullptr};
