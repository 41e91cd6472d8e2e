#include <wend/abi.h>

#include <algorithm>
#include <core/experiment/composition.hpp>
#include <core/experiment/resolve.hpp>
#include <core/experiment/robots.hpp>
#include <limits>
#include <set>

namespace wend::core {

namespace {

class Resolver {
 public:
  Resolver(const Scope& scope, Json file) : scope_(scope), robots_(scope) { resolved_.file = std::move(file); }

  std::optional<Resolved> run() {
    Json& file = resolved_.file;
    scope_.check("", file, "", "the experiment");
    if (!file.is_object()) return std::nullopt;
    read_numbers(file);
    robots_.read(file);
    if (Json* worlds = array_in(file, "worlds"))
      for (std::size_t i = 0; i < worlds->size(); ++i) read_world((*worlds)[i], element("/worlds", i));
    scope_.check_unique("world", "/worlds", world_ids_);
    if (Json* arms = array_in(file, "arms"))
      for (std::size_t i = 0; i < arms->size(); ++i) read_arm((*arms)[i], element("/arms", i));
    scope_.check_unique("arm", "/arms", arm_ids_);
    check_state_arms(scope_, resolved_);
    check_figures(file);
    if (scope_.diagnostics.any()) return std::nullopt;
    robots_.show_defaults();
    return std::move(resolved_);
  }

 private:
  static Json* array_in(Json& file, const char* key) {
    const auto found = file.find(key);
    return found != file.end() && found->is_array() ? &*found : nullptr;
  }

  void read_numbers(const Json& file) {
    resolved_.seed = count_in(file, "seed").value_or(0);
    resolved_.seeds = count_in(file, "seeds").value_or(1);
    if (const Json* test = member(file, "test"))
      resolved_.episodes = static_cast<std::uint32_t>(count_in(*test, "episodes").value_or(10));
    if (const Json* record = member(file, "record")) {
      resolved_.traced_episodes = static_cast<std::uint32_t>(count_in(*record, "episodes").value_or(1));
      resolved_.traced_seeds = count_in(*record, "seeds").value_or(1);
      resolved_.traced_training = static_cast<std::uint32_t>(count_in(*record, "training").value_or(0));
    }
  }

  void check_figures(const Json& file) const {
    const Json* figures = member(file, "figures");
    const Json* worlds = figures ? member(*figures, "worlds") : nullptr;
    for (std::size_t i = 0; worlds && worlds->is_array() && i < worlds->size(); ++i) {
      const Json& id = (*worlds)[i];
      if (id.is_string() && std::find(world_ids_.begin(), world_ids_.end(), id.get<std::string>()) == world_ids_.end())
        scope_.unknown(element("/figures/worlds", i), "world", id, " in the figures", world_ids_);
    }
  }

  // ----------------------------------------------------------------------------------------------------- worlds

  void read_world(Json& file, const std::string& pointer) {
    WorldSpec world;
    world.id = text_in(file, "id");
    scope_.check("world", file, pointer, world.id.empty() ? "a world" : "world " + quote(world.id));
    world_ids_.push_back(world.id);
    world_entries_.push_back(nullptr);
    world_robots_.push_back(text_in(file, "robot"));
    if (file.is_object()) {
      if (member(file, "id") && file["id"].is_string()) scope_.check_id(pointer + "/id", "world", world.id);
      std::vector<Need> needs;
      Composed composed = compose_object(scope_, file, pointer, WEND_WORLD, needs);
      world_entries_.back() = composed.entry;
      world.type = composed.spec.type;
      world.params = std::move(composed.spec.params);
      world.content = std::move(composed.spec.content);
      world.files = composed.files;
      world.robots = static_cast<std::uint32_t>(count_in(file, "robots").value_or(1));
      world.one_scene = text_in(file, "draw") == "once";
      const std::uint64_t variants = count_in(file, "variants").value_or(1) * std::max<std::uint64_t>(1, world.files);
      world.variants =
          static_cast<std::uint32_t>(std::min<std::uint64_t>(variants, std::numeric_limits<std::uint32_t>::max()));
      if (!world_robots_.back().empty())
        robots_.check_name(world_robots_.back(), pointer + "/robot", "world " + quote(world.id));
    }
    resolved_.worlds.push_back(std::move(world));
  }

  // ------------------------------------------------------------------------------------------------------- arms

  void read_arm(Json& file, const std::string& pointer) {
    ArmSpec arm;
    arm.id = text_in(file, "id");
    arm_ids_.push_back(arm.id);
    const std::string who = "arm " + quote(arm.id);
    scope_.check("arm", file, pointer, arm.id.empty() ? "an arm" : who);
    if (!file.is_object()) return;
    if (member(file, "id") && file["id"].is_string()) scope_.check_id(pointer + "/id", "arm", arm.id);

    std::vector<Need> needs;
    if (file.contains("policy")) {
      Composed policy = compose(scope_, file["policy"], pointer + "/policy", WEND_POLICY, needs);
      arm.policy = std::move(policy.spec);
      arm.privileged =
          any_entry(scope_.catalog, arm.policy, [](const ComponentEntry& entry) { return entry.privileged; });
    }
    if (file.contains("reward"))
      arm.reward = compose(scope_, file["reward"], pointer + "/reward", WEND_REWARD, needs).spec;
    read_arm_worlds(file, pointer, arm);
    check_robot_names(file, pointer, who);
    if (file.contains("train") && file["train"].is_object())
      arm.train = resolve_train(scope_, resolved_, arm, file["train"], pointer + "/train");

    std::set<std::size_t> entered(arm.worlds.begin(), arm.worlds.end());
    if (arm.train)
      for (const auto* draws : {&arm.train->worlds, &arm.train->selection})
        for (const WorldDraw& draw : *draws) entered.insert(draw.world);
    for (const std::size_t world : entered) enter(file, pointer, arm, needs, world);
    if (arm.train) check_one_robot(pointer, arm);
    resolved_.arms.push_back(std::move(arm));
  }

  void read_arm_worlds(const Json& file, const std::string& pointer, ArmSpec& arm) const {
    const Json* names = member(file, "worlds");
    if (!names || !names->is_array()) {
      for (std::size_t i = 0; i < resolved_.worlds.size(); ++i) arm.worlds.push_back(i);
      return;
    }
    std::set<std::size_t> chosen;
    for (std::size_t i = 0; i < names->size(); ++i) {
      if (!(*names)[i].is_string()) continue;
      const std::string name = (*names)[i].get<std::string>();
      const auto found = std::find(world_ids_.begin(), world_ids_.end(), name);
      const std::string at = element(pointer + "/worlds", i);
      if (found == world_ids_.end()) {
        scope_.unknown(at, "world", name, " in arm " + quote(arm.id), world_ids_);
      } else if (!chosen.insert(static_cast<std::size_t>(found - world_ids_.begin())).second) {
        scope_.error(at, "world " + quote(name) + " is named twice", "remove one");
      }
    }
    arm.worlds.assign(chosen.begin(), chosen.end());
  }

  void check_robot_names(const Json& file, const std::string& pointer, const std::string& who) const {
    const Json* robot = member(file, "robot");
    if (!robot) return;
    if (robot->is_string()) {
      robots_.check_name(robot->get<std::string>(), pointer + "/robot", who);
    } else if (robot->is_object()) {
      for (const auto& [world, name] : robot->items()) {
        const std::string at = pointer + "/robot/" + pointer_token(world);
        if (world != "*" && std::find(world_ids_.begin(), world_ids_.end(), world) == world_ids_.end())
          scope_.unknown(at, "world", world, " in the robots of " + who, world_ids_, true);
        if (name.is_string())
          robots_.check_name(name.get<std::string>(), at, who);
        else
          scope_.error(at, "expected the name of a robot, found " + quote(name.dump()), "a text");
      }
    } else {
      scope_.error(pointer + "/robot", "expected the name of a robot, found " + quote(robot->dump()),
                   "a text, or {\"WORLD\": \"ROBOT\", \"*\": \"ROBOT\"}");
    }
  }

  // The robot that the arm drives in a world, "" for none.
  std::string robot_name(const Json& file, std::size_t world) const {
    const Json* robot = member(file, "robot");
    if (robot && robot->is_string()) return robot->get<std::string>();
    if (robot && robot->is_object())
      for (const std::string& key : {world_ids_[world], std::string("*")})
        if (robot->contains(key)) return text_in(*robot, key.c_str());
    return world_robots_[world];
  }

  void enter(const Json& file, const std::string& pointer, ArmSpec& arm, const std::vector<Need>& needs,
             std::size_t world) {
    const ComponentEntry* entry = world_entries_[world];
    if (entry == nullptr) return;
    const std::string name = robot_name(file, world);
    const std::string where = "world " + quote(world_ids_[world]);
    if (!name.empty() && robots_.has(name)) {
      arm.robots[world] = robots_.in_world(name, *entry);
      check_needs(robots_.needs(name), *entry, where);
    } else if (name.empty() && !entry->robot.is_null()) {
      scope_.error(pointer, "arm " + quote(arm.id) + " has no robot for " + where,
                   robots_.names().empty() ? "define one in \"robots\" and name it here"
                                           : "add \"robot\": " + quote(robots_.names().front()));
    } else {
      arm.robots[world] = RobotSpec{};
    }
    check_needs(needs, *entry, where);
  }

  void check_needs(const std::vector<Need>& needs, const ComponentEntry& world, const std::string& where) const {
    for (const Need& need : needs)
      for (const std::string& interface : need.interfaces)
        if (!world.answers(interface))
          scope_.error(need.pointer,
                       need.who + " needs a world that answers for " + quote(interface) + ", and " + where + " (" +
                           quote(world.id) + ") does not",
                       "use it in other worlds");
  }

  // One learner is created with one robot, whatever worlds it is trained in.
  void check_one_robot(const std::string& pointer, const ArmSpec& arm) const {
    const WorldDraw* first = nullptr;
    for (const auto* draws : {&arm.train->worlds, &arm.train->selection})
      for (const WorldDraw& draw : *draws) {
        if (!first) first = &draw;
        const auto a = arm.robots.find(first->world), b = arm.robots.find(draw.world);
        if (a == arm.robots.end() || b == arm.robots.end()) continue;
        if (a->second.name == b->second.name && a->second.definition == b->second.definition) continue;
        scope_.error(pointer + "/train",
                     "arm " + quote(arm.id) + " would be trained with different robots, " + quote(a->second.name) +
                         " in world " + quote(world_ids_[first->world]) + " and " + quote(b->second.name) +
                         " in world " + quote(world_ids_[draw.world]),
                     "train in worlds with one robot");
      }
  }

  const Scope& scope_;
  Resolved resolved_;
  Robots robots_;
  std::vector<std::string> world_ids_, arm_ids_, world_robots_;
  std::vector<const ComponentEntry*> world_entries_;  // by world; nullptr where its type is unknown
};

}  // namespace

std::optional<Resolved> resolve(const Scope& scope, Json file) {
  return Resolver(scope, std::move(file)).run();
}

}  // namespace wend::core
