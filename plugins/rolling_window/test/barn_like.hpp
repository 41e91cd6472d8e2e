// Cluttered fields like the BARN worlds (Perille, Xiao et al. 2020): cylinders on a grid of 0.15 m cells, grown by a
// cellular automaton; and the optimal length through them, by brute force on a fine grid.
#pragma once
#include <queue>

#include "rig.hpp"

namespace rig {

// Least length of a centre path of a disc `body` from the scene's start to within its goal (8-connected grid of 0.05
// m), or infinite.
inline double optimal_length(const Scene& scene, double body, double x0, double y0, double x1, double y1) {
  constexpr double cell = 0.05;
  const int w = static_cast<int>((x1 - x0) / cell), h = static_cast<int>((y1 - y0) / cell);
  std::vector<char> blocked(static_cast<std::size_t>(w * h), 0);
  for (const wend_disc& d : scene.obstacles) {
    const double r = d.radius + body;
    for (int j = std::max(0, static_cast<int>((d.y - r - y0) / cell));
         j <= std::min(h - 1, static_cast<int>((d.y + r - y0) / cell)); ++j)
      for (int i = std::max(0, static_cast<int>((d.x - r - x0) / cell));
           i <= std::min(w - 1, static_cast<int>((d.x + r - x0) / cell)); ++i) {
        const double dx = x0 + (i + 0.5) * cell - d.x, dy = y0 + (j + 0.5) * cell - d.y;
        if (dx * dx + dy * dy < r * r) blocked[static_cast<std::size_t>(j * w + i)] = 1;
      }
  }
  std::vector<double> best(blocked.size(), 1e300);
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> open;
  const int from = static_cast<int>((scene.start.y - y0) / cell) * w + static_cast<int>((scene.start.x - x0) / cell);
  open.push({best[static_cast<std::size_t>(from)] = 0, from});
  while (!open.empty()) {
    const auto [g, k] = open.top();
    open.pop();
    if (g > best[static_cast<std::size_t>(k)]) continue;
    const int i = k % w, j = k / w;
    const double dx = x0 + (i + 0.5) * cell - scene.goal.x, dy = y0 + (j + 0.5) * cell - scene.goal.y;
    if (dx * dx + dy * dy <= cell * cell) return g;
    for (int n = 0; n < 9; ++n) {
      const int a = i + n % 3 - 1, b = j + n / 3 - 1;
      if (n == 4 || a < 0 || b < 0 || a >= w || b >= h || blocked[static_cast<std::size_t>(b * w + a)]) continue;
      const double to = g + cell * (n % 2 == 0 ? std::sqrt(2.0) : 1);
      if (to < best[static_cast<std::size_t>(b * w + a)])
        open.push({best[static_cast<std::size_t>(b * w + a)] = to, b * w + a});
    }
  }
  return 1e300;
}
inline double optimal_length(const Scene& scene, double body) {
  return optimal_length(scene, body, -4.5, 0, 0, 14);
}

inline Scene barn_like_try(Random& random) {
  constexpr int columns = 30, rows = 64, corridor = 34;
  std::vector<int> cells(columns * rows, 0);
  const double fill = random.uniform(0.15, 0.35);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      cells[static_cast<std::size_t>(r * columns + c)] =
          r == 0 || c == 0 || c == columns - 1 || (r >= corridor && random.chance(fill));
  const int rounds = 2 + static_cast<int>(random.below(3));
  for (int k = 0; k < rounds; ++k) {
    std::vector<int> next = cells;
    for (int r = corridor; r < rows; ++r)
      for (int c = 1; c < columns - 1; ++c) {
        int around = 0;
        for (int j = -1; j <= 1; ++j)
          for (int i = -1; i <= 1; ++i)
            if ((i || j) && r + j < rows) around += cells[static_cast<std::size_t>((r + j) * columns + c + i)];
        int& cell = next[static_cast<std::size_t>(r * columns + c)];
        cell = around >= 5 || (cell && around >= 2);
      }
    cells = next;
  }
  Scene scene;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      if (cells[static_cast<std::size_t>(r * columns + c)])
        scene.obstacles.push_back({-4.5 + 0.15 * (c + 0.5), 0.15 * (r + 0.5), 0.075});
  scene.start = {-2.25, 3, wend::math::half_pi, 0, 0};
  scene.goal = {-2.25, 13, 1};
  return scene;
}

// Kept where a disc of 0.35 m can pass.
inline Scene barn_like(std::uint64_t seed) {
  for (std::uint64_t attempt = 0;; ++attempt) {
    Random random(wend::stream(seed, attempt));
    Scene scene = barn_like_try(random);
    if (optimal_length(scene, 0.35) < 1e300) return scene;
  }
}

}  // namespace rig
