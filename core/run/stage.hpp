// The stage of a unit: a world with its robots' sensors and the arm's reward, and the spaces that come of them.
#pragma once
#include <core/experiment/unit.hpp>
#include <core/run/bounds.hpp>
#include <core/run/instance.hpp>

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wend::core {

struct StageOptions {
  Libraries* libraries = nullptr;
  const Listener* listener = nullptr;
  std::uint32_t copies = 1;
};

class Stage {
 public:
  Stage(const WorldSpec& world, const DriverSpec& driver, const StreamSpec& stream, const StageOptions& options);

  std::uint32_t copies() const noexcept { return copies_; }
  std::uint32_t robots() const noexcept { return robots_; }
  std::uint32_t rows() const noexcept { return copies_ * robots_; }
  const wend_space& observation() const noexcept { return observation_; }
  const wend_space& action() const noexcept { return action_; }
  double period() const noexcept { return period_; }  // s between two decisions

  const Instance& world() const noexcept { return *world_; }
  const wend_geometry2d* geometry() const noexcept { return geometry_; }
  // What a policy of this stage is created with.
  Surroundings surroundings() const;

  // A new episode in each named copy; one episode per copy.
  void reset(const std::vector<std::uint32_t>& copies, const std::vector<wend_episode>& episodes,
             const std::vector<std::uint32_t>& rows, const std::vector<wend_episode>& row_episodes);

  // One decision period.  `actions` and `outcomes` hold robots() rows for each of the named copies.
  void step(const std::vector<std::uint32_t>& copies, const double* actions, wend_outcome* outcomes);

  // One observation row for each of `rows`; throws UnitFailed("rule") where a value is not finite or out of its column.
  void sense(const std::vector<std::uint32_t>& rows, double* out);

  void score(const wend_batch& batch, wend_outcome* outcomes);

 private:
  struct Eye {  // a sensor and where its columns begin
    const Instance* instance;
    const wend_sensor* table;
    std::uint32_t offset, width;
  };
  void add_sensor(const Instance& instance, const std::string& prefix);
  void check_space(const wend_space* space, const std::string& whose) const;
  void refuse(const double* values, std::size_t i) const;

  std::uint32_t copies_, robots_;
  Listener const* listener_;
  Libraries* libraries_;
  DriverSpec driver_;
  StreamSpec stream_;
  std::unique_ptr<Instance> world_;
  std::vector<std::unique_ptr<Instance>> sensors_;
  std::unique_ptr<Instance> reward_;
  const wend_world* world_table_ = nullptr;
  const wend_geometry2d* geometry_ = nullptr;
  const wend_reward* reward_table_ = nullptr;
  std::vector<Eye> eyes_;
  std::deque<std::string> names_;
  std::vector<wend_column> columns_;
  wend_space observation_{}, action_{};
  Bounds bounds_;  // of observations
  double period_ = 0;
};

}  // namespace wend::core
