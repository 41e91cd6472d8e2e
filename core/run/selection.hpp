// keep: "best": of the snapshots of a training, the one that does best on worlds which are not the tested ones.
#pragma once
#include <core/run/cell.hpp>

#include <string>

namespace wend::core {

class Selection {
 public:
  // Tests the snapshot frozen in the training's selection worlds; an equal one never replaces an earlier one.
  void consider(const std::string& bytes, const Training& training, const WorkOptions& options);
  const std::string& best() const noexcept { return best_; }

 private:
  std::string best_;
  double success_ = -1, reward_ = 0;
};

}  // namespace wend::core
