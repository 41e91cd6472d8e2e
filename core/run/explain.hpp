// What a policy has to say of itself, to a person: after some decisions of a test episode, or at its start.
#pragma once
#include <core/run/cell.hpp>

namespace wend::core {

struct Question {
  Cell cell;
  std::uint64_t episode = 0, decisions = 0;  // decisions: driven before it is asked; an episode may end earlier
  std::uint32_t robot = 0;
};
void to_json(Json&, const Question&);
void from_json(const Json&, Question&);

// {"decisions": as many as were driven, "components": [{"path", "type", "text"}, ...]} of those that have a text.
Json explain(const Question& question, const std::string& state, const std::string& state_name, const WorkOptions& options);

}  // namespace wend::core
