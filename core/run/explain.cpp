#include <core/experiment/streams.hpp>
#include <core/run/explain.hpp>
#include <core/run/rollout.hpp>

namespace wend::core {
namespace {

std::string text_of(const Instance& instance, const wend_telemetry& table, std::uint32_t row) {
  std::string text;
  const wend_sink sink{sizeof(wend_sink), &text, [](void* to, const void* bytes, std::uint64_t n) -> wend_status {
                         static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), n);
                         return WEND_OK;
                       }};
  instance.check(table.text(instance.self(), row, &sink), "text");
  return text;
}

}  // namespace

void to_json(Json& json, const Question& q) {
  json = {{"cell", q.cell}, {"episode", q.episode}, {"decisions", q.decisions}, {"robot", q.robot}};
}
void from_json(const Json& json, Question& q) {
  json.at("cell").get_to(q.cell);
  json.at("episode").get_to(q.episode);
  json.at("decisions").get_to(q.decisions);
  json.at("robot").get_to(q.robot);
}

Json explain(const Question& question, const std::string& state, const std::string& state_name, const WorkOptions& options) {
  const Cell& cell = question.cell;
  Stage stage(cell.world, cell.driver, cell.stream, {options.libraries, options.listener, 1});
  Driver driver(cell.driver, stage);
  if (!state.empty()) driver.load(state, state_name);
  Rollout::Observer nobody;
  Rollout rollout(stage, driver, nobody);
  rollout.start({0}, {episode_of(cell.stream, cell.world, cell.variant, question.episode, WEND_TEST)});
  std::uint64_t driven = 0;
  for (; driven < question.decisions && !rollout.idle(); ++driven) rollout.step(false);
  Json components = Json::array();
  driver.root().visit([&](Instance& instance) {
    const auto* table = instance.get<wend_telemetry>(WEND_TELEMETRY);
    if (WEND_HAS(table, text))
      components.push_back({{"path", instance.path()}, {"type", instance.type()}, {"text", text_of(instance, *table, question.robot)}});
  });
  return {{"decisions", driven}, {"components", std::move(components)}};
}

}  // namespace wend::core
