#include <core/base/error.hpp>
#include <core/base/files.hpp>
#include <core/run/cell.hpp>
#include <core/run/explain.hpp>
#include <core/run/failure.hpp>
#include <core/run/process_state.hpp>
#include <core/run/scene.hpp>
#include <core/run/training.hpp>
#include <core/run/work.hpp>

namespace wend::core {

NLOHMANN_JSON_SERIALIZE_ENUM(Request::Kind, {{Request::Kind::cell, "cell"},
                                             {Request::Kind::training, "training"},
                                             {Request::Kind::check, "check"},
                                             {Request::Kind::scene, "scene"},
                                             {Request::Kind::explain, "explain"}})

void to_json(Json& json, const Request& r) {
  json = {{"kind", r.kind}, {"unit", r.unit}, {"plugins", r.plugins}, {"state", r.state}, {"state_name", r.state_name}, {"scratch", r.scratch}, {"batch", r.batch}};
}
void from_json(const Json& json, Request& r) {
  json.at("kind").get_to(r.kind);
  json.at("unit").get_to(r.unit);
  json.at("plugins").get_to(r.plugins);
  json.at("state").get_to(r.state);
  json.at("state_name").get_to(r.state_name);
  json.at("scratch").get_to(r.scratch);
  json.at("batch").get_to(r.batch);
}

void to_json(Json& json, const Answer& a) {
  json = {{"ok", a.ok}, {"result", a.result}, {"cause", a.failure.cause}, {"message", a.failure.message}, {"warnings", a.warnings}};
}
void from_json(const Json& json, Answer& a) {
  json.at("ok").get_to(a.ok);
  json.at("result").get_to(a.result);
  json.at("cause").get_to(a.failure.cause);
  json.at("message").get_to(a.failure.message);
  json.at("warnings").get_to(a.warnings);
}

namespace {

std::string read_state(const Request& request) {
  std::string state = read_file(request.state);
  if (state.empty()) throw UnitFailed("state", request.state_name + ": expected a state, found an empty file");
  return state;
}

}  // namespace

Answer perform(const Request& request, Libraries& libraries) {
  Answer answer;
  Listener listener;
  listener.log = [&](std::uint32_t level, const std::string& message) {
    if (level >= 2 && answer.warnings.size() < 20) answer.warnings.push_back(message.substr(0, 1000));
  };
  const ProcessState before;
  try {
    libraries.know(request.plugins);
    const WorkOptions options{&libraries, &listener, request.batch, request.scratch};
    const std::string state = request.state.empty() ? std::string() : read_state(request);
    switch (request.kind) {
      case Request::Kind::cell:
        answer.result = run_cell(request.unit.get<Cell>(), state, request.state_name, options);
        break;
      case Request::Kind::training:
        answer.result = run_training(request.unit.get<Training>(), state, request.state_name, options);
        break;
      case Request::Kind::check:
        check_cell(request.unit.get<Cell>(), options);
        break;
      case Request::Kind::scene:
        answer.result = show_scene(request.unit, options);
        break;
      case Request::Kind::explain:
        answer.result = explain(request.unit.get<Question>(), state, request.state_name, options);
        break;
    }
    answer.ok = true;
  } catch (const UnitFailed& failed) {
    answer.failure = {failed.cause(), failed.what()};
  } catch (const std::bad_alloc&) {
    answer.failure = {"memory", "out of memory"};
  } catch (const Error& failed) {
    answer.failure = {"host", failed.what()};
  } catch (const Json::exception& failed) {
    answer.failure = {"host", failed.what()};
  } catch (const std::exception& failed) {
    answer.failure = {"rule", std::string("a plugin let an exception out, expected a status: ") + failed.what()};
  } catch (...) {
    answer.failure = {"rule", "a plugin let an exception out, expected a status: it is no std::exception"};
  }
  if (const std::string changed = before.restore(); answer.ok && !changed.empty()) {
    answer.ok = false;
    answer.result = Json::object();
    answer.failure = {"rule", "a plugin changed the process's " + changed + " and did not put it back"};
  }
  return answer;
}

}  // namespace wend::core
