// What happened in one episode, enough to draw it again without simulating: written as NPZ, read by render and by numpy.
#pragma once
#include <core/base/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace wend::core {

// One static shape of the world, as wend_shape has it.
struct TraceShape {
  std::uint32_t form = 0, kind = 0;   // WEND_SHAPE_*, WEND_*
  std::vector<double> xy;             // points; a grid: lower-left x, y and cell size
  std::uint32_t columns = 0, rows = 0;
  std::vector<std::uint8_t> cells;    // grid: 1 is occupied, row-major from the bottom
  double radius = 0;
};

struct Trace {
  Json about = Json::object();        // arm, world, variant, seed, episode, point, at, privileged
  std::uint32_t robots = 0, action_width = 0, movers = 0;
  std::vector<double> time;           // T + 1, s
  std::vector<double> pose;           // (T + 1) x robots x 3: x, y, heading; no geometry: empty, as are goals
  std::vector<double> goal;           // (T + 1) x robots x 3: x, y, radius
  std::vector<double> body_radius;    // robots
  std::vector<double> action;         // T x robots x action_width
  std::vector<double> reward;         // T x robots
  std::vector<std::uint32_t> flags;   // T x robots: WEND_TERMINATED | ...; a robot that ended repeats its last flags
  std::vector<double> mover;          // (T + 1) x movers x 3: x, y, radius
  std::vector<TraceShape> shapes;     // that do not move
  std::vector<std::string> telemetry_names;  // per step: "policy.J", "avoid.q0"
  std::vector<double> telemetry;      // T x robots x names
};

// Throws Error(Exit::data) with the file's name and what is wrong with it; a damaged file never crashes the reader.
void write_trace(const std::string& path, const Trace& trace);
Trace read_trace(const std::string& path);

}  // namespace wend::core
