#include <gtest/gtest.h>

#include <core/base/error.hpp>
#include <core/figure/display.hpp>

namespace wend::core {
namespace {

Figure sample() {
  Figure figure;
  figure.width = 200;
  figure.height = 100;
  figure.title = "é τ";
  figure.clips = {{0, 0, 50, 50}};
  figure.items.push_back(
      {Path{{{1, 2}, {3.25, 4}}, true, rgb(0x112233, 0.5), Pen{rgb(0xff0000), 2, Cap::round, {4, 2}}}, 0});
  figure.items.push_back({Circle{{5, 6}, 7, {}, Pen{}}, -1});
  figure.items.push_back({Rectangle{{1, 2, 3, 4}, rgb(0), {}}, -1});
  Text text;
  text.text = "<&\"'>";
  text.anchor = Anchor::end;
  text.bold = true;
  text.turn = -90;
  text.halo = 1.5;
  figure.items.push_back({text, -1});
  figure.items.push_back({Cells{{0, 0, 30, 20}, 3, 2, {0, 1, 1, 1, 0, 1}, rgb(0x808080)}, 0});
  return figure;
}

std::string error_of(const Json& json) {
  try {
    figure_from_json(json);
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::data);
    return error.what();
  }
  return "no error";
}

TEST(Display, ComesBackFromJsonAsItWas) {
  EXPECT_EQ(figure_from_json(Json::parse(to_json(sample()).dump())), sample());
}

TEST(Display, WritesCellsAsRuns) {
  EXPECT_EQ(to_json(sample())["items"][4]["cells"], Json({1, 3, 1, 1}));
}

TEST(Display, SaysWhereAFigureIsWrong) {
  const Json good = to_json(sample());
  const auto wrong = [&](const char* pointer, const Json& value) {
    Json json = good;
    json[Json::json_pointer(pointer)] = value;
    return error_of(json);
  };
  EXPECT_EQ(wrong("/width", 1e9), "figure/width: expected a number in [1, 20000], found 1000000000.0");
  EXPECT_EQ(wrong("/items/1/circle/2", -1), "figure/items/1/circle/2: expected a number in [0, 1000000], found -1");
  EXPECT_EQ(wrong("/items/0/path", Json({1, 2, 3})),
            "figure/items/0/path: expected an even number of coordinates, found [1,2,3]");
  EXPECT_EQ(wrong("/items/0/path/0", nullptr),
            "figure/items/0/path/0: expected a number in [-1000000, 1000000], found null");
  EXPECT_EQ(wrong("/items/0/fill", "red"), "figure/items/0/fill: expected a colour \"#rrggbbaa\", found \"red\"");
  EXPECT_EQ(wrong("/items/0/pen/dash", Json({0, 0})),
            "figure/items/0/pen/dash: expected lengths that sum to at least 0.5 px, found [0,0]");
  EXPECT_EQ(wrong("/items/0/clip", 1), "figure/items/0/clip: expected a whole number in [0, 0], found 1");
  EXPECT_EQ(wrong("/items/0/glow", 1), "figure/items/0: unknown key \"glow\"");
  EXPECT_EQ(wrong("/items/3/anchor", "left"),
            "figure/items/3/anchor: expected \"start\", \"middle\" or \"end\", found \"left\"");
  EXPECT_EQ(wrong("/items/4/cells", Json({1, 99})),
            "figure/items/4/cells/1: expected a whole number in [0, 5], found 99");
  EXPECT_EQ(wrong("/items/4/cells", Json({1, 2})),
            "figure/items/4/cells: expected runs that sum to 6 cells, found [1,2]");
  EXPECT_EQ(wrong("/items/4/columns", 100000),
            "figure/items/4/cells: expected runs that sum to 200000 cells, found [1,3,1,1]");
  EXPECT_EQ(
      wrong("/items/2", Json::object()),
      "figure/items/2: expected an object with \"path\", \"circle\", \"rectangle\", \"text\" or \"cells\", found {}");
  EXPECT_EQ(error_of(Json::array()), "figure: expected an object, found []");
}

}  // namespace
}  // namespace wend::core
