// Passes on what the policy in its slot does; built with FLIP_AT, it flips the last bit of that decision's first action
// in each episode.  Both builds have the same manifest, so that only the actions differ.
#include <cstring>
#include <wend/plugin.hpp>

#ifndef FLIP_AT
#define FLIP_AT UINT64_MAX
#endif

class Flip {
 public:
  explicit Flip(const wend::Config& config) : inner_(*config.slot("inner")), decisions_(config.rows()) {}

  void begin(wend::Rows rows, wend::Episodes episodes) {
    for (const std::uint32_t row : rows) decisions_[row] = 0;
    inner_.begin(rows, episodes);
  }

  void act(wend::Rows rows, wend::Matrix<const double> observations, wend::Matrix<double> actions) {
    inner_.act(rows, observations.data(), actions.data());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (++decisions_[rows[i]] != FLIP_AT) continue;
      std::uint64_t bits;
      std::memcpy(&bits, &actions[i][0], sizeof bits);
      bits ^= 1;
      std::memcpy(&actions[i][0], &bits, sizeof bits);
    }
  }

 private:
  wend::PolicyRef inner_;
  std::vector<std::uint64_t> decisions_;
};

WEND_PLUGIN(wend::component<Flip>("test.flip"))
