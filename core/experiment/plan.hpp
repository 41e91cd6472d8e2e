// All trainings and cells of an experiment, in an order that depends on the experiment alone.  What thousands of units
// have in common is kept once; a unit is put together when it is asked for.
#pragma once
#include <core/experiment/resolve.hpp>
#include <core/experiment/unit.hpp>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace wend::core {

// What is wanted of an experiment; empty sets: everything.
struct PlanFilter {
  std::uint64_t first_seed = 0, end_seed = 1;
  std::set<std::string> arms, worlds;

  bool wants(const std::set<std::string>& chosen, const std::string& id) const {
    return chosen.empty() || chosen.contains(id);
  }
};

class Plan {
 public:
  static constexpr std::size_t max_cells = 1'000'000;

  std::size_t training_count() const { return trainings_.size(); }
  std::size_t cell_count() const { return cells_.size(); }
  const std::string& training_id(std::size_t i) const { return trainings_[i].id; }
  const std::string& cell_id(std::size_t i) const { return cells_[i].id; }
  Training training(std::size_t i) const;
  Cell cell(std::size_t i) const;

  // One cell of each distinct composition of driver and world: what has to be created to know that all can be.
  std::vector<Cell> compositions() const;

  // Appends the units of one point of the sweep; false, and nothing is appended, if the plan would have more than
  // max_cells.
  bool add(const Json& point, const Resolved& experiment, const PlanFilter& filter);

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  struct TrainingGroup {  // trainings that differ by their seed
    Training common;      // without driver and worlds
    std::size_t driver = 0, first = 0;
    std::size_t source = none;       // the group whose final states they start from
    std::uint64_t traced_seeds = 0;  // of the seeds below it episodes are recorded
    std::vector<std::size_t> worlds, selection_worlds;
  };
  struct CellGroup {  // cells of one arm in one world at one point
    Cell common;      // without driver and world
    std::size_t driver = 0, world = 0;
    std::vector<std::optional<Budget>> at;  // nothing: the final state
    std::uint32_t snapshot_episodes = 1;
  };
  struct Entry {
    std::string id;
    std::size_t group = 0;
    std::uint64_t seed = 0;
    std::uint32_t variant = 0, at = 0;
    std::size_t training = none;
  };

  std::size_t keep(const DriverSpec& driver);
  std::size_t keep(const WorldSpec& world);
  std::size_t add_training(const Json& point, const Resolved& experiment, const ArmSpec& arm, std::size_t tested,
                           const PlanFilter& filter);
  void add_cells(CellGroup group, std::uint64_t traced_seeds, std::size_t training_group, const PlanFilter& filter);
  Cell light_cell(const CellGroup& group, const Entry& entry) const;
  Training light_training(const TrainingGroup& group, std::uint64_t seed, std::size_t place) const;

  std::vector<DriverSpec> drivers_;
  std::vector<WorldSpec> worlds_;
  std::map<std::string, std::size_t> driver_index_, world_index_, training_index_;  // by digest
  std::vector<std::string> driver_digests_, world_digests_;
  std::vector<TrainingGroup> training_groups_;
  std::vector<CellGroup> cell_groups_;
  std::vector<std::uint64_t> traced_seeds_;  // by cell group
  std::vector<Entry> trainings_, cells_;
};

// The trainings or cells of a plan as a range of values.
template <class Unit>
class Units {
 public:
  class iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Unit;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = Unit;
    iterator(const Units* units, std::size_t i) : units_(units), i_(i) {}
    Unit operator*() const { return (*units_)[i_]; }
    iterator& operator++() { return ++i_, *this; }
    bool operator==(const iterator& other) const { return i_ == other.i_; }
    bool operator!=(const iterator& other) const { return i_ != other.i_; }

   private:
    const Units* units_;
    std::size_t i_;
  };

  explicit Units(const Plan& plan) : plan_(&plan) {}
  std::size_t size() const { return is_cells ? plan_->cell_count() : plan_->training_count(); }
  bool empty() const { return size() == 0; }
  const std::string& id(std::size_t i) const { return is_cells ? plan_->cell_id(i) : plan_->training_id(i); }
  Unit operator[](std::size_t i) const {
    if constexpr (is_cells)
      return plan_->cell(i);
    else
      return plan_->training(i);
  }
  iterator begin() const { return {this, 0}; }
  iterator end() const { return {this, size()}; }

 private:
  static constexpr bool is_cells = std::is_same_v<Unit, Cell>;
  const Plan* plan_;
};

}  // namespace wend::core
