#include <algorithm>
#include <core/base/sha256.hpp>
#include <core/experiment/plan.hpp>
#include <utility>

namespace wend::core {

namespace {

// Where the arm is trained if it is tested in `tested`.
std::vector<WorldDraw> training_draws(const TrainSpec& train, std::size_t tested) {
  return train.worlds.empty() ? std::vector<WorldDraw>{{tested, true}} : train.worlds;
}

// The states that are tested: snapshots, then the final one unless a snapshot is just that.
std::vector<std::optional<Budget>> tested_states(const ArmSpec& arm) {
  std::vector<std::optional<Budget>> states;
  if (!arm.train) return {std::nullopt};
  const TrainSpec& train = *arm.train;
  for (const std::uint64_t count : train.at) states.push_back(Budget{train.budget.unit, count});
  const bool final_is_there = train.keep == "last" && !train.at.empty() && train.at.back() == train.budget.amount;
  if (!final_is_there) states.push_back(std::nullopt);
  return states;
}

// Robots and worlds of the sets were checked to fit each other, so a missing one is an arm's world without robot.
DriverSpec driver_of(const ArmSpec& arm, std::size_t world) {
  const auto robot = arm.robots.find(world);
  return {arm.id, robot == arm.robots.end() ? RobotSpec{} : robot->second, arm.policy, arm.reward};
}

// The arm whose training this one starts from; resolve() has found it there.
const ArmSpec& source_of(const Resolved& experiment, const ArmSpec& arm) {
  return *std::find_if(experiment.arms.begin(), experiment.arms.end(),
                       [&](const ArmSpec& other) { return other.id == arm.train->state_arm; });
}

template <class Spec>
std::size_t keep_once(const Spec& spec, const std::string& digest, std::vector<Spec>& all,
                      std::vector<std::string>& digests, std::map<std::string, std::size_t>& index) {
  const auto [entry, fresh] = index.try_emplace(digest, all.size());
  if (fresh) {
    all.push_back(spec);
    digests.push_back(digest);
  }
  return entry->second;
}

}  // namespace

std::size_t Plan::keep(const DriverSpec& driver) {
  return keep_once(driver, digest(driver), drivers_, driver_digests_, driver_index_);
}
std::size_t Plan::keep(const WorldSpec& world) {
  return keep_once(world, digest(world), worlds_, world_digests_, world_index_);
}

bool Plan::add(const Json& point, const Resolved& experiment, const PlanFilter& filter) {
  double count = static_cast<double>(cells_.size());
  for (const ArmSpec& arm : experiment.arms)
    for (const std::size_t world : arm.worlds)
      if (filter.wants(filter.arms, arm.id) && filter.wants(filter.worlds, experiment.worlds[world].id))
        count += static_cast<double>(filter.end_seed - filter.first_seed) * experiment.worlds[world].variants *
                 static_cast<double>(tested_states(arm).size());
  if (count > static_cast<double>(max_cells)) return false;

  for (const ArmSpec& arm : experiment.arms) {
    if (!filter.wants(filter.arms, arm.id)) continue;
    for (const std::size_t world : arm.worlds) {
      if (!filter.wants(filter.worlds, experiment.worlds[world].id)) continue;
      CellGroup group;
      group.driver = keep(driver_of(arm, world));
      group.world = keep(experiment.worlds[world]);
      group.at = tested_states(arm);
      group.common.point = point;
      group.common.stream = {experiment.seed, 0, false};
      group.common.episodes = experiment.episodes;
      group.common.traced_episodes = std::min(experiment.traced_episodes, experiment.episodes);
      group.common.privileged = arm.privileged;
      group.snapshot_episodes = experiment.episodes;
      std::size_t training = none;
      if (arm.train && arm.train->budget.amount > 0) {
        group.snapshot_episodes = arm.train->snapshot_episodes.value_or(experiment.episodes);
        training = add_training(point, experiment, arm, world, filter);
      } else if (arm.train && !arm.train->state_arm.empty()) {
        training = add_training(point, experiment, source_of(experiment, arm), world, filter);
      } else if (arm.train) {
        group.common.state = arm.train->state;
      }
      add_cells(std::move(group), experiment.traced_seeds, training, filter);
    }
  }
  return true;
}

std::size_t Plan::add_training(const Json& point, const Resolved& experiment, const ArmSpec& arm, std::size_t tested,
                               const PlanFilter& filter) {
  const TrainSpec& train = *arm.train;
  const std::vector<WorldDraw> draws = training_draws(train, tested);
  TrainingGroup group;
  if (!train.state_arm.empty())
    group.source = add_training(point, experiment, source_of(experiment, arm), tested, filter);
  group.driver = keep(driver_of(arm, draws.front().world));
  Training& common = group.common;
  common.point = point;
  common.budget = train.budget;
  common.greedy_every = train.greedy_every;
  common.snapshots = train.at;
  common.until = train.until;
  common.keep = train.keep;
  common.initial_state = train.state;
  common.traced_episodes = experiment.traced_training;
  group.traced_seeds = experiment.traced_seeds;
  for (const WorldDraw& draw : draws) {
    group.worlds.push_back(keep(experiment.worlds[draw.world]));
    common.streams.push_back({experiment.seed, 0, draw.train});
  }
  if (train.keep == "best") {
    if (common.snapshots.back() < train.budget.amount) common.snapshots.push_back(train.budget.amount);
    common.selection_episodes = train.snapshot_episodes.value_or(experiment.episodes);
    for (const WorldDraw& draw : train.selection.empty() ? draws : train.selection) {
      group.selection_worlds.push_back(keep(experiment.worlds[draw.world]));
      common.selection_streams.push_back({experiment.seed, 0, draw.train});
    }
  }
  Json digests{{"unit", "training"},
               {"driver", driver_digests_[group.driver]},
               {"worlds", Json::array()},
               {"selection_worlds", Json::array()}};
  for (const std::size_t world : group.worlds) digests["worlds"].push_back(world_digests_[world]);
  for (const std::size_t world : group.selection_worlds) digests["selection_worlds"].push_back(world_digests_[world]);

  const std::string first_id = identify(light_training(group, filter.first_seed, 0), digests);
  const auto [shared, fresh] = training_index_.try_emplace(first_id, training_groups_.size());
  if (!fresh) return shared->second;
  group.first = trainings_.size();
  for (std::uint64_t seed = filter.first_seed; seed < filter.end_seed; ++seed) {
    const Training one = light_training(group, seed, static_cast<std::size_t>(seed - filter.first_seed));
    trainings_.push_back({identify(one, digests), training_groups_.size(), seed, 0, 0, none});
  }
  training_groups_.push_back(std::move(group));
  return shared->second;
}

void Plan::add_cells(CellGroup group, std::uint64_t traced_seeds, std::size_t training_group,
                     const PlanFilter& filter) {
  const std::size_t index = cell_groups_.size();
  const std::uint32_t variants = worlds_[group.world].variants;
  const auto states = static_cast<std::uint32_t>(group.at.size());
  const Json digests{
      {"unit", "cell"}, {"driver", driver_digests_[group.driver]}, {"world", world_digests_[group.world]}};
  traced_seeds_.push_back(traced_seeds);
  cell_groups_.push_back(std::move(group));
  for (std::uint64_t seed = filter.first_seed; seed < filter.end_seed; ++seed) {
    const std::size_t training = training_group == none ? none
                                                        : training_groups_[training_group].first +
                                                              static_cast<std::size_t>(seed - filter.first_seed);
    for (std::uint32_t variant = 0; variant < variants; ++variant)
      for (std::uint32_t at = 0; at < states; ++at) {
        Entry entry{"", index, seed, variant, at, training};
        entry.id = identify(light_cell(cell_groups_[index], entry), digests);
        cells_.push_back(std::move(entry));
      }
  }
}

Cell Plan::light_cell(const CellGroup& group, const Entry& entry) const {
  Cell cell = group.common;
  cell.id = entry.id;
  cell.stream.seed = entry.seed;
  cell.variant = entry.variant;
  cell.at = group.at[entry.at];
  const bool final_state = entry.at + 1 == group.at.size();
  if (!final_state) cell.episodes = group.snapshot_episodes;
  cell.traced_episodes = entry.seed < traced_seeds_[entry.group] ? std::min(cell.traced_episodes, cell.episodes) : 0;
  if (entry.training != none) cell.training = trainings_[entry.training].id;
  return cell;
}

Cell Plan::cell(std::size_t i) const {
  const Entry& entry = cells_[i];
  const CellGroup& group = cell_groups_[entry.group];
  Cell cell = light_cell(group, entry);
  cell.driver = drivers_[group.driver];
  cell.world = worlds_[group.world];
  return cell;
}

Training Plan::training(std::size_t i) const {
  const Entry& entry = trainings_[i];
  const TrainingGroup& group = training_groups_[entry.group];
  Training training = light_training(group, entry.seed, i - group.first);
  training.id = entry.id;
  training.driver = drivers_[group.driver];
  for (const std::size_t world : group.worlds) training.worlds.push_back(worlds_[world]);
  for (const std::size_t world : group.selection_worlds) training.selection_worlds.push_back(worlds_[world]);
  return training;
}

// The training of one seed, at its place in the group, without driver and worlds.
Training Plan::light_training(const TrainingGroup& group, std::uint64_t seed, std::size_t place) const {
  Training training = group.common;
  for (auto* streams : {&training.streams, &training.selection_streams})
    for (StreamSpec& stream : *streams) stream.seed = seed;
  if (group.source != none)
    training.initial_training = trainings_[training_groups_[group.source].first + place].id;
  if (seed >= group.traced_seeds) training.traced_episodes = 0;
  return training;
}

std::vector<Cell> Plan::compositions() const {
  std::set<std::pair<std::size_t, std::size_t>> seen;
  std::vector<Cell> result;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const CellGroup& group = cell_groups_[cells_[i].group];
    if (seen.emplace(group.driver, group.world).second) result.push_back(cell(i));
  }
  return result;
}

}  // namespace wend::core
