#include <gtest/gtest.h>
#include <wend/abi.h>

#include <core/base/error.hpp>
#include <core/base/files.hpp>
#include <core/record/npz.hpp>
#include <core/record/trace.hpp>
#include <cstdlib>
#include <filesystem>
#include <random>

namespace wend::core {
namespace {

class TraceFile : public testing::Test {
 protected:
  TraceFile() {
    char name[] = "/tmp/wend-trace-XXXXXX";
    folder_ = mkdtemp(name);
    path_ = folder_ + "/t.npz";
  }
  ~TraceFile() override { std::filesystem::remove_all(folder_); }

  std::string error_of_writing(const Trace& trace) {
    try {
      write_trace(path_, trace);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  std::string error_of_reading() {
    try {
      read_trace(path_);
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::data);
      return error.what();
    }
    return "";
  }

  std::string folder_, path_;
};

// Two robots, three states, one mover, every form of shape.
Trace sample() {
  Trace trace;
  trace.about = {{"arm", "tëst"}, {"episode", 3}};
  trace.robots = 2;
  trace.action_width = 1;
  trace.movers = 1;
  trace.time = {0, 0.5, 1};
  for (int i = 0; i < 18; ++i) {
    trace.pose.push_back(i);
    trace.goal.push_back(-i);
  }
  trace.body_radius = {0.25, 0.5};
  trace.action = {0, 1, 2, 0};
  trace.reward = {-1, 0, 0.5, 100};
  trace.flags = {0, WEND_TERMINATED | WEND_ARRIVED, WEND_TRUNCATED, WEND_TERMINATED | WEND_ARRIVED};
  trace.mover = {1, 2, 0.5, 1.5, 2, 0.5, 2, 2, 0.5};
  trace.shapes = {{WEND_SHAPE_DISC, WEND_OBSTACLE, {4, 5}, 0, 0, {}, 1.5},
                  {WEND_SHAPE_SEGMENTS, WEND_WALL, {0, 0, 1, 0, 1, 0, 1, 1}, 0, 0, {}, 0},
                  {WEND_SHAPE_GRID, WEND_WALL, {-1, -1, 0.5}, 3, 2, {0, 1, 0, 1, 1, 0}, 0},
                  {WEND_SHAPE_POLYGON, WEND_WALL, {0, 0, 1, 0, 0, 1}, 0, 0, {}, 0}};
  trace.telemetry_names = {"policy.J", "avoid.q0"};
  trace.telemetry = {1, 2, 3, 4, 5, 6, 7, 8};
  return trace;
}

TEST_F(TraceFile, GivesBackWhatWasWritten) {
  const Trace a = sample();
  write_trace(path_, a);
  const Trace b = read_trace(path_);
  EXPECT_EQ(a.about, b.about);
  EXPECT_EQ(a.robots, b.robots);
  EXPECT_EQ(a.action_width, b.action_width);
  EXPECT_EQ(a.movers, b.movers);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.pose, b.pose);
  EXPECT_EQ(a.goal, b.goal);
  EXPECT_EQ(a.body_radius, b.body_radius);
  EXPECT_EQ(a.action, b.action);
  EXPECT_EQ(a.reward, b.reward);
  EXPECT_EQ(a.flags, b.flags);
  EXPECT_EQ(a.mover, b.mover);
  EXPECT_EQ(a.telemetry_names, b.telemetry_names);
  EXPECT_EQ(a.telemetry, b.telemetry);
  ASSERT_EQ(a.shapes.size(), b.shapes.size());
  for (std::size_t i = 0; i < a.shapes.size(); ++i) {
    EXPECT_EQ(a.shapes[i].form, b.shapes[i].form);
    EXPECT_EQ(a.shapes[i].kind, b.shapes[i].kind);
    EXPECT_EQ(a.shapes[i].xy, b.shapes[i].xy);
    EXPECT_EQ(a.shapes[i].columns, b.shapes[i].columns);
    EXPECT_EQ(a.shapes[i].rows, b.shapes[i].rows);
    EXPECT_EQ(a.shapes[i].cells, b.shapes[i].cells);
    EXPECT_EQ(a.shapes[i].radius, b.shapes[i].radius);
  }
}

TEST_F(TraceFile, AnEpisodeWithoutStepsAndAWorldWithoutAnything) {
  Trace trace;
  trace.time = {0};
  write_trace(path_, trace);
  const Trace back = read_trace(path_);
  EXPECT_EQ(back.time, std::vector<double>{0});
  EXPECT_EQ(back.robots, 0u);
  EXPECT_TRUE(back.shapes.empty());
}

TEST_F(TraceFile, NumPyReadsIt) {
  if (std::system("/usr/bin/python3 -c 'import numpy' 2>/dev/null") != 0) GTEST_SKIP() << "python3 has no numpy";
  write_trace(path_, sample());
  write_file(folder_ + "/check.py", "import numpy as np, json\nz = np.load('" + path_ +
                                        "')\n"
                                        "assert z['pose'].shape == (3, 2, 3) and z['pose'][2, 1, 0] == 15\n"
                                        "assert z['flags'].shape == (2, 2) and z['flags'][1, 0] == 2\n"
                                        "assert z['telemetry'].shape == (2, 2, 2)\n"
                                        "assert json.loads(bytes(z['about']))['arm'] == 'tëst'\n");
  EXPECT_EQ(std::system(("/usr/bin/python3 " + folder_ + "/check.py").c_str()), 0);
}

TEST_F(TraceFile, RefusesToWriteWhatDoesNotFitTogether) {
  const std::string where = "cannot write the trace " + path_ + ": ";
  Trace trace = sample();
  trace.pose.pop_back();
  EXPECT_EQ(error_of_writing(trace), where + "pose: expected 18 values, found 17");
  trace = sample();
  trace.telemetry_names.pop_back();
  EXPECT_EQ(error_of_writing(trace), where + "telemetry: expected 4 values, found 8");
  trace = sample();
  trace.time.clear();
  EXPECT_EQ(error_of_writing(trace), where + "time: expected at least one value, found none");
  trace = sample();
  trace.shapes[2].cells.pop_back();
  EXPECT_EQ(error_of_writing(trace), where + "shape 2: expected 6 cells, found 5");
  trace = sample();
  trace.shapes[1].xy.pop_back();
  EXPECT_EQ(error_of_writing(trace), where + "shape 1: expected pairs of values in xy, found 7");
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(TraceFile, ADamagedFileIsAnErrorThatNamesIt) {
  write_trace(path_, sample());
  const std::string good = read_file(path_);
  write_file(path_, good.substr(0, good.size() / 2));
  EXPECT_EQ(error_of_reading(), path_ + " is damaged: not an NPZ file, or its end is cut off");

  NpzWriter other;
  other.add("format", std::vector<std::int64_t>{2}, {1});
  other.write(path_);
  EXPECT_EQ(error_of_reading(), path_ + ": a trace of another format: expected 1, found 2");

  NpzWriter deep;
  deep.add("format", std::vector<std::int64_t>{1}, {1});
  deep.add_text("about", std::string(100000, '['));
  deep.write(path_);
  EXPECT_EQ(error_of_reading(), path_ + " is damaged: array \"about\" is not a JSON object");
}

// Arrays that are sound each by itself and don't fit together.
TEST_F(TraceFile, NoForgedShapeReadsBeyondTheArrays) {
  for (const std::uint32_t columns : {2u, 0xffffffffu}) {
    NpzWriter file;
    const std::vector<double> none;
    file.add("format", std::vector<std::int64_t>{1}, {1});
    file.add_text("about", "{}");
    file.add("time", std::vector<double>{0}, {1});
    for (const char* name : {"pose", "goal", "action", "mover", "telemetry"}) file.add(name, none, {0, 0, 3});
    file.add("body_radius", none, {0});
    file.add("reward", none, {0, 0});
    file.add("flags", std::vector<std::uint32_t>{}, {0, 0});
    file.add_text("telemetry_names", "[]");
    file.add("shape_form", std::vector<std::uint32_t>{WEND_SHAPE_GRID}, {1});
    file.add("shape_kind", std::vector<std::uint32_t>{1}, {1});
    file.add("shape_values", std::vector<std::uint32_t>{3}, {1});
    file.add("shape_columns", std::vector<std::uint32_t>{columns}, {1});
    file.add("shape_rows", std::vector<std::uint32_t>{columns}, {1});
    file.add("shape_radius", std::vector<double>{0}, {1});
    file.add("shape_xy", std::vector<double>{0, 0, 1}, {3});
    file.add("shape_cells", std::vector<std::uint8_t>{1, 1, 1}, {3});
    file.write(path_);
    EXPECT_EQ(error_of_reading(), path_ + " is damaged: shape 0 asks for more points or cells than there are");
  }
}

}  // namespace
}  // namespace wend::core
