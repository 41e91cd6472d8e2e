#include <gtest/gtest.h>

#include <core/plugin/schema.hpp>

namespace wend::core {
namespace {

const Json lspi =
    Json::parse(R"({"type": "object", "additionalProperties": false, "required": ["reach"], "properties": {
  "observe": {"type": "array", "items": {"type": "string"}, "default": ["sonar.*"], "description": "Columns."},
  "gamma": {"type": "number", "minimum": 0, "exclusiveMaximum": 1, "default": 0.9},
  "samples": {"type": "integer", "minimum": 1, "default": 5},
  "mirror": {"type": "boolean", "default": false},
  "basis": {"enum": ["powers", "quartic", "rbf"], "default": "powers"},
  "reach": {"type": "number", "exclusiveMinimum": 0},
  "body": {"type": "object", "properties": {"radius": {"type": "number", "minimum": 0, "default": 3}}, "default": {}},
  "noise": {"type": "object", "properties": {"sigma": {"type": "number", "default": 1}}},
  "axes": {"type": "array", "items": {"type": "number", "minimum": -180, "maximum": 180}, "minItems": 1, "maxItems": 3}
}})");

const Json shapes = Json::parse(R"({"oneOf": [
  {"type": "object", "properties": {"kind": {"const": "disc"}, "radius": {"type": "number", "default": 1}}},
  {"type": "object", "properties": {"kind": {"const": "box", "default": "box"}, "size": {"type": "number"}},
   "required": ["size"]},
  {"enum": ["none", "all"]},
  {"type": "integer", "minimum": 0}]})");

// The complaints about `text`, or the value with its defaults.
std::string checked(const Json& schema, const std::string& text) {
  Diagnostics diagnostics;
  const auto document = Document::parse("a.json", text, diagnostics);
  if (!document) return diagnostics.text();
  Json value = document->root();
  check_schema(schema, value, "",
               {"learner \"wend.lspi\"", &*document, {"all parameters: wend plugins show wend.lspi"}}, diagnostics);
  return diagnostics.any() ? diagnostics.text() : value.dump();
}

// The only complaint, without the note, which each has.
std::string complaint(const Json& schema, const std::string& text) {
  std::string all = checked(schema, text);
  const std::string note = "   = all parameters: wend plugins show wend.lspi\n";
  EXPECT_TRUE(all.ends_with(note)) << all;
  all.resize(all.size() - std::min(all.size(), note.size()));
  return all;
}

void expect(const Json& schema, const std::string& text, const std::string& message, const std::string& place,
            const std::string& carets) {
  EXPECT_EQ(complaint(schema, text),
            "error: " + message + "\n  --> a.json:1:" + place + "\n   1 |  " + text + "\n     |  " + carets + "\n");
}

TEST(CheckSchema, FillsDefaults) {
  EXPECT_EQ(checked(lspi, R"({"reach": 20})"),
            R"({"basis":"powers","body":{"radius":3.0},"gamma":0.9,"mirror":false,"observe":["sonar.*"],)"
            R"("reach":20.0,"samples":5})");
}

TEST(CheckSchema, AnObjectWithoutDefaultStaysAbsentUntilItIsWritten) {
  EXPECT_EQ(checked(lspi, R"({"reach": 20, "noise": {}, "body": {"radius": 1}})"),
            R"({"basis":"powers","body":{"radius":1.0},"gamma":0.9,"mirror":false,"noise":{"sigma":1.0},)"
            R"("observe":["sonar.*"],"reach":20.0,"samples":5})");
}

TEST(CheckSchema, EqualValuesGetEqualText) {
  EXPECT_EQ(checked(lspi, R"({"reach": 2, "samples": 3.0})"), checked(lspi, R"({"reach": 2.0, "samples": 3})"));
  EXPECT_EQ(checked(lspi, R"({"reach": 2e0, "samples": 30e-1})"), checked(lspi, R"({"reach": 2.0, "samples": 3})"));
}

TEST(CheckSchema, UnknownKeys) {
  expect(lspi, R"({"reach": 1, "gama": 0.9})", "unknown parameter \"gama\" for learner \"wend.lspi\"", "14  (/gama)",
         "             ^^^^^^ did you mean \"gamma\"? (number in [0, 1), default 0.9)");
  expect(lspi, R"({"reach": 1, "body": {"rradius": 1}})",
         "unknown parameter \"body/rradius\" for learner \"wend.lspi\"", "23  (/body/rradius)",
         "                      ^^^^^^^^^ did you mean \"radius\"? (number >= 0, default 3)");
  expect(lspi, R"({"reach": 1, "body": {"zzz": 1}})", "unknown parameter \"body/zzz\" for learner \"wend.lspi\"",
         "23  (/body/zzz)", "                      ^^^^^ expected \"radius\"");
  expect(Json{{"type", "object"}}, R"({"zzz": 1})", "unknown parameter \"zzz\" for learner \"wend.lspi\"", "2  (/zzz)",
         " ^^^^^ there are none here");
}

TEST(CheckSchema, AMisspeltRequiredKeyIsOneMistake) {
  expect(lspi, R"({"raech": 1})", "unknown parameter \"raech\" for learner \"wend.lspi\"", "2  (/raech)",
         " ^^^^^^^ did you mean \"reach\"? (number > 0)");
}

TEST(CheckSchema, MissingKeys) {
  expect(lspi, "{}", "missing parameter \"reach\" of learner \"wend.lspi\"", "1", "^ number > 0");
}

TEST(CheckSchema, WrongTypesAndRanges) {
  const std::string of = " of learner \"wend.lspi\": expected ";
  const auto wrong = [&](const std::string& key, const std::string& value, const std::string& message,
                         const std::string& hint = "") {
    const std::string text = "{\"reach\": 1, \"" + key + "\": " + value + "}", before(16 + key.size() + 1, ' ');
    const bool container = value[0] == '[' || value[0] == '{';
    const std::string carets(container ? 1 : value.size(), '^');
    expect(lspi, text, "parameter \"" + key + "\"" + of + message,
           std::to_string(before.size() + 1) + "  (/" + key + ")", before + carets + hint);
  };
  wrong("gamma", "1.0", "number in [0, 1), found 1.0");
  wrong("gamma", "-0.5", "number in [0, 1), found -0.5");
  wrong("gamma", "true", "number in [0, 1), found true");
  wrong("gamma", "null", "number in [0, 1), found null");
  wrong("gamma", "\"0.9\"", "number in [0, 1), found \"0.9\"", " a number has no quotes");
  wrong("gamma", "[0.9]", "number in [0, 1), found an array of 1");
  wrong("samples", "1.9", "integer >= 1, found 1.9");
  wrong("samples", "0", "integer >= 1, found 0");
  wrong("samples", "-1", "integer >= 1, found -1");
  wrong("samples", "4294967297.5", "integer >= 1, found 4294967297.5");
  wrong("mirror", "1", "boolean, found 1", " write true or false");
  wrong("basis", "\"quartc\"", "\"powers\", \"quartic\" or \"rbf\", found \"quartc\"", " did you mean \"quartic\"?");
  wrong("basis", "3", "\"powers\", \"quartic\" or \"rbf\", found 3");
  wrong("observe", "\"sonar.*\"", "array of string, found \"sonar.*\"");
  wrong("axes", "[]", "array of 1 to 3 (number in [-180, 180]), found an empty array");
  wrong("axes", "[1, 2, 3, 4]", "array of 1 to 3 (number in [-180, 180]), found an array of 4");
  wrong("body", "3", "object with \"radius\", found 3");
  EXPECT_EQ(
      complaint(lspi, "[]"),
      "error: parameters of learner \"wend.lspi\": expected object with \"axes\", \"basis\", \"body\", \"gamma\", "
      "\"mirror\", "
      "\"noise\", \"observe\", \"reach\" (1 more), found an empty array\n  --> a.json:1:1\n   1 |  []\n     |  ^\n");
  expect(lspi, R"({"reach": 1, "axes": [0, 200]})", "parameter \"axes/1\"" + of + "number in [-180, 180], found 200",
         "26  (/axes/1)", "                         ^^^");
}

TEST(CheckSchema, IntegersBeyond2To53AreRefused) {
  const std::string of = " of learner \"wend.lspi\": expected an integer of at most 2^53 in size, found ";
  const auto wrong = [&](const std::string& text, const std::string& key, const std::string& value) {
    const std::string all = complaint(lspi, text);
    EXPECT_TRUE(all.starts_with("error: parameter \"" + key + "\"" + of + value + "\n")) << all;
    EXPECT_TRUE(all.ends_with(" larger ones are not exact\n")) << all;
  };
  wrong(R"({"reach": 1, "samples": 9007199254740993})", "samples", "9007199254740993");
  wrong(R"({"reach": 1, "samples": 18446744073709551615})", "samples", "18446744073709551615");
  wrong(R"({"reach": 1, "samples": 1e17})", "samples", "1e+17");
  wrong(R"({"reach": 9007199254740993})", "reach", "9007199254740993");
  wrong(R"({"reach": 1, "samples": -9223372036854775808})", "samples", "-9223372036854775808");
  EXPECT_NE(checked(lspi, R"({"reach": 1e300, "samples": 9007199254740992})").find("\"samples\":9007199254740992"),
            std::string::npos);
}

TEST(CheckSchema, EveryMistakeIsTold) {
  EXPECT_EQ(
      checked(lspi, "{\"gamma\": 2,\n \"samples\": 0,\n \"zeta\": 1}"),
      "error: missing parameter \"reach\" of learner \"wend.lspi\"\n  --> a.json:1:1\n   1 |  {\"gamma\": 2,\n"
      "     |  ^ number > 0\n   = all parameters: wend plugins show wend.lspi\n"
      "error: parameter \"gamma\" of learner \"wend.lspi\": expected number in [0, 1), found 2\n  --> a.json:1:11  "
      "(/gamma)\n"
      "   1 |  {\"gamma\": 2,\n     |            ^\n   = all parameters: wend plugins show wend.lspi\n"
      "error: parameter \"samples\" of learner \"wend.lspi\": expected integer >= 1, found 0\n  --> a.json:2:13  "
      "(/samples)\n"
      "   2 |  \"samples\": 0,\n     |             ^\n   = all parameters: wend plugins show wend.lspi\n"
      "error: unknown parameter \"zeta\" for learner \"wend.lspi\"\n  --> a.json:3:2  (/zeta)\n   3 |  \"zeta\": 1}\n"
      "     |  ^^^^^^ expected \"axes\", \"basis\", \"body\", \"gamma\", \"mirror\", \"noise\", \"observe\", \"reach\" "
      "or \"samples\"\n"
      "   = all parameters: wend plugins show wend.lspi\n");
}

TEST(CheckSchema, AlternativesAreChosenByTheirConstant) {
  EXPECT_EQ(checked(shapes, R"({"kind": "disc"})"), R"({"kind":"disc","radius":1.0})");
  EXPECT_EQ(checked(shapes, R"({"kind": "box", "size": 2})"), R"({"kind":"box","size":2.0})");
  EXPECT_EQ(checked(shapes, R"({"size": 2})"), R"({"kind":"box","size":2.0})");  // the alternative that is the default
  EXPECT_EQ(checked(shapes, R"("all")"), R"("all")");
  EXPECT_EQ(checked(shapes, "7.0"), "7");
  expect(shapes, R"({"kind": "bax"})",
         "parameter \"kind\" of learner \"wend.lspi\": expected \"disc\" or \"box\", found \"bax\"", "10  (/kind)",
         "         ^^^^^ did you mean \"box\"?");
  expect(shapes, R"({"kind": "disc", "size": 2})", "unknown parameter \"size\" for learner \"wend.lspi\"",
         "18  (/size)", "                 ^^^^^^ expected \"kind\" or \"radius\"");
  expect(shapes, "true",
         "parameters of learner \"wend.lspi\": expected integer >= 0 or \"none\" or \"all\" or object with \"kind\" "
         "\"disc\" or "
         "\"box\", found true",
         "1", "^^^^");
  Json strict = shapes;
  strict["oneOf"][1]["properties"]["kind"].erase("default");
  expect(strict, R"({"size": 2})", "missing parameter \"kind\" of learner \"wend.lspi\"", "1", "^ \"disc\" or \"box\"");
}

TEST(CheckSchema, WithoutDocumentAndSubjectThereIsStillAPointer) {
  Json value = {{"reach", 1}, {"a/b", 2}};
  Diagnostics diagnostics;
  check_schema(lspi, value, "/params", {"", nullptr, {}, "key"}, diagnostics);
  EXPECT_EQ(diagnostics.text(),
            "error: unknown key \"a~1b\"\n  --> (/params/a~1b)\n   = expected \"axes\", \"basis\", \"body\", "
            "\"gamma\", \"mirror\", "
            "\"noise\", \"observe\", \"reach\" or \"samples\"\n");
}

TEST(CheckSchema, AMillionMistakesStayBounded) {
  const Json schema = Json::parse(R"({"type": "array", "items": {"type": "string"}})");
  Json value = Json::array();
  for (int i = 0; i < 300'000; ++i) value.push_back(i);
  Diagnostics diagnostics;
  check_schema(schema, value, "", {}, diagnostics);
  EXPECT_EQ(diagnostics.size(), 300'000u);
  EXPECT_EQ(diagnostics.sorted().size(), Diagnostics::max_kept);
}

}  // namespace
}  // namespace wend::core
