// Observations as bits: worked examples of each encoding, and what is refused.
#include "encoder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <wend/math.hpp>
#include <wend/testing.hpp>

using wend::testing::error_of;

namespace {

// Parameters as the host hands them over: sorted by path.
class Values {
 public:
  Values& set(const std::string& path, double number) { return put(path, number, ""), *this; }
  Values& set(const std::string& path, const char* text) { return put(path, 0, text), *this; }
  wend::Params params() {
    values_.clear();
    for (const auto& [path, value] : all_)
      values_.push_back({path.c_str(), value.second.empty() ? nullptr : value.second.c_str(), value.first});
    return wend::Params(values_);
  }

 private:
  void put(const std::string& path, double number, const std::string& text) { all_[path] = {number, text}; }
  std::map<std::string, std::pair<double, std::string>> all_;
  std::vector<wend_value> values_;
};

struct Robot {
  wend::Columns columns;
  Values values;
  explicit Robot(int beams = 7) {
    for (int i = 0; i < beams; ++i) columns.box("sonar.range." + std::to_string(i), "m", 0, 3, 1.5 - 0.5 * i);
    columns.box("goal.distance", "m", 0).box("goal.bearing", "rad").discrete("cell.0", 3).discrete("cell.1", 2);
  }
  Robot& part(int i, const std::string& columns_of, const char* as) {
    const std::string path = "encoding/" + std::to_string(i);
    values.set(path + "/columns/0", columns_of.c_str()).set(path + "/as", as);
    return *this;
  }
  Robot& thermometer(int i, std::initializer_list<double> thresholds) {
    part(i, "sonar.range.*", "thermometer");
    int k = 0;
    for (const double t : thresholds)
      values.set("encoding/" + std::to_string(i) + "/thresholds/" + std::to_string(k++), t);
    return *this;
  }
  Robot& sectors(int i, double n) {
    part(i, "goal.bearing", "sectors");
    values.set("encoding/" + std::to_string(i) + "/sectors", n);
    return *this;
  }
  xcs::Encoder make() { return xcs::Encoder(wend::Space(columns.table()), values.params(), "encoding"); }
  std::string refusal() {
    return error_of([&] { make(); });
  }
};

std::string bits(const xcs::Encoder& encoder, const std::vector<double>& observation) {
  std::vector<std::uint64_t> message(encoder.words(), ~std::uint64_t{0});  // what was there before does not matter
  encoder.encode(observation, message.data());
  std::string text;
  for (std::size_t j = 0; j < encoder.bits(); ++j) text += message[j / 64] >> (j % 64) & 1 ? '1' : '0';
  return text;
}

constexpr double pi = wend::math::pi;

}  // namespace

TEST(Encoder, MakesTheSeventeenBitsOfTheNavigationPaper) {
  Robot robot;
  const xcs::Encoder encoder = robot.thermometer(0, {0.35, 0.9}).sectors(1, 8).make();
  ASSERT_EQ(encoder.bits(), 17u);
  EXPECT_EQ(encoder.names()[0], "sonar.range.0<0.35");
  EXPECT_EQ(encoder.names()[13], "sonar.range.6<0.9");
  EXPECT_EQ(encoder.names()[16], "goal.bearing.g2");
  EXPECT_EQ(bits(encoder, {0.1, 0.35, 0.5, 0.9, 3, 0.34, 2, 5, 0, 0, 0}),
            "11"
            "01"
            "01"
            "00"
            "00"
            "11"
            "00"
            "000");
}

TEST(Encoder, MakesTheTenBitVariant) {
  Robot robot;
  const xcs::Encoder encoder = robot.thermometer(0, {0.35}).sectors(1, 8).make();
  ASSERT_EQ(encoder.bits(), 10u);
  EXPECT_EQ(bits(encoder, {0.1, 1, 1, 0.2, 1, 1, 1, 5, 0, 0, 0}), "1001000000");
}

TEST(Encoder, GivesNeighbouringSectorsCodesThatDifferInOneBit) {
  Robot robot;
  const xcs::Encoder encoder = robot.sectors(0, 8).make();
  const auto at = [&](double bearing) { return bits(encoder, {1, 1, 1, 1, 1, 1, 1, 5, bearing, 0, 0}); };
  EXPECT_EQ(at(0), "000");
  EXPECT_EQ(at(pi / 8 - 1e-9), "000");
  EXPECT_EQ(at(pi / 8 + 1e-9), "100");
  EXPECT_EQ(at(-pi / 8 + 1e-9), "000");
  EXPECT_EQ(at(pi - 1e-9), at(-pi)) << "behind is one sector";
  std::map<std::string, int> seen;
  std::string last = at(-pi);
  for (int k = -3; k <= 4; ++k) {
    const std::string now = at(k * pi / 4);
    int differ = 0;
    for (std::size_t j = 0; j < 3; ++j) differ += now[j] != last[j];
    EXPECT_EQ(differ, 1) << k;
    ++seen[now];
    last = now;
  }
  EXPECT_EQ(seen.size(), 8u);
}

TEST(Encoder, WritesWholeNumbersAndCrossesWords) {
  Robot robot(31);
  const xcs::Encoder encoder = robot.thermometer(0, {0.35, 0.9}).part(1, "cell.*", "binary").make();
  ASSERT_EQ(encoder.bits(), 65u);
  ASSERT_EQ(encoder.words(), 2u);
  std::vector<double> observation(31, 3);
  for (const double value : {5.0, 0.0, 2.0, 1.0}) observation.push_back(value);
  EXPECT_EQ(bits(encoder, observation), std::string(62, '0') + "01" + "1");
}

TEST(Encoder, HasASignatureThatTellsEncodingsApart) {
  Robot a, b, c;
  a.thermometer(0, {0.35, 0.9}).sectors(1, 8);
  b.thermometer(0, {0.35, 0.8}).sectors(1, 8);
  c.thermometer(0, {0.35, 0.9}).sectors(1, 16);
  EXPECT_NE(a.make().signature(), b.make().signature());
  EXPECT_NE(a.make().signature(), c.make().signature());
  EXPECT_EQ(a.make().signature(), a.make().signature());
}

TEST(Encoder, RefusesWhatCannotBeEncoded) {
  EXPECT_EQ(Robot().thermometer(0, {0.9, 0.35}).refusal(), "expected finite thresholds in ascending order, found 0.35");
  EXPECT_EQ(Robot().sectors(0, 6).refusal(), "expected a power of two from 2 on, found 6");
  EXPECT_EQ(Robot().part(0, "goal.distance", "binary").refusal(),
            "expected columns of whole numbers for binary, found \"goal.distance\" in m: encode it as thermometer or "
            "sectors");
  Robot distance;
  distance.part(0, "goal.distance", "sectors").values.set("encoding/0/sectors", 8);
  EXPECT_EQ(distance.refusal(), "expected angles in rad for sectors, found \"goal.distance\" in m");
  EXPECT_EQ(Robot().refusal(), "expected at least one bit to match on, found none");
  EXPECT_EQ(Robot(1).part(0, "laser.*", "thermometer").refusal(),
            "no column fits \"laser.*\"; the columns are sonar.range.0, goal.distance, goal.bearing, cell.0, cell.1");
}

TEST(Encoder, RefusesReadingsThatAreNoNumbersOrOutOfRange) {
  Robot robot;
  const xcs::Encoder encoder = robot.sectors(0, 8).part(1, "cell.*", "binary").make();
  EXPECT_EQ(error_of([&] {
              bits(encoder, {1, 1, 1, 1, 1, 1, 1, 5, std::nan(""), 0, 0});
            }),
            "observation \"goal.bearing\": expected a finite number, found NaN");
  EXPECT_EQ(error_of([&] {
              bits(encoder, {1, 1, 1, 1, 1, 1, 1, 5, 0, 3, 0});
            }),
            "observation \"cell.0\": expected a whole number 0..2, found 3");
  EXPECT_EQ(error_of([&] {
              bits(encoder, {1, 1, 1, 1, 1, 1, 1, 5, 0, 0.5, 0});
            }),
            "observation \"cell.0\": expected a whole number 0..2, found 0.5");
}
