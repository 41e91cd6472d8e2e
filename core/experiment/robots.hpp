// The robots of an experiment: their sensors, and their definitions as each type of world wants them.
#pragma once
#include <core/experiment/composition.hpp>
#include <core/experiment/scope.hpp>
#include <core/experiment/unit.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace wend::core {

class Robots {
 public:
  explicit Robots(const Scope& scope) : scope_(scope) {}

  void read(Json& file);  // its "robots"; `file` lives as long as this

  bool has(const std::string& name) const { return robots_.contains(name); }
  bool check_name(const std::string& name, const std::string& pointer, const std::string& who) const;
  std::vector<std::string> names() const;
  const std::vector<Need>& needs(const std::string& name) const { return robots_.at(name).needs; }

  // The robot as worlds of one type want it.  Its mistakes are told once, however many types find them.
  const RobotSpec& in_world(const std::string& name, const ComponentEntry& world);

  // Writes a robot's defaults into the file where all types of worlds that it enters agree on them.
  void show_defaults();

 private:
  struct Robot {
    Json* file = nullptr;
    std::vector<SensorSpec> sensors;
    std::vector<Need> needs;
    std::map<std::string, RobotSpec> by_world_type;
  };
  void read_sensors(const std::string& name, Robot& robot);

  const Scope& scope_;
  std::map<std::string, Robot> robots_;
  std::set<std::string> told_;  // pointers of mistakes
};

}  // namespace wend::core
