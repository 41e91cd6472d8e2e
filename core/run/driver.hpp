// The driver of a unit: the policy tree of an arm, created for a stage, and what it has learned as bytes.
#pragma once
#include <core/run/bounds.hpp>
#include <core/run/stage.hpp>

#include <string>
#include <vector>

namespace wend::core {

class Driver {
 public:
  Driver(const DriverSpec& spec, const Stage& stage);

  void begin(const std::vector<std::uint32_t>& rows, const std::vector<wend_episode>& episodes);
  // One action row for each observation row; throws UnitFailed("rule") where an action is not in the action space.
  void act(const std::vector<std::uint32_t>& rows, const double* observations, double* actions);

  bool learns() const noexcept { return learner_ != nullptr; }
  std::uint64_t learn(const wend_batch& batch);
  void finish();

  // Everything below the root that has the extension wend.state/1, slots before owners.
  std::string save() const;
  void load(const std::string& bytes, const std::string& name);  // name: of the file, for messages

  const Bounds& bounds() const noexcept { return bounds_; }  // of actions
  Instance& root() const noexcept { return *root_; }

 private:
  const wend_space* action_;
  Bounds bounds_;
  std::unique_ptr<Instance> root_;
  const wend_policy* policy_ = nullptr;
  const wend_learner* learner_ = nullptr;
};

}  // namespace wend::core
