// A request to do one piece of work, and its answer, as JSON: what travels between the host and its workers.
#pragma once
#include <core/base/json.hpp>
#include <core/experiment/unit.hpp>
#include <core/run/library.hpp>

#include <map>
#include <string>

namespace wend::core {

struct Request {
  enum class Kind { cell, training, check, scene, explain };
  Kind kind = Kind::cell;
  Json unit;                                   // a Cell, or a Training
  std::map<std::string, std::string> plugins;  // component id -> file
  std::string state, state_name;               // a state file to start from, and its name for messages
  std::string scratch;                         // folder for traces and states
  std::uint32_t batch = 16;
};
void to_json(Json&, const Request&);
void from_json(const Json&, Request&);

struct Answer {
  bool ok = false;
  Json result = Json::object();  // a CellResult, a TrainingResult, {"scene": text}, what explain() says
  Failure failure;
  std::vector<std::string> warnings;
};
void to_json(Json&, const Answer&);
void from_json(const Json&, Answer&);

// Does the work in this process.  Whatever goes wrong is in the answer.
Answer perform(const Request& request, Libraries& libraries);

}  // namespace wend::core
