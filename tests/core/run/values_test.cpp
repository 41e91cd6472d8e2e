#include <gtest/gtest.h>

#include <core/run/values.hpp>
#include <cstring>

namespace wend::core {
namespace {

std::vector<std::string> shown(const FlatValues& values) {
  std::vector<std::string> all;
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    const wend_value& value = values.data()[i];
    all.push_back(std::string(value.path) + "=" + (value.text ? value.text : std::to_string(value.number)));
  }
  return all;
}

TEST(FlatValues, AreSortedByPath) {
  const Json params = {{"b", {{"radius", 2}, {"name", "disc"}}},
                       {"a", {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}},
                       {"on", true},
                       {"off", false},
                       {"nothing", nullptr},
                       {"none", Json::array()},
                       {"list", {{{"x", 1}}, {{"x", 2.5}}}}};
  const FlatValues values(params);
  EXPECT_EQ(shown(values),
            (std::vector<std::string>{"a/0=1.000000", "a/1=2.000000", "a/10=11.000000", "a/2=3.000000", "a/3=4.000000",
                                      "a/4=5.000000", "a/5=6.000000", "a/6=7.000000", "a/7=8.000000", "a/8=9.000000",
                                      "a/9=10.000000", "b/name=disc", "b/radius=2.000000", "list/0/x=1.000000",
                                      "list/1/x=2.500000", "off=0.000000", "on=1.000000"}));
  EXPECT_EQ(Json::parse(values.text()), params);
  for (std::uint32_t i = 1; i < values.size(); ++i)
    EXPECT_LT(std::strcmp(values.data()[i - 1].path, values.data()[i].path), 0);
}

TEST(FlatValues, StayWhereTheyAreWhenMoved) {
  FlatValues first(Json{{"text", "a text that is longer than a small string"}, {"n", 4}});
  const char* path = first.data()[1].path;
  const FlatValues second = std::move(first);
  EXPECT_EQ(second.data()[1].path, path);
  EXPECT_STREQ(second.data()[1].text, "a text that is longer than a small string");
  EXPECT_EQ(second.data()[0].number, 4);
}

TEST(FlatValues, OfNothingAreNone) {
  const FlatValues values(Json::object());
  EXPECT_EQ(values.size(), 0u);
  EXPECT_STREQ(values.text(), "{}");
}

}  // namespace
}  // namespace wend::core
