// A plugin of an ABI that is yet to come.
#include <wend/abi.h>

extern "C" WEND_EXPORT constexpr wend_plugin wend_plugin_1{sizeof(wend_plugin), 2, 7, 0, nullptr};
