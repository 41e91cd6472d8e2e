#include <gtest/gtest.h>

#include <core/stats/table.hpp>
#include <sstream>

namespace wend::core {
namespace {

Json row(const std::string& arm, const std::string& world) {
  return {
      {"arm", arm},
      {"world", world},
      {"point", Json::object()},
      {"at", Json::object()},
      {"privileged", false},
      {"seeds", 10},
      {"episodes", 1000},
      {"success", {{"rate", 0.99}, {"low", 0.982}, {"high", 0.9953}, {"n", 1000}}},
      {"collision", {{"rate", 0}, {"low", 0}, {"high", 0.004}, {"n", 1000}}},
      {"timeout", {{"rate", 0.01}, {"low", 0.005}, {"high", 0.018}, {"n", 1000}}},
      {"metrics", {{"steps", {{"mean", 520.4}}}, {"path_length_m", {{"mean", 131.25}}}, {"spl", {{"mean", 0.9123}}}}}};
}

Json summary(std::vector<Json> rows) {
  return {{"results", rows}, {"cells", {{"planned", 4}, {"done", 4}, {"failed", 0}}}};
}

TEST(Table, IsAligned) {
  Json other = row("πfad", "u_trap");
  other["privileged"] = true;
  other["metrics"] = Json::object();
  other["success"] = {{"rate", 0.0}, {"low", 0.0}, {"high", 0.278}, {"n", 10}};
  other["collision"]["rate"] = 1.0;
  other["timeout"]["rate"] = 0.0;
  other["episodes"] = 10;
  EXPECT_EQ(table(summary({row("rolling_window", "ordinary"), other})),
            "arm             world        n   success % [95 %]  collided  timeout  steps  path m    SPL\n"
            "──────────────  ────────  ────  ─────────────────  ────────  ───────  ─────  ──────  ─────\n"
            "rolling_window  ordinary  1000  99.0 [98.2, 99.5]       0.0      1.0    520   131.2  0.912\n"
            "πfad *          u_trap      10    0.0 [0.0, 27.8]     100.0      0.0      -       -      -\n"
            "* privileged: reads the true map\n");
}

TEST(Table, ShowsPointsAndSnapshotsAndFailures) {
  Json one = row("lspi", "ordinary");
  one["at"] = {{"samples", 2300}};
  one["point"] = {{"/arms/0/policy/params/gamma", 0.9}};
  Json all = summary({one});
  all["cells"] = {{"planned", 4}, {"done", 2}, {"failed", 1}};
  EXPECT_EQ(
      table(all),
      "arm   world     at                          n   success % [95 %]  collided  timeout  steps  path m    SPL\n"
      "────  ────────  ───────────────────────  ────  ─────────────────  ────────  ───────  ─────  ──────  ─────\n"
      "lspi  ordinary  gamma 0.9, samples 2300  1000  99.0 [98.2, 99.5]       0.0      1.0    520   131.2  0.912\n"
      "2 of 4 cells are done, 1 failed\n");
}

TEST(Table, LeavesOutRatesWithoutMeaning) {
  Json one = row("xcs", "mux11");
  for (const char* key : {"success", "collision", "timeout"}) one.erase(key);
  one["metrics"] = {{"steps", {{"mean", 1.0}}}};
  EXPECT_EQ(table(summary({one})),
            "arm  world     n  steps\n"
            "───  ─────  ────  ─────\n"
            "xcs  mux11  1000      1\n");
  EXPECT_EQ(table(summary({})), "arm  world\n───  ─────\n");
}

TEST(Table, FitsATerminalAndNoEscapeSequenceReachesIt) {
  const std::string text =
      table(summary({row(std::string(60, 'a'), "w\x1b[31m" + std::string(60, 'b')), row("é", "文字")}));
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_NE(text.find("w?[31mbbb"), std::string::npos);
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line.size(), 110u);  // ASCII
  EXPECT_NE(text.find("…"), std::string::npos);
  EXPECT_NE(text.find("\né "), std::string::npos);
}

TEST(Table, AMarkSurvivesShortening) {
  Json one = row(std::string(80, 'a'), "w");
  one["privileged"] = true;
  EXPECT_NE(table(summary({one})).find("a… *  w"), std::string::npos);
}

}  // namespace
}  // namespace wend::core
