#include <wend/abi.h>

#include <algorithm>
#include <cmath>
#include <core/figure/axis.hpp>
#include <core/figure/map_panel.hpp>
#include <core/figure/map_scene.hpp>

namespace wend::core {
namespace {

constexpr double largest_detour = 0.25;  // of the map's longer side: how far beyond the map a way is still shown

class Extent {
 public:
  void add(double x, double y, double margin = 0) {
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(margin)) return;
    left_ = std::min(left_, x - margin);
    right_ = std::max(right_, x + margin);
    bottom_ = std::min(bottom_, y - margin);
    top_ = std::max(top_, y + margin);
  }
  bool empty() const { return left_ > right_; }
  void limit(const Extent& to, double margin) {
    left_ = std::max(left_, to.left_ - margin);
    right_ = std::min(right_, to.right_ + margin);
    bottom_ = std::max(bottom_, to.bottom_ - margin);
    top_ = std::min(top_, to.top_ + margin);
  }
  double longer() const { return std::max(right_ - left_, top_ - bottom_); }
  Box padded(double margin) const {
    return {left_ - margin, bottom_ - margin, right_ - left_ + 2 * margin, top_ - bottom_ + 2 * margin};
  }

 private:
  double left_ = 1e300, right_ = -1e300, bottom_ = 1e300, top_ = -1e300;
};

void add_shape(Extent& extent, const TraceShape& shape) {
  if (shape.form == WEND_SHAPE_GRID && shape.xy.size() >= 3) {
    extent.add(shape.xy[0], shape.xy[1]);
    extent.add(shape.xy[0] + shape.xy[2] * shape.columns, shape.xy[1] + shape.xy[2] * shape.rows);
    return;
  }
  for (std::size_t i = 0; i + 1 < shape.xy.size(); i += 2)
    extent.add(shape.xy[i], shape.xy[i + 1], shape.form == WEND_SHAPE_DISC ? shape.radius : 0);
}

void widen(Box& box, double low_aspect, double high_aspect) {
  const double wanted_width = std::max(box.width, box.height * low_aspect);
  const double wanted_height = std::max(box.height, wanted_width / high_aspect);
  box = {box.x - (wanted_width - box.width) / 2, box.y - (wanted_height - box.height) / 2, wanted_width, wanted_height};
}

MapView view_of(const Box& world, Place corner, double scale) {
  return {world, {corner.x, corner.y, world.width * scale, world.height * scale}, scale};
}

}  // namespace

Box map_bounds(const std::vector<MapArm>& arms) {
  Extent map, ways;
  for (const MapArm& arm : arms) {
    const Trace& trace = *arm.trace;
    for (const TraceShape& shape : trace.shapes) add_shape(map, shape);
    for (std::size_t i = 0; i + 2 < trace.goal.size(); i += 3)
      map.add(trace.goal[i], trace.goal[i + 1], trace.goal[i + 2]);
    for (std::size_t i = 0; i + 2 < trace.mover.size(); i += 3)
      map.add(trace.mover[i], trace.mover[i + 1], trace.mover[i + 2]);
    for (std::size_t i = 0; trace.robots > 0 && i + 2 < trace.pose.size(); i += 3) {
      const std::size_t robot = i / 3 % trace.robots;
      const double radius = robot < trace.body_radius.size() ? trace.body_radius[robot] : 0;
      (i / 3 < trace.robots ? map : ways).add(trace.pose[i], trace.pose[i + 1], radius);
    }
  }
  if (map.empty()) map.add(0, 0, 1);
  Extent all = map;
  if (!ways.empty()) {
    ways.limit(map, largest_detour * map.longer());
    const Box shown = ways.padded(0);
    all.add(shown.x, shown.y);
    all.add(shown.right(), shown.bottom());
  }
  return all.padded(std::max(0.015 * all.longer(), 1e-6));
}

MapView fit_map(Box world, Place corner, double longest, double low_aspect, double high_aspect) {
  widen(world, low_aspect, high_aspect);
  return view_of(world, corner, longest / std::max(world.width, world.height));
}

MapView fit_map_height(Box world, Place corner, double height, double low_aspect, double high_aspect) {
  widen(world, low_aspect, high_aspect);
  return view_of(world, corner, height / world.height);
}

void add_map(Figure& figure, const MapView& view, const std::vector<MapArm>& arms) {
  const int clip = static_cast<int>(figure.clips.size());
  figure.clips.push_back(view.page);
  std::vector<Item>& items = figure.items;
  items.push_back({Rectangle{view.page, ink::ground, {}}, clip});
  const MapScene scene(items, view, clip);
  const Trace* longest = arms.empty() ? nullptr : arms.front().trace;
  for (const MapArm& arm : arms)
    if (arm.trace->time.size() > longest->time.size()) longest = arm.trace;
  if (longest != nullptr) {
    for (const TraceShape& shape : arms.front().trace->shapes) scene.add_shape(shape);
    scene.add_movers(*longest);
    scene.add_goals(*longest);
  }
  for (const MapArm& arm : arms) scene.add_way(arm, MapScene::Layer::seam);
  for (const MapArm& arm : arms) scene.add_way(arm, MapScene::Layer::line);
  scene.add_starts(arms);
  for (const MapArm& arm : arms) scene.add_body(arm);
  if (longest != nullptr) scene.add_goal_rings(*longest);
  for (const MapArm& arm : arms) scene.add_ending(arm);
  items.push_back({Rectangle{view.page, {}, Pen{ink::frame, 1, Cap::butt, {}}}, -1});
}

double add_scale_bar(Figure& figure, const MapView& view, Place at, double room) {
  const double metres = round_down_nicely(room / view.scale), length = metres * view.scale;
  Path bar{{{at.x, at.y - 4}, {at.x, at.y}, {at.x + length, at.y}, {at.x + length, at.y - 4}}, false, {}, {}};
  bar.pen = Pen{ink::text, 1.4, Cap::butt, {}};
  figure.items.push_back({std::move(bar), -1});
  const std::string text = grouped(metres, metres < 1 ? 3 : 0) + " m";
  figure.items.push_back({label({at.x + length + 6, at.y + 1}, text, 11.5), -1});
  return metres;
}

}  // namespace wend::core
