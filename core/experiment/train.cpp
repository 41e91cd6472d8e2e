// The "train" of an arm: its budget, its worlds, its snapshots, and the rule that nothing is chosen on what is tested.
#include <wend/abi.h>

#include <algorithm>
#include <core/experiment/composition.hpp>
#include <core/experiment/resolve.hpp>

namespace wend::core {

namespace {

constexpr const char* budget_units[] = {"samples", "steps", "episodes"};

class TrainReader {
 public:
  TrainReader(const Scope& scope, Resolved& experiment, const ArmSpec& arm, Json& file, const std::string& pointer)
      : scope_(scope), experiment_(experiment), arm_(arm), file_(file), pointer_(pointer) {}

  TrainSpec read() {
    scope_.check("train", file_, pointer_, "the training of arm " + quote(arm_.id));
    read_state();
    read_budget();
    train_.worlds = draws(file_, "worlds", pointer_ + "/worlds");
    train_.greedy_every = static_cast<std::uint32_t>(count_in(file_, "greedy_every").value_or(0));
    train_.until = text_in(file_, "until");
    if (text_in(file_, "keep") == "best") train_.keep = "best";
    if (const Json* evaluate = member(file_, "evaluate")) read_evaluate(*evaluate);
    if (train_.budget.amount == 0) {
      if (member(file_, "state")) check_untrained();
    } else {
      check_learner();
      if (train_.keep == "best") check_selection();
    }
    return std::move(train_);
  }

 private:
  void read_state() {
    if (const Json* state = member(file_, "state"); state && state->is_object()) {
      train_.state_arm = text_in(*state, "arm");
      return;
    }
    const std::string name = text_in(file_, "state");
    if (name.empty()) {
      if (member(file_, "state") && file_["state"].is_string())
        scope_.error(pointer_ + "/state", "\"state\" names no file", "the path of a state file");
      return;
    }
    const std::vector<std::string> found = scope_.assets.find(name, false, pointer_ + "/state");
    if (!found.empty()) {
      train_.state = scope_.assets.hash_of(found[0], pointer_ + "/state");
      experiment_.state_files[train_.state] = found[0];
      file_["state"] = found[0];
    }
    scope_.report_assets();
  }

  void read_budget() {
    std::vector<std::string> given;
    for (const char* unit : budget_units) {
      if (!member(file_, unit)) continue;
      given.push_back(unit);
    }
    if (given.size() == 1) train_.budget = {given[0], count_in(file_, given[0].c_str()).value_or(1)};
    if (given.size() > 1)
      scope_.error(pointer_,
                   "the training of arm " + quote(arm_.id) + " has several budgets, " + quote_list(given, "and"),
                   "keep one of them");
    if (given.empty() && !member(file_, "state"))
      scope_.error(pointer_, "the training of arm " + quote(arm_.id) + " has no budget",
                   "add \"samples\", \"steps\" or \"episodes\", or the \"state\" of an earlier training");
  }

  // The worlds that the array `key` of `object` names.
  std::vector<WorldDraw> draws(const Json& object, const char* key, const std::string& pointer) const {
    std::vector<WorldDraw> result;
    const Json* names = member(object, key);
    if (!names || !names->is_array()) return result;
    std::vector<std::string> known;
    for (const WorldSpec& world : experiment_.worlds) {
      known.push_back(world.id);
      known.push_back(world.id + ":train");
    }
    for (std::size_t i = 0; i < names->size(); ++i) {
      if (!(*names)[i].is_string()) continue;
      const std::string name = (*names)[i].get<std::string>();
      const auto found = std::find(known.begin(), known.end(), name);
      const std::string at = pointer + "/" + std::to_string(i);
      if (found == known.end()) {
        scope_.unknown(at, "world", name, " in the training of arm " + quote(arm_.id), known);
        continue;
      }
      const auto index = static_cast<std::size_t>(found - known.begin());
      const WorldDraw draw{index / 2, index % 2 == 1};
      if (std::find(result.begin(), result.end(), draw) != result.end())
        scope_.error(at, "world " + quote(name) + " is named twice", "remove one");
      result.push_back(draw);
    }
    return result;
  }

  void read_evaluate(const Json& evaluate) {
    const std::string at = pointer_ + "/evaluate";
    const Json* counts = member(evaluate, "at");
    for (std::size_t i = 0; counts && counts->is_array() && i < counts->size(); ++i) {
      const Json& count = (*counts)[i];
      if (!count.is_number_unsigned() && !(count.is_number_integer() && count.get<std::int64_t>() >= 0)) continue;
      train_.at.push_back(count.get<std::uint64_t>());
      if (train_.budget.amount > 0 && train_.at.back() > train_.budget.amount)
        scope_.error(at + "/at/" + std::to_string(i),
                     "no snapshot can be taken at " + std::to_string(train_.at.back()) + " " + train_.budget.unit +
                         ", the budget is " + std::to_string(train_.budget.amount),
                     "at most the budget");
    }
    std::sort(train_.at.begin(), train_.at.end());
    train_.at.erase(std::unique(train_.at.begin(), train_.at.end()), train_.at.end());
    if (const auto episodes = count_in(evaluate, "episodes"))
      train_.snapshot_episodes = static_cast<std::uint32_t>(*episodes);
    train_.selection = draws(evaluate, "worlds", at + "/worlds");
    if (member(evaluate, "worlds") && train_.keep != "best")
      scope_.error(at + "/worlds", "\"worlds\" has no effect: they are where the best snapshot is chosen",
                   "remove them, or add \"keep\": \"best\" to \"train\"", true);
  }

  void check_untrained() const {
    for (const char* key : {"worlds", "evaluate"})
      if (member(file_, key)) no_effect(key);
    if (train_.greedy_every > 0) no_effect("greedy_every");
    if (!train_.until.empty()) no_effect("until");
    if (train_.keep == "best") no_effect("keep");
    const auto has_state = [](const ComponentEntry& entry) {
      return entry.answers(WEND_STATE) || entry.answers(WEND_LEARNER);
    };
    if (!train_.state.empty() && !any_entry(scope_.catalog, arm_.policy, has_state))
      scope_.error(pointer_ + "/state", "no component of arm " + quote(arm_.id) + " can load a state",
                   "remove \"train\", or use a policy that learns", true);
  }
  void no_effect(const char* key) const {
    scope_.error(pointer_ + "/" + key, quote(key) + " has no effect without a budget",
                 "add \"samples\", \"steps\" or \"episodes\"", true);
  }

  void check_learner() const {
    if (arm_.policy.type.empty() || answers(scope_.catalog, arm_.policy, WEND_LEARNER)) return;
    const ComponentEntry* entry = scope_.catalog.find(arm_.policy.type);
    if (entry == nullptr) return;
    const bool forwards = !entry->forwards.empty();
    scope_.error(
        pointer_, "arm " + quote(arm_.id) + " cannot be trained: " + title(*entry) + " is no learner",
        forwards ? "put a learner into its slot " + quote(entry->forwards) : "remove \"train\", or use a learner",
        true);
  }

  // Whoever chooses the best snapshot by what is tested reports a maximum over noise.
  void check_selection() const {
    if (train_.at.empty())
      scope_.error(pointer_ + "/keep", "there are no snapshots to choose the best of",
                   "add \"evaluate\": {\"at\": [...]}");
    const bool named = !train_.selection.empty();
    const std::vector<WorldDraw>& places = named ? train_.selection : train_.worlds;
    for (const WorldDraw& draw : places) {
      const bool tested = std::find(arm_.worlds.begin(), arm_.worlds.end(), draw.world) != arm_.worlds.end();
      if (draw.train || !tested) continue;
      const std::string& id = experiment_.worlds[draw.world].id;
      scope_.error(named ? pointer_ + "/evaluate/worlds" : pointer_ + "/keep",
                   "the best snapshot would be chosen in world " + quote(id) + ", which is tested",
                   "name " + quote(id + ":train") + " or another world in \"evaluate\": {\"worlds\": [...]}");
    }
  }

  const Scope& scope_;
  Resolved& experiment_;
  const ArmSpec& arm_;
  Json& file_;
  const std::string& pointer_;
  TrainSpec train_;
};

// The types of a composition, as they stand in its state: "wend.a(avoid: wend.b)".
std::string types_of(const ComponentSpec& spec) {
  std::string text;
  for (const auto& [slot, component] : spec.slots)
    text += (text.empty() ? "(" : ", ") + slot + ": " + types_of(component);
  return spec.type + (text.empty() ? "" : text + ")");
}

const ArmSpec* arm_of(const Resolved& experiment, const std::string& id) {
  for (const ArmSpec& arm : experiment.arms)
    if (arm.id == id) return &arm;
  return nullptr;
}

using Defect = std::optional<std::pair<std::string, std::string>>;  // what is wrong, and what to do

// What is wrong with the worlds in which `arm` is tested if it starts, perhaps by way of others, from what `source` learns.
Defect defect_in_worlds(const Resolved& experiment, const ArmSpec& arm, const ArmSpec& source) {
  const TrainSpec& train = *source.train;
  const std::string which = "arm " + quote(arm.id) + " starts from arm " + quote(source.id);
  const auto has = [](const std::vector<std::size_t>& worlds, std::size_t world) {
    return std::find(worlds.begin(), worlds.end(), world) != worlds.end();
  };
  for (const std::size_t world : arm.worlds)
    if (train.worlds.empty() && !has(source.worlds, world))
      return std::pair(which + ", which is not trained for world " + quote(experiment.worlds[world].id),
                       "add \"worlds\" to the \"train\" of arm " + quote(source.id) + ", or to arm " + quote(arm.id));
  if (train.keep != "best") return std::nullopt;
  for (const WorldDraw& draw : train.selection.empty() ? train.worlds : train.selection) {
    if (draw.train || !has(arm.worlds, draw.world)) continue;
    const std::string& id = experiment.worlds[draw.world].id;
    return std::pair(which + ", whose best snapshot is chosen in world " + quote(id) + ", which is tested",
                     "name " + quote(id + ":train") + " or another world in \"evaluate\": {\"worlds\": [...]} of arm " +
                         quote(source.id));
  }
  return std::nullopt;
}

// What is wrong with starting `arm` from the training of `source`.
Defect defect(const Resolved& experiment, const ArmSpec& arm, const ArmSpec& source) {
  const std::string which = "arm " + quote(arm.id) + " starts from arm " + quote(source.id);
  if (!source.train || source.train->budget.amount == 0)
    return std::pair(which + ", which is not trained", std::string("name an arm whose \"train\" has a budget"));
  std::size_t steps = 0;
  for (const ArmSpec* at = &source; at && at->train && !at->train->state_arm.empty(); at = arm_of(experiment, at->train->state_arm))
    if (at == &arm || ++steps > experiment.arms.size())
      return std::pair(which + ", which starts from it", std::string("one of them must start from nothing"));
  if (types_of(arm.policy) != types_of(source.policy))
    return std::pair(which + ", but its policy is " + types_of(arm.policy) + " and that one's is " + types_of(source.policy),
                     std::string("use the same types in the same slots"));
  for (const ArmSpec* at = &source; at && at->train; at = arm_of(experiment, at->train->state_arm))
    if (const auto found = defect_in_worlds(experiment, arm, *at)) return found;
  return std::nullopt;
}

}  // namespace

std::optional<TrainSpec> resolve_train(const Scope& scope, Resolved& experiment, const ArmSpec& arm, Json& file,
                                       const std::string& pointer) {
  TrainReader reader(scope, experiment, arm, file, pointer);
  return reader.read();
}

void check_state_arms(const Scope& scope, const Resolved& experiment) {
  std::vector<std::string> ids;
  for (const ArmSpec& arm : experiment.arms) ids.push_back(arm.id);
  for (std::size_t i = 0; i < experiment.arms.size(); ++i) {
    const ArmSpec& arm = experiment.arms[i];
    if (!arm.train || arm.train->state_arm.empty()) continue;
    const std::string pointer = element("/arms", i) + "/train/state/arm";
    const ArmSpec* source = arm_of(experiment, arm.train->state_arm);
    if (source == nullptr) {
      scope.unknown(pointer, "arm", arm.train->state_arm, " in the training of arm " + quote(arm.id), ids);
    } else if (const auto found = defect(experiment, arm, *source)) {
      scope.error(pointer, found->first, found->second);
    }
  }
}

}  // namespace wend::core
