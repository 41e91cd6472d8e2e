#include <core/run/failure.hpp>
#include <core/run/library.hpp>

#include <boost/dll/shared_library.hpp>
#include <dlfcn.h>

#include <cfenv>

namespace wend::core {
namespace {

// dlopen of a plugin linked with -ffast-math sets flush-to-zero for the whole process; this puts the environment back.
class KeepFloatingPoint {
 public:
  KeepFloatingPoint() { std::fegetenv(&environment_); }
  ~KeepFloatingPoint() { std::fesetenv(&environment_); }

 private:
  std::fenv_t environment_;
};

}  // namespace

struct Libraries::Loaded {
  boost::dll::shared_library library;
  const wend_plugin* plugin = nullptr;
};

Libraries::Libraries() = default;

Libraries::~Libraries() = default;

const wend_component& Libraries::component(const std::string& id) {
  const auto file = files_.find(id);
  if (file == files_.end()) throw UnitFailed("load", "no plugin file is known for component \"" + id + "\"");
  const std::string& path = file->second;
  auto& slot = loaded_[path];
  if (!slot) {
    const KeepFloatingPoint keep;
    auto loaded = std::make_unique<Loaded>();
    boost::dll::fs::error_code error;
    std::string reason;
    try {
      loaded->library.load(path, boost::dll::load_mode::rtld_now | boost::dll::load_mode::rtld_local);
    } catch (const std::exception& failure) {  // the code alone would hide what dlerror() said
      reason = failure.what();
    }
    if (!loaded->library.is_loaded()) throw UnitFailed("load", "cannot load " + path + ": " + reason);
    // Never unloaded, not even at the end: a plugin may have threads or thread-local destructors in its code.
    if (void* same = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) ::dlclose(same);
    if (!loaded->library.has("wend_plugin_1"))
      throw UnitFailed("load", path + ": expected the exported symbol wend_plugin_1, found none");
    loaded->plugin = &loaded->library.get<const wend_plugin>("wend_plugin_1");
    if (loaded->plugin->abi_major != WEND_ABI_MAJOR)
      throw UnitFailed("load", path + ": expected ABI " + std::to_string(WEND_ABI_MAJOR) + ".x, found " +
                                   std::to_string(loaded->plugin->abi_major) + "." +
                                   std::to_string(loaded->plugin->abi_minor) + "; build it against this wend's headers");
    slot = std::move(loaded);
  }
  const wend_plugin& plugin = *slot->plugin;
  for (std::uint32_t i = 0; i < plugin.component_count; ++i)
    if (plugin.components[i] && plugin.components[i]->id && id == plugin.components[i]->id) return *plugin.components[i];
  throw UnitFailed("load", path + ": its manifest names component \"" + id + "\", its code does not");
}

}  // namespace wend::core
