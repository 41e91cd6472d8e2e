// The arena: disc robots among discs, segments, polygons, occupied cells, walls and movers.
//
// One period is `substeps` times dt; in each dt everything moves, then collisions, arrivals and the time limit are
// tested.  A copy's course depends on its episode and its actions alone, never on which other copies are stepped.
#pragma once
#include <array>
#include <string>
#include <wend/plugin.hpp>

#include "scenes/source.hpp"
#include "state.hpp"

namespace arena {

struct Options {
  double dt = 1;                         // s
  std::uint32_t substeps = 1;            // dt in a period
  std::uint64_t limit = 0;               // dt in an episode
  double radius = 0, stop_distance = 0;  // m, of the robots
  double draw_clearance = 0;             // m, between a drawn start or goal and any surface, beyond the body
  double draw_distance = 0;              // m, least distance from a start to a goal where one of them is drawn
  double goal_radius = 1;                // m, where the scene has none
  bool optimal = true;
  double optimal_cell = 0;                    // m, 0: as the scene and the body suggest
  double optimal_speed = 0;                   // m/s, 0: no score
  double arrive = 1, collide = -1, step = 0;  // rewards

  explicit Options(const wend::Config&);
  double period() const noexcept { return dt * substeps; }
};

class World {
 public:
  explicit World(const wend::Config&);

  // ---- wend.world/1
  double period() const noexcept { return options_.period(); }
  const wend::Columns& action(std::uint32_t) const noexcept { return kinematics_.columns(); }
  void reset(wend::Rows copies, wend::Episodes);
  void step(wend::Rows copies, wend::Matrix<const double> actions, std::span<wend_outcome>);

  // ---- wend.geometry2d/1
  void poses(wend::Rows, std::span<wend_pose>) const;
  void bodies(wend::Rows, std::span<wend_disc> body, std::span<wend_disc> goal) const;
  void cast(wend::Rows, std::span<const wend_pose> rays, double reach, std::uint32_t kinds, double* distance,
            std::uint8_t* kind);
  void clearance(wend::Rows, std::span<const double> xy, std::uint32_t kinds, std::span<double> out) const;
  std::span<const wend_shape> shapes(std::uint32_t copy);

  // ---- wend.body/1, wend.scene/1, wend.telemetry/1
  wend_limits limits(std::uint32_t robot) const;
  void predict(std::uint32_t robot, std::span<const wend_motion> from, wend::Matrix<const double> actions,
               double seconds, std::span<wend_motion> to) const;
  void write_scene(std::uint32_t copy, wend::Writer&) const;
  const wend::Columns* telemetry(std::uint32_t when) const noexcept;
  void read(std::uint32_t when, wend::Rows, wend::Matrix<double> out) const;

 private:
  // reset.cpp
  std::shared_ptr<Place> place_for(const wend_episode&);
  void reset_copy(std::uint32_t copy, const wend_episode&);
  void put_fixed(Copy&, Robot*, const wend_episode&);
  void draw_phases(Copy&, const Robot*, const wend_episode&);
  void draw_robot(Copy&, Robot*, std::uint32_t robot, const wend_episode&);
  bool room(const Copy&, const Robot*, std::uint32_t robot, double x, double y, bool goal) const;
  std::shared_ptr<const DistanceField> field_to(Place&, const Robot&, std::uint32_t robot, bool own);
  void begin(Copy&, Robot&);

  // step.cpp
  void step_some(wend::Rows copies, const double* actions, wend_outcome*);
  void decide(Robot&, std::span<const double> action) const;
  bool tick(wend::Rows copies);
  void move_movers(Copy&) const;
  void move_goals(Copy&, Robot*) const;
  void move(std::span<Robot* const>) const;
  void settle(const StaticMap&, Robot&, const wend_motion& from, Twist, double length) const;
  void sweep(const StaticMap&, Robot&, const wend_motion& from, Twist, double length) const;
  void meet_movers(const Copy&, Robot&) const;
  void meet_robots(Robot*) const;
  void meet(Robot&, double old_x, double old_y, double x, double y, double radius) const;
  void finish(const Copy&, Robot&) const;

  Robot* robots(std::uint32_t copy) noexcept { return &rows_[std::size_t{copy} * robots_]; }

  // sense.cpp
  void note_reach(double reach);
  void cast_block(const StaticMap&, wend::Rows, const wend_pose* rays, double reach, std::uint32_t kinds,
                  double* distance, std::uint8_t* kind) const;
  void meet_moving(Rays&, wend::Rows, std::uint32_t what) const;
  void list_shapes(Copy&);

  Options options_;
  std::uint32_t robots_;
  Kinematics kinematics_;
  SceneSource source_;
  std::vector<Robot> rows_;
  std::vector<Copy> copies_;
  std::vector<const StaticMap*> maps_;  // around each row
  bool one_map_ = false;                // around all rows
  bool movers_ = false;                 // in any scene so far
  std::vector<std::shared_ptr<Place>> places_;  // the last ones used, the latest first
  wend::Columns metrics_;
  std::array<std::atomic<double>, 4> reaches_{};  // asked for by rays so far; 0: none
};

}  // namespace arena
