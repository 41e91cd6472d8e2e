// wend.clearance -- the avoidance reward of Liu et al., "A reactive navigation method of mobile robots based on LSPI
// and rolling windows", equation (11), with the conditions of table 1 as its explanations resolve them.  d are the
// distances of the next state s'.
//
//   symbol  here     meaning
//   d_l     left     least distance of the left half, m
//   d_r     right    least distance of the right half, m
//   d       least    min(d_l, d_r)
//
//   1  d <= D_us or collided   -penalty, the task is over
//   2  d_l <= D, d_r <= D      -k (D - d_l) - k (D - d_r)
//   3  d_l <= D, d_r >  D      -k (D - d_l)
//   4  d_l >  D, d_r <= D      -k (D - d_r)
//   5  both > D                 0
#include <limits>
#include <vector>
#include <wend/plugin.hpp>
#include <wend/reading.hpp>

namespace clearance {
namespace {

class Clearance {
 public:
  explicit Clearance(const wend::Config& config)
      : distances_(config.observation, config.params.texts("observe"), "observe"),
        D_(config.params.number("D")),
        D_us_(config.params.number("D_us")),
        k_(config.params.number("k")),
        penalty_(config.params.number("penalty")),
        action_costs_(config.params.numbers("action_costs")),
        terminate_(config.params.flag("terminate")),
        training_(config.rows(), 0) {
    if (D_us_ > D_)
      throw wend::parameter_error("D_us",
                                  "expected at most D = " + std::to_string(D_) + ", found " + std::to_string(D_us_));
    const bool table = config.action.width() == 1 && config.action[0].count > 0;
    if (!action_costs_.empty() && (!table || config.action[0].count != action_costs_.size()))
      throw wend::parameter_error("action_costs", "expected one cost for each discrete action, " +
                                                      std::to_string(table ? config.action[0].count : 0) + ", found " +
                                                      std::to_string(action_costs_.size()));
    bool left = false, right = false;
    for (std::size_t i = 0; i < distances_.size(); ++i) left |= is_left(i), right |= is_right(i);
    if (!left || !right)
      throw wend::parameter_error("observe",
                                  std::string("expected distances to the left and to the right, found none to the ") +
                                      (left ? "right" : "left"));
  }

  void begin(wend::Rows rows, wend::Episodes episodes) {
    for (std::size_t i = 0; i < rows.size(); ++i) training_[rows[i]] = episodes[i].mode != WEND_TEST;
  }

  void score(const wend::Batch& batch, std::span<wend_outcome> outcomes) {
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const bool collided = (batch.outcomes[i].flags & WEND_COLLIDED) != 0;
      double left = std::numeric_limits<double>::infinity(), right = left;
      for (std::size_t k = 0; k < distances_.size(); ++k) {
        const double d = distances_(batch.next_observations[i], k);
        if (is_left(k)) left = std::min(left, d);
        if (is_right(k)) right = std::min(right, d);
      }
      const bool crashed = collided || std::min(left, right) <= D_us_;
      outcomes[i].reward = crashed ? -penalty_ : -k_ * lack(left) - k_ * lack(right) - cost_of(batch.actions[i][0]);
      if (crashed && terminate_ && training_[batch.rows[i]]) outcomes[i].flags |= WEND_TERMINATED;
    }
  }

 private:
  double cost_of(double action) const noexcept {
    return action_costs_.empty() ? 0 : action_costs_[static_cast<std::size_t>(action)];
  }
  double lack(double side) const noexcept { return side <= D_ ? D_ - side : 0; }
  // A beam straight ahead or behind counts for both sides, so that the reward has the mirror symmetry of the task.
  bool is_middle(std::size_t i) const noexcept {
    const double bearing = distances_.bearing(i);
    return bearing == 0 || bearing == wend::math::pi || bearing == -wend::math::pi;
  }
  bool is_left(std::size_t i) const noexcept { return is_middle(i) || distances_.bearing(i) > 0; }
  bool is_right(std::size_t i) const noexcept { return is_middle(i) || distances_.bearing(i) < 0; }

  wend::Reading distances_;
  double D_, D_us_;  // m
  double k_, penalty_;
  std::vector<double> action_costs_;  // by discrete action; none: actions are free, as in the paper
  bool terminate_;
  std::vector<char> training_;  // of each row
};

}  // namespace
}  // namespace clearance

WEND_PLUGIN(wend::component<clearance::Clearance>("wend.clearance"))
