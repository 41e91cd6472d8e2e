#include <gtest/gtest.h>

#include <core/base/document.hpp>
#include <ctime>
#include <functional>
#include <random>

namespace wend::core {
namespace {

std::string errors(const std::string& text) {
  Diagnostics diagnostics;
  const bool accepted = Document::parse("x.json", text, diagnostics).has_value();
  EXPECT_NE(accepted, diagnostics.any());
  return diagnostics.text();
}

Document parsed(const std::string& text) {
  Diagnostics diagnostics;
  auto document = Document::parse("x.json", text, diagnostics);
  EXPECT_EQ(diagnostics.text(), "");
  return std::move(document).value();
}

std::string told(const Document& document, const std::string& pointer, bool key = false) {
  Diagnostics diagnostics;
  diagnostics.add(document.at(pointer, "here", key));
  return diagnostics.text();
}

const std::string experiment = R"({
  "name": "barn",
  "arms": [
    {"id": "field"},
    {"id": "lspi", "policy": {"type": "wend.rolling_window", "slots": {"avoid": {
                           "params": {"gama": 0.9, "a/b~c": [1, 2.50, "tü\u00e9"]}}}}}
  ]
}
)";

TEST(Document, PointsAtValuesAndKeys) {
  const Document document = parsed(experiment);
  EXPECT_EQ(document.name(), "x.json");
  EXPECT_EQ(document.root()["arms"][1]["policy"]["slots"]["avoid"]["params"]["a/b~c"][2], "tüé");
  EXPECT_EQ(told(document, "/arms/1/policy/slots/avoid/params/gama", true),
            "error: here\n"
            "  --> x.json:6:39  (/arms/1/policy/slots/avoid/params/gama)\n"
            "   6 |  \"params\": {\"gama\": 0.9, \"a/b~c\": [1, 2.50, \"tü\\u00e9\"]}}}}}\n"
            "     |             ^^^^^^\n");
  EXPECT_EQ(told(document, "/arms/1/policy/slots/avoid/params/gama"),
            "error: here\n"
            "  --> x.json:6:47  (/arms/1/policy/slots/avoid/params/gama)\n"
            "   6 |  \"params\": {\"gama\": 0.9, \"a/b~c\": [1, 2.50, \"tü\\u00e9\"]}}}}}\n"
            "     |                     ^^^\n");
  EXPECT_EQ(told(document, "/arms/1/policy/slots/avoid/params/a~1b~0c/2"),
            "error: here\n"
            "  --> x.json:6:71  (/arms/1/policy/slots/avoid/params/a~1b~0c/2)\n"
            "   6 |  \"params\": {\"gama\": 0.9, \"a/b~c\": [1, 2.50, \"tü\\u00e9\"]}}}}}\n"
            "     |                                             ^^^^^^^^^^\n");
  EXPECT_EQ(told(document, ""), "error: here\n  --> x.json:1:1\n   1 |  {\n     |  ^\n");
}

TEST(Document, WhatTheFileDoesNotHaveIsAtItsNearestAncestor) {
  const Document document = parsed(experiment);
  for (const char* pointer :
       {"/arms/7", "/arms/01", "/arms/-", "/arms/2/policy/type", "/arms/+1", "/arms/18446744073709551617"}) {
    const Diagnostic diagnostic = document.at(pointer, "m", true);
    EXPECT_EQ(diagnostic.line, 3u) << pointer;
    EXPECT_EQ(diagnostic.column, 11u) << pointer;
    EXPECT_EQ(diagnostic.pointer, pointer);
  }
  EXPECT_EQ(document.at("/name/x", "m").column, 11u);  // below a text there is nothing
  EXPECT_EQ(document.at("/seed", "m").line, 1u);
  EXPECT_EQ(document.at("no pointer", "m").line, 1u);
}

TEST(Document, AReplacedValueIsNotBlamedOnTheFile) {
  Document document = parsed(experiment);
  document.replaced("/arms/0", "--set /arms/0={}");
  EXPECT_EQ(told(document, "/arms/0/id"),
            "error: here\n  --> x.json:3:11  (/arms/0/id)\n   3 |  \"arms\": [\n     |          ^\n"
            "   = the value comes from --set /arms/0={}\n");
  EXPECT_EQ(document.at("/arms/1/id", "m").line, 5u);
}

TEST(Document, LongLinesAreCut) {
  const std::string many(200, ' ');
  const Document document =
      parsed("{\"a\": \"" + std::string(100, 'x') + "\", \"b\": [1], \"c\": \"" + std::string(80, 'y') + "\"}");
  EXPECT_EQ(told(document, "/b"), "error: here\n  --> x.json:1:116  (/b)\n   1 |  ..." + std::string(52, 'x') +
                                      "\", \"b\": [1], \"c\": \"" + std::string(29, 'y') + "...\n     |  " +
                                      std::string(63, ' ') + "^\n");
  EXPECT_EQ(document.at("/c", "m").length, 40u);  // as much of the text as is shown
  EXPECT_EQ(told(parsed("[\n" + many + "7]"), "/0"), "error: here\n  --> x.json:2:201  (/0)\n   2 |  7]\n     |  ^\n");
}

TEST(Document, TabsWindowsLinesAndByteOrderMarks) {
  const Document document = parsed("\xef\xbb\xbf{\r\n\t\"a\":\t[1,\t2]\r\n}\r\n");
  EXPECT_EQ(told(document, "/a/1"),
            "error: here\n  --> x.json:2:11  (/a/1)\n   2 |  \"a\": [1, 2]\n     |           ^\n");
  EXPECT_EQ(document.at("", "m").column, 1u);
}

TEST(Document, SyntaxErrorsSayWhatWasExpected) {
  const auto at = [](const std::string& text, const std::string& message, const std::string& place,
                     const std::string& carets) {
    EXPECT_EQ(errors(text),
              "error: " + message + "\n  --> x.json:1:" + place + "\n   1 |  " + text + "\n     |  " + carets + "\n");
  };
  at("[1,]", "expected a value, found \"]\"", "4  (/1)", "   ^ remove the comma before it");
  at("{\"a\":1,}", "expected a key in double quotes, found \"}\"", "8", "       ^ remove the comma before it");
  at("{'a':1}", "expected a key in double quotes, found \"'\"", "2", " ^");
  at("['a']", "expected a value, found \"'\"", "2  (/0)", " ^ texts stand in double quotes");
  at("{a:1}", "expected a key in double quotes, found \"a\"", "2", " ^");
  at("[NaN]", "expected a value, found \"NaN\"", "2  (/0)", " ^^^ JSON has no NaN and no infinity");
  at("[-Infinity]", "expected a value, found \"-Infinity\"", "2  (/0)", " ^^^^^^^^^ JSON has no NaN and no infinity");
  at("[True]", "expected a value, found \"True\"", "2  (/0)", " ^^^^ write true");
  at("[01]", "a number that starts with 0", "2  (/0)", " ^^ remove the 0");
  at("[1.]", "expected a digit after the decimal point, found \"]\"", "4  (/0)", "   ^");
  at("[.5]", "expected a value, found \".5\"", "2  (/0)", " ^^ a number starts with a digit");
  at("[+1]", "expected a value, found \"+1\"", "2  (/0)", " ^^ a number has no plus sign");
  at("[1e+]", "expected a digit in the exponent, found \"]\"", "5  (/0)", "    ^");
  at("[0x10]", "expected a number, found \"0x10\"", "2  (/0)", " ^^^^");
  at("[1 2]", "expected \",\" or \"]\", found \"2\"", "4  (/0)", "   ^ is a comma missing before it?");
  at("{\"a\":[1}", "expected \",\" or \"]\", found \"}\"", "8  (/a/0)", "       ^ close the inner bracket first");
  at("{\"a\" 1}", "expected \":\" after the key, found \"1\"", "6  (/a)", "     ^");
  at("[1, // c]", "expected a value, found \"/\"", "5  (/1)", "    ^ JSON has no comments");
  at("[1] x", "expected the end of the file, found \"x\"", "5", "    ^ one file holds one value");
  at("[\"ab", "a text that does not end: the closing quote is missing", "2  (/0)", " ^");
  at("[\"\\x\"]", "an unknown escape in a text", "3  (/0)", "  ^^ write \\\\ for a backslash");
  at("[\"\\u12g4\"]", "expected four hexadecimal digits after \\u", "3  (/0)", "  ^^");
  at("[1,2", "expected \",\" or \"]\", found the end of the file", "5  (/1)", "    ^");
  at("{\"a\"", "expected \":\", found the end of the file", "5  (/a)", "    ^");
  EXPECT_EQ(errors(""), "error: expected a value, found the end of the file\n  --> x.json:1:1\n");
  EXPECT_EQ(errors("[\"a\nb\"]"),
            "error: a text that does not end on its line\n  --> x.json:1:2  (/0)\n   1 |  [\"a\n"
            "     |   ^^ close the quotes; \\n is a new line\n");
  EXPECT_EQ(errors("[\"\x01\"]"),
            "error: a control character in a text\n  --> x.json:1:3  (/0)\n   1 |  [\"?\"]\n"
            "     |    ^ write \\t for a tab, \\u00XX for others\n");
}

TEST(Document, TrapsOfJsonAreRefused) {
  const auto at = [](const std::string& text, const std::string& message, const std::string& carets) {
    EXPECT_EQ(errors(text),
              "error: " + message + "\n  --> x.json:1:2  (/0)\n   1 |  " + text + "\n     |  " + carets + "\n");
  };
  const std::string range = "a number beyond the range of double (about 4.9e-324 to 1.8e308)";
  at("[1e400]", range, " ^^^^^");
  at("[-1e400]", range, " ^^^^^^");
  at("[5e-325]", range, " ^^^^^^");  // would silently be 0
  const std::string wide = "an integer that does not fit into 64 bits", hint = " write it as 1e20 if rounding is meant";
  at("[18446744073709551616]", wide, " ^^^^^^^^^^^^^^^^^^^^" + hint);
  at("[-9223372036854775809]", wide, " ^^^^^^^^^^^^^^^^^^^^" + hint);
  EXPECT_EQ(errors("[\"\\u0000\"]"),
            "error: a text may not contain NUL\n  --> x.json:1:3  (/0)\n"
            "   1 |  [\"\\u0000\"]\n     |    ^^^^^^\n");
  for (const char* half : {"\\ud800", "\\udc00", "\\ud800\\n", "\\ud800\\ud800"})
    EXPECT_TRUE(errors("[\"" + std::string(half) + "\"]").starts_with("error: half of a surrogate pair in a text\n"))
        << half;
  EXPECT_EQ(parsed("[\"\\ud83d\\ude00\"]").root()[0], "\xf0\x9f\x98\x80");
}

TEST(Document, NumbersKeepTheirKindAndValue) {
  const Json root = parsed(
                        "[18446744073709551615, -9223372036854775808, 4294967297, 1.0, -0.0, 1e2, 4.9e-324, "
                        "1.7976931348623157e308, true]")
                        .root();
  EXPECT_EQ(root[0].get<std::uint64_t>(), 18446744073709551615u);
  EXPECT_TRUE(root[0].is_number_unsigned());
  EXPECT_EQ(root[1].get<std::int64_t>(), INT64_MIN);
  EXPECT_EQ(root[2].get<std::uint64_t>(), 4294967297u);
  EXPECT_TRUE(root[3].is_number_float());
  EXPECT_TRUE(std::signbit(root[4].get<double>()));
  EXPECT_EQ(root[5].get<double>(), 100.0);
  EXPECT_EQ(root[6].get<double>(), 4.9406564584124654e-324);
  EXPECT_EQ(root[7].get<double>(), 1.7976931348623157e308);
  EXPECT_TRUE(root[8].is_boolean());
}

TEST(Document, EveryDuplicateKeyIsTold) {
  EXPECT_EQ(errors("{\"a\": 1,\n \"b\": {\"c\": 2, \"\\u0063\": 3},\n \"a\": 4}"),
            "error: duplicate key \"c\", first on line 2\n  --> x.json:2:16  (/b/c)\n"
            "   2 |  \"b\": {\"c\": 2, \"\\u0063\": 3},\n     |                ^^^^^^^^ remove one of them\n"
            "error: duplicate key \"a\", first on line 1\n  --> x.json:3:2  (/a)\n"
            "   3 |  \"a\": 4}\n     |  ^^^ remove one of them\n");
}

TEST(Document, InvalidUtf8HasAPlace) {
  EXPECT_EQ(errors("{\"a\":\n \"\xc3\xa9\xff\"}"),
            "error: a byte that is not UTF-8\n  --> x.json:2:4\n   2 |  \"\xc3\xa9\xef\xbf\xbd\"}\n"
            "     |    ^ save the file as UTF-8\n");
  EXPECT_EQ(errors("\xff\xfe{"),
            "error: a byte that is not UTF-8\n  --> x.json:1:1\n"
            "   1 |  \xef\xbf\xbd\xef\xbf\xbd{\n     |  ^ save the file as UTF-8\n");
}

TEST(Document, DepthAndSizeAreBounded) {
  EXPECT_EQ(errors(std::string(64, '[') + std::string(64, ']')), "");
  EXPECT_TRUE(errors(std::string(65, '[') + std::string(65, ']'))
                  .starts_with("error: nested deeper than 64 levels\n  --> x.json:1:65  (/0/0"));
  EXPECT_TRUE(errors(std::string(5'000'000, '[')).starts_with("error: nested deeper than 64 levels\n"));
  EXPECT_EQ(errors(std::string(Document::max_bytes + 1, ' ')),
            "error: the file has 16777217 bytes, expected at most 16777216\n  --> x.json\n");
  std::string many = "[";
  for (std::size_t i = 0; i < Document::max_values; ++i) many += "0,";
  EXPECT_TRUE(
      errors(many).starts_with("error: more than 1000000 values in one file\n  --> x.json:1:2000000  (/999999)\n"));
}

// The largest hostile file: one line, every key twice, then every place asked for.
TEST(Document, IsQuickOnHostileFiles) {
  const std::clock_t begin = std::clock();
  std::string text = "{";
  for (int i = 0; i < 450'000; ++i) text += "\"k" + std::to_string(i) + "\":0,";
  for (int i = 449'999; i > 0; --i) text += "\"k" + std::to_string(i) + "\":0,";
  text.back() = '}';
  Diagnostics diagnostics;
  EXPECT_FALSE(Document::parse("x.json", text, diagnostics));
  EXPECT_EQ(diagnostics.size(), Diagnostics::max_kept);
  std::string array = "{\"long\": [0";
  for (int i = 0; i < 900'000; ++i) array += ",12345678";
  const Document document = parsed(array + "]}");
  for (int i = 0; i < 500; ++i) EXPECT_EQ(document.at("/long/" + std::to_string(900'000 - i), "m").length, 8u);
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  EXPECT_LT(seconds, 8.0);  // about 2 s, unoptimised 5; a quadratic search would take minutes
}

TEST(Document, EveryPlaceOfARandomDocumentIsRight) {
  std::mt19937 random(7);
  const std::function<Json(int)> grow = [&](int depth) -> Json {
    const auto pick = random() % (depth > 5 ? 5 : 7);
    if (pick == 0) return static_cast<std::int64_t>(random()) - 2147483648;
    if (pick == 1) return static_cast<double>(random()) / 7;
    if (pick == 2) return "t\n\"" + std::to_string(random() % 100) + "é/~";
    if (pick == 3) return random() % 2 == 0;
    if (pick == 4) return nullptr;
    Json all = pick == 5 ? Json::array() : Json::object();
    for (unsigned i = random() % 6; i > 0; --i)
      if (pick == 5)
        all.push_back(grow(depth + 1));
      else
        all["k/~\"é" + std::to_string(random() % 50)] = grow(depth + 1);
    return all;
  };
  for (int round = 0; round < 200; ++round) {
    const Json value = Json::array({grow(0), grow(0), grow(0)});
    const int indent = static_cast<int>(random() % 4) - 1;
    const std::string text = value.dump(indent);
    const Document document = parsed(text);
    ASSERT_EQ(document.root(), value);
    std::vector<std::string> lines{""};
    for (const char c : text)
      if (c == '\n')
        lines.emplace_back();
      else if ((static_cast<unsigned char>(c) & 0xc0) == 0x80)
        lines.back().back() = '?';  // one character, one column
      else
        lines.back() += c;
    const Json flat = value.flatten();
    for (const auto& [pointer, ignored] : flat.items()) {
      const Json& scalar = value[Json::json_pointer(pointer)];
      if (scalar.is_structured()) continue;  // flatten() calls an empty one null
      std::string expected = scalar.dump();
      for (std::size_t at; (at = expected.find("\xc3\xa9")) != std::string::npos;) expected.replace(at, 2, "?");
      const Diagnostic found = document.at(pointer, "m");
      ASSERT_LE(found.line, lines.size());
      std::string shown = lines[found.line - 1].substr(found.column - 1, expected.size());
      for (char& c : shown) c = c == '\xc3' ? '?' : c;
      EXPECT_EQ(shown, expected) << pointer << " in " << text;
    }
  }
}

TEST(PointerTokens, AreUnescaped) {
  EXPECT_EQ(pointer_tokens(""), std::vector<std::string>{});
  EXPECT_EQ(pointer_tokens("/"), std::vector<std::string>{""});
  EXPECT_EQ(pointer_tokens("/a~1b/~0~01/"), (std::vector<std::string>{"a/b", "~~1", ""}));
  EXPECT_EQ(pointer_token("a/b~"), "a~1b~0");
}

}  // namespace
}  // namespace wend::core
