#include <core/run/failure.hpp>
#include <core/run/scene.hpp>

namespace wend::core {

Json show_scene(const Json& request, const WorkOptions& options) {
  const Json robot = request.value("robot", Json::object());
  Surroundings around;
  around.libraries = options.libraries;
  around.listener = options.listener;
  around.robot = &robot;
  const auto key = request.at("key").get<std::uint64_t>();
  around.key = [key](const std::string&) { return key; };
  const Instance world(ComponentSpec{request.at("type").get<std::string>(), request.at("params"), {}}, "world", around);

  const std::uint32_t copy = 0;
  const wend_episode episode{0, key, key, request.value("variant", std::uint32_t{0}), WEND_TEST};
  world.check(world.need<wend_world>(WEND_WORLD).reset(world.self(), &copy, 1, &episode), "reset");

  const auto* scene = world.get<wend_scene>(WEND_SCENE);
  if (scene == nullptr)
    throw UnitFailed("rule", "world (" + world.type() + "): expected the extension " WEND_SCENE ", found none: its scenes cannot be written");
  std::string text;
  const wend_sink sink{sizeof(wend_sink), &text, [](void* to, const void* bytes, std::uint64_t n) -> wend_status {
                         static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), n);
                         return WEND_OK;
                       }};
  world.check(scene->write(world.self(), copy, &sink), "write");
  return {{"scene", text}};
}

}  // namespace wend::core
