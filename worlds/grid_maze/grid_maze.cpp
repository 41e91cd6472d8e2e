// wend.grid_maze: an animat in a maze of cells sees its eight neighbours and looks for food.
//   Woods1  S. W. Wilson: ZCS: a zeroth level classifier system, Evolutionary Computation 2 (1994) 1-18;
//   Woods2  S. W. Wilson: Classifier fitness based on accuracy, Evolutionary Computation 3 (1995) 149-175;
//   Maze4   P. L. Lanzi: A study of the generalization capabilities of XCS, ICGA 1997, 418-425;
//   Maze5, Maze6  P. L. Lanzi: An analysis of generalization in the XCS classifier system, Evolutionary Computation 7
//           (1999) 125-149.
//
//   paper                 here
//   sensor vector         bit.0 ..: the neighbour to the north first, then clockwise, 2 or 3 bits each (maze.hpp)
//   actions 0..7          the same eight directions; into rock the animat stays
//   food, reward 1000     payoff, the episode ends
//   optimum               Maze::steps_to_food, by breadth-first search
#include <cmath>
#include <limits>
#include <string>
#include <vector>
#include <wend/plugin.hpp>

#include "maps.hpp"
#include "maze.hpp"

namespace grid_maze {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Maze maze_of(const wend::Params& params) {
  const std::string name = params.text("maze");
  const std::vector<std::string> rows = params.texts("map");
  if (name != "custom" && !rows.empty())
    throw wend::parameter_error("map", "expected no rows beside maze \"" + name + "\", found " +
                                           std::to_string(rows.size()) + "; say maze \"custom\" to use them");
  const Edge edge = params.text("edge") == "rock" ? Edge::rock : Edge::wraps;
  return Maze(name == "custom" ? rows : named_map(name), edge);
}

std::uint32_t bits_of(const wend::Params& params) {
  const auto bits = static_cast<std::uint32_t>(params.count("bits"));
  return bits != 0 ? bits : params.text("maze") == "woods2" ? 3 : 2;
}

std::uint64_t steps_of(const wend::Params& params) {
  const double limit = params.number("time_limit");
  if (limit != std::floor(limit))
    throw wend::parameter_error("time_limit",
                                "expected a whole number of steps, a second each, found " + wend::number_text(limit));
  return params.count("time_limit");
}

struct Animat {
  std::uint32_t cell = 0, start = 0;
  std::uint64_t steps = 0;
  bool exploring = false, over = false;
};

class GridMaze {
 public:
  explicit GridMaze(const wend::Config& config)
      : maze_(maze_of(config.params)),
        bits_(bits_of(config.params)),
        payoff_(config.params.number("payoff")),
        limit_(steps_of(config.params)),
        enumerate_(config.params.text("test") == "enumerate"),
        animats_(config.rows()) {
    if (config.robots() != 1)
      throw wend::unsupported("expected one robot in a grid maze, found " + std::to_string(config.robots()));
    action_.discrete("direction", Maze::directions);
    for (std::uint32_t i = 0; i < Maze::directions * bits_; ++i) seen_.discrete("bit." + std::to_string(i), 2);
    told_.box("steps_to_food", "1", 1).box("optimal_steps", "1", 1).box("step_ratio", "1", 1);
    look();
  }

  double period() const { return 1; }
  const wend::Columns& action(std::uint32_t) const { return action_; }

  void reset(wend::Rows copies, wend::Episodes episodes) {
    const auto& starts = maze_.empty_cells();
    for (std::size_t i = 0; i < copies.size(); ++i) {
      const wend_episode& episode = episodes[i];
      const std::uint64_t k = enumerate_ && episode.mode == WEND_TEST
                                  ? episode.index % starts.size()
                                  : wend::Random(wend::stream(episode.seed, "start")).below(starts.size());
      animats_[copies[i]] = {starts[k], starts[k], 0, episode.mode == WEND_TRAIN_EXPLORE, false};
    }
  }

  void step(wend::Rows copies, wend::Matrix<const double> actions, std::span<wend_outcome> outcomes) {
    for (std::size_t i = 0; i < copies.size(); ++i) {
      Animat& animat = animats_[copies[i]];
      const double asked = actions[i][0];
      if (!(asked >= 0 && asked < Maze::directions))
        throw wend::Error(WEND_E_ARGUMENT, {}, "expected a direction 0..7, found " + std::to_string(asked));
      animat.cell = maze_.step(animat.cell, static_cast<std::uint32_t>(asked));
      ++animat.steps;
      if (maze_.food(animat.cell))
        outcomes[i] = {payoff_, WEND_TERMINATED | WEND_ARRIVED, 0};
      else
        outcomes[i] = {0, animat.steps >= limit_ ? std::uint32_t{WEND_TRUNCATED} : 0u, 0};
      animat.over = outcomes[i].flags != 0;
    }
  }

  const wend::Columns& columns() const { return seen_; }
  void sense(wend::Rows rows, wend::Matrix<double> out) const {
    const std::size_t width = seen_.width();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double* seen = views_.data() + animats_[rows[i]].cell * width;
      std::copy(seen, seen + width, out[i].begin());
    }
  }

  const wend::Columns* telemetry(std::uint32_t when) const { return when == WEND_PER_EPISODE ? &told_ : nullptr; }
  void read(std::uint32_t, wend::Rows rows, wend::Matrix<double> out) const {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Animat& animat = animats_[rows[i]];
      const bool tell = animat.over && !animat.exploring;
      const auto steps = static_cast<double>(animat.steps);
      const double optimal = maze_.steps_to_food(animat.start);
      out[i][0] = tell ? steps : none;
      out[i][1] = tell ? optimal : none;
      out[i][2] = tell ? steps / optimal : none;
    }
  }

 private:
  // What is seen from every cell, once.
  void look() {
    const std::size_t width = seen_.width();
    views_.resize(std::size_t{maze_.width()} * maze_.height() * width);
    for (std::uint32_t cell = 0; cell < maze_.width() * maze_.height(); ++cell)
      for (std::uint32_t d = 0; d < Maze::directions; ++d) {
        const std::uint32_t code = code_of(maze_.sees(cell, d), bits_);
        for (std::uint32_t b = 0; b < bits_; ++b)
          views_[cell * width + d * bits_ + b] = static_cast<double>(code >> (bits_ - 1 - b) & 1);
      }
  }

  Maze maze_;
  std::uint32_t bits_;
  double payoff_;
  std::uint64_t limit_;
  bool enumerate_;
  std::vector<Animat> animats_;
  std::vector<double> views_;  // cells x columns
  wend::Columns action_, seen_, told_;
};

}  // namespace
}  // namespace grid_maze

WEND_PLUGIN(wend::component<grid_maze::GridMaze>("wend.grid_maze"))
