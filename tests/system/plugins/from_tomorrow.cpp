// Asks for the next major ABI, which its manifest does not tell: the host finds out as it loads the file.
#include <wend/abi.h>

static const wend_component component = {sizeof component, "test.from_tomorrow", nullptr, nullptr, nullptr};
static const wend_component* const components[] = {&component};
const wend_plugin wend_plugin_1 = {sizeof wend_plugin_1, WEND_ABI_MAJOR + 1, 0, 1, components};
