#include <gtest/gtest.h>

#include <core/base/diagnostics.hpp>

namespace wend::core {
namespace {

Diagnostic gama() {
  Diagnostic diagnostic;
  diagnostic.message = "unknown parameter \"gama\" for learner \"wend.lspi\"";
  diagnostic.file = "barn.json";
  diagnostic.pointer = "/arms/1/policy/slots/avoid/params/gama";
  diagnostic.line = 6;
  diagnostic.column = 40;
  diagnostic.length = 6;
  diagnostic.source_line = "\"params\": {\"gama\": 0.9}";
  diagnostic.source_column = 12;
  diagnostic.hint = "did you mean \"gamma\"? (number in [0, 1), default 0.9)";
  diagnostic.notes = {"all parameters: wend plugins show wend.lspi"};
  return diagnostic;
}

Diagnostic at(const std::string& file, std::size_t line, std::size_t column, const std::string& message) {
  Diagnostic diagnostic;
  diagnostic.message = message;
  diagnostic.file = file;
  diagnostic.line = line;
  diagnostic.column = column;
  return diagnostic;
}

TEST(Diagnostics, LooksAsPromised) {
  Diagnostics diagnostics;
  EXPECT_FALSE(diagnostics.any());
  EXPECT_EQ(diagnostics.text(), "");
  diagnostics.add(gama());
  EXPECT_EQ(diagnostics.text(), R"(error: unknown parameter "gama" for learner "wend.lspi"
  --> barn.json:6:40  (/arms/1/policy/slots/avoid/params/gama)
   6 |  "params": {"gama": 0.9}
     |             ^^^^^^ did you mean "gamma"? (number in [0, 1), default 0.9)
   = all parameters: wend plugins show wend.lspi
)");
}

TEST(Diagnostics, LongLineNumbersMoveTheBar) {
  Diagnostic diagnostic = at("a.json", 123456, 2, "x");
  diagnostic.source_line = "[1]";
  Diagnostics diagnostics;
  diagnostics.add(diagnostic);
  EXPECT_EQ(diagnostics.text(), "error: x\n  --> a.json:123456:2\n123456 |  [1]\n       |   ^\n");
}

TEST(Diagnostics, WithoutPositionTheHintIsANote) {
  Diagnostic diagnostic = at("a.json", 0, 0, "too large");
  diagnostic.hint = "split it";
  diagnostic.notes = {"a note"};
  Diagnostics diagnostics;
  diagnostics.add(diagnostic);
  diagnostic = {};
  diagnostic.message = "nowhere";
  diagnostics.add(diagnostic);
  diagnostic.message = "inside";
  diagnostic.pointer = "/a";
  diagnostics.add(diagnostic);
  EXPECT_EQ(diagnostics.text(),
            "error: nowhere\nerror: inside\n  --> (/a)\nerror: too large\n  --> a.json\n   = split it\n   = a note\n");
}

TEST(Diagnostics, SortedByFileLineColumnThenOrderOfArrival) {
  Diagnostics diagnostics;
  diagnostics.add(at("b.json", 1, 1, "e"));
  diagnostics.add(at("a.json", 10, 1, "d"));
  diagnostics.add(at("a.json", 9, 30, "b"));
  diagnostics.add(at("a.json", 9, 30, "c"));
  diagnostics.add(at("a.json", 9, 4, "a"));
  std::string order;
  for (const Diagnostic& diagnostic : diagnostics.sorted()) order += diagnostic.message;
  EXPECT_EQ(order, "abcde");
}

TEST(Diagnostics, EqualOnesAreToldOnce) {
  Diagnostics diagnostics, more;
  diagnostics.add(gama());
  diagnostics.add(gama());
  EXPECT_EQ(diagnostics.size(), 1u);
  more.add(gama());
  more.add(at("a.json", 1, 1, "other"));
  diagnostics.add(more);
  EXPECT_EQ(diagnostics.size(), 2u);
}

TEST(Diagnostics, AHostileFileCannotFillTheMemory) {
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < Diagnostics::max_kept + 7; ++i) diagnostics.add(at("a.json", i + 1, 1, "m"));
  EXPECT_TRUE(diagnostics.full());
  EXPECT_EQ(diagnostics.size(), Diagnostics::max_kept + 7);
  EXPECT_EQ(diagnostics.sorted().size(), Diagnostics::max_kept);
  EXPECT_TRUE(diagnostics.text().ends_with("  --> a.json:500:1\nerror: 7 more, not shown\n"));
}

TEST(Diagnostics, AsJson) {
  Diagnostics diagnostics;
  diagnostics.add(gama());
  Diagnostic raw = at("\xff.json", 1, 1, "a \xc3 b");
  diagnostics.add(raw);
  const Json json = diagnostics.json();
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(
      json[0].dump(),
      R"_({"column":40,"file":"barn.json","hint":"did you mean \"gamma\"? (number in [0, 1), default 0.9)",)_"
      R"("length":6,"line":6,"message":"unknown parameter \"gama\" for learner \"wend.lspi\"",)"
      R"("notes":["all parameters: wend plugins show wend.lspi"],"pointer":"/arms/1/policy/slots/avoid/params/gama"})");
  EXPECT_EQ(json[1]["message"], "a \xef\xbf\xbd b");
  EXPECT_EQ(json[1]["file"], "\xef\xbf\xbd.json");
}

TEST(DidYouMean, FindsTheNearest) {
  const std::vector<std::string> words{"alpha", "gamma", "gap", "learning_rate", "wend.clearance", "wend.lspi"};
  EXPECT_EQ(did_you_mean("gama", words), "gamma");
  EXPECT_EQ(did_you_mean("agmma", words), "gamma");  // swapped neighbours are one mistake
  EXPECT_EQ(did_you_mean("Gamma", words), "gamma");
  EXPECT_EQ(did_you_mean("learning-rate", words), "learning_rate");
  EXPECT_EQ(did_you_mean("learnigrate", words), "learning_rate");
  EXPECT_EQ(did_you_mean("lspi", words), "wend.lspi");
  EXPECT_EQ(did_you_mean("wend.clearence", words), "wend.clearance");
  EXPECT_EQ(did_you_mean("gpa", words), "gap");
}

TEST(DidYouMean, SaysNothingWhereNoneIsNear) {
  const std::vector<std::string> words{"alpha", "gamma", "x"};
  EXPECT_EQ(did_you_mean("epsilon", words), "");
  EXPECT_EQ(did_you_mean("beta", words), "");
  EXPECT_EQ(did_you_mean("y", words), "");
  EXPECT_EQ(did_you_mean("", words), "");
  EXPECT_EQ(did_you_mean("gamma", {}), "");
  EXPECT_EQ(did_you_mean(std::string(1'000'000, 'a'), words), "");
}

TEST(DidYouMean, ATieGoesToTheFirst) {
  EXPECT_EQ(did_you_mean("axis", {"axes", "axix"}), "axes");
}

TEST(Quote, FitsOnOneLine) {
  EXPECT_EQ(quote("a"), "\"a\"");
  EXPECT_EQ(quote(""), "\"\"");
  EXPECT_EQ(quote("tau \xcf\x84"), "\"tau \xcf\x84\"");
  EXPECT_EQ(quote("a\"b\\c"), R"("a\"b\\c")");
  EXPECT_EQ(quote("a\n\t\r\x1b[31m\x7f"), R"("a\n\t\r\u001b[31m\u007f")");
  EXPECT_EQ(quote("\xc2\x9b"), R"("\u009b")");
  EXPECT_EQ(quote("\xff\xc3"), "\"\xef\xbf\xbd\xef\xbf\xbd\"");
  EXPECT_EQ(quote(std::string("a\0b", 3)), R"("a\u0000b")");
  EXPECT_EQ(quote("\xcf\x84\xcf\x84\xcf\x84", 2), "\"\xcf\x84\xcf\x84...\"");
}

TEST(QuoteList, ReadsAsASentence) {
  EXPECT_EQ(quote_list({}), "");
  EXPECT_EQ(quote_list({"a"}), "\"a\"");
  EXPECT_EQ(quote_list({"a", "b"}), "\"a\" or \"b\"");
  EXPECT_EQ(quote_list({"a", "b", "c"}, "and"), "\"a\", \"b\" and \"c\"");
  EXPECT_EQ(quote_list({"a", "b", "c", "d"}, "or", 2), "\"a\", \"b\" (2 more)");
}

TEST(Utf8, SequencesByTheStandard) {
  EXPECT_EQ(utf8_sequence(""), 0u);
  EXPECT_EQ(utf8_sequence("a"), 1u);
  EXPECT_EQ(utf8_sequence("\xc2\x80"), 2u);
  EXPECT_EQ(utf8_sequence("\xe2\x82\xac!"), 3u);
  EXPECT_EQ(utf8_sequence("\xf4\x8f\xbf\xbf"), 4u);
  for (const char* bad : {"\x80", "\xbf", "\xc0\x80", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xf0\x8f\xbf\xbf",
                          "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff", "\xc3", "\xe2\x82", "\xf0\x9f\x98", "\xc3("})
    EXPECT_EQ(utf8_sequence(bad), 0u) << quote(bad);
}

}  // namespace
}  // namespace wend::core
