#include <gtest/gtest.h>

#include <core/plugin/schema.hpp>

namespace wend::core {
namespace {

TEST(Describe, SaysWhatIsAllowed) {
  const auto words = [](const char* text) { return describe(Json::parse(text)); };
  EXPECT_EQ(words(R"({"type": "number", "minimum": 0, "exclusiveMaximum": 1, "default": 0.9})"),
            "number in [0, 1), default 0.9");
  EXPECT_EQ(words(R"({"enum": ["powers", "quartic", "rbf"], "default": "powers"})"),
            "\"powers\", \"quartic\" or \"rbf\", default \"powers\"");
  EXPECT_EQ(words(R"({"type": "array", "items": {"type": "string"}, "default": ["sonar.*"]})"),
            "array of string, default [\"sonar.*\"]");
  EXPECT_EQ(words(R"({"type": "number"})"), "number");
  EXPECT_EQ(words(R"({"type": "integer", "minimum": 1.0, "default": 2.0})"), "integer >= 1, default 2");
  EXPECT_EQ(words(R"({"type": "number", "exclusiveMinimum": 0, "maximum": 1.5})"), "number in (0, 1.5]");
  EXPECT_EQ(words(R"({"type": "number", "exclusiveMaximum": 0})"), "number < 0");
  EXPECT_EQ(words(R"({"type": "number", "maximum": 0})"), "number <= 0");
  EXPECT_EQ(words(R"({"type": "boolean", "default": true})"), "boolean, default true");
  EXPECT_EQ(words(R"({"type": "string", "format": "file"})"), "name of a file");
  EXPECT_EQ(words(R"({"const": 3})"), "3");
  EXPECT_EQ(words(R"({"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2})"),
            "array of 2 (number)");
  EXPECT_EQ(words(R"({"type": "array", "items": {"type": "number"}, "minItems": 2})"), "array of at least 2 (number)");
  EXPECT_EQ(words(R"({"type": "array", "items": {"type": "number"}, "maxItems": 2})"), "array of at most 2 (number)");
  EXPECT_EQ(words(R"({"type": "object", "properties": {"a": {"type": "number"}}, "default": {}})"),
            "object with \"a\", default {}");
  EXPECT_EQ(words(R"({"type": "array", "items": {"type": "number"},)"
                  R"( "default": [1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24]})"),
            "array of number, default an array of 24");
}

}  // namespace
}  // namespace wend::core
