#include <gtest/gtest.h>

#include <algorithm>
#include <core/base/error.hpp>
#include <core/figure/figures.hpp>
#include <core/figure/map_figure.hpp>
#include <core/figure/outcome.hpp>
#include <core/figure/step_series.hpp>

#include "../../render/synthetic.hpp"

namespace wend::core {
namespace {

Trace recorded(const std::string& arm, const std::string& world, int variant, Json more = Json::object()) {
  Trace trace = test::drive({{10, 10}, {50, 60}, {88, 88}}, 1, 0, test::arrived, {88, 88}, 3, 3);
  trace.shapes = {test::bounds(100, 100), test::disc(30, 70, 5)};
  trace.about = {{"arm", arm},   {"world", world},          {"variant", variant}, {"seed", 0},
                 {"episode", 0}, {"point", Json::object()}, {"privileged", false}};
  trace.about.update(more);
  return trace;
}

Json result(const std::string& arm, const std::string& world, double rate) {
  return {{"arm", arm},
          {"world", world},
          {"point", Json::object()},
          {"privileged", arm == "b"},
          {"success", {{"rate", rate}, {"low", rate - 0.1}, {"high", 1}}}};
}

Json summary() {
  Json curve = {{"arm", "a"},
                {"world", "w"},
                {"point", Json::object()},
                {"robot", nullptr},
                {"metric", "success"},
                {"x", "samples"},
                {"points", Json::array({{0, 0.1, 0.0, 0.2}, {100, 0.9, nullptr, nullptr}})}};
  return {{"experiment", "test"},
          {"results", {result("b", "w", 0.5), result("a", "w", 0.9), result("a", "v/2", 0.7)}},
          {"curves", {curve}}};
}

std::vector<std::string> names(const std::vector<NamedFigure>& figures) {
  std::vector<std::string> all;
  for (const NamedFigure& figure : figures) all.push_back(figure.name);
  return all;
}

std::vector<std::string> texts(const Figure& figure) {
  std::vector<std::string> all;
  for (const Item& item : figure.items)
    if (const Text* text = std::get_if<Text>(&item.what)) all.push_back(text->text);
  return all;
}

bool shows(const Figure& figure, const std::string& text) {
  const auto all = texts(figure);
  return std::find(all.begin(), all.end(), text) != all.end();
}

using Names = std::vector<std::string>;

TEST(Figures, ARunDirectoryGetsAllThatItsRecordsAllow) {
  std::vector<Trace> traces;
  for (int variant = 0; variant < 6; ++variant) {
    traces.push_back(recorded("a", "w", variant));
    traces.push_back(recorded("b", "w", variant));
  }
  traces.push_back(recorded("a", "v/2", 0));
  for (const double at : {10000.0, 0.0, 500.0}) traces.push_back(recorded("a", "w", 0, {{"at", {{"samples", at}}}}));
  const auto figures = figures_of(summary(), traces, Json::object());
  EXPECT_EQ(names(figures), (Names{"map_w_0", "map_w_1", "map_w_3", "map_w_5", "map_v_2_0", "maps", "learning_w_a",
                                   "curve_success_w", "success"}));
  EXPECT_EQ(figures[0].figure.title, "test · w · map 0");
  EXPECT_TRUE(shows(figures[0].figure, " (privileged)"));
  EXPECT_TRUE(shows(figures[0].figure, "arrived · 111 steps, 111.2 m"));
  EXPECT_TRUE(shows(figures[6].figure, "10,000 samples"));
  EXPECT_TRUE(shows(figures[8].figure, "90.0 %"));
}

TEST(Figures, TrialsOfATrainingStandOnOneMap) {
  std::vector<Trace> traces;
  for (int episode = 0; episode < 3; ++episode)
    traces.push_back(recorded("a", "w", 0, {{"training", true}, {"episode", episode}}));
  for (std::uint32_t& flags : traces[1].flags)
    if (flags == test::arrived) flags = test::collided;
  traces.push_back(recorded("a", "w", 0));
  const auto figures = figures_of(summary(), traces, Json::object());
  EXPECT_EQ(names(figures), (Names{"map_w_0", "trials_w_a", "curve_success_w", "success"}));
  const Figure& trials = figures[1].figure;
  EXPECT_EQ(trials.title, "test · w · a while it learns");
  EXPECT_TRUE(shows(trials, "failed: 1 trial"));
  EXPECT_TRUE(shows(trials, "arrived: 2 trials"));
  EXPECT_TRUE(shows(trials, "collided"));  // what the end markers mean
  EXPECT_FALSE(shows(figures[0].figure, "failed: 1 trial"));
}

TEST(Figures, StepsAreDrawnOverTime) {
  std::vector<Trace> traces = {recorded("a", "w", 0), recorded("b", "w", 0)};
  for (int episode = 0; episode < 2; ++episode)
    traces.push_back(recorded("a", "w", 0, {{"training", true}, {"episode", episode}}));
  for (Trace& trace : traces) {
    trace.telemetry_names = {"avoid.q", "avoid.J"};
    for (std::size_t t = 0; t < trace.reward.size(); ++t) {
      trace.telemetry.push_back(0);
      trace.telemetry.push_back(static_cast<double>(t));
    }
  }
  traces[1].pose.clear();  // a world without a map has values over time all the same
  const auto figures = figures_of(summary(), traces, {{"steps", {"J", "reward", "nothing"}}, {"variants", 0}, {"curves", Json::array()}});
  EXPECT_EQ(names(figures), (Names{"trials_w_a", "success", "steps_J_w", "trial_steps_J_w_a", "steps_reward_w", "trial_steps_reward_w_a"}));
  EXPECT_TRUE(shows(figures[2].figure, "b"));
  EXPECT_TRUE(shows(figures[2].figure, "time (s)"));
  EXPECT_FALSE(shows(figures[3].figure, "b"));
}

TEST(StepSeries, EpisodesFollowEachOtherWithAGap) {
  Trace trace = recorded("a", "w", 0);
  const std::size_t steps = trace.reward.size();
  const auto points = step_series({&trace, &trace}, "reward");
  ASSERT_EQ(points.size(), 2 * steps + 1);
  EXPECT_EQ(points[0].x, trace.time[0]);
  EXPECT_TRUE(std::isnan(points[steps].x));
  EXPECT_EQ(points[steps + 1].x, trace.time.back() + trace.time[0]);
  EXPECT_TRUE(step_series({&trace}, "J").empty());
  std::fill(trace.reward.begin(), trace.reward.end(), std::nan(""));
  EXPECT_TRUE(step_series({&trace, &trace}, "reward").empty());
}

TEST(Figures, OptionsChooseWorldsAndMaps) {
  const std::vector<Trace> traces = {recorded("a", "w", 0), recorded("a", "w", 1), recorded("a", "v/2", 0)};
  const auto figures = figures_of(summary(), traces, {{"worlds", {"w"}}, {"variants", 1}, {"title", "mine"}});
  EXPECT_EQ(names(figures), (Names{"map_w_0", "curve_success_w", "success"}));
  EXPECT_EQ(figures[0].figure.title, "mine · w · map 0");
}

TEST(Figures, AnEmptyRunHasNone) {
  EXPECT_TRUE(figures_of({{"results", Json::array()}}, {}, Json::object()).empty());
}

TEST(Figures, AWorldWithoutAMapHasNoMap) {
  Trace trace = recorded("a", "w", 0);
  trace.pose.clear();
  EXPECT_EQ(names(figures_of(summary(), {trace}, Json::object())), (Names{"curve_success_w", "success"}));
}

TEST(Figures, ASweepHasAMapForEachPoint) {
  const std::vector<Trace> traces = {recorded("a", "w", 0, {{"point", {{"/arms/0/params/gamma", 0.5}}}}),
                                     recorded("a", "w", 0, {{"point", {{"/arms/0/params/gamma", 0.9}}}})};
  EXPECT_EQ(names(figures_of(Json::object(), traces, Json::object())),
            (Names{"map_w_0_gamma___0.5", "map_w_0_gamma___0.9"}));
}

TEST(Figures, RefusesASummaryOfAnotherForm) {
  try {
    figures_of({{"results", {1}}}, {}, Json::object());
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "summary.json: /results: expected objects with \"arm\" and \"world\"");
  }
}

TEST(Figures, FileNamesHoldNothingThatAShellOrAFolderWouldRead) {
  EXPECT_EQ(file_name("../a b/é$"), "_.._a_b____");
  EXPECT_EQ(file_name(""), "_");
}

TEST(Outcome, CountsUntilTheRobotEnded) {
  Trace trace = test::drive({{0, 0}, {3, 4}}, 1, 0, test::collided, {9, 9}, 1, 0.5);
  EXPECT_EQ(outcome(trace, 0).ending, Ending::collided);
  EXPECT_EQ(outcome(trace, 0).steps, 5u);
  EXPECT_NEAR(outcome(trace, 0).length, 5, 1e-12);
  trace.flags[1] = test::timed_out;
  EXPECT_EQ(outcome(trace, 0).ending, Ending::timeout);
  EXPECT_NEAR(outcome(trace, 0).length, 2, 1e-12);
  EXPECT_EQ(effort(outcome(trace, 0)), "2 steps, 2 m");
  EXPECT_EQ(outcome(Trace{}).ending, Ending::unfinished);
}

TEST(MapFigure, SurvivesPosesThatAreNotNumbers) {
  Trace trace = recorded("a", "w", 0);
  for (std::size_t i = 30; i < 60; ++i) trace.pose[i] = NAN;
  trace.pose[6] = 1e300;
  const Figure figure = map_figure({{"a", &trace, 0, false, {}}}, "t");
  EXPECT_LT(figure.width, 1500);
  EXPECT_LT(figure.height, 1500);
}

TEST(MapFigure, KeepsTheMapLargeWhenARobotRunsAway) {
  Trace trace = recorded("a", "w", 0);
  trace.pose[3 * (trace.time.size() - 1)] = 1e5;
  const Box bounds = map_bounds({{"a", &trace, 0, false, {}}});
  EXPECT_LT(bounds.width, 140);
}

}  // namespace
}  // namespace wend::core
