#include <core/experiment/streams.hpp>
#include <core/run/failure.hpp>
#include <core/run/stage.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wend::core {

Stage::Stage(const WorldSpec& world, const DriverSpec& driver, const StreamSpec& stream, const StageOptions& options)
    : copies_(options.copies),
      robots_(world.robots),
      listener_(options.listener),
      libraries_(options.libraries),
      driver_(driver),
      stream_(stream) {
  Surroundings around;
  around.libraries = libraries_;
  around.listener = listener_;
  around.copies = copies_;
  around.robots = robots_;
  around.robot = driver.robot.name.empty() ? nullptr : &driver.robot.definition;
  around.key = [&](const std::string&) { return world_key(stream, world.id); };
  world_ = std::make_unique<Instance>(ComponentSpec{world.type, world.params, {}}, "world", around);
  world_table_ = &world_->need<wend_world>(WEND_WORLD);
  geometry_ = world_->get<wend_geometry2d>(WEND_GEOMETRY2D);
  period_ = world_table_->period(world_->self());
  if (!(period_ > 0) || !std::isfinite(period_))
    throw UnitFailed("rule", "world (" + world.type + "): expected a period above 0 s, found " + as_text(period_));

  const wend_space* action = world_table_->action(world_->self(), 0);
  check_space(action, "world (" + world.type + "): action space");
  action_ = *action;

  Surroundings lent = surroundings();
  lent.observation = nullptr;
  lent.action = nullptr;
  for (const SensorSpec& sensor : driver.robot.sensors) {
    sensors_.push_back(std::make_unique<Instance>(sensor.component, "sensor/" + sensor.id, lent));
    add_sensor(*sensors_.back(), sensor.id);
  }
  if (eyes_.empty()) {  // a world without sensors observes itself
    if (!world_->get<wend_sensor>(WEND_SENSOR))
      throw UnitFailed("rule", "world (" + world.type + "): it does not observe itself, so its robot needs sensors; found none");
    add_sensor(*world_, "world");
  }
  observation_ = {sizeof(wend_space), static_cast<std::uint32_t>(columns_.size()), columns_.data()};
  bounds_ = Bounds(observation_);

  if (driver.reward) {
    reward_ = std::make_unique<Instance>(*driver.reward, "reward", surroundings());
    reward_table_ = &reward_->need<wend_reward>(WEND_REWARD);
  }
}

Surroundings Stage::surroundings() const {
  Surroundings around;
  around.libraries = libraries_;
  around.listener = listener_;
  around.copies = copies_;
  around.robots = robots_;
  around.world = world_->ref();
  around.observation = &observation_;
  around.action = &action_;
  around.key = [stream = stream_, arm = driver_.arm](const std::string& path) { return component_key(stream, arm, path); };
  return around;
}

void Stage::check_space(const wend_space* space, const std::string& whose) const {
  if (space == nullptr || space->width == 0 || space->columns == nullptr)
    throw UnitFailed("rule", whose + ": expected at least one column, found none");
  if (space->width > 100000) throw UnitFailed("rule", whose + ": expected at most 100000 columns, found " + std::to_string(space->width));
  for (std::uint32_t i = 0; i < space->width; ++i)
    if (space->columns[i].name == nullptr || space->columns[i].unit == nullptr)
      throw UnitFailed("rule", whose + ": column " + std::to_string(i) + " has no name or no unit");
}

void Stage::add_sensor(const Instance& instance, const std::string& prefix) {
  const auto& table = instance.need<wend_sensor>(WEND_SENSOR);
  const wend_space* space = table.space(instance.self());
  check_space(space, instance.path() + " (" + instance.type() + "): space");
  eyes_.push_back({&instance, &table, static_cast<std::uint32_t>(columns_.size()), space->width});
  for (std::uint32_t i = 0; i < space->width; ++i) {
    wend_column column = space->columns[i];
    column.name = names_.emplace_back(prefix + "." + column.name).c_str();
    columns_.push_back(column);
  }
}

void Stage::reset(const std::vector<std::uint32_t>& copies, const std::vector<wend_episode>& episodes,
                  const std::vector<std::uint32_t>& rows, const std::vector<wend_episode>& row_episodes) {
  const auto n = static_cast<std::uint32_t>(rows.size());
  world_->check(world_table_->reset(world_->self(), copies.data(), static_cast<std::uint32_t>(copies.size()), episodes.data()), "reset");
  for (const Eye& eye : eyes_)
    if (eye.instance != world_.get() && eye.table->begin)
      eye.instance->check(eye.table->begin(eye.instance->self(), rows.data(), n, row_episodes.data()), "begin");
  if (reward_table_ && reward_table_->begin)
    reward_->check(reward_table_->begin(reward_->self(), rows.data(), n, row_episodes.data()), "begin");
}

void Stage::step(const std::vector<std::uint32_t>& copies, const double* actions, wend_outcome* outcomes) {
  world_->check(world_table_->step(world_->self(), copies.data(), static_cast<std::uint32_t>(copies.size()), actions, outcomes), "step");
  for (std::size_t i = 0; i < copies.size() * robots_; ++i)
    if (!std::isfinite(outcomes[i].reward))
      throw UnitFailed("rule", "world (" + world_->type() + "): step: expected a finite reward, found " + as_text(outcomes[i].reward));
}

void Stage::sense(const std::vector<std::uint32_t>& rows, double* out) {
  const std::size_t width = columns_.size();
  std::fill_n(out, rows.size() * width, std::numeric_limits<double>::quiet_NaN());  // what it forgets is not the last row's
  for (const Eye& eye : eyes_)
    eye.instance->check(eye.table->sense(eye.instance->self(), rows.data(), static_cast<std::uint32_t>(rows.size()), out + eye.offset, width),
                        "sense");
  if (const std::size_t bad = bounds_.first_outside(out, rows.size()); bad != rows.size() * width) refuse(out, bad);
}

void Stage::refuse(const double* values, std::size_t i) const {
  const std::size_t column = i % columns_.size();
  const Eye* whose = &eyes_.front();
  for (const Eye& eye : eyes_)
    if (column >= eye.offset) whose = &eye;
  throw UnitFailed("rule", whose->instance->path() + " (" + whose->instance->type() + "): sense: expected " +
                               bounds_.expected(column) + " for " + columns_[column].name + ", found " + as_text(values[i]));
}

void Stage::score(const wend_batch& batch, wend_outcome* outcomes) {
  if (reward_table_ == nullptr) return;
  reward_->check(reward_table_->score(reward_->self(), &batch, outcomes), "score");
  for (std::uint32_t i = 0; i < batch.n; ++i)
    if (!std::isfinite(outcomes[i].reward))
      throw UnitFailed("rule", "reward (" + reward_->type() + "): score: expected a finite reward, found " + as_text(outcomes[i].reward));
}

}  // namespace wend::core
