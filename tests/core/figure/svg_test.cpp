#include <gtest/gtest.h>

#include <core/figure/svg.hpp>
#include <core/figure/text_metrics.hpp>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

namespace wend::core {
namespace {

constexpr const char* hostile = "</text><script>alert(1)</script>&\"'\x01\xff é τ";

Figure hostile_figure() {
  Figure figure;
  figure.width = 100;
  figure.height = 50;
  figure.title = hostile;
  figure.clips = {{0, 0, 10, 10}, {5, 5, 10, 10}};
  Text text;
  text.text = hostile;
  text.turn = 45;
  text.halo = 1;
  figure.items.push_back({text, 0});
  figure.items.push_back({Circle{{1, 2}, 3, rgb(0xff0000, 0.5), Pen{rgb(0), 1, Cap::round, {3, 2}}}, 1});
  figure.items.push_back({Cells{{0, 0, 4, 2}, 2, 1, {0, 1}, rgb(0)}, -1});
  return figure;
}

TEST(Svg, EscapesWhatComesFromOutside) {
  EXPECT_EQ(xml_text("a<b>&\"'\x01\xff\xc3\xa9"), "a&lt;b&gt;&amp;&quot;&#39;\xEF\xBF\xBD\xEF\xBF\xBD\xc3\xa9");
  const std::string svg = to_svg(hostile_figure(), "\"><x");
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_EQ(svg.find("\"><x"), std::string::npos);
}

TEST(Svg, IsWellFormedXml) {
  if (std::system("python3 -c 'import xml.dom.minidom' 2>/dev/null") != 0) GTEST_SKIP() << "python3 is not installed";
  const std::string path = testing::TempDir() + "wend_svg_test.svg";
  std::ofstream(path) << to_svg(hostile_figure());
  const std::string check =
      "python3 -c \"import sys, xml.dom.minidom as m; d = m.parse(sys.argv[1]); "
      "assert len(d.getElementsByTagName('clipPath')) == 2 and not d.getElementsByTagName('script')\" " +
      path;
  EXPECT_EQ(std::system(check.c_str()), 0);
  std::remove(path.c_str());
}

TEST(Svg, DrawsEachRunOfCellsAndKeepsDashes) {
  const std::string svg = to_svg(hostile_figure());
  EXPECT_NE(svg.find("d=\"M2 0h2v2h-2z\""), std::string::npos);
  EXPECT_NE(svg.find("stroke-dasharray=\"3 2\""), std::string::npos);
  EXPECT_NE(svg.find("fill-opacity=\"0.5\""), std::string::npos);
}

TEST(TextMetrics, DecodesOnlyUtf8) {
  const auto decoded = [](std::string_view text) {
    std::u32string points;
    for (std::size_t i = 0; i < text.size();) points += next_code_point(text, i);
    return points;
  };
  EXPECT_EQ(decoded("aé€😀"), U"aé€😀");
  EXPECT_EQ(decoded("\xc0\x80"), U"\uFFFD\uFFFD");            // an overlong zero
  EXPECT_EQ(decoded("\xed\xa0\x80"), U"\uFFFD\uFFFD\uFFFD");  // a surrogate
  EXPECT_EQ(decoded("\xe2\x82"), U"\uFFFD\uFFFD");            // cut off
}

TEST(TextMetrics, CutsTextThatDoesNotFit) {
  EXPECT_DOUBLE_EQ(text_width("AV", 10), 13.68);  // 684 + 684 thousandths of an em
  EXPECT_EQ(fit_text("rolling_window_memory", 12, 1000), "rolling_window_memory");
  const std::string cut = fit_text("rolling_window_memory", 12, 80);
  EXPECT_TRUE(cut.ends_with("…"));
  EXPECT_LE(text_width(cut, 12), 80);
}

}  // namespace
}  // namespace wend::core
