#include <gtest/gtest.h>

#include <core/plugin/schema.hpp>

namespace wend::core {
namespace {

TEST(SchemaDefect, SoundOnesHaveNone) {
  EXPECT_EQ(
      schema_defect(Json::parse(R"({"type": "object", "additionalProperties": false, "required": ["a"], "properties": {
    "a": {"type": "integer", "minimum": 0, "exclusiveMaximum": 5, "default": 4.0, "description": "Counts."},
    "b": {"type": "object", "properties": {"c": {"type": "boolean", "default": true}}, "default": {}},
    "map": {"type": "array", "items": {"type": "string"}, "format": "files", "minItems": 1},
    "state": {"type": "string", "format": "file"},
    "size": {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2, "default": [1, 2]}}})")),
      std::nullopt);
  EXPECT_EQ(schema_defect(Json::parse(R"({"oneOf": [
    {"type": "object", "properties": {"kind": {"const": "disc"}, "form": {"const": 1}}},
    {"type": "object", "properties": {"kind": {"const": "box", "default": "box"}, "form": {"const": 1}}},
    {"enum": ["none", "all"]}, {"type": "integer"}], "default": {"kind": "disc"}})")),
            std::nullopt);
}

TEST(SchemaDefect, EachDefectIsNamed) {
  const auto defect = [](const char* text) { return schema_defect(Json::parse(text)).value_or("none"); };
  EXPECT_EQ(defect("3"), "expected a schema, found 3");
  EXPECT_EQ(defect("{}"), "expected \"type\", \"enum\", \"const\" or \"oneOf\"");
  EXPECT_EQ(defect(R"({"type": "float"})"),
            "/type: expected one type of \"number\", \"integer\", \"boolean\", \"string\", \"array\" or \"object\", "
            "found \"float\"");
  EXPECT_EQ(defect(R"({"type": ["number", "null"]})"),
            "/type: expected one type of \"number\", \"integer\", \"boolean\", \"string\", \"array\" or \"object\", "
            "found an array of 2");
  EXPECT_EQ(defect(R"({"type": "number", "minimun": 0})"),
            "/minimun: unknown keyword \"minimun\" (did you mean \"minimum\"?)");
  EXPECT_EQ(defect(R"({"type": "string", "pattern": "a"})"), "/pattern: unknown keyword \"pattern\"");
  EXPECT_EQ(defect(R"({"type": "string", "minimum": 0})"), "/minimum: \"minimum\" is for numbers");
  EXPECT_EQ(defect(R"({"type": "number", "minimum": "0"})"), "/minimum: expected a number, found \"0\"");
  EXPECT_EQ(defect(R"({"type": "number", "minimum": 2, "maximum": 1})"),
            "no number lies in the range: number in [2, 1]");
  EXPECT_EQ(defect(R"({"type": "number", "minimum": 1, "exclusiveMaximum": 1})"),
            "no number lies in the range: number in [1, 1)");
  EXPECT_EQ(defect(R"({"type": "number", "minimum": 1, "exclusiveMinimum": 1})"),
            "\"minimum\" and \"exclusiveMinimum\" exclude each other");
  EXPECT_EQ(defect(R"({"type": "array"})"), "an array needs \"items\"");
  EXPECT_EQ(defect(R"({"type": "array", "items": {"type": "number"}, "minItems": -1})"),
            "/minItems: expected a count, found -1");
  EXPECT_EQ(defect(R"({"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 2})"),
            "\"minItems\" is more than \"maxItems\"");
  EXPECT_EQ(defect(R"({"type": "number", "items": {"type": "number"}})"), "/items: \"items\" is for arrays");
  EXPECT_EQ(defect(R"({"type": "array", "items": {"type": "nmber"}})"),
            "/items/type: expected one type of \"number\", \"integer\", \"boolean\", \"string\", \"array\" or "
            "\"object\", found \"nmber\"");
  EXPECT_EQ(defect(R"({"enum": []})"), "/enum: expected an array of values, found an empty array");
  EXPECT_EQ(defect(R"({"enum": ["a", 1]})"), "/enum: expected numbers, strings or booleans of one type, found 1");
  EXPECT_EQ(defect(R"({"enum": ["a", "a"]})"), "/enum: \"a\" stands here twice");
  EXPECT_EQ(defect(R"({"type": "number", "enum": ["a"]})"),
            "/enum: expected numbers, strings or booleans of one type, found \"a\"");
  EXPECT_EQ(defect(R"({"const": null})"), "/const: expected numbers, strings or booleans of one type, found null");
  EXPECT_EQ(defect(R"({"const": 1, "enum": [1]})"), "\"enum\", \"const\" and \"oneOf\" exclude each other");
  EXPECT_EQ(defect(R"({"type": "number", "format": "file"})"),
            "/format: expected \"file\" for a string or \"files\" for an array of strings, found \"file\"");
  EXPECT_EQ(defect(R"({"type": "object", "additionalProperties": true})"),
            "/additionalProperties: expected false, found true");
  EXPECT_EQ(defect(R"({"type": "object", "properties": {"a/b": {"type": "number"}}})"),
            "/properties/a~1b: a property is named with letters, digits and _-.$, found \"a/b\"");
  EXPECT_EQ(defect(R"({"type": "object", "properties": {"a": 3}})"), "/properties/a: expected a schema, found 3");
  EXPECT_EQ(defect(R"({"type": "object", "required": ["a"]})"),
            "/required/0: expected the name of a property, found \"a\"");
  EXPECT_EQ(defect(R"({"type": "number", "maximum": 1, "default": 2})"),
            "/default: the default does not satisfy it: expected number <= 1, found 2");
  EXPECT_EQ(defect(R"({"type": "object", "properties": {"a": {"type": "number"}}, "default": {"a": "x"}})"),
            "/default: the default does not satisfy it: parameter \"a\": expected number, found \"x\"");
  EXPECT_EQ(defect(R"({"type": "number", "description": 3})"), "/description: expected a text, found 3");
}

TEST(SchemaDefect, AlternativesHaveToBeToldApart) {
  const auto defect = [](const std::string& branches) {
    return schema_defect(Json::parse("{\"oneOf\": " + branches + "}")).value_or("none");
  };
  EXPECT_EQ(defect("[]"), "/oneOf: expected an array of schemas, found an empty array");
  EXPECT_EQ(defect(R"([{"type": "number"}, {"type": "integer"}])"),
            "/oneOf/0: two alternatives are of the type number: nothing tells them apart");
  EXPECT_EQ(defect(R"([{"oneOf": [{"type": "number"}]}])"), "/oneOf/0: \"oneOf\" cannot stand directly in \"oneOf\"");
  EXPECT_EQ(defect(R"([{"type": "object", "properties": {"kind": {"const": "a"}}},)"
                   R"( {"type": "object", "properties": {"kind": {"const": "a"}}}])"),
            "/oneOf: nothing tells the alternatives apart: expected a property that is \"const\" in each");
  EXPECT_EQ(defect(R"([{"type": "object", "properties": {"kind": {"const": "a", "default": "a"}}},
                       {"type": "object", "properties": {"kind": {"const": "b", "default": "b"}}}])"),
            "/oneOf: \"kind\" has a default in more than one alternative");
  EXPECT_EQ(schema_defect(Json::parse(R"({"type": "string", "oneOf": [{"type": "number"}]})")),
            "/oneOf/0: the alternative is no string");
}

}  // namespace
}  // namespace wend::core
