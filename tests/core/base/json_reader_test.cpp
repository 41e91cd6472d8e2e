#include <gtest/gtest.h>

#include <core/base/diagnostics.hpp>
#include <core/base/json_reader.hpp>
#include <random>

namespace wend::core {
namespace {

bool utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t n = utf8_sequence(text);
    if (n == 0) return false;
    text.remove_prefix(n);
  }
  return true;
}

// Whatever nlohmann refuses we refuse; what we accept is the same value; what only we refuse is a trap on this list.
void compare(const std::string& text) {
  const JsonText own = read_json(text, 64, 1000);
  if (own.mistakes.empty()) {
    ASSERT_TRUE(Json::accept(text)) << text;
    const Json other = Json::parse(text);
    ASSERT_EQ(own.root, other) << text;
    ASSERT_EQ(own.root.dump(), other.dump()) << text;
    ASSERT_EQ(own.places.front().next, own.places.size());
    return;
  }
  if (!Json::accept(text)) return;
  for (const JsonMistake& mistake : own.mistakes) {
    const std::string_view message = mistake.message;
    EXPECT_TRUE(mistake.duplicate || message == "a text may not contain NUL" ||
                message.starts_with("an integer that does not fit") || message.starts_with("a number beyond") ||
                message.starts_with("nested deeper"))
        << message << " in " << text;
  }
}

TEST(JsonReader, AgreesWithNlohmannOnMutatedTexts) {
  const std::vector<std::string> seeds{
      R"({"a": [1, -2.5e3, 0, -0.0, 1E+2], "b\n\u00e9": {"c": null, "d": [true]}, "": "x\\\"\/\b\f\t\ud83d\ude00"})",
      R"([[], {}, [[[]]], "", 18446744073709551615, -9223372036854775808, 1e-7, 123.456, 0.1])",
      R"( { "k" : "v" , "n" : [ 1 , 2 , 3 ] } )",
      "3",
      "\"\"",
      "-0",
      "null",
      "1e308",
      "[1,2,3,4,5,6,7,8,9,10]"};
  const std::string alphabet = "{}[]\",:.-+eE0123456789 \n\t\\/ubntfalsrd\xc3\xa9";
  std::mt19937 random(3);
  for (int round = 0; round < 200'000; ++round) {
    std::string text = seeds[random() % seeds.size()];
    for (unsigned edits = random() % 4; edits > 0; --edits) {
      const std::size_t at = random() % text.size();
      const char c = alphabet[random() % alphabet.size()];
      if (random() % 3 == 0)
        text.erase(at, 1 + random() % 3);
      else if (random() % 2 == 0)
        text.insert(at, 1, c);
      else
        text[at] = c;
      if (text.empty()) text = " ";
    }
    if (utf8(text)) compare(text);
    if (HasFatalFailure()) return;
  }
}

TEST(JsonReader, AgreesWithNlohmannOnRandomDoubles) {
  std::mt19937_64 random(5);
  for (int round = 0; round < 100'000; ++round) {
    const std::uint64_t bits = random();
    double number;
    std::memcpy(&number, &bits, sizeof number);
    if (!std::isfinite(number)) continue;
    const std::string text = Json(number).dump();
    const JsonText own = read_json(text, 64, 1000);
    ASSERT_TRUE(own.mistakes.empty()) << text;
    ASSERT_EQ(own.root.get<double>(), number) << text;
  }
}

TEST(JsonReader, PlacesNestAndSkip) {
  const std::string text = R"({"a": [1, {"b": 2}], "c": 3})";
  const JsonText own = read_json(text, 64, 1000);
  ASSERT_EQ(own.places.size(), 6u);  // the object, the array, 1, the inner object, 2, 3
  const auto of = [&](std::size_t i) {
    return text.substr(own.places[i].begin, own.places[i].end - own.places[i].begin);
  };
  EXPECT_EQ(of(1), R"([1, {"b": 2}])");
  EXPECT_EQ(own.places[1].next, 5u);
  EXPECT_EQ(of(3), R"({"b": 2})");
  EXPECT_EQ(own.places[3].next, 5u);
  EXPECT_EQ(of(5), "3");
  EXPECT_EQ(text.substr(own.places[5].key_begin, own.places[5].key_end - own.places[5].key_begin), "\"c\"");
}

}  // namespace
}  // namespace wend::core
